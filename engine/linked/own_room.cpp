#include "engine/linked/own_room.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

namespace carom {

OwnRoom::OwnRoom(double reach_m, const Observers& observers, std::span<const Event> others)
    : reach_m_(reach_m) {
  for (std::size_t i = 0; i < observers.size(); ++i) {
    reaches_m_.push_back(reachBeside(observers.headEvent(i), others));
    promises_.emplace_back(observers.headEvent(i), observers.boardFromRoom(), reaches_m_.back());
  }
  const std::array<Vec3, kMostViewers> atTheHeads{};
  tell(observers, std::span(atTheHeads).first(observers.size()), others, true);
}

double OwnRoom::reachBeside(const Event& head, std::span<const Event> others) const {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Event& other : others) nearest_m = std::min(nearest_m, glm::distance(head.r_m, other.r_m));
  return reachBeside_m(reach_m_, nearest_m);
}

Stroke OwnRoom::putOff(std::uint32_t viewer, const Stroke& stroke, const Lorentz& boardFromRoom) const {
  const Event kept = promises_.at(viewer).putOff({stroke.at_s, stroke.from_m.value()}, boardFromRoom);
  Stroke off = stroke;
  off.at_s = kept.t_s;
  off.from_m = kept.r_m;
  return off;
}

StrokeTold OwnRoom::made(std::uint32_t viewer, const Stroke& stroke) {
  if (present_.strokes == kMostStrokesTold) throw std::length_error("OwnRoom: too many strokes in one game");
  return {present_.strokes++, viewer, stroke};
}

const Present& OwnRoom::tell(const Observers& observers, std::span<const Vec3> handsFromHeads_m,
                             std::span<const Event> others, bool waits) {
  const Lorentz& boardFromRoom = observers.boardFromRoom();
  ++present_.number;
  present_.waits = waits;
  present_.size = promises_.size();
  for (std::size_t i = 0; i < promises_.size(); ++i) {
    const Event& head = observers.headEvent(i);
    reaches_m_[i] = reachBeside(head, others);
    promises_[i].renew(head, boardFromRoom, reaches_m_[i]);
    present_.persons[i] = {promises_[i].event(), head,
                           promises_[i].drawnHand(head, handsFromHeads_m[i], boardFromRoom, reaches_m_[i]),
                           observers.properTime_s(i)};
  }
  return present_;
}

}  // namespace carom
