#include "engine/game/soft_puck_mesh.h"

#include <glm/common.hpp>

namespace carom {

namespace {

/// The cells of a puck that is rigid in its setup and becomes soft later.
constexpr int kStiffCells = 10;

}  // namespace

SoftMesh softMeshOf(const Puck& puck) {
  const int cells = puck.soft ? puck.soft->cells : kStiffCells;
  if (puck.outline_m.empty()) return softDisc(puck.radius_m, cells);
  return softRectangle(glm::abs(puck.outline_m.front()), cells);
}

}  // namespace carom
