#pragma once
// The operator's commands: from a key (app/input/keys.h), the console, or a button of a hand device. A
// command either changes the settings (`apply`), or is a one-time order that settings do not hold, such as
// seeking in a recording; the frame source executes those.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "app/operator/operator_settings.h"
#include "cave/texts/saying.h"

namespace carom {

struct SetSwitch {
  std::uint8_t Switches::*effect;
  bool beside;  ///< applies to the right half of the walls
  bool on;
  bool operator==(const SetSwitch&) const = default;
};
struct SetView {
  std::uint8_t TimeViews::*view;
  bool on;
  bool operator==(const SetView&) const = default;
};
/// Sets a wall option: black walls, swapped eyes, tracker crosses, latency overlay.
struct SetWalls {
  std::uint8_t WallControls::*option;
  bool on;
  bool operator==(const SetWalls&) const = default;
};
struct ShowOnWalls {
  Shown shown;
  bool operator==(const ShowOnWalls&) const = default;
};
struct ShowKeys {
  bool on;
  bool operator==(const ShowKeys&) const = default;
};
/// Shows the operator's console, or has it wait out of sight.
struct ShowConsole {
  bool on;
  bool operator==(const ShowConsole&) const = default;
};
struct SetEyeSeparation {
  double apart_m;
  bool operator==(const SetEyeSeparation&) const = default;
};
struct SetLightSpeed {
  double speed_m_s;
  bool operator==(const SetLightSpeed&) const = default;
};
/// Takes one of the choices that the lesson offers (app/operator/lesson.h): an answer or a velocity.
struct ChooseInLesson {
  int choice;  ///< counted from 1
  bool operator==(const ChooseInLesson&) const = default;
};
struct AdvanceLesson {
  bool operator==(const AdvanceLesson&) const = default;
};
/// Starts the scenario's tour.
struct StartTour {
  bool operator==(const StartTour&) const = default;
};
struct PlayScenario {
  std::string file;  ///< scenario file, played from its beginning
  bool afresh =
      false;  ///< a choice of the visitor: the same game, too, begins with all settings as at its start
  std::string
      recordTo{};  ///< session file that this game and those after it are written to; empty: as before
  std::optional<std::size_t> task{};  ///< with which of its tasks it begins; empty: the same, or the first
  bool operator==(const PlayScenario&) const = default;
};
/// Starts the session's first game anew, with every setting as the session began: for the next visitor.
struct WelcomeNextVisitor {
  bool operator==(const WelcomeNextVisitor&) const = default;
};
/// Keeps the energy with which a task was done, if it is the least so far.
struct KeepTaskBest {
  std::size_t task;
  double energy_j;
  bool operator==(const KeepTaskBest&) const = default;
};
/// Shows the visitor's best shot again, as they saw it.
struct ShowBestShot {
  bool isEnd = false;   ///< the game ends with it, if there is one
  bool isKept = false;  ///< only the moment at its end is shown, and kept as a picture
  bool operator==(const ShowBestShot&) const = default;
};
/// Lets a viewer read another of the session's languages.
struct SetLanguage {
  std::size_t viewer;
  std::uint8_t language;  ///< an index into SessionLanguages::all
  bool operator==(const SetLanguage&) const = default;
};
/// Tells the person in the room why what they asked for is not done.
struct TellPerson {
  texts::Saying words;
  bool operator==(const TellPerson&) const = default;
};
/// Leaves the game with the other room, or lets it be joined again.
struct SetLinked {
  bool on;
  bool operator==(const SetLinked&) const = default;
};
struct Pause {
  bool on;
  bool operator==(const Pause&) const = default;
};
struct SetRate {
  double rate;  ///< as in Playback::rate
  bool operator==(const SetRate&) const = default;
};
struct Seek {
  double session_s;  ///< session time to continue from
  bool operator==(const Seek&) const = default;
};

using Command =
    std::variant<SetSwitch, SetView, SetWalls, ShowOnWalls, ShowKeys, ShowConsole, SetEyeSeparation,
                 SetLightSpeed, ChooseInLesson, AdvanceLesson, StartTour, PlayScenario, WelcomeNextVisitor,
                 KeepTaskBest, ShowBestShot, SetLanguage, TellPerson, SetLinked, Pause, SetRate, Seek>;
using Commands = std::vector<Command>;

/// Applies the command to the settings. Returns false if nothing changes: the setting has that value already,
/// or the lesson has no such answer.
bool apply(const Command& command, OperatorSettings& settings);

/// Returns the lesson command for buttons of a hand device: the choice counted from 1 (0 is none), otherwise
/// "go on" if `onwards`.
std::optional<Command> lessonCommand(int choice, bool onwards);

/// Returns the last of the commands that is of type `Order`, or null if there is none.
template <typename Order>
const Order* lastOf(std::span<const Command> commands) {
  const Order* last = nullptr;
  for (const Command& command : commands) {
    if (const auto* order = std::get_if<Order>(&command)) last = order;
  }
  return last;
}

/// Returns the name of what the command sets: "aberration", "board-now", "walls".
std::string nameOf(const Command& command);

/// Returns the value that the command sets, such as "off". `settings` are those after the command was
/// applied; the lesson's state is read from them.
std::string valueOf(const Command& command, const OperatorSettings& settings);

/// Returns name and value: "aberration: off".
std::string toString(const Command& command, const OperatorSettings& settings);

}  // namespace carom
