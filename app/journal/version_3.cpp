#include "app/journal/version_3.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace carom::version3 {
namespace {

constexpr std::size_t kFrameBytes = 1008, kKnotBytes = 104, kEventBytes = 216;

/// Reads values one after the other, with the compiler's padding.
class Bytes {
 public:
  Bytes(std::span<const std::byte> bytes, std::size_t expected) : rest_(bytes) {
    if (bytes.size() == expected) return;
    throw std::runtime_error(fmt::format("a record of {} bytes, expected {}", bytes.size(), expected));
  }

  template <typename T>
  T next() {
    T value;
    std::memcpy(&value, rest_.data(), sizeof value);
    rest_ = rest_.subspan(sizeof value);
    return value;
  }
  void skip(std::size_t bytes) { rest_ = rest_.subspan(bytes); }

  double number() { return next<double>(); }
  std::uint64_t count() { return next<std::uint64_t>(); }
  std::uint8_t byte() { return next<std::uint8_t>(); }
  Vec2 pair() {
    const double x = number();
    return {x, number()};
  }
  Vec3 place() {
    const double x = number(), y = number();
    return {x, y, number()};
  }
  Event event() {
    const double t_s = number();
    return {t_s, place()};
  }
  Pose pose() {
    Pose pose{place(), {}};
    pose.orientation.x = number();
    pose.orientation.y = number();
    pose.orientation.z = number();
    pose.orientation.w = number();
    return pose;
  }
  Lorentz transform() {
    const double c_m_s = number();
    glm::dmat4 matrix;
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) matrix[column][row] = number();
    }
    return {c_m_s, matrix};
  }
  EyeView eye() {
    const Event observation = event();
    const Vec3 inRoom_m = place();
    return {observation, inRoom_m, place()};
  }
  Switches switches() {
    Switches switches;
    for (const NamedSwitch& named : kNamedSwitches) switches.*named.value = byte();
    return switches;
  }

 private:
  std::span<const std::byte> rest_;
};

void readObserver(Bytes& in, ObserverView& observer) {
  observer.headFromBoard = in.transform();
  for (EyeView* eye : {&observer.left, &observer.right, &observer.middle}) *eye = in.eye();
  observer.properTime_s = in.number();
}

void readControls(Bytes& in, WallControls& controls) {
  controls.shown = static_cast<Shown>(in.byte());
  controls.blank = in.byte();
  controls.eyesSwapped = in.byte();
  controls.trackerCross = in.byte();
  controls.latency = in.byte();
}

void readViews(Bytes& in, TimeViews& views) {
  for (std::uint8_t TimeViews::*view :
       {&TimeViews::boardNow, &TimeViews::myNow, &TimeViews::paths, &TimeViews::events, &TimeViews::clocks,
        &TimeViews::ruler, &TimeViews::angles, &TimeViews::split, &TimeViews::frozen})
    views.*view = in.byte();
  views.beside = in.switches();
}

void readHand(Bytes& in, HandView& hand, DriveView& drive) {
  hand.shown = in.byte();
  hand.pulling = in.byte();
  in.skip(6);
  hand.target = in.count();
  hand.from_m = in.place();
  hand.to_m = in.place();
  hand.target_m = in.place();
  hand.towards = in.place();
  hand.u = in.number();
  drive.thrust = in.place();
  drive.mode = static_cast<DriveMode>(in.byte());
  drive.atLimit = in.byte();
  in.skip(6);
}

}  // namespace

FrameRecord frameOf(std::span<const std::byte> bytes) {
  Bytes in(bytes, kFrameBytes);
  FrameRecord record;
  ViewerState& viewer = record.viewers.front();
  record.number = in.count();
  record.display_s = in.number();
  readObserver(in, viewer.observer);
  record.boardFromRoom = in.transform();
  record.truncateFrom_s = in.number();
  record.pucks = in.count();
  record.eventsKept = in.count();
  record.forgetBefore_s = in.number();
  record.last = in.count();
  record.lightSpeed_m_s = in.number();
  record.switches = in.switches();
  readControls(in, record.controls);
  readViews(in, record.views);
  viewer.tracked.roomFromHeadSensor = in.pose();
  viewer.tracked.roomFromHand = in.pose();
  viewer.tracked.headKnown = in.byte();
  viewer.tracked.handKnown = in.byte();
  in.skip(6);
  readHand(in, viewer.hand, record.drive);
  record.lesson.phase = static_cast<LessonPhase>(in.byte());
  record.lesson.answer = in.byte();
  viewer.notice.text = in.next<std::array<char, 120>>();
  return record;
}

Knot knotOf(std::span<const std::byte> bytes) {
  Bytes in(bytes, kKnotBytes);
  Knot knot;
  knot.turn = in.event();
  knot.u = in.place();
  knot.properTime_s = in.number();
  knot.signal = in.event();
  knot.deceleration_m_s2 = in.number();
  return knot;
}

std::vector<GameEvent> eventsOf(std::span<const std::byte> bytes) {
  std::vector<GameEvent> events;
  for (; !bytes.empty(); bytes = bytes.subspan(kEventBytes)) {
    Bytes in(bytes.first(std::min(bytes.size(), kEventBytes)), kEventBytes);
    GameEvent& event = events.emplace_back();
    event.number = in.count();
    event.which = in.next<std::uint32_t>();
    event.kind = static_cast<EventKind>(in.byte());
    if (const int cushion = in.byte(); cushion > 0) event.cushion = static_cast<Cushion>(cushion - 1);
    const int turns = in.byte(), withoutDelay = in.byte();
    if (turns > 2 || withoutDelay > 1) throw std::runtime_error("no such event can be");
    event.withoutDelay = withoutDelay == 1;
    event.at = in.event();
    event.heat_j = in.number();
    for (int turn = 0; turn < turns; ++turn) {
      const std::uint64_t puck = in.count();
      const Event at = in.event();
      const Vec2 before = in.pair(), after = in.pair();
      event.turns.push_back({puck, at, before, after, in.number()});
    }
  }
  return events;
}

}  // namespace carom::version3
