#pragma once
// A short message for the person in the room: something was just refused, or has happened.

#include <array>
#include <string_view>

namespace carom {

/// UTF-8, ended by a zero byte; longer text is cut. Empty: there is no message.
struct Notice {
  std::array<char, 120> text{};

  Notice() = default;
  explicit Notice(std::string_view words) {
    std::size_t bytes = words.size() < text.size() ? words.size() : text.size() - 1;
    while (bytes < words.size() && bytes > 0 && (static_cast<unsigned char>(words[bytes]) & 0xC0U) == 0x80U)
      --bytes;  // never cuts a letter in two
    words.copy(text.data(), bytes);
  }
  std::string_view words() const { return text.data(); }

  bool operator==(const Notice&) const = default;
};

}  // namespace carom
