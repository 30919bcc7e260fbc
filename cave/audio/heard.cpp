#include "cave/audio/heard.h"

#include <algorithm>
#include <cmath>

#include "engine/light/light_cone.h"

namespace carom {
namespace {

constexpr double kFull_m = 0.8;  // at this distance or less, an event has full loudness

/// Returns whether the event's light has arrived.
bool hasCome(const Event& event, const Event& eye, double c_m_s, bool retarded) {
  const double way_m = retarded ? glm::distance(eye.r_m, event.r_m) : 0.0;
  return c_m_s * (eye.t_s - event.t_s) >= way_m;
}

/// Returns how much the pucks' motion was changed: the largest change of γβ.
double changeOf(const Turns& turns) {
  double change = 0.0;
  for (const Turn& turn : turns) {
    const Vec3 before = uFromBeta({turn.betaBefore, 0.0}), after = uFromBeta({turn.betaAfter, 0.0});
    change = std::max(change, glm::distance(before, after));
  }
  return change;
}

/// Returns the speed at which soft pucks touch, or one and a cushion: they turn only later, over some time.
double closingOf(const GameEvent& event) {
  const Vec2 beta = event.turns[0].betaBefore;
  if (event.turns.size() == 2) return glm::length(event.turns[1].betaBefore - beta);
  const bool alongX = event.cushion == Cushion::plusX || event.cushion == Cushion::minusX;
  return std::abs(alongX ? beta.x : beta.y);
}

EventKind soundOf(EventKind kind) {
  if (kind == EventKind::jam || kind == EventKind::softSoft) return EventKind::puckPuck;
  return kind == EventKind::softCushion ? EventKind::puckCushion : kind;
}

bool isSilent(EventKind kind) {
  return kind == EventKind::flash || kind == EventKind::parted || kind == EventKind::farSide;
}

Heard heardOf(const GameEvent& event, const Event& eye, const Lorentz& headFromBoard,
              const Switches& switches) {
  const Vec3 way_m = event.at.r_m - eye.r_m;
  const double distance_m = glm::length(way_m);
  const ViewFrame frame(headFromBoard, switches);
  const Vec3 seen_m = kernel::rayThrough(frame.drawnFromBoard.matrix(), way_m);
  const bool isSoft = event.kind == EventKind::softSoft || event.kind == EventKind::softCushion;
  const double change = isSoft ? closingOf(event) : changeOf(event.turns);
  const double nearness = kFull_m / std::max(glm::length(seen_m), kFull_m);
  // D = |seen|/ℓ: distance in the head's frame over that in the board's, for a ray (−ℓ, r).
  const Displacement ray{-distance_m / headFromBoard.lightSpeed_m_s(), way_m};
  const double doppler = distance_m > 0.0 ? glm::length((headFromBoard * ray).dr_m) / distance_m : 1.0;
  return {soundOf(event.kind), seen_m, change / (1.0 + change) * nearness, doppler};
}

}  // namespace

void heardBetween(const ObserverView& before, const ObserverView& now, const Switches& switches,
                  const std::vector<GameEvent>& events, std::vector<Heard>& heard) {
  heard.clear();
  const Event &was = before.middle.observation, &is = now.middle.observation;
  if (!(is.t_s > was.t_s && is.t_s - was.t_s < kLeap_s)) return;
  const double c_m_s = now.headFromBoard.lightSpeed_m_s();
  const bool retarded = switches.retardation != 0;
  for (const GameEvent& event : events) {
    if (isSilent(event.kind) || hasCome(event.at, was, c_m_s, retarded) ||
        !hasCome(event.at, is, c_m_s, retarded))
      continue;
    heard.push_back(heardOf(event, is, now.headFromBoard, switches));
  }
}

}  // namespace carom
