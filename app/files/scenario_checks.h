#pragma once
// What can be checked of a scenario once every value by itself is right.

#include <vector>

#include "app/files/scenario.h"
#include "app/files/toml_file.h"

namespace carom {

/// Complains of a name that is taken.
void checkNames(const std::vector<TomlTable>& pucks, const std::vector<TomlTable>& bodies,
                const std::vector<TomlTable>& flashes, const std::vector<TomlTable>& pulses);

/// Complains of pucks that overlap or reach over a cushion at t = 0. `tables`: the pucks'.
void checkPlaces(const BilliardSetup& setup, const std::vector<TomlTable>& tables);

/// Under friction the points of a puck stay slower than light only while R a < c²/2.
void checkFriction(const BilliardSetup& setup, const TomlTable& physics);

/// What only the game itself can tell.
void checkPlayable(const BilliardSetup& setup, const TomlTable& root);

}  // namespace carom
