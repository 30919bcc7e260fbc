#include "app/study/form_fields.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "engine/base/printable.h"

namespace carom {
namespace {

int digitOf(char letter) {
  if (letter >= '0' && letter <= '9') return letter - '0';
  if (letter >= 'a' && letter <= 'f') return letter - 'a' + 10;
  return letter >= 'A' && letter <= 'F' ? letter - 'A' + 10 : -1;
}

/// Returns a name or a value as it was before it was encoded.
std::string decoded(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int high = i + 2 < text.size() && text[i] == '%' ? digitOf(text[i + 1]) : -1;
    const int low = high >= 0 ? digitOf(text[i + 2]) : -1;
    if (low >= 0) {
      plain += static_cast<char>(high * 16 + low);
      i += 2;
    } else {
      plain += text[i] == '+' ? ' ' : text[i];
    }
  }
  return printable(plain);
}

/// Returns the number of bytes of the letter with which a text begins, 1 to 4; 0 if it is no UTF-8.
std::size_t letterBytes(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t bytes = first < 0x80                    ? 1
                            : first >= 0xC2 && first < 0xE0 ? 2
                            : first >= 0xE0 && first < 0xF0 ? 3
                            : first >= 0xF0 && first < 0xF5 ? 4
                                                            : 0;
  if (bytes == 0 || bytes > text.size()) return 0;
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) return 0;
  }
  return bytes;
}

/// Returns whether a letter marks or changes the direction of reading: U+200E, U+200F, U+202A to U+202E,
/// U+2066 to U+2069.
bool changesDirection(std::string_view letter) {
  if (letter.size() != 3 || letter.substr(0, 2) < "\xE2\x80" || letter.substr(0, 2) > "\xE2\x81")
    return false;
  const auto last = static_cast<unsigned char>(letter[2]);
  if (letter[1] == '\x80') return last == 0x8E || last == 0x8F || (last >= 0xAA && last <= 0xAE);
  return last >= 0xA6 && last <= 0xA9;
}

}  // namespace

FormFields::FormFields(std::string_view form) {
  if (form.size() > kMostFormBytes) return;
  while (!form.empty() && fields_.size() < kMostFormFields) {
    const std::string_view field = form.substr(0, form.find('&'));
    form.remove_prefix(std::min(form.size(), field.size() + 1));
    const std::size_t equals = field.find('=');
    if (equals == std::string_view::npos) continue;
    fields_.emplace(decoded(field.substr(0, equals)), decoded(field.substr(equals + 1)));
  }
}

const std::string& FormFields::operator[](std::string_view name) const {
  static const std::string none;
  const auto found = fields_.find(name);
  return found == fields_.end() ? none : found->second;
}

int FormFields::number(std::string_view name, int most, int otherwise) const {
  const std::string& text = (*this)[name];
  int value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool isWhole = failed == std::errc() && end == text.data() + text.size() && !text.empty();
  return isWhole && value >= 0 && value <= most ? value : otherwise;
}

std::string plainWords(std::string_view text, std::size_t letters) {
  std::string words;
  for (std::size_t count = 0; !text.empty() && count < letters; ++count) {
    const std::size_t bytes = letterBytes(text);
    if (bytes == 0) {
      words += '?';
      text.remove_prefix(1);
      continue;
    }
    if (!changesDirection(text.substr(0, bytes))) words += text.substr(0, bytes);
    text.remove_prefix(bytes);
  }
  return words;
}

}  // namespace carom
