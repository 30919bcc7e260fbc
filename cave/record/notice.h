#pragma once
// A short message for the person in the room: something was just refused, or has happened.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "cave/texts/language.h"
#include "cave/texts/saying.h"

namespace carom {

/// UTF-8, ended by a zero byte; longer text is cut.
template <std::size_t bytes>
struct ShortText {
  std::array<char, bytes> text{};

  ShortText() = default;
  explicit ShortText(std::string_view words) {
    std::size_t kept = words.size() < bytes ? words.size() : bytes - 1;
    while (kept < words.size() && kept > 0 && (static_cast<unsigned char>(words[kept]) & 0xC0U) == 0x80U)
      --kept;  // never cuts a letter in two
    words.copy(text.data(), kept);
  }
  std::string_view words() const { return text.data(); }

  bool operator==(const ShortText&) const = default;
};

/// Empty: there is no message.
struct Notice {
  ShortText<120> english;
  /// As cave/texts/saying.h writes it. Empty: a text of the game, or one that is too long for it.
  ShortText<320> said;

  Notice() = default;
  explicit Notice(std::string_view ofGame) : english(ofGame) {}
  explicit Notice(const texts::Saying& saying) : english(saying.english()) {
    const std::string line = saying.line();
    if (line.size() < said.text.size()) said = ShortText<320>(line);
  }
  bool empty() const { return english.text.front() == 0; }
  /// Returns the message in the language in use.
  std::string words() const {
    if (!texts::language()) return std::string(english.words());
    return said.words().empty() ? texts::other(english.words()) : texts::Saying::read(said.words()).words();
  }

  bool operator==(const Notice&) const = default;
};

}  // namespace carom
