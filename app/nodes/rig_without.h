#pragma once
// A rig in which the walls of some nodes are left out, because their computers are.

#include <vector>

#include "app/rig/rig.h"

namespace carom {

/// Returns the rig without these nodes (ranks above 0) and their walls. The nodes after them move up, so that
/// ranks are consecutive; `missing` names those that were left out. Throws std::runtime_error if the rig has
/// no such node, or no wall is left.
Rig rigWithout(Rig rig, std::vector<int> nodes);

}  // namespace carom
