#pragma once
// Meshes seen from above.

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace carom {

/// Returns the corners of the triangles of a mesh file (cave/mesh_input/mesh_file.h) in x and y, three for
/// each. Throws InputError.
std::vector<glm::dvec2> trianglesFromAbove(const std::string& path);

}  // namespace carom
