#include "app/page/page_bulk.h"

#include <zlib.h>

#include <bit>
#include <stdexcept>

namespace carom {
namespace {

/// Appends whole numbers plane by plane, the lowest bytes first.
template <typename Number>
std::size_t appendPlanes(const std::vector<Number>& numbers, std::string& bytes) {
  const std::size_t at = bytes.size();
  for (std::size_t plane = 0; plane < sizeof(Number); ++plane)
    for (const Number number : numbers) bytes += static_cast<char>(number >> 8 * plane & 0xff);
  return at;
}

/// Takes the bits of the number before out of each, or subtracts it.
template <typename Bits, typename Number>
std::vector<Bits> changesOf(std::span<const Number> numbers) {
  std::vector<Bits> changes;
  changes.reserve(numbers.size());
  Bits before = 0;
  for (const Number number : numbers) {
    const auto bits = std::bit_cast<Bits>(number);
    if constexpr (std::is_floating_point_v<Number>) {
      changes.push_back(bits ^ before);
    } else {
      changes.push_back(static_cast<Bits>(bits - before));
    }
    before = bits;
  }
  return changes;
}

}  // namespace

PageColumn PageBulk::add(std::span<const double> numbers) {
  return {appendPlanes(changesOf<std::uint64_t>(numbers), bytes_), numbers.size(), "f64"};
}
PageColumn PageBulk::add(std::span<const float> numbers) {
  return {appendPlanes(changesOf<std::uint32_t>(numbers), bytes_), numbers.size(), "f32"};
}
PageColumn PageBulk::add(std::span<const std::int16_t> numbers) {
  return {appendPlanes(changesOf<std::uint16_t>(numbers), bytes_), numbers.size(), "i16"};
}
PageColumn PageBulk::add(std::span<const std::uint32_t> numbers) {
  return {appendPlanes(changesOf<std::uint32_t>(numbers), bytes_), numbers.size(), "u32"};
}
PageColumn PageBulk::add(std::span<const std::uint8_t> numbers) {
  return {appendPlanes(changesOf<std::uint8_t>(numbers), bytes_), numbers.size(), "u8"};
}

std::string lettersOf(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), Z_BEST_COMPRESSION) != Z_OK)
    throw std::runtime_error("the page is too large for this machine's memory");
  packed.resize(size);
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string letters;
  letters.reserve(packed.size() / 3 * 4 + 4);
  for (std::size_t i = 0; i < packed.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < packed.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(packed[i + k]))
                                   : 0U;
    };
    const std::uint32_t three = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (std::size_t k = 0; k < 4; ++k)
      letters += i + k <= packed.size() ? kLetters[three >> (18 - 6 * k) & 63] : '=';
  }
  return letters;
}

}  // namespace carom
