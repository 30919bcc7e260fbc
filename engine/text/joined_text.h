#pragma once
// Texts of words and numbers one after the other, for messages, without what streams bring along.

#include <array>
#include <concepts>
#include <cstdio>
#include <string>
#include <string_view>

namespace carom {

/// Returns a number in its shortest form, rounded to `digits` digits.
inline std::string digitsOf(double number, int digits) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, number);
  return text.data();
}

/// Returns the parts, words and numbers, as one text; numbers that are not whole have at most `digits`
/// digits.
template <class... Parts>
std::string joinedText([[maybe_unused]] int digits, const Parts&... parts) {
  std::string text;
  [[maybe_unused]] const auto add = [&](const auto& part) {
    using Part = std::remove_cvref_t<decltype(part)>;
    if constexpr (std::floating_point<Part>) {
      text += digitsOf(part, digits);
    } else if constexpr (std::integral<Part>) {
      text += std::to_string(part);
    } else {
      text += std::string_view(part);
    }
  };
  (add(parts), ...);
  return text;
}

}  // namespace carom
