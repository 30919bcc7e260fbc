#include "cave/mesh/mesh_chunks.h"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "cave/mesh/mesh_builder.h"

namespace carom {
namespace {

vtkSmartPointer<vtkPolyData> wavyPatch(int cells) {
  MeshBuilder builder;
  builder.addPatch(cells, cells, [](double u, double v) {
    return PatchPoint{{4.0 * u, 3.0 * v, 0.2 * std::sin(9.0 * u + 5.0 * v)}, {u, v, 0.5}};
  });
  return builder.build();
}

using CornerNumbers = std::array<float, 9>;  // place, normal, data for painting
using TriangleNumbers = std::array<CornerNumbers, 3>;

CornerNumbers cornerOf(const MeshVertex& v) {
  return {v.place_m.x, v.place_m.y, v.place_m.z, v.normal.x, v.normal.y,
          v.normal.z,  v.surface.x, v.surface.y, v.surface.z};
}

std::vector<TriangleNumbers> sortedTriangles(std::vector<TriangleNumbers> triangles) {
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

TEST(MeshChunks, EveryTriangleIsInOneChunkAndInItsSphere) {
  const auto mesh = wavyPatch(60);
  ChunkedMeshes meshes;
  appendChunks(*wavyPatch(3), meshes);  // an earlier mesh must not mix with it
  const std::size_t before = meshes.chunks.size();
  appendChunks(*mesh, meshes);
  std::vector<TriangleNumbers> kept, given;
  std::uint32_t next = meshes.chunks[before].firstIndex;
  for (const MeshChunk& chunk : std::span(meshes.chunks).subspan(before)) {
    EXPECT_EQ(chunk.firstIndex, next);
    next += chunk.indexCount;
    EXPECT_LE(chunk.indexCount, 3 * kChunkTriangles);
    EXPECT_GE(chunk.indexCount, 3 * kChunkTriangles / 2 - 3);
    EXPECT_LT(chunk.radius_m, 0.8) << "its triangles lie together";
    for (std::uint32_t i = 0; i < chunk.indexCount; i += 3) {
      TriangleNumbers corners;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const MeshVertex& vertex = meshes.vertices[meshes.indices[chunk.firstIndex + i + k]];
        EXPECT_LE(glm::distance(glm::dvec3(vertex.place_m), chunk.middle_m), chunk.radius_m);
        corners[k] = cornerOf(vertex);
      }
      kept.push_back(corners);
    }
  }
  EXPECT_EQ(next, meshes.indices.size());
  const auto tuple = [](vtkDataArray& array, vtkIdType i) {
    return glm::vec3(array.GetComponent(i, 0), array.GetComponent(i, 1), array.GetComponent(i, 2));
  };
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i) {
    TriangleNumbers corners;
    for (int k = 0; k < 3; ++k) {
      const vtkIdType id = mesh->GetCell(i)->GetPointId(k);
      corners[static_cast<std::size_t>(k)] =
          cornerOf({tuple(*mesh->GetPoints()->GetData(), id), tuple(*mesh->GetPointData()->GetNormals(), id),
                    tuple(*mesh->GetPointData()->GetArray("surface"), id)});
    }
    given.push_back(corners);
  }
  EXPECT_TRUE(sortedTriangles(kept) == sortedTriangles(given));
}

TEST(MeshChunks, TheSameMeshGivesTheSameChunks) {
  ChunkedMeshes a, b;
  appendChunks(*wavyPatch(40), a);
  appendChunks(*wavyPatch(40), b);
  EXPECT_EQ(a.indices, b.indices);
  EXPECT_EQ(a.chunks.size(), b.chunks.size());
}

TEST(MeshChunks, WithoutTrianglesThereAreNoChunks) {
  ChunkedMeshes meshes;
  appendChunks(*vtkSmartPointer<vtkPolyData>::New(), meshes);
  EXPECT_TRUE(meshes.chunks.empty());
  EXPECT_TRUE(meshes.vertices.empty());
}

}  // namespace
}  // namespace carom
