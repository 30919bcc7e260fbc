#include "app/study/form_fields.h"

#include <algorithm>
#include <charconv>

#include "engine/text/printable.h"

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
  return printable(plain, "\t\n\r");
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

}  // namespace carom
