#pragma once
// Reads the soft pucks of a scenario file.

#include <string>
#include <vector>

#include "app/scenario/scenario.h"
#include "app/scenario/scenario_bodies.h"
#include "app/toml/toml_file.h"

namespace carom {

/// Reads [puck.soft], if the puck has it, but for the bodies that hold its sides.
void readSoft(const TomlTable& table, Puck& puck);

/// Gives the soft pucks the motions of the bodies that hold them, and reports those that they cannot have.
/// `tables` are those of the pucks.
void holdSides(BilliardSetup& setup, const std::vector<TomlTable>& tables, std::vector<BodyText>& bodies);

/// Reports friction, corners and spins that cannot be beside soft pucks. `physics` may be none.
void checkSoft(const BilliardSetup& setup, const std::vector<TomlTable>& tables, const TomlTable* physics);

/// Returns findings about unusual soft pucks.
std::vector<Finding> oddSoft(const BilliardSetup& setup, const std::vector<TomlTable>& tables);

/// Returns the warning about a puck that could not be followed.
std::string crushedText(const std::string& puck, double t_s);

}  // namespace carom
