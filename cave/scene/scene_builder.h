#pragma once
// Builds the scene of a game: hall, table, pucks and scripted bodies, divided finely enough for bent light.

#include <span>

#include <glm/vec3.hpp>

#include "cave/mesh/tessellation.h"
#include "cave/scene/scene.h"
#include "cave/scene/scene_part.h"
#include "engine/billiard/billiard.h"

namespace carom {

/// Uses the board of `setup`, and of its pucks only their masses and whether they are or can
/// become soft. Throws InputError
/// (engine/text/input_error.h) if a mesh file is faulty.
Scene buildScene(const BilliardSetup& setup, std::span<const BodyLooks> pucks,
                 std::span<const BodyLooks> told = {}, const Hall& hall = {},
                 const Tessellation& tessellation = {});

/// Returns the ruler for a person on the side of `person_m`: halfway to the rail nearest to them or, without
/// a board, 1 m from the origin.
Ruler rulerBeside(const BilliardSetup& setup, const glm::dvec3& person_m);

}  // namespace carom
