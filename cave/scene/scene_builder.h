#pragma once
// Builds the scene of a game: hall, table, pucks and bodies that move as told, divided finely enough for bent
// light.

#include <span>

#include <glm/vec3.hpp>

#include "cave/mesh/tessellation.h"
#include "cave/scene/scene.h"
#include "cave/scene/scene_part.h"
#include "engine/billiard/billiard.h"

namespace carom {

/// Of `setup` only the board is looked at. Throws InputError (engine/base/input_error.h) for a mesh file at
/// fault.
Scene buildScene(const BilliardSetup& setup, std::span<const BodyLooks> pucks,
                 std::span<const BodyLooks> told = {}, const Hall& hall = {},
                 const Tessellation& tessellation = {});

/// The ruler halfway to the near rail of someone who stands on the side of `person_m`; without a board, 1 m
/// from its origin.
Ruler rulerBeside(const BilliardSetup& setup, const glm::dvec3& person_m);

}  // namespace carom
