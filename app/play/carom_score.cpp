#include "app/play/carom_score.h"

#include <glm/geometric.hpp>

namespace carom {
namespace {

/// Returns the puck that collides with this one in the event, or none.
std::optional<std::size_t> partnerOf(std::size_t puck, const GameEvent& event) {
  if (event.kind != EventKind::puckPuck || event.turns.size() != 2) return {};
  if (event.turns[0].puck == puck) return event.turns[1].puck;
  if (event.turns[1].puck == puck) return event.turns[0].puck;
  return {};
}

}  // namespace

void CaromScore::struck(std::size_t puck, double arrives_s) {
  shot_ = {puck, arrives_s, {}};
  ++strokes_;
}

bool CaromScore::look(std::span<const GameEvent> events, const Event& eye, double c_m_s) {
  if (!shot_) return false;
  for (const GameEvent& event : events) {
    const auto partner = partnerOf(shot_->puck, event);
    if (!partner || event.at.t_s < shot_->arrives_s) continue;
    if (event.at.t_s + glm::distance(event.at.r_m, eye.r_m) / c_m_s > eye.t_s) continue;  // not seen yet
    if (!shot_->touched) shot_->touched = partner;
    if (partner == shot_->touched) continue;
    shot_.reset();
    ++caroms_;
    return true;
  }
  return false;
}

}  // namespace carom
