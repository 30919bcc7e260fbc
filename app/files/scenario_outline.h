#pragma once
// Reads and checks the corners of a puck in a scenario file.

#include <vector>

#include "app/files/toml_file.h"
#include "engine/billiard/billiard_setup.h"

namespace carom {

/// Reads `radius_m`, or `outline_m` with the radius and, where the file gives none, the inertia that follow from it.
void readShape(const TomlTable& table, Puck& puck);

/// Returns what is unusual about the outline of a puck.
std::vector<Finding> oddOutline(const TomlTable& table, const Puck& puck);

}  // namespace carom
