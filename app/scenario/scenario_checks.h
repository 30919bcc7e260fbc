#pragma once
// Checks of a scenario that involve several values, after each value has been checked by itself.

#include <vector>

#include "app/scenario/scenario.h"
#include "app/toml/toml_file.h"

namespace carom {

/// Reports duplicate names.
void checkNames(const std::vector<TomlTable>& pucks, const std::vector<TomlTable>& bodies,
                const std::vector<TomlTable>& flashes, const std::vector<TomlTable>& pulses);

/// Reports pucks that overlap or reach over a cushion at t = 0. `tables` are those of the pucks.
void checkPlaces(const BilliardSetup& setup, const std::vector<TomlTable>& tables);

/// Reports friction too strong for a puck: under friction its points stay slower than light only while R a <
/// c²/2.
void checkFriction(const BilliardSetup& setup, const TomlTable& physics);

/// Reports faults that only the simulation can find.
void checkPlayable(const BilliardSetup& setup, const TomlTable& root);

}  // namespace carom
