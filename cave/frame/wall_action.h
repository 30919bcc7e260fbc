#pragma once
// What a press on a button of the front wall asks for.

#include <cstdint>

#include "cave/record/choice.h"

namespace carom {

struct WallAction {
  enum class Kind : std::uint8_t {
    none,       ///< nothing: the ground between buttons
    choice,     ///< `number` is that of a Choice
    choose,     ///< an answer or a velocity of the lesson, counted from 1 by `number`
    goOn,       ///< as Enter: skip, explanation, back to the scene, best shot
    again,      ///< as Y
    home,       ///< as Home
    unfreeze,   ///< as F in a frozen view
    keys,       ///< as H
    spacetime,  ///< as I
    tasks,      ///< begins the tasks
    nextTask,   ///< goes on to the next one
    effect,     ///< as 1 to 5: turns the effect that `number` counts in kNamedSwitches, from 0
    keepShot,   ///< keeps a picture of the best shot
    language,   ///< goes on to the session's language that `number` counts, from 0
  };
  Kind kind = Kind::none;
  std::uint8_t number = 0;

  bool operator==(const WallAction&) const = default;
};

/// What a game offers on the front wall.
struct GameOffers {
  bool choices = false, hasTable = false, hasTasks = false;  ///< `hasTable`: there is one to come home to
};

constexpr WallAction actionOf(Choice choice) {
  return {WallAction::Kind::choice, static_cast<std::uint8_t>(choice)};
}

}  // namespace carom
