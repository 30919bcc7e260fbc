#include "app/play/seen_blows.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "app/hand/cue.h"
#include "cave/audio/heard.h"

namespace carom {
namespace {

Vec3 uOf(const Vec2& beta) { return uFromBeta({beta, 0.0}); }

const Turn* turnOf(const GameEvent& event, std::size_t puck) {
  const auto found = std::find_if(event.turns.begin(), event.turns.end(),
                                  [puck](const Turn& turn) { return turn.puck == puck; });
  return found == event.turns.end() ? nullptr : found;
}

Vec3 softChange(const GameEvent& event, const Turn& own) {
  const Vec3 u = uOf(own.betaBefore);
  if (event.turns.size() == 2)
    return uOf((&own == event.turns.begin() ? event.turns[1] : event.turns[0]).betaBefore) - u;
  const bool alongX = event.cushion == Cushion::plusX || event.cushion == Cushion::minusX;
  return alongX ? Vec3(-2.0 * u.x, 0.0, 0.0) : Vec3(0.0, -2.0 * u.y, 0.0);
}

/// Returns where the change is seen: a stroke where it arrives, all else where the bodies touch.
const Event& placeOf(const GameEvent& event, const Turn& own) {
  return event.kind == EventKind::stroke ? own.event : event.at;
}

}  // namespace

std::optional<Vec3> changeOf(const GameEvent& event, std::size_t puck) {
  const bool isSoft = event.kind == EventKind::softSoft || event.kind == EventKind::softCushion;
  const bool isFelt = isSoft || event.kind == EventKind::stroke || event.kind == EventKind::puckPuck ||
                      event.kind == EventKind::puckCushion || event.kind == EventKind::jam;
  const Turn* const own = turnOf(event, puck);
  if (!isFelt || !own) return {};
  return isSoft ? softChange(event, *own) : uOf(own->betaAfter) - uOf(own->betaBefore);
}

// An eye at (t_o, r_o) has seen the event (t, r) when t + |r_o − r|/c ≤ t_o.
std::span<const Vec3> SeenBlows::look(std::span<const GameEvent> events, const FrameRecord& record,
                                      std::size_t viewer) {
  seen_.clear();
  const Event& now = record.viewers[viewer].observer.middle.observation;
  const std::optional<Event> before = std::exchange(before_, now);
  if (!shot_ || !before || !(now.t_s > before->t_s && now.t_s - before->t_s < kLeap_s)) return seen_;
  const double c_m_s = record.boardFromRoom.lightSpeed_m_s();
  const bool isRetarded = record.switches.retardation != 0;
  const auto hasCome = [&](const Event& event, const Event& eye) {
    return c_m_s * (eye.t_s - event.t_s) >= (isRetarded ? glm::distance(eye.r_m, event.r_m) : 0.0);
  };
  for (const GameEvent& event : events) {
    const std::optional<Vec3> change = changeOf(event, shot_->puck);
    if (!change) continue;
    const Event& at = placeOf(event, *turnOf(event, shot_->puck));
    if (at.t_s < shot_->arrives_s - 1e-9 || hasCome(at, *before) || !hasCome(at, now)) continue;
    seen_.push_back(wayInRoom(*change, record.boardFromRoom));
  }
  return seen_;
}

}  // namespace carom
