#pragma once
// What the buttons on the front wall command.

#include <cstddef>
#include <optional>

#include "app/operator/command.h"
#include "cave/frame/wall_action.h"

namespace carom {

/// Returns the command of a button that a viewer presses. None for the way home, which is no command but a
/// wish of the drive, and for the ground between buttons.
std::optional<Command> commandOf(const WallAction& action, const OperatorSettings& settings,
                                 std::size_t viewer = 0);

}  // namespace carom
