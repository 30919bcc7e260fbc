#include "engine/light/mesh_view.h"

#include "engine/light/vertex_history.h"

namespace carom {

Vec3 RigidMeshView::offset_m(std::size_t vertex) const {
  return {offsets_.x_m[vertex], offsets_.y_m[vertex], offsets_.z_m[vertex]};
}

void RigidMeshView::look(const Event& observation, const Lorentz& headFromBoard) {
  observation_ = observation;
  headFromBoard_ = headFromBoard;
  viewBody(line_, observation, headFromBoard, view_);
}

std::size_t RigidMeshView::see(std::size_t first, const SeenPoints& seen) {
  return seePoints(view_, offsets_.slice(first, seen.size()), seen);
}

void RigidMeshView::properTimes(std::size_t first, std::span<const float> boardTime_m,
                                std::span<double> properTime_s) {
  for (std::size_t i = 0; i < boardTime_m.size(); ++i) {
    const double t_s = observation_.t_s + boardTime_m[i] / line_.lightSpeed_m_s();
    const auto history = vertexHistory(line_, offset_m(first + i));
    properTime_s[i] = properTimeAt(pieceAt(history, t_s), t_s, line_.lightSpeed_m_s());
  }
}

std::optional<Emission> RigidMeshView::emission(std::size_t vertex) const {
  return carom::emission(line_, offset_m(vertex), observation_, headFromBoard_);
}

}  // namespace carom
