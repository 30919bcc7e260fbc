#pragma once
// Pucks and other moving bodies: built here, or read from a mesh file.

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/mesh/mesh_builder.h"
#include "cave/mesh/tessellation.h"
#include "cave/scene/scene_part.h"

namespace carom {

/// Returns a bevelled disc with its shadows on the cloth, in cells no larger than `cell_m`.
///
/// A shadow is old: light that would have lit the cloth beside the puck passed the puck's top, 2 cm higher,
/// at least 14 ms earlier. At 0.9 c the puck was then 18 mm further back, which is 10 pixels for a person 1.5
/// m away, so a disc straight below the puck would be wrong. While the puck moves straight, each lamp's
/// shadow moves with it, and the vertex shader (body_vert.glsl, `shadowed`) places it where it is, and where
/// it is seen. After a bounce the shadow follows the puck's centre at once, 14 ms too early.
std::vector<ScenePart> puckParts(double radius_m, double height_m, std::size_t body, const glm::vec3& colour,
                                 double cell_m = kAnyCell_m);

/// Returns a rod of 1 m along x, in bands of 10 cm.
ScenePart rodPart(std::size_t body, const glm::vec3& colour, double cell_m = kAnyCell_m);

/// Returns a mesh read from a file (cave/mesh/mesh_file.h), with the middle of its bounding box at the body's
/// centre. With `radius_m` > 0 it is scaled so that it just fits into a vertical cylinder of that radius.
ScenePart meshPart(const vtkSmartPointer<vtkPolyData>& read, double radius_m, std::size_t body,
                   const glm::vec3& colour, const Tessellation& tessellation);

/// Returns a mesh as it stands, in metres from the body's centre.
ScenePart surfacePart(const vtkSmartPointer<vtkPolyData>& mesh, std::size_t body, const glm::vec3& colour,
                      const Tessellation& tessellation);

}  // namespace carom
