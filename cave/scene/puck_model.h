#pragma once
// Pucks and other moving bodies: built here, or read from a mesh file.

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/mesh/mesh_builder.h"
#include "cave/mesh/tessellation.h"
#include "cave/scene/scene_part.h"

namespace carom {

/// Returns a bevelled disc with its shadows on the cloth (cave/scene/shadow_model.h), in cells no larger than
/// `cell_m`.
std::vector<ScenePart> puckParts(double radius_m, double height_m, std::size_t body, const glm::vec3& colour,
                                 double cell_m = kAnyCell_m);

/// Returns a rod of 1 m along x, in bands of 10 cm.
ScenePart rodPart(std::size_t body, const glm::vec3& colour, double cell_m = kAnyCell_m);

/// Returns a mesh read from a file (cave/mesh_input/mesh_file.h), with the middle of its bounding box at the
/// body's centre. With `radius_m` > 0 it is scaled so that it just fits into a vertical cylinder of that
/// radius. With `place` it lies and is scaled as that says.
ScenePart meshPart(const vtkSmartPointer<vtkPolyData>& read, double radius_m, std::size_t body,
                   const glm::vec3& colour, const Tessellation& tessellation,
                   const std::optional<MeshPlace>& place = {});

/// Paints a mesh, which fits into a cylinder of this radius, in an even number of sectors around the z axis.
void paintSectors(ScenePart& part, int sectors, double radius_m);

/// The linear colour of wooden bodies.
inline constexpr glm::vec3 kPineColour{0.40F, 0.24F, 0.11F};

/// Gives a mesh the surface of a material, in its colour.
void paintMaterial(ScenePart& part, Material material);

/// Returns a mesh as it stands, in metres from the body's centre.
ScenePart surfacePart(const vtkSmartPointer<vtkPolyData>& mesh, std::size_t body, const glm::vec3& colour,
                      const Tessellation& tessellation);

}  // namespace carom
