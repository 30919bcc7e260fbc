#pragma once
// Reads numbers from a packet and never beyond its end.

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>

namespace carom {

/// Whatever is read beyond the packet's end is zero, and `ok` is false from then on.
class WireReader {
 public:
  WireReader(std::span<const std::uint8_t> bytes, std::endian order) : rest_(bytes), order_(order) {}

  bool ok() const { return ok_; }
  std::span<const std::uint8_t> rest() const { return rest_; }

  template <class T>
  requires std::is_arithmetic_v<T> T read() {
    std::uint8_t bytes[sizeof(T)] = {};
    const auto taken = take(sizeof(T));
    for (std::size_t i = 0; i < taken.size(); ++i) {
      bytes[order_ == std::endian::native ? i : sizeof(T) - 1 - i] = taken[i];
    }
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }

  /// Returns the next `count` bytes; none if there are fewer.
  std::span<const std::uint8_t> take(std::size_t count) {
    if (count > rest_.size()) {
      ok_ = false;
      rest_ = {};
      return {};
    }
    const auto taken = rest_.first(count);
    rest_ = rest_.subspan(count);
    return taken;
  }

  /// Skips `count` items of `size` bytes.
  void skip(std::size_t count, std::size_t size = 1) {
    take(size != 0 && count > rest_.size() / size ? rest_.size() + 1 : count * size);
  }

  /// Returns a text that ends with a zero byte, and skips that byte.
  std::string_view text() {
    const void* end = rest_.empty() ? nullptr : std::memchr(rest_.data(), 0, rest_.size());
    if (!end) {
      skip(rest_.size() + 1);
      return {};
    }
    const auto length = static_cast<std::size_t>(static_cast<const std::uint8_t*>(end) - rest_.data());
    const auto taken = take(length + 1);
    return {reinterpret_cast<const char*>(taken.data()), length};
  }

 private:
  std::span<const std::uint8_t> rest_;
  std::endian order_;
  bool ok_ = true;
};

}  // namespace carom
