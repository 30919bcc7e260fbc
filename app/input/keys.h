#pragma once
// The keys of a session. They work in any of rank 0's windows; ending it, in any window of any node.

#include <string>
#include <string_view>
#include <vector>

#include "app/operator/command.h"
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

/// Returns the key for one thing, as `nameOf` (app/operator/command.h) names it: "aberration", "board-now",
/// "walls". Empty where there is none.
KeyLine keyFor(KeysOf place, std::string_view what);

/// Returns what the pressed keys ask for, each as the settings are after the ones before it. `now_s`: the session's
/// time, from which the arrows go. Allocates only where a key is pressed.
Commands commandsOf(const WindowInput& input, KeysOf place, double now_s, const OperatorSettings& settings);

/// Says on standard error what the keys do.
void sayKeys(KeysOf place);

}  // namespace carom
