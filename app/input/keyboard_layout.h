#pragma once
// Names the keys (cave/texts/key_names.h) as the layout of the keyboard prints them.

#include <string>
#include <string_view>

#include "cave/gl/graphics.h"

namespace carom {

/// Returns letters as keys have them, in capitals where there are any, by the rules of Unicode: "é" as "É",
/// "ß" as it is. UTF-8.
std::string asOnKey(std::string_view letters);

/// Follows the layout of the display's keyboard. The windows of a session that somebody plays have one;
/// without it the keys have the names of a US keyboard.
class KeyboardLayout {
 public:
  /// Names the keys. Graphics must live.
  KeyboardLayout() { name(); }

  /// Names them anew if a key was pressed: the layout may be another one since.
  void follow(const WindowInput& input) {
    if (!input.keys.empty()) name();
  }

 private:
  static void name();
};

/// Returns the names in use as one text, for another node.
std::string keyNamesInUse();
/// Uses the names of such a text.
void useKeyNames(std::string_view names);

}  // namespace carom
