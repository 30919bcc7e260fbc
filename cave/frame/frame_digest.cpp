#include "cave/frame/frame_digest.h"

#include <span>
#include <type_traits>

#include "engine/base/xxh3.h"

namespace carom {
namespace {

/// Digests values one after the other, without the padding between them.
class Digest {
 public:
  template <typename T>
  requires std::is_arithmetic_v<T> Digest& operator<<(const T& value) {
    digest_ = XXH3_64bits_withSeed(&value, sizeof value, digest_);
    return *this;
  }
  Digest& operator<<(const Vec3& v) { return *this << v.x << v.y << v.z; }
  Digest& operator<<(const Event& event) { return *this << event.t_s << event.r_m; }
  Digest& operator<<(const Knot& knot) {
    *this << knot.turn << knot.u << knot.properTime_s << knot.signal << knot.deceleration_m_s2;
    if (spins(knot))
      *this << knot.spin.angle_rad << knot.spin.omega_rad_s << knot.spin.rim_u << knot.spin.slowing_1_s;
    return *this;
  }

  Digest& operator<<(const GameEvent& event) {
    *this << event.number << static_cast<std::uint8_t>(event.kind)
          << (event.cushion ? static_cast<int>(*event.cushion) : -1) << event.which << event.at
          << event.heat_j << event.turns.size();
    if (event.withoutDelay || event.sideOnSide) *this << event.withoutDelay << event.sideOnSide;
    for (const Turn& turn : event.turns) {
      *this << turn.puck << turn.event << turn.betaBefore.x << turn.betaBefore.y << turn.betaAfter.x
            << turn.betaAfter.y << turn.properTime_s;
      if (turn.spinBefore_kg_m2_s != 0.0 || turn.spinAfter_kg_m2_s != 0.0)
        *this << turn.spinBefore_kg_m2_s << turn.spinAfter_kg_m2_s;
    }
    return *this;
  }

  operator std::uint64_t() const { return digest_; }

 private:
  std::uint64_t digest_ = 0;
};

void add(const Lorentz& transform, Digest& digest) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) digest << transform.matrix()[column][row];
  }
}

Digest digestOf(const ObserverView& observer, const Lorentz& boardFromRoom) {
  Digest digest;
  add(observer.headFromBoard, digest);
  add(boardFromRoom, digest);
  for (const EyeView& eye : observer.all()) {
    digest << eye.observation << eye.positionInRoom_m << eye.seenFromInRoom_m;
  }
  digest << observer.properTime_s;
  return digest;
}

std::uint64_t digestOf(const TimeViews& views) {
  Digest digest;
  digest << views.boardNow << views.myNow << views.paths << views.events << views.clocks << views.split
         << views.frozen << views.ruler << views.angles;
  for (const NamedSwitch& named : kNamedSwitches) digest << views.beside.*named.value;
  return digest;
}

std::uint64_t digestOf(const HandView& hand) {
  Digest digest;
  digest << hand.shown << hand.pulling << hand.target << hand.from_m << hand.to_m << hand.target_m
         << hand.towards << hand.u;
  return hand.offset_m == 0.0 ? digest : digest << hand.offset_m;
}

Digest digestOf(const ViewerState& viewer, const DriveView& drive) {
  Digest digest;
  for (const Pose& pose : {viewer.tracked.roomFromHeadSensor, viewer.tracked.roomFromHand}) {
    const glm::dquat& q = pose.orientation;
    digest << pose.position_m << q.w << q.x << q.y << q.z;
  }
  digest << viewer.tracked.headKnown << viewer.tracked.handKnown;
  digest << digestOf(viewer.hand) << drive.thrust << static_cast<std::uint8_t>(drive.mode) << drive.atLimit;
  return digest;
}

/// Digests the newest knots and their numbers: once a history has lost or gained a knot, its digest stays
/// different.
std::uint64_t digestOfNewest(std::span<const WorldLine> histories) {
  Digest digest;
  for (const WorldLine& history : histories) digest << history.knots().size() << history.knots().back();
  return digest;
}

/// Does the same for the list of events.
std::uint64_t digestOfNewest(std::span<const GameEvent> events) {
  Digest digest;
  digest << events.size();
  if (!events.empty()) digest << events.front().number << events.back();
  return digest;
}

}  // namespace

FrameDigest digestOf(const FrameState& state, const World& world) {
  const FrameRecord& record = state.record;
  Digest switches, knots;
  for (const NamedSwitch& named : kNamedSwitches) switches << record.switches.*named.value;
  switches << static_cast<std::uint8_t>(record.controls.shown) << record.controls.blank
           << record.controls.eyesSwapped << record.controls.trackerCross << record.controls.latency
           << record.lightSpeed_m_s << digestOf(record.views);
  // What older programs did not know is digested only where it is there, so that their digests stay.
  if (record.controls.comfort) switches << record.controls.comfort;
  if (record.fade != 0.0) switches << record.fade;
  if (record.score != Score{}) switches << record.score.caroms << record.score.strokes;
  Digest tracked = digestOf(static_cast<const ViewerState&>(record), record.drive);
  switches << static_cast<std::uint8_t>(record.lesson.phase) << record.lesson.answer;
  for (const char letter : record.notice.text) switches << letter;
  Digest observers = digestOf(record.observer, record.boardFromRoom);
  if (record.viewers > 1) observers << record.room_s << record.placeInRoom_m << record.lapse;
  if (record.viewers > 1) switches << record.hasTurn;
  for (std::size_t viewer = 1; viewer < record.viewers; ++viewer) {
    const ViewerState& other = record.viewer(viewer);
    observers << std::uint64_t{digestOf(other.observer, record.boardFromRoom)} << other.placeInRoom_m
              << other.lapse;
    tracked << std::uint64_t{digestOf(other, record.drive)};
    for (const char letter : other.notice.text) switches << letter;
    switches << other.score.caroms << other.score.strokes << other.hasTurn;
  }
  knots << record.truncateFrom_s << record.pucks << record.forgetBefore_s;
  for (const BodyKnot& knot : state.knots) knots << knot.body << knot.knot;
  Digest events;
  events << record.eventsKept;
  for (const GameEvent& event : state.events) events << event;
  return {{Digest() << record.number << record.last, Digest() << record.display_s, observers, switches,
           tracked, knots, events, digestOfNewest(world.histories), digestOfNewest(world.events)}};
}

HistoryDigest digestOf(const WorldLine& history) {
  Digest turns, velocities, properTimes, signal;
  for (const Knot& knot : history.knots()) {
    turns << knot.turn;
    velocities << knot.u << knot.deceleration_m_s2;
    properTimes << knot.properTime_s;
    signal << knot.signal;
  }
  return {{history.knots().size(), turns, velocities, properTimes, signal}};
}

}  // namespace carom
