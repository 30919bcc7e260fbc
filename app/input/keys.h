#pragma once
// The keyboard commands of a session. They work in all of rank 0's windows; ending (app/input/end_question.h)
// works in any window of any node.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/operator/command.h"
#include "cave/gl/graphics.h"

namespace carom {

/// The kind of session in which keys are pressed; some keys work only in certain kinds. In a dry run, which
/// is a session, keys move the head as well (app/play/mouse_people.h).
enum class KeysOf { session, replay, patterns, dryRun };

/// Returns whether a game is played, and not shown again.
inline bool isLive(KeysOf place) { return place == KeysOf::session || place == KeysOf::dryRun; }

/// One line of the list of keys.
struct KeyLine {
  std::string keys;  ///< "1", "+ −"
  std::string does;  ///< short description
};

/// Returns the list of keys in the order of the table, with their names on this keyboard.
std::vector<KeyLine> keyMap(KeysOf place);

/// The list of keys, made anew when the language or the names of the keys have changed.
class KeyList {
 public:
  explicit KeyList(KeysOf place) : place_(place) {}

  /// Returns the list for somebody who reads this language of the session.
  const std::vector<KeyLine>& in(std::uint8_t language);

 private:
  struct Made {
    bool isMade = false;
    std::uint8_t language = 0;
    std::uint64_t keysNamed = 0;  ///< KeyNames::changes
    bool operator==(const Made&) const = default;
  };
  KeysOf place_;
  Made made_;
  std::vector<KeyLine> lines_;
};

/// Returns the key of a command named as by `nameOf` (app/operator/command.h), such as "aberration",
/// "board-now" or "walls". Empty if it has no key.
KeyLine keyFor(KeysOf place, std::string_view what);

/// Returns the commands of the pressed keys, each computed from the settings after the previous ones. `now_s`
/// is the session time from which the arrow keys seek. Allocates only if a key is pressed.
Commands commandsOf(const WindowInput& input, KeysOf place, double now_s, const OperatorSettings& settings);

/// Prints the list of keys to standard error.
void sayKeys(KeysOf place);

}  // namespace carom
