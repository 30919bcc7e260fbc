#pragma once
// Pucks and other moving bodies: built here, or read from a mesh file.

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/mesh/mesh_builder.h"
#include "cave/mesh/tessellation.h"
#include "cave/scene/scene_part.h"

namespace carom {

/// A bevelled disc with its shadows on the cloth, in cells no larger than `cell_m`.
///
/// A shadow is old: light that would have lit the cloth beside the puck passed the puck's top, 2 cm higher,
/// 14 ms or more before, when at 0.9 c the puck was 18 mm further back: 10 pixels to someone 1.5 m away. So
/// no disc under the puck is right. While the puck goes straight, each lamp's shadow goes with it, and the
/// vertex shader (body_vert.glsl, `shadowed`) puts it where it is, and where it is seen. After a bounce it
/// follows its centre at once, 14 ms too early.
std::vector<ScenePart> puckParts(double radius_m, double height_m, std::size_t body, const glm::vec3& colour,
                                 double cell_m = kAnyCell_m);

/// A rod of 1 m along x, in bands of 10 cm.
ScenePart rodPart(std::size_t body, const glm::vec3& colour, double cell_m = kAnyCell_m);

/// A mesh read from a file (cave/mesh/mesh_file.h), its box's middle at the body's centre. With `radius_m` >
/// 0 it is scaled so that it just fits a vertical cylinder of that radius.
ScenePart meshPart(const vtkSmartPointer<vtkPolyData>& read, double radius_m, std::size_t body,
                   const glm::vec3& colour, const Tessellation& tessellation);

}  // namespace carom
