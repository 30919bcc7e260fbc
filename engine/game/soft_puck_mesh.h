#pragma once
// The mesh of a soft puck.

#include "engine/game/billiard_setup.h"
#include "engine/soft/soft_mesh.h"

namespace carom {

/// Returns the mesh of a puck that is soft from the beginning, or the one that it has when it becomes soft.
SoftMesh softMeshOf(const Puck& puck);

}  // namespace carom
