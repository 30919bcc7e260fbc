#pragma once
// The keys of a session. They work in any of rank 0's windows; ending it, in any window of any node.

#include <string>
#include <string_view>
#include <vector>

#include "app/operator/controls.h"
#include "cave/gl/graphics.h"

namespace carom {

/// Escape, Q, or a window's own button.
bool wantsToEnd(const WindowInput& input);

/// Where keys are pressed: not every key means something everywhere.
enum class KeysOf { session, replay, patterns };

/// One line of the keyboard's map.
struct KeyLine {
  std::string keys;  ///< "1", "+ −"
  std::string does;  ///< in a few words
};

/// What the keys do, in the order of the table.
std::vector<KeyLine> keyMap(KeysOf place);

/// The key that changes one thing, as `changesOf` (app/operator/controls.h) names it: "aberration",
/// "board-now", "walls". Empty where none does.
KeyLine keyFor(KeysOf place, std::string_view what);

/// Changes the controls as the pressed keys say. `now_s`: the session's time, from which the arrows go.
void obeyKeys(const WindowInput& input, KeysOf place, double now_s, Controls& controls);

/// True if the key of the keyboard's map was pressed.
bool asksForKeys(const WindowInput& input);

/// Says on standard error what the keys do.
void sayKeys(KeysOf place);

}  // namespace carom
