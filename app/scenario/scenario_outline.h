#pragma once
// Reads and checks the corners of a puck in a scenario file.

#include <optional>
#include <vector>

#include "app/scenario/scenario.h"
#include "app/toml/toml_file.h"
#include "engine/game/billiard_setup.h"

namespace carom {

/// Reads `radius_m`, `outline_m` or `outline = "mesh"` with the radius and, where the file gives none, the
/// inertia that follow from an outline. A mesh whose footprint is the outline gets its place. Where a fault
/// leaves the shape unknown, the radius stays 0.
void readShape(const TomlTable& table, Puck& puck, std::optional<PuckMesh>& mesh);

/// Returns findings about an unusual outline of a puck.
std::vector<Finding> oddOutline(const TomlTable& table, const Puck& puck,
                                const std::optional<PuckMesh>& mesh);

}  // namespace carom
