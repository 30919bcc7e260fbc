#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "cave/mesh_files/mesh_bytes.h"
#include "cave/mesh_files/mesh_lines.h"
#include "cave/mesh_files/warp_grid.h"
#include "cave/warps/warp_formats.h"

namespace carom {
namespace {

/// Reads x y z u v w.
WarpPoint pointOf(MeshBytes& bytes, std::size_t index) {
  std::array<float, 6> values{};
  for (float& value : values) {
    const std::size_t at = bytes.at();
    value = bytes.number();
    if (!(std::abs(value) <= kFarthestInWindow))
      meshFault(1, 1,
                fmt::format("vertex {} has {}, at byte {}, expected a number from {} to {}", index, value, at,
                            -kFarthestInWindow, kFarthestInWindow));
  }
  return {.inWindow = {values[0], 1.0F - values[1]}, .inPicture = {values[3], values[4]}};
}

/// Adds the triangles of a list or strip.
void addIndexed(const std::vector<std::uint32_t>& indices, WarpMesh& mesh) {
  const bool isList = indices.size() % 3 == 0;
  for (std::size_t i = 0; i + 2 < indices.size(); i += isList ? 3 : 1) {
    const std::array<std::uint32_t, 3> corners{indices[i], indices[i + 1], indices[i + 2]};
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
      mesh.triangles.push_back(corners);
  }
}

}  // namespace

Warp parseSgcWarp(std::string_view content) {
  constexpr int kAngles = 11;  // of the projector's frustum, which the corners of the wall say
  constexpr std::size_t kVertex_bytes = 24, kIndex_bytes = 4;
  MeshBytes bytes(content);
  if (!content.starts_with("SGC")) meshFault(1, 1, "this is no mesh of SCISS, expected SGC at its beginning");
  bytes.take(3);
  const int version = bytes.byte();
  if (version != 1 && version != 2)
    meshFault(1, 4, fmt::format("the file is of version {}, expected 1 or 2", version));
  if (const std::uint32_t type = bytes.whole(); type != 0)
    meshFault(1, 5, fmt::format("the mesh is of type {}, expected 0, of a flat picture", type));
  for (int i = 0; i < kAngles; ++i) bytes.number();
  const std::size_t columns = bytes.whole(), second = bytes.whole();
  const bool isGrid = version == 1;
  // The product cannot overflow: each factor is under 2^32.
  const std::size_t count = isGrid ? columns * second : second;
  if ((isGrid && (columns < 2 || second < 2)) || count < 3 || count > bytes.left() / kVertex_bytes)
    meshFault(
        1, 1,
        fmt::format("{} vertices are told at byte 52, and {} bytes follow, expected as many vertices of {} "
                    "bytes, in two rows and columns at least",
                    count, bytes.left(), kVertex_bytes));
  WarpMesh mesh;
  mesh.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) mesh.points.push_back(pointOf(bytes, i));
  const std::size_t indexCount = bytes.whole();
  if (indexCount * kIndex_bytes != bytes.left())
    meshFault(1, 1,
              fmt::format("{} indices are told at byte {}, and {} bytes follow, expected {}", indexCount,
                          bytes.at() - kIndex_bytes, bytes.left(), indexCount * kIndex_bytes));
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < indexCount; ++i) {
    indices.push_back(bytes.whole());
    if (indices.back() >= count)
      meshFault(1, 1,
                fmt::format("index {} at byte {} is none of the {} vertices, expected one of them",
                            indices.back(), bytes.at() - kIndex_bytes, count));
  }
  if (isGrid)
    addGridTriangles(columns, second, mesh);  // its indices are strips of the same cells
  else
    addIndexed(indices, mesh);
  if (mesh.triangles.empty()) meshFault(1, 1, "there is no triangle, expected one at least");
  return {mesh, mesh};
}

}  // namespace carom
