#include "engine/text/printable.h"

namespace carom {

std::string printable(std::string_view text, std::string_view kept) {
  std::string shown;
  shown.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : '\0');
    const bool isLateControl = byte == 0xC2 && next >= 0x80 && next <= 0x9F;  // in UTF-8
    const bool isControl = byte < 0x20 || byte == 0x7F;
    const bool stays = kept.find(text[i]) != std::string_view::npos;
    shown += isLateControl || (isControl && !stays) ? '?' : text[i];
    if (isLateControl) ++i;
  }
  return shown;
}

}  // namespace carom
