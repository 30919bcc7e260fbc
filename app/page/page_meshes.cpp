#include "app/page/page_meshes.h"

#include <array>
#include <map>
#include <span>

#include "cave/bodies/visible_chunks.h"
#include "cave/mesh/mesh_chunks.h"

namespace carom {
namespace {

/// Returns the mesh of chunks that are no tiles, with the vertices that it uses.
PageMesh meshOf(const ChunkedMeshes& all, const PartChunks& part) {
  PageMesh mesh;
  std::map<std::uint32_t, std::uint32_t> own;
  for (const MeshChunk& chunk : std::span(all.chunks).subspan(part.first, part.count)) {
    for (const std::uint32_t i : std::span(all.indices).subspan(chunk.firstIndex, chunk.indexCount)) {
      const auto [found, isNew] = own.try_emplace(i, static_cast<std::uint32_t>(mesh.vertices.size()));
      if (isNew) mesh.vertices.push_back(all.vertices[i]);
      mesh.indices.push_back(found->second);
    }
  }
  return mesh;
}

/// Appends a tile whose cells are each divided into parts × parts.
void appendTile(const ChunkedMeshes& all, const SurfaceTile& tile, int parts, PageMesh& mesh) {
  const std::uint32_t row = static_cast<std::uint32_t>(tile.cells[0]) + 1;
  for (int v = 0; v < tile.cells[1]; ++v) {
    for (int u = 0; u < tile.cells[0]; ++u) {
      const MeshVertex* const corner =
          &all.tileVertices[tile.firstVertex + static_cast<std::uint32_t>(v) * row +
                            static_cast<std::uint32_t>(u)];
      const VertexGrid grid{static_cast<std::uint32_t>(mesh.vertices.size()), {parts, parts}};
      appendVertices({corner, corner + 1, corner + row, corner + row + 1}, parts, mesh.vertices);
      appendTriangles(grid, 0, {0, 0, 0, 0}, mesh.indices);
    }
  }
}

PageMesh tilesOf(const ChunkedMeshes& all, const PartChunks& part, int parts) {
  PageMesh mesh;
  for (const MeshChunk& chunk : std::span(all.chunks).subspan(part.first, part.count))
    appendTile(all, all.tiles[chunk.tile], parts, mesh);
  return mesh;
}

std::size_t cellsOf(const SceneChunks& scene) {
  std::size_t cells = 0;
  for (const SurfaceTile& tile : scene.meshes.tiles)
    cells += static_cast<std::size_t>(tile.cells[0]) * static_cast<std::size_t>(tile.cells[1]);
  return cells;
}

}  // namespace

PageMeshes pageMeshes(const Scene& scene, std::size_t mostResting) {
  const SceneChunks chunks(scene);
  const std::size_t cells = cellsOf(chunks);
  const auto verticesAt = [cells](int parts) {
    return cells * static_cast<std::size_t>(parts + 1) * static_cast<std::size_t>(parts + 1);
  };
  int parts = 1;
  while (parts < kMostParts && verticesAt(2 * parts) <= mostResting) parts *= 2;
  PageMeshes made;
  std::map<std::uint32_t, std::size_t> meshAt;  // by the first chunk
  for (std::size_t number = 0; number < scene.parts.size(); ++number) {
    const PartChunks& part = chunks.parts[number];
    if (part.count == 0) continue;
    const auto [found, isNew] = meshAt.try_emplace(part.first, made.meshes.size());
    if (isNew)
      made.meshes.push_back(part.tiled ? tilesOf(chunks.meshes, part, parts) : meshOf(chunks.meshes, part));
    made.parts.push_back({number, found->second});
  }
  return made;
}

}  // namespace carom
