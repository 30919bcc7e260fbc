#include "cave/mesh/mesh_chunks.h"

#include <algorithm>
#include <array>
#include <future>
#include <limits>
#include <span>

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/mesh_input/polygons.h"

namespace carom {
namespace {

/// A triangle by its corners' numbers in the mesh, and the sum of its corners' places.
struct Triangle {
  std::array<std::uint32_t, 3> corners;
  glm::vec3 sum_m;
};

glm::vec3 tupleOf(vtkDataArray* array, vtkIdType i) {
  if (!array || array->GetNumberOfComponents() != 3) return glm::vec3(0.0F);
  std::array<double, 3> tuple{};
  array->GetTuple(i, tuple.data());
  return {tuple[0], tuple[1], tuple[2]};
}

/// Returns the light that reaches a point: all of it, unless the mesh says otherwise.
std::array<std::uint8_t, 4> litAt(vtkDataArray* array, vtkIdType i) {
  std::array<std::uint8_t, 4> lit{255, 255, 255, 255};
  if (!array || array->GetNumberOfComponents() != 4) return lit;
  for (int k = 0; k < 4; ++k)
    lit[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(array->GetComponent(i, k));
  return lit;
}

/// Returns the triangles of the mesh; polygons with more corners are cut into fans.
std::vector<Triangle> trianglesOf(vtkPolyData& mesh) {
  std::vector<Triangle> triangles;
  triangles.reserve(static_cast<std::size_t>(mesh.GetNumberOfPolys()));
  vtkDataArray* const places = mesh.GetPoints() ? mesh.GetPoints()->GetData() : nullptr;
  forEachPolygon(*mesh.GetPolys(), [&](std::span<const vtkIdType> corners) {
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const std::array<vtkIdType, 3> fan{corners[0], corners[i - 1], corners[i]};
      Triangle triangle{{}, glm::vec3(0.0F)};
      for (std::size_t k = 0; k < 3; ++k) {
        triangle.corners[k] = static_cast<std::uint32_t>(fan[k]);
        triangle.sum_m += tupleOf(places, fan[k]);
      }
      triangles.push_back(triangle);
    }
  });
  return triangles;
}

/// Orders triangles so that those of each chunk lie together, by halving them along the longest side of their
/// box, and returns them. Halves of many are ordered at once.
std::vector<std::span<Triangle>> chunksOf(std::span<Triangle> triangles) {
  constexpr std::size_t kMany = 200000;
  if (triangles.empty()) return {};
  if (triangles.size() <= kChunkTriangles) {
    // Neighbours in the mesh are neighbours in memory again, and share vertices soon.
    std::sort(triangles.begin(), triangles.end(),
              [](const Triangle& a, const Triangle& b) { return a.corners < b.corners; });
    return {triangles};
  }
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  for (const Triangle& triangle : triangles) {
    low = glm::min(low, triangle.sum_m);
    high = glm::max(high, triangle.sum_m);
  }
  const glm::vec3 size = high - low;
  const int along = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t half = triangles.size() / 2;
  // Where places are equal the numbers decide, so that the order does not depend on the library.
  std::nth_element(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(half), triangles.end(),
                   [along](const Triangle& a, const Triangle& b) {
                     if (a.sum_m[along] != b.sum_m[along]) return a.sum_m[along] < b.sum_m[along];
                     return a.corners < b.corners;
                   });
  auto second = std::async(triangles.size() > kMany ? std::launch::async : std::launch::deferred, chunksOf,
                           triangles.subspan(half));
  std::vector<std::span<Triangle>> chunks = chunksOf(triangles.first(half));
  const std::vector<std::span<Triangle>> others = second.get();
  chunks.insert(chunks.end(), others.begin(), others.end());
  return chunks;
}

/// Returns the sphere around the box of these vertices.
MeshChunk chunkAround(const ChunkedMeshes& meshes, std::size_t firstIndex) {
  const std::span<const std::uint32_t> indices = std::span(meshes.indices).subspan(firstIndex);
  glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
  for (const std::uint32_t i : indices) {
    low = glm::min(low, glm::dvec3(meshes.vertices[i].place_m));
    high = glm::max(high, glm::dvec3(meshes.vertices[i].place_m));
  }
  MeshChunk chunk{static_cast<std::uint32_t>(firstIndex), static_cast<std::uint32_t>(indices.size()), 0,
                  0.5 * (low + high), 0.0};
  for (const std::uint32_t i : indices) {
    const glm::dvec3 place_m(meshes.vertices[i].place_m);
    chunk.radius_m = std::max(chunk.radius_m, glm::distance(place_m, chunk.middle_m));
  }
  return chunk;
}

}  // namespace

MeshVertex vertexOf(vtkPolyData& mesh, vtkIdType i) {
  vtkPointData& data = *mesh.GetPointData();
  return {tupleOf(mesh.GetPoints()->GetData(), i), tupleOf(data.GetNormals(), i),
          tupleOf(data.GetArray("surface"), i), litAt(data.GetArray("lit"), i)};
}

void appendChunks(vtkPolyData& mesh, ChunkedMeshes& to) {
  constexpr auto kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<Triangle> triangles = trianglesOf(mesh);
  std::vector<std::uint32_t> numbers(static_cast<std::size_t>(mesh.GetNumberOfPoints()), kUnused);
  to.vertices.reserve(to.vertices.size() + numbers.size());
  to.indices.reserve(to.indices.size() + 3 * triangles.size());
  for (const std::span<const Triangle> chunk : chunksOf(triangles)) {
    const std::size_t firstIndex = to.indices.size();
    for (const Triangle& triangle : chunk) {
      for (const std::uint32_t corner : triangle.corners) {
        if (numbers[corner] == kUnused) {
          numbers[corner] = static_cast<std::uint32_t>(to.vertices.size());
          to.vertices.push_back(vertexOf(mesh, corner));
        }
        to.indices.push_back(numbers[corner]);
      }
    }
    to.chunks.push_back(chunkAround(to, firstIndex));
  }
}

}  // namespace carom
