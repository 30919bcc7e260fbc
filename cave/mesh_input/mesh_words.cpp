#include "cave/mesh_input/mesh_words.h"

namespace carom {

std::string shown(std::string_view text) {
  std::string printable(text.substr(0, 40));
  std::replace_if(
      printable.begin(), printable.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  return printable;
}

}  // namespace carom
