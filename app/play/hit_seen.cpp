#include "app/play/hit_seen.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

namespace carom {
namespace {

bool isHitOf(std::size_t puck, const GameEvent& event) {
  if (!isOfPucks(event.kind)) return false;
  return std::any_of(event.turns.begin(), event.turns.end(),
                     [puck](const Turn& turn) { return turn.puck == puck; });
}

}  // namespace

void HitSeen::struck(std::size_t puck, double arrives_s) {
  shot_ = {puck, arrives_s};
  count_ = 0;
}

// An eye at (t_o, r_o) has seen the event (t, r) when t + |r_o − r|/c ≤ t_o. Both sides run evenly within a
// frame, to the second order of its length.
std::optional<std::span<const HitSeen::Seen>> HitSeen::look(std::span<const GameEvent> events,
                                                            const FrameRecord& record) {
  if (!shot_) return {};
  const double room_s = record.room_s, roomBefore_s = std::exchange(roomBefore_s_, room_s);
  const bool begins = !shot_->hit;
  for (const GameEvent& event : events) {
    if (shot_->hit || event.at.t_s < shot_->arrives_s || !isHitOf(shot_->puck, event)) continue;
    shot_->hit = event.at;
  }
  if (!shot_->hit) return {};
  const Event& hit = *shot_->hit;
  const double c_m_s = record.boardFromRoom.lightSpeed_m_s();
  for (std::size_t viewer = 0; viewer < record.viewerCount; ++viewer) {
    const Event& eye = record.viewers[viewer].observer.middle.observation;
    const double left_s = hit.t_s + glm::distance(hit.r_m, eye.r_m) / c_m_s - eye.t_s;
    const double before_s = begins ? left_s : before_s_[viewer];
    before_s_[viewer] = left_s;
    const bool known = std::any_of(seen_.begin(), seen_.begin() + static_cast<std::ptrdiff_t>(count_),
                                   [viewer](const Seen& seen) { return seen.viewer == viewer; });
    if (known || left_s > 0.0) continue;
    const double share = before_s > left_s ? before_s / (before_s - left_s) : 1.0;
    seen_[count_++] = {viewer, roomBefore_s + std::clamp(share, 0.0, 1.0) * (room_s - roomBefore_s)};
  }
  if (count_ < record.viewerCount) return {};
  shot_.reset();
  std::sort(seen_.begin(), seen_.begin() + static_cast<std::ptrdiff_t>(count_),
            [](const Seen& a, const Seen& b) { return a.room_s < b.room_s; });
  return std::span<const Seen>(seen_).first(count_);
}

}  // namespace carom
