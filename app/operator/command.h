#pragma once
// What the operator can ask for: by a key (app/input/keys.h), in the console, by a button of a hand's device. A
// command changes the settings (`apply`) or is an order of one moment, such as a place to go to in a recording,
// which settings do not hold: then the source of the frames obeys it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "app/operator/operator_settings.h"

namespace carom {

struct SetSwitch {
  std::uint8_t Switches::*effect;
  bool beside;  ///< of the right half of the walls
  bool on;
  bool operator==(const SetSwitch&) const = default;
};
struct SetView {
  std::uint8_t TimeViews::*view;
  bool on;
  bool operator==(const SetView&) const = default;
};
/// Black walls, swapped eyes, the trackers' crosses, the latency.
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
struct SetEyeSeparation {
  double apart_m;
  bool operator==(const SetEyeSeparation&) const = default;
};
struct SetLightSpeed {
  double speed_m_s;
  bool operator==(const SetLightSpeed&) const = default;
};
struct AnswerLesson {
  int answer;  ///< from 1
  bool operator==(const AnswerLesson&) const = default;
};
struct AdvanceLesson {
  bool operator==(const AdvanceLesson&) const = default;
};
/// Sets out on the scenario's own drive.
struct StartTour {
  bool operator==(const StartTour&) const = default;
};
struct PlayScenario {
  std::string file;  ///< the one that is played: from its beginning
  bool operator==(const PlayScenario&) const = default;
};
struct Pause {
  bool on;
  bool operator==(const Pause&) const = default;
};
struct SetRate {
  double rate;  ///< as Playback::rate
  bool operator==(const SetRate&) const = default;
};
struct Seek {
  double session_s;  ///< the session's time to go on from
  bool operator==(const Seek&) const = default;
};

using Command =
    std::variant<SetSwitch, SetView, SetWalls, ShowOnWalls, ShowKeys, SetEyeSeparation, SetLightSpeed,
                 AnswerLesson, AdvanceLesson, StartTour, PlayScenario, Pause, SetRate, Seek>;
using Commands = std::vector<Command>;

/// Has the command take effect. Returns false if it changes nothing: everything is so already, there is no such answer.
bool apply(const Command& command, OperatorSettings& settings);

/// Returns what buttons of a hand's device say to a lesson: an answer from 1 (0: none), else "go on".
std::optional<Command> lessonCommand(int answer, bool onwards);

/// Returns the last of the commands that is an order of this kind; null if there is none.
template <typename Order>
const Order* lastOf(std::span<const Command> commands) {
  const Order* last = nullptr;
  for (const Command& command : commands) {
    if (const auto* order = std::get_if<Order>(&command)) last = order;
  }
  return last;
}

/// Returns the name of what the command is about: "aberration", "board-now", "walls".
std::string nameOf(const Command& command);

/// Returns what it is about that becomes: "off". `settings`: after it was applied; a lesson's place is told from there.
std::string valueOf(const Command& command, const OperatorSettings& settings);

/// Returns both: "aberration: off".
std::string toString(const Command& command, const OperatorSettings& settings);

}  // namespace carom
