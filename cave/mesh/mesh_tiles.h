#pragma once
// Makes tiles with all their levels from meshes that were built of patches (cave/mesh/mesh_builder.h).

#include <array>
#include <cstdint>
#include <functional>
#include <map>

#include <vtkPolyData.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/mesh/mesh_chunks.h"

namespace carom {

/// Returns whether MeshBuilder made the mesh.
bool hasPatches(vtkPolyData& mesh);

class MeshTiles {
 public:
  using Light = std::function<double(const MeshVertex&)>;
  /// Appends to `to`, which it keeps a reference to. `light` is what falls on a vertex, 1 being about as much
  /// as on the cloth under a lamp.
  MeshTiles(ChunkedMeshes& to, Light light);

  /// Appends the tiles of a mesh, each as one chunk, whose cells may be drawn as large as `largestCell_m`, in
  /// addition to what shape and light allow. Edges that tiles have in common, of this mesh or an earlier one,
  /// get one number.
  void append(vtkPolyData& mesh, double largestCell_m);

 private:
  struct Patch;
  using Key = std::array<long long, 9>;
  void appendTile(const Patch& patch, const glm::ivec2& corner, const glm::ivec2& cells,
                  double largestCell_m);
  struct EdgeOfTile;
  EdgeOfTile edgeOf(const Patch& patch, const glm::ivec2& from, const glm::ivec2& step, int cells);
  int coarsestOf(const Patch& patch, const glm::ivec2& corner, const glm::ivec2& cells) const;

  ChunkedMeshes& to_;
  Light light_;
  std::map<Key, std::uint32_t> edges_;
};

}  // namespace carom
