#pragma once
// Spoils bytes the way networks, cables and enemies do.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace carom::test {

using Bytes = std::vector<std::uint8_t>;

/// One to four changes, each of one kind: a byte, a bit, a number of 1 to 8 bytes made extreme, a piece cut
/// out, put in twice or overwritten from elsewhere, bytes put in, the end cut off, another packet's end.
inline Bytes mutated(Bytes bytes, const Bytes& other, std::mt19937_64& random) {
  const auto below = [&](std::size_t bound) {
    return bound == 0 ? 0 : static_cast<std::size_t>(random() % bound);
  };
  const auto at = [](Bytes& b, std::size_t i) { return b.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
    const std::size_t from = below(bytes.size()), length = std::min(1 + below(16), bytes.size() - from);
    switch (bytes.empty() ? 5 : below(9)) {
      case 0:
        bytes[from] = static_cast<std::uint8_t>(random());
        break;
      case 1:
        bytes[from] ^= static_cast<std::uint8_t>(1 << below(8));
        break;
      case 2: {
        constexpr std::uint8_t kExtremes[]{0x00, 0xff, 0x7f, 0x80, 0x01, '0', '9', '-'};
        const std::uint8_t extreme = kExtremes[below(std::size(kExtremes))];
        const std::size_t end = std::min(from + (std::size_t{1} << below(4)), bytes.size());
        std::fill(at(bytes, from), at(bytes, end), extreme);
        break;
      }
      case 3:
        bytes.erase(at(bytes, from), at(bytes, from + length));
        break;
      case 4: {
        const Bytes piece(at(bytes, from), at(bytes, from + length));
        bytes.insert(at(bytes, below(bytes.size() + 1)), piece.begin(), piece.end());
        break;
      }
      case 5: {
        Bytes piece(1 + below(16));
        for (std::uint8_t& byte : piece) byte = static_cast<std::uint8_t>(random());
        bytes.insert(at(bytes, below(bytes.size() + 1)), piece.begin(), piece.end());
        break;
      }
      case 6:
        bytes.resize(from);
        break;
      case 7: {
        const std::size_t to = below(bytes.size() - length + 1);
        std::copy_n(Bytes(at(bytes, from), at(bytes, from + length)).begin(), length, at(bytes, to));
        break;
      }
      default: {
        const std::size_t start = below(other.size());
        bytes.resize(from);
        bytes.insert(bytes.end(), other.begin() + static_cast<std::ptrdiff_t>(start), other.end());
        break;
      }
    }
  }
  return bytes;
}

}  // namespace carom::test
