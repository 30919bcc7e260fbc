#pragma once
// Reads and checks what turns the pucks of a scenario file.

#include <vector>

#include "app/toml/findings.h"
#include "app/toml/toml_file.h"
#include "engine/game/billiard_setup.h"

namespace carom {

/// Returns the angular momentum of a puck, given as such or by how fast it turns; 0 if neither is there.
double readSpin(const TomlTable& table, const Puck& puck, double c_m_s);

/// Records a fault if a stroke passes beside the puck.
void checkOffset(const TomlTable& table, const Stroke& stroke, const Puck& puck);

/// Return findings about an unusual spin of a puck, which has a mesh or not, and about friction.
std::vector<Finding> oddSpin(const TomlTable& table, const Puck& puck, bool hasMesh, double c_m_s);
std::vector<Finding> oddFriction(const TomlTable& physics, const PhysicsRules& rules);

}  // namespace carom
