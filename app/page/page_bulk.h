#pragma once
// The numbers of a page: columns of them, made so that they compress well, and the whole as letters.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// Where a column lies in the bytes, and what its numbers are.
struct PageColumn {
  std::size_t at = 0, count = 0;
  const char* kind = "";  ///< f64, f32, i16, u32 or u8
};

/// Columns, one after the other. Each number is kept as its difference from the one before (of whole numbers)
/// or with that one's bits taken out (of others), all first bytes before all second bytes and so on: what
/// changes little is zeros then. pages/data.js reads it.
class PageBulk {
 public:
  PageColumn add(std::span<const double> numbers);
  PageColumn add(std::span<const float> numbers);
  PageColumn add(std::span<const std::int16_t> numbers);
  PageColumn add(std::span<const std::uint32_t> numbers);
  PageColumn add(std::span<const std::uint8_t> numbers);

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Returns the bytes compressed (RFC 1950) and as letters (RFC 4648).
std::string lettersOf(std::string_view bytes);

}  // namespace carom
