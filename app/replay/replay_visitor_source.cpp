#include "app/replay/replay_visitor_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "devices/tracker/trace.h"
#include "engine/light/light_cone.h"
#include "engine/text/log.h"

namespace carom {
namespace {

/// Returns the rig for the one who visits: its first viewer.
Rig rigOf(Rig rig, const Visitor& visitor) {
  rig.viewers.resize(1);
  rig.viewers.front().force.reset();
  if (!visitor.trace) return rig;
  TrackerSetup& tracker = rig.trackers[rig.viewers.front().head.sensor.tracker];
  tracker = {};
  tracker.kind = TrackerKind::recorded;
  tracker.source = *visitor.trace;
  rig.viewers.front().head.sensor.sensor = 0;
  rig.viewers.front().head.eyesFromSensor = {};
  rig.viewers.front().hand.reset();
  return rig;
}

Scenario scenarioOf(Scenario scenario, const Visitor& visitor) {
  ObserverStart& start = scenario.observer;
  start.beta = visitor.beta.value_or(start.beta);
  start.position_m = visitor.from_m.value_or(start.position_m);
  start.facing_rad = visitor.facing_rad.value_or(start.facing_rad);
  return scenario;
}

/// Returns the headset of a head whose eyes see as in `view`, with the displays of another that was worn.
HeadsetState wornBy(const Pose& roomFromHead, const ObserverView& view, const HeadsetState& other) {
  HeadsetState state = other;
  const glm::dquat headFromRoom = glm::conjugate(headBetween(other.eyes).orientation);
  for (const auto& [eye, side] : {std::pair(&state.eyes[0], Eye::left), {&state.eyes[1], Eye::right}})
    eye->roomFromEye = {
        view.of(side).positionInRoom_m,
        glm::normalize(roomFromHead.orientation * headFromRoom * eye->roomFromEye.orientation)};
  state.isWorn = 1;
  state.velocityKnown = 0;
  return state;
}

std::optional<double> lengthOf_s(const Visitor& visitor) {
  if (!visitor.trace) return std::nullopt;
  const std::vector<TrackerSample> samples = readTrace(*visitor.trace);
  return samples.back().time_s - samples.front().time_s;
}

}  // namespace

ReplayVisitorSource::ReplayVisitorSource(const Rig& rig, const Scenario& scenario, const Visitor& visitor,
                                         RecordedGame game, std::chrono::steady_clock::time_point start)
    : viewers_(rigOf(rig, visitor), scenarioOf(scenario, visitor), start),
      roomFromBoard_(
          startingRoom(scenarioOf(scenario, visitor).observer, rig.axes, scenario.billiard.lightSpeed_m_s)
              .inverse()),
      origin_{0.0, scenarioOf(scenario, visitor).observer.position_m},
      eyeSeparation_m_(rig.viewers.front().head.eyeSeparation_m),
      lightSpeed_m_s_(scenario.billiard.lightSpeed_m_s),
      end_s_(lengthOf_s(visitor)),
      mayStay_(visitor.mayStay),
      hasTracedHeadset_(isHeadset(rig) && visitor.trace),
      game_(std::move(game)) {}

double ReplayVisitorSource::roomTimeOf_s(const ObserverView& view) const {
  return (roomFromBoard_ * (view.middle.observation - origin_)).dt_s;
}

/// Returns a board time that no visible point of a puck exceeds. In the puck's rest frame a point within R of
/// the centre is seen within R/c of when the centre is, and within R of where; on the board at most γ(1 + β)
/// R/c later.
double ReplayVisitorSource::latestSeen_s(const ObserverView& view) const {
  double latest_s = 0.0;
  for (std::size_t puck = 1; puck <= game_.pucks; ++puck) {
    const WorldLine& line = game_.world.histories[puck];
    const Motion centre = centreSeen(line, view.middle.observation);
    const double u = glm::length(centre.u), gamma = std::hypot(1.0, u);
    latest_s = std::max(latest_s, centre.event.t_s + (gamma + u) * line.radius_m() / line.lightSpeed_m_s());
  }
  return latest_s;
}

/// Returns the view when not frozen: advances, or goes to the time the operator seeks, but not beyond what
/// was recorded.
ObserverView ReplayVisitorSource::goOn(const Playback& playback, const FrameTimes& times) {
  const std::optional<double> goTo_s = std::exchange(goTo_s_, std::nullopt);
  const bool lives = !goTo_s && !playback.paused && playback.rate == 1.0;
  double by_s = playback.paused ? 0.0 : playback.rate * times.step_s;
  // The beginning is the game's, at room time 0, however long the visit has lasted.
  if (goTo_s) by_s = *goTo_s > 0.0 ? *goTo_s - previous_.display_s : -previous_.roomTime_s;
  const ObserverView view =
      lives ? viewers_.at(times, eyeSeparation_m_)[0]
            : viewers_.freeView(times, eyeSeparation_m_, std::max(by_s, -previous_.roomTime_s))[0];
  previous_.heldBack = latestSeen_s(view) > game_.known_s;
  if (!previous_.heldBack) return view;
  return viewers_.freeView(times, eyeSeparation_m_, previous_.roomTime_s - roomTimeOf_s(view))[0];
}

ObserverView ReplayVisitorSource::look(const OperatorSettings& settings, const FrameTimes& times) {
  if (settings.views.frozen && previous_.sight)
    return viewers_.frozenView({*previous_.sight}, times, eyeSeparation_m_)[0];
  previous_.sight = goOn(settings.playback, times);
  previous_.roomTime_s = roomTimeOf_s(*previous_.sight);
  return *previous_.sight;
}

/// Returns whether the trace ends, or whether the next frame but one might show more than was recorded.
bool ReplayVisitorSource::isLast(const FrameTimes& times, const ObserverView& view) {
  const double seen_s = latestSeen_s(view), step_s = seen_s - previous_.seen_s.value_or(seen_s);
  previous_.seen_s = seen_s;
  if (end_s_ && times.display_s + times.step_s > *end_s_) return true;
  if (mayStay_ || (!previous_.heldBack && seen_s + 2.0 * step_s <= game_.known_s)) return false;
  log::note(fmt::format("What comes after board time {:.2f} s was not recorded: the visit ends.", seen_s));
  return true;
}

void ReplayVisitorSource::next(const FrameTimes& times, const FrameInput& input, OperatorSettings& settings,
                               Decision& decision) {
  readOnly_.handled(input.desk, previous_.display_s);
  if (const Seek* seek = lastOf<Seek>(input.commands)) goTo_s_ = seek->session_s;
  decision.frame = std::move(game_.news);
  game_.news = {};
  FrameRecord& record = decision.frame.record;
  record.number = times.number;
  record.pucks = game_.pucks;
  record.headset = viewers_.putOn(times.headset);
  record.viewers.front().observer = look(settings, times);
  if (hasTracedHeadset_)
    record.headset = wornBy(viewers_.head(0).pose, record.viewers.front().observer, game_.headset);
  record.display_s = previous_.display_s = times.display_s;
  record.lightSpeed_m_s = lightSpeed_m_s_;
  record.last = times.isLast || isLast(times, record.viewers.front().observer);
  putInto(record, settings);
  viewers_.putInto(record);
  decision.alarms = viewers_.takeAlarms();
  readOnly_.tell(previous_.display_s, record.viewers.front().notice);
}

}  // namespace carom
