#include "app/play/cue_interaction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "cave/frame/bodies.h"
#include "cave/scene/scene.h"
#include "cave/texts/saying.h"
#include "engine/light/light_path.h"
#include "engine/text/log.h"

namespace carom {

Event handEvent(const Vec3& handInRoom_m, const SeenFrame& seen) {
  const Lorentz& boardFromRoom = seen.record.boardFromRoom;
  const EyeView& head = seen.self.observer.middle;
  Event hand = head.observation + boardFromRoom * Displacement{0.0, handInRoom_m - head.seenFromInRoom_m};
  for (const ViewerState& viewer : seen.record.present()) {
    for (const EyeView& eye : viewer.observer.all()) {
      const double light_s = glm::distance(hand.r_m, eye.observation.r_m) / boardFromRoom.lightSpeed_m_s();
      hand.t_s = std::max(hand.t_s, eye.observation.t_s - light_s);
    }
  }
  return hand;
}

namespace {

/// Returns ", 8 mm right of its centre"; empty for a stroke at the centre.
texts::Saying sideText(double offset_m) {
  if (offset_m == 0.0) return {};
  const double aside_mm = 1e3 * std::abs(offset_m);
  return offset_m > 0.0 ? texts::say(texts::message::kRightOfCentre, aside_mm)
                        : texts::say(texts::message::kLeftOfCentre, aside_mm);
}

}  // namespace

CueInteraction::Outcome CueInteraction::step(const HandInput& hand, bool still, Game& game,
                                             FrameRecord& record, std::size_t viewer,
                                             const OwnRoom* promises) {
  ViewerState& own = record.viewers[viewer];
  const SeenFrame seen(record, viewer);
  PickResult pointed;
  const std::optional<std::size_t> ringed = std::exchange(ringed_, {});
  if (!hand.device.empty()) {
    game.playTo(latestObservation_s(own.observer));  // as far as the eyes see
    pointed = aim_.at({hand.from_m, hand.along}, game.pucks(), {own.observer, hand.eye, record.switches},
                      record.boardFromRoom);
    if (!pointed.puck && ringed && isInRing(*ringed, hand, game, seen)) pointed.puck = ringed;
  }
  const bool held = cue_.target().has_value();
  const Cue::Outcome cue = cue_.step(hand, pointed,
                                     {.frozen = still,
                                      .inLesson = record.lesson.phase == LessonPhase::shows,
                                      .isRinged = ringed.has_value()});
  if (!held && cue_.target()) {
    aside_m_ = pointed.end_m -
               aim_.seenInRoom_m(game.pucks()[*cue_.target()], {own.observer, hand.eye, record.switches});
  }
  own.hand = viewOf(hand, pointed, game, seen);
  if (cue.letGo) return strike(*cue.letGo, hand, game, seen, promises);
  return {{}, {}, cue.refused.empty() ? texts::Saying(hand.refused) : cue.refused};
}

/// Returns whether the hand points into the ring around a puck as it is seen.
bool CueInteraction::isInRing(std::size_t puck, const HandInput& hand, const Game& game,
                              const SeenFrame& seen) {
  constexpr double kBeside_m = 0.02;
  const Vec3 way_m =
      aim_.seenInRoom_m(game.pucks()[puck], {seen.self.observer, hand.eye, seen.record.switches}) -
      hand.from_m;
  const double along_m = glm::dot(way_m, hand.along);
  const double ring_m = std::max(kRing_m, scenario_->billiard.pucks[puck].radius_m + kBeside_m);
  return along_m > 0.0 && glm::length(way_m - along_m * hand.along) < ring_m;
}

void CueInteraction::offer(std::size_t puck, const Game& game, FrameRecord& record, std::size_t viewer) {
  const ObserverView& observer = record.viewers[viewer].observer;
  HandView& hand = record.viewers[viewer].hand;
  ringed_ = puck;
  if (hand.target != 0) return;
  hand.target = kRestingBody + 1 + puck;
  hand.target_m = aim_.seenInRoom_m(game.pucks()[puck], {observer, Eye::middle, record.switches});
  if (hand.shown) return;
  hand.shown = 1;
  hand.from_m = observer.middle.positionInRoom_m;
  hand.to_m = hand.target_m;
}

double CueInteraction::offset_m(const Vec2& u, std::size_t target, const Lorentz& boardFromRoom) const {
  const PhysicsRules& rules = scenario_->billiard.rules;
  const Puck& puck = scenario_->billiard.pucks[target];
  if (puck.outline_m.empty() && rules.puckFriction == 0.0 && rules.cushionFriction == 0.0) return 0.0;
  return sideOf(aside_m_, u, boardFromRoom, puck.radius_m);
}

/// Returns the hand's view. While the cue is held, its ray ends where the target is seen, wherever the hand
/// points.
HandView CueInteraction::viewOf(const HandInput& hand, const PickResult& pointed, const Game& game,
                                const SeenFrame& seen) {
  HandView view;
  view.shown = !hand.device.empty();
  if (!view.shown) return view;
  view.from_m = hand.from_m;
  view.to_m = pointed.end_m;
  const auto target = cue_.target() ? cue_.target() : pointed.puck;
  if (!target) return view;
  view.target = kRestingBody + 1 + *target;
  view.target_m =
      aim_.seenInRoom_m(game.pucks()[*target], {seen.self.observer, hand.eye, seen.record.switches});
  if (!cue_.target()) return view;
  const CueStroke stroke = strokeOf(cue_.pull_m(), seen.record.boardFromRoom, cue_.d0_m());
  view.pulling = 1;
  view.to_m = view.target_m;
  view.towards = stroke.towards;
  view.u = glm::length(stroke.u);
  view.offset_m = offset_m(stroke.u, *cue_.target(), seen.record.boardFromRoom);
  return view;
}

CueInteraction::Outcome CueInteraction::strike(std::size_t puck, const HandInput& hand, Game& game,
                                               const SeenFrame& seen, const OwnRoom* promises) const {
  const Puck& target = scenario_->billiard.pucks[puck];
  const double c_m_s = scenario_->billiard.lightSpeed_m_s;
  const Vec2 u = strokeOf(cue_.pull_m(), seen.record.boardFromRoom, cue_.d0_m()).u;
  if (u == Vec2(0.0)) return {{}, {}, texts::message::kLetGo};
  Event from = handEvent(hand.from_m, seen);
  if (from.t_s < 0.0) return {{}, {}, texts::message::kBeforeGame};
  Stroke stroke{puck, from.t_s, from.r_m, target.mass_kg * c_m_s * u,
                offset_m(u, puck, seen.record.boardFromRoom)};
  if (promises)
    stroke = promises->putOff(static_cast<std::uint32_t>(seen.viewer), stroke, seen.record.boardFromRoom);
  const bool isPutOff = stroke.at_s > from.t_s;
  from = {stroke.at_s, *stroke.from_m};
  try {
    const Event arrival = game.strike(stroke);
    const double pace = seen.record.lightSpeed_m_s / c_m_s;  // game seconds per second of the viewer
    const auto passes_s = [&](const Event& begin, const Event& end) {
      return (seen.record.boardFromRoom.inverse() * (end - begin)).dt_s / pace;
    };
    const Event back = lightMeets(arrival, seen.self.observer.middle.observation,
                                  betaFromU(seen.self.observer.headFromBoard.inverse().u()), c_m_s);
    return {stroke, arrival.t_s,
            texts::say(texts::message::kStroke, target.name, passes_s(from, arrival), passes_s(arrival, back),
                       sideText(stroke.offset_m)),
            isPutOff};
  } catch (const std::invalid_argument& error) {
    log::note(error.what());
    return {{}, {}, texts::say(texts::message::kOutOfReach, target.name)};
  }
}

}  // namespace carom
