#include "app/tables/html_text.h"

#include <cstddef>

namespace carom {

std::string htmlOf(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += letter;
    }
  }
  return safe;
}

std::string filled(std::string_view text, const PageWords& words) {
  std::string whole;
  for (std::size_t from = 0;;) {
    const std::size_t begins = text.find("{{", from), ends = text.find("}}", begins);
    if (ends == std::string_view::npos) return whole += text.substr(from);
    whole += text.substr(from, begins - from);
    whole += words.at(std::string(text.substr(begins + 2, ends - begins - 2)));
    from = ends + 2;
  }
}

}  // namespace carom
