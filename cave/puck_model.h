#pragma once
// Pucks and other moving bodies: built here, or read from a mesh file.

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/mesh_builder.h"
#include "cave/scene.h"

namespace carom {

/// The colour (linear) for a body of this name; names that are no colours take one of a palette by `index`.
glm::vec3 colourOf(const std::string& name, std::size_t index);

/// A bevelled disc with its contact shadow, in cells no larger than `cell_m`.
std::vector<ScenePart> puckParts(double radius_m, double height_m, std::size_t body, const glm::vec3& colour,
                                 double cell_m = kAnyCell_m);

/// A rod of 1 m along x, in bands of 10 cm.
ScenePart rodPart(std::size_t body, const glm::vec3& colour, double cell_m = kAnyCell_m);

/// A mesh read from a file (cave/mesh_file.h), its box's middle at the body's centre. With `radius_m` > 0 it
/// is scaled so that it just fits a vertical cylinder of that radius.
ScenePart meshPart(const vtkSmartPointer<vtkPolyData>& read, double radius_m, std::size_t body,
                   const glm::vec3& colour, const Tessellation& tessellation);

}  // namespace carom
