#include "app/play/carom_score.h"

#include <glm/geometric.hpp>

namespace carom {
namespace {

/// Returns the puck that collides with this one in the event, or none.
std::optional<std::size_t> partnerOf(std::size_t puck, const GameEvent& event) {
  if (!isOfPucks(event.kind) || event.turns.size() != 2) return {};
  if (event.turns[0].puck == puck) return event.turns[1].puck;
  if (event.turns[1].puck == puck) return event.turns[0].puck;
  return {};
}

}  // namespace

void CaromScore::struck(std::size_t puck, double arrives_s) {
  shot_ = {puck, arrives_s, {}};
  ++score_.strokes;
}

std::optional<std::size_t> CaromScore::look(std::span<const GameEvent> events, const Event& eye,
                                            double c_m_s) {
  if (!shot_) return {};
  std::size_t cushions = 0;
  for (const GameEvent& event : events) {
    if (event.at.t_s < shot_->arrives_s) continue;
    if (event.at.t_s + glm::distance(event.at.r_m, eye.r_m) / c_m_s > eye.t_s) continue;  // not seen yet
    if (isOfCushion(event.kind) && event.turns.front().puck == shot_->puck) ++cushions;
    const auto partner = partnerOf(shot_->puck, event);
    if (!partner) continue;
    if (!shot_->touched) shot_->touched = partner;
    if (partner == shot_->touched) continue;
    shot_.reset();
    ++score_.caroms;
    return cushions;
  }
  return {};
}

}  // namespace carom
