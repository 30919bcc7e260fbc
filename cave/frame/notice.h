#pragma once
// A line for the person in the room: what was just refused, or happened, in words.

#include <array>
#include <string_view>

namespace carom {

/// UTF-8, ended by a zero; cut where it is longer. Empty: nothing is said.
struct Notice {
  std::array<char, 120> text{};

  Notice() = default;
  explicit Notice(std::string_view words) {
    std::size_t bytes = words.size() < text.size() ? words.size() : text.size() - 1;
    while (bytes < words.size() && bytes > 0 && (static_cast<unsigned char>(words[bytes]) & 0xC0U) == 0x80U)
      --bytes;  // not in the middle of a letter
    words.copy(text.data(), bytes);
  }
  std::string_view words() const { return text.data(); }

  bool operator==(const Notice&) const = default;
};

}  // namespace carom
