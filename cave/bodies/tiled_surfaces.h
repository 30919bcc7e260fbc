#pragma once
// Chooses how finely the tiles of what rests are drawn for one eye on one wall: as coarsely as they may be
// without anything lying farther than half a pixel from where light shows it. Theory: app/doc/physics.md,
// Aberration and cells.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/bodies/visible_chunks.h"

namespace carom {

/// Chosen anew for each eye and wall. Allocates only when it is made, or for a wall that needs more triangles
/// than any before.
class TiledSurfaces {
 public:
  /// Keeps a reference to `scene`.
  explicit TiledSurfaces(const SceneChunks& scene);

  /// Sets the eye's place on the board and its head's γβ there.
  void look(const glm::dvec3& eye_m, const glm::dvec3& u);

  /// Chooses all levels for a wall on which angles up to `tolerance_rad` may be off, and collects the
  /// triangles of the tiles that are chosen.
  void choose(const VisibleChunks& visible, double tolerance_rad);

  /// Triangles of tiles as they were built, between the scene's `tileVertices`, and those of tiles that
  /// needed finer ones, between `fineVertices`; part by part.
  std::span<const std::uint32_t> indices() const { return tiles_.indices; }
  std::span<const std::uint32_t> fineIndices() const { return cells_.indices; }
  std::span<const MeshVertex> fineVertices() const { return fineVertices_; }

  /// A part's own among such triangles: the places of its first index and of that after its last.
  struct Range {
    std::size_t first, end;
  };
  Range rangeOf(std::size_t part) const { return tiles_.rangeOf(part); }
  Range fineRangeOf(std::size_t part) const { return cells_.rangeOf(part); }

  /// Returns a number that is the same while all levels are.
  std::size_t digest() const;

 private:
  struct Triangles {
    std::vector<std::uint32_t> indices;
    std::vector<std::size_t> firstOfPart;
    Range rangeOf(std::size_t part) const { return {firstOfPart[part], firstOfPart[part + 1]}; }
  };
  void chooseLevels();
  int levelWithin(const TileDetail& detail, double longest_m) const;
  int levelOfCell(const Extent& extent, double cell_m) const;
  void appendTile(const SurfaceTile& tile, int level);
  void appendCells(const SurfaceTile& tile);
  int levelOfCellsEdge(const SurfaceTile& tile, const glm::ivec2& from, const glm::ivec2& step) const;

  const SceneChunks* scene_;
  glm::dvec3 eye_m_{0.0}, u_{0.0};
  double rootTolerance_ = 0.0;
  std::vector<double> longest_m_;     // of each edge and then each tile, over the root of the tolerance
  std::vector<std::uint8_t> levels_;  // of each edge and then each tile
  Triangles tiles_, cells_;
  std::vector<MeshVertex> fineVertices_;
};

}  // namespace carom
