#pragma once
// The scene of a game as a page in a browser has it: its meshes, fine enough for bent light, with their
// light.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/mesh/mesh_vertex.h"
#include "cave/scene/scene.h"

namespace carom {

/// A mesh; each three indices are a triangle.
struct PageMesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;
};

struct PagePart {
  std::size_t part = 0;  ///< of the scene
  std::size_t mesh = 0;
};

struct PageMeshes {
  std::vector<PageMesh> meshes;
  std::vector<PagePart> parts;  ///< in the order in which they are drawn
};

/// Returns the scene's meshes, each once. What rests is divided as it was built, and finer while all of it
/// together has no more than `mostResting` vertices.
PageMeshes pageMeshes(const Scene& scene, std::size_t mostResting);

}  // namespace carom
