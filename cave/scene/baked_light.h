#pragma once
// The light of what rests on the board, computed once: which of the lamps each vertex of table and hall sees,
// and how much of the hall around it is open. Lamps, hall and table rest in one frame, so none of this
// depends on the eye, and a frame costs no more for it. Pucks have shadows of their own
// (cave/bodies/shaders/body_vert.glsl).

#include <cstdint>
#include <span>

#include "cave/scene/scene.h"

namespace carom {

/// Adds a point array "lit" to the meshes of the scene's resting parts: four bytes, the share of each lamp's
/// disc that the vertex sees, and the share of the hall's light that reaches it. `scene.casters` throw the
/// shadows. The same scene gets the same bytes on every machine. Throws std::runtime_error if Embree cannot
/// begin.
void bakeLight(Scene& scene);

/// Returns whether the part rests and is lit.
bool isLit(const ScenePart& part);

/// Adds the point array "lit" to a mesh and returns its bytes, to be set.
std::span<std::uint8_t> addLit(vtkPolyData& mesh);

}  // namespace carom
