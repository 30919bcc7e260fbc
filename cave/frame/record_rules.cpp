#include "cave/frame/record_rules.h"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <stdexcept>

#include "engine/base/limits.h"

namespace carom {
namespace {

template <typename... T>
[[noreturn]] void refuse(fmt::format_string<const T&...> text, const T&... values) {
  throw std::invalid_argument(fmt::format(text, values...));
}

void expectFinite(const char* field, std::initializer_list<double> values) {
  for (const double value : values) {
    if (!std::isfinite(value)) refuse("{} is {}, expected a finite number", field, value);
  }
}
void expectFinite(const char* field, const Vec3& v) { expectFinite(field, {v.x, v.y, v.z}); }
void expectFinite(const char* field, const Event& e) {
  expectFinite(field, {e.t_s, e.r_m.x, e.r_m.y, e.r_m.z});
}
void expectFinite(const char* field, const Pose& pose) {
  const glm::dquat& q = pose.orientation;
  expectFinite(field, pose.position_m);
  expectFinite(field, {q.w, q.x, q.y, q.z});
}

void expectFlag(const char* field, std::uint64_t value) {
  if (value > 1) refuse("{} is {}, expected 0 or 1", field, value);
}
void expectFlags(const Switches& switches) {
  for (const NamedSwitch& named : kNamedSwitches) expectFlag(named.name, switches.*named.value);
}

void expectPossible(const char* frame, const Lorentz& transform, double gameLightSpeed_m_s) {
  const double c_m_s = transform.lightSpeed_m_s();
  if (c_m_s != gameLightSpeed_m_s)
    refuse("{} has light at {} m/s, expected the game's {}", frame, c_m_s, gameLightSpeed_m_s);
  // `inverse` uses the formula for Lorentz transforms; it does not invert any other matrix.
  constexpr double kRounding = 1e-9;
  const glm::dmat4 one = (transform.inverse() * transform).matrix();
  const double gamma = transform.matrix()[0][0];
  bool possible = std::isfinite(gamma) && gamma > 0.0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      const double off = std::abs(one[column][row] - (row == column ? 1.0 : 0.0));
      possible = possible && off <= kRounding * gamma * gamma;
    }
  }
  if (!possible) refuse("{} is none, expected a Lorentz transform", frame);
}

void expectPossible(const ObserverView& observer, double gameLightSpeed_m_s) {
  expectPossible("the head's frame", observer.headFromBoard, gameLightSpeed_m_s);
  for (const EyeView& eye : observer.all()) {
    expectFinite("an eye's event", eye.observation);
    expectFinite("an eye's place in the room", eye.positionInRoom_m);
    expectFinite("the place that an eye sees from", eye.seenFromInRoom_m);
  }
  expectFinite("the person's proper time", {observer.properTime_s});
}

void expectPossible(const WallControls& walls) {
  if (walls.shown > Shown::alignmentPattern) {
    refuse("controls.shown is {}, expected 0 to {}", static_cast<int>(walls.shown),
           static_cast<int>(Shown::alignmentPattern));
  }
  expectFlag("controls.blank", walls.blank);
  expectFlag("controls.eyesSwapped", walls.eyesSwapped);
  expectFlag("controls.trackerCross", walls.trackerCross);
  expectFlag("controls.latency", walls.latency);
  expectFlag("controls.comfort", walls.comfort);
}

void expectPossible(const HandView& hand) {
  expectFlag("hand.shown", hand.shown);
  expectFlag("hand.pulling", hand.pulling);
  for (const Vec3& place : {hand.from_m, hand.to_m, hand.target_m, hand.towards})
    expectFinite("the hand", place);
  expectFinite("the stroke", {hand.u, hand.offset_m});
}

void expectPossible(const ViewerState& viewer, double gameLightSpeed_m_s) {
  expectPossible(viewer.observer, gameLightSpeed_m_s);
  expectFinite("the head sensor's pose", viewer.tracked.roomFromHeadSensor);
  expectFinite("the hand's pose", viewer.tracked.roomFromHand);
  expectFlag("tracked.headKnown", viewer.tracked.headKnown);
  expectFlag("tracked.handKnown", viewer.tracked.handKnown);
  expectPossible(viewer.hand);
  if (viewer.notice.text.back() != 0) refuse("notice has no end");
  expectFinite("the head's place in the room", viewer.placeInRoom_m);
  expectFinite("the lapse", {viewer.lapse});
  expectFlag("hasTurn", viewer.hasTurn);
}

void expectPossible(const HeadsetState& headset) {
  expectFlag("headset.isWorn", headset.isWorn);
  expectFlag("headset.velocityKnown", headset.velocityKnown);
  expectFinite("the headset's velocity", headset.runtimeVelocity_m_s);
  for (const HeadsetEye& eye : headset.eyes) {
    const EyeFrustum& f = eye.frustum;
    expectFinite("an eye's pose", eye.roomFromEye);
    expectFinite("an eye's frustum", {f.left, f.right, f.down, f.up});
    if (!(f.left < f.right && f.down < f.up)) refuse("an eye's frustum is none");
  }
}

void expectPossible(const DriveView& drive) {
  expectFinite("the thrust", drive.thrust);
  if (drive.mode > DriveMode::tour) refuse("drive.mode is none that there is");
  expectFlag("drive.atLimit", drive.atLimit);
}

}  // namespace

void expectPossible(const FrameRecord& record, double gameLightSpeed_m_s) {
  expectFinite("display_s", {record.display_s});
  if (record.viewers < 1 || record.viewers > kMostViewers)
    refuse("viewers is {}, expected 1 to {}", record.viewers, kMostViewers);
  for (std::size_t viewer = 0; viewer < record.viewers; ++viewer)
    expectPossible(record.viewer(viewer), gameLightSpeed_m_s);
  expectFinite("the room's time", {record.room_s});
  expectPossible("the room's frame", record.boardFromRoom, gameLightSpeed_m_s);
  if (std::isnan(record.truncateFrom_s))
    refuse("truncateFrom_s is no number, expected a board time or infinity");
  const double c_m_s = record.lightSpeed_m_s;
  const bool settable = c_m_s >= kLeastLightSpeed_m_s && c_m_s <= kMostLightSpeed_m_s;
  if (!settable && c_m_s != gameLightSpeed_m_s) {
    refuse("lightSpeed_m_s is {}, expected {} to {} or the game's {}", c_m_s, kLeastLightSpeed_m_s,
           kMostLightSpeed_m_s, gameLightSpeed_m_s);
  }
  expectFlag("last", record.last);
  expectFlags(record.switches);
  expectPossible(record.controls);
  for (const NamedView& named : kNamedViews) expectFlag(named.name, record.views.*named.value);
  expectFlags(record.views.beside);
  expectPossible(record.drive);
  expectPossible(record.headset);
  if (record.lesson.phase > LessonPhase::explains || record.lesson.answer > kMostAnswers)
    refuse("lesson is in no phase that there is");
  if (!(record.fade >= 0.0 && record.fade <= 1.0)) refuse("fade is {}, expected 0 to 1", record.fade);
}

void expectPossible(const Knot& knot) {
  expectFinite("a knot's turn", knot.turn);
  expectFinite("a knot's u", knot.u);
  expectFinite("a knot's proper time", {knot.properTime_s});
  expectFinite("a knot's signal", knot.signal);
  expectFinite("a knot's deceleration", {knot.deceleration_m_s2});
  const Spin& spin = knot.spin;
  expectFinite("a knot's spin", {spin.angle_rad, spin.omega_rad_s, spin.rim_u, spin.slowing_1_s});
}

void expectPossible(const GameEvent& event, std::uint64_t pucks) {
  if (event.kind > EventKind::jam) refuse("an event of a kind that there is not");
  if (event.cushion && *event.cushion > Cushion::minusY) refuse("an event at a cushion that there is not");
  expectFinite("an event's place", event.at);
  expectFinite("an event's heat", {event.heat_j});
  for (const Turn& turn : event.turns) {
    if (turn.puck >= pucks)
      refuse("an event turns puck {}, expected one of {} from 0", std::uint64_t{turn.puck}, pucks);
    expectFinite("a turn's event", turn.event);
    expectFinite("a turn's velocities",
                 {turn.betaBefore.x, turn.betaBefore.y, turn.betaAfter.x, turn.betaAfter.y});
    expectFinite("a turn's proper time", {turn.properTime_s});
  }
}

}  // namespace carom
