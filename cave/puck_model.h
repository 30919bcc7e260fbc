#pragma once
// Pucks and other moving bodies: built here, or read from a mesh file.

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/scene.h"

namespace carom {

/// The colour (linear) for a body of this name; names that are no colours take one of a palette by `index`.
glm::vec3 colourOf(const std::string& name, std::size_t index);

/// A bevelled disc with its contact shadow.
std::vector<ScenePart> puckParts(double radius_m, double height_m, std::size_t body, const glm::vec3& colour);

/// A rod of 1 m along x, in bands of 10 cm.
ScenePart rodPart(std::size_t body, const glm::vec3& colour);

/// A mesh file (.obj .stl .ply .vtk .vtp), its box's middle at the body's centre. With `radius_m` > 0 it is
/// scaled so that it just fits a vertical cylinder of that radius. Throws std::runtime_error naming the file.
ScenePart meshPart(const std::string& path, double radius_m, std::size_t body, const glm::vec3& colour);

}  // namespace carom
