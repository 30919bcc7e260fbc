#pragma once
// The billiard table and the clocks on it, at rest on the board.

#include <vector>

#include "cave/mesh/mesh_builder.h"
#include "cave/scene/scene_part.h"
#include "engine/billiard/billiard.h"

namespace carom {

/// Returns the cloth, cushions, rails with diamonds, body and legs of a table whose legs stand on the floor
/// at z = `floor_m`, and clocks on its rails.
std::vector<ScenePart> tableParts(const Board& board, double floor_m);

/// Returns the cloth of an open plane: a square without cushions.
std::vector<ScenePart> openPlaneParts(double size_m);

/// Builds digital clocks with a face on both sides.
class ClockMaker {
 public:
  /// Adds a clock whose foot has its middle at `foot_m`; its front faces the horizontal direction `facing`.
  void add(const glm::dvec3& foot_m, const glm::dvec3& facing, double width_m, double cell_m);
  std::vector<ScenePart> parts() const;

 private:
  MeshBuilder faces_;
  MeshBuilder cases_;
};

}  // namespace carom
