#pragma once
// Meshes as they are drawn: vertices and triangles in two arrays, in chunks of triangles that lie together,
// so that what a wall cannot show need not be drawn.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <vtkPolyData.h>
#include <glm/vec3.hpp>

#include "cave/mesh/mesh_vertex.h"
#include "cave/mesh/surface_tiles.h"

namespace carom {

/// A run of triangles or a tile, and a sphere around them in the body's rest frame.
struct MeshChunk {
  std::uint32_t firstIndex = 0;
  std::uint32_t indexCount = 0;  ///< 0 of a tile
  std::uint32_t tile = 0;        ///< the number of the tile, if it is one
  glm::dvec3 middle_m{0.0};
  double radius_m = 0.0;
};

/// Chunks of one mesh after another. Each three indices are a triangle of `vertices`.
struct ChunkedMeshes {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<MeshChunk> chunks;
  std::vector<SurfaceTile> tiles;
  std::vector<MeshVertex> tileVertices;
  std::vector<TileEdge> edges;  ///< of the tiles
};

/// Returns a point of a mesh with its normal and its tuples of the arrays "surface" and "lit"; where the mesh
/// lacks them, they are 0 and all light.
MeshVertex vertexOf(vtkPolyData& mesh, vtkIdType i);

/// The most triangles of a chunk; chunks of larger meshes have at least half as many. Smaller ones leave out
/// more unseen triangles, and cost more to test.
inline constexpr std::size_t kChunkTriangles = 256;

/// Appends a mesh. Points that no triangle uses are left out. The order depends on the mesh alone.
void appendChunks(vtkPolyData& mesh, ChunkedMeshes& to);

}  // namespace carom
