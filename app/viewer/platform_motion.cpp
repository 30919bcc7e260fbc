#include "app/viewer/platform_motion.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

#include "cave/frame/hall.h"
#include "cave/texts/texts.h"
#include "engine/base/limits.h"
#include "engine/spacetime/lorentz.h"

namespace carom {
namespace {

constexpr double kAtRest_u = 1e-12;  // rounding of a platform that has been braked
constexpr double kInPlace_m = 1e-4;
constexpr double kFacing_rad = 1e-9;
constexpr double kTurn_rad_s = std::numbers::pi / 6.0;
constexpr double kTourFrom_u = 1e-9;    // largest deviation from the motion for which the tour was made
constexpr double kFar_m = 8.0;          // from the table's centre: beyond the hall's walls
constexpr double kToWall_m = 0.5;       // least distance that the drive keeps from the hall's walls
constexpr double kMeant = 0.1;          // least steering that ends a tour; less is a device's noise
constexpr int kMostStretches = 32;      // per frame; the rest then passes without thrust
constexpr std::size_t kTripPushes = 3;  // accelerate, coast, decelerate

/// Returns the room's orientation: boardFromRoom is a boost after it.
glm::dquat attitudeOf(const Lorentz& boardFromRoom) {
  const glm::dmat4 rest =
      (Lorentz::boost(boardFromRoom.u(), boardFromRoom.lightSpeed_m_s()).inverse() * boardFromRoom).matrix();
  return glm::normalize(
      glm::quat_cast(glm::dmat3(Vec3(rest[1].y, rest[1].z, rest[1].w), Vec3(rest[2].y, rest[2].z, rest[2].w),
                                Vec3(rest[3].y, rest[3].z, rest[3].w))));
}

Head headOnTheWay(const Head& before, const Head& head, double share) {
  Head there = head;
  there.roomFromHead.position_m =
      glm::mix(before.roomFromHead.position_m, head.roomFromHead.position_m, share);
  return there;
}

}  // namespace

PlatformMotion::PlatformMotion(const Scenario& scenario, const RoomAxes& axes, bool begins)
    : c_m_s_(scenario.billiard.lightSpeed_m_s),
      strongest_m_s2_(strongestThrust_m_s2(c_m_s_)),
      most_u_(scenario.most_u),
      up_(axes.up),
      boardFromHome_{scenario.observer.position_m, attitudeOf(startingRoom(scenario.observer, axes, c_m_s_))},
      atStart_u_(startingRoom(scenario.observer, axes, c_m_s_).u()) {
  if (const auto& board = scenario.billiard.board)
    halfHall_m_ = 0.5 * hallFloor_m({board->length_m, board->width_m}) - kToWall_m;
  double at_s = 0.0;
  for (const ThrustLeg& leg : scenario.tour) {
    if (leg.from_s > at_s) tour_.push_back({leg.from_s - at_s, Vec3(0.0)});
    const Vec3& thrust = leg.thrust_m_s2;
    tour_.push_back({leg.for_s, axes.right * thrust.x + axes.forward * thrust.y + axes.up * thrust.z});
    at_s = leg.from_s + leg.for_s;
  }
  way_.reserve(std::max(tour_.size(), kTripPushes));
  if (begins && scenario.tourAtOnce) setOut();
}

void PlatformMotion::begin(const Observer& observer) {
  setsOut_ = false;
  const Vec3 u = observer.boardFromRoom().u();
  if (tour_.empty()) {
    notice_ = Notice(texts::message::kNoFlight);
  } else if (view_.mode == DriveMode::tour) {
    notice_ = Notice(texts::message::kFlightUnderWay);
  } else if (glm::length(u) > kTourFrom_u && glm::length(u - atStart_u_) > kTourFrom_u) {
    notice_ = Notice(texts::message::kFlightBeginsAtRest);
  } else {
    take(tour_);
    view_.mode = DriveMode::tour;
    setOutBoard_s_ = observer.headEvent().t_s;
    setOutOwn_s_ = observer.properTime_s();
  }
}

void PlatformMotion::endTour(const Observer& observer) {
  leaveWay(DriveMode::free);
  const double board_s = observer.headEvent().t_s - setOutBoard_s_,
               own_s = observer.properTime_s() - setOutOwn_s_;
  notice_ = Notice(fmt::format(texts::message::kFlightFinished, board_s, own_s));
}

void PlatformMotion::take(std::span<const Thrust> way) {
  way_.assign(way.begin(), way.end());
  push_ = 0;
  pushed_s_ = 0.0;
}

void PlatformMotion::leaveWay(DriveMode mode) {
  way_.clear();
  push_ = 0;
  view_.mode = mode;
}

void PlatformMotion::sayOnce(bool& said, std::string_view words) {
  if (!said) notice_ = Notice(words);
  said = true;
}

void PlatformMotion::obey(const DriveWish& wish) {
  const bool steers = glm::length(wish.steer) > kMeant;
  steered_ = steered_ || steers;
  if (view_.mode == DriveMode::tour && (wish.home || wish.brake || steers))
    notice_ = Notice(texts::message::kFlightInterrupted);
  if (wish.home) {
    if (view_.mode != DriveMode::home) leaveWay(DriveMode::home);
  } else if (wish.brake) {
    leaveWay(DriveMode::braking);
  } else if (steers || view_.mode == DriveMode::braking) {
    leaveWay(DriveMode::free);
  }
}

void PlatformMotion::live(const DriveWish& wish, double dtau_s, double pace, const Head& before,
                          const Head& head, Observer& observer) {
  if (setsOut_) begin(observer);
  obey(wish);
  view_.atLimit = 0;
  const bool turns = view_.mode == DriveMode::free || view_.mode == DriveMode::braking;
  if (turns && wish.turn_rad != 0.0) observer.turn(wish.turn_rad, up_);
  // Observer's dT = sqrt(dτ² + |dx|²/c²): both run evenly through the frame.
  Vec3 step_m = head.roomFromHead.position_m - before.roomFromHead.position_m;
  if (!(glm::length(step_m) <= kGlitchCelerity_m_s * dtau_s)) step_m = Vec3(0.0);
  const double frame_s = std::hypot(pace * dtau_s, glm::length(step_m) / c_m_s_);
  Vec3 gained_m_s(0.0);
  double lived = 0.0;  // fraction of the frame
  for (int count = 0; lived < 1.0 && count < kMostStretches; ++count) {
    const Vec3 headInRoom_m = headOnTheWay(before, head, lived).roomFromHead.position_m;
    const Left left{(1.0 - lived) * frame_s, (1.0 - lived) * dtau_s};
    const Manoeuvre stretch = next(wish, observer, headInRoom_m, left);
    const double until = stretch.for_s < left.platform_s ? lived + stretch.for_s / frame_s : 1.0;
    observer.step((until - lived) * dtau_s, headOnTheWay(before, head, until), pace, stretch.thrust_m_s2);
    if (stretch.turn_rad != 0.0) observer.turn(stretch.turn_rad, stretch.turnAxisInRoom);
    gained_m_s += stretch.thrust_m_s2 * ((until - lived) * frame_s);
    lived = until;
  }
  if (lived < 1.0) observer.step((1.0 - lived) * dtau_s, head, pace);
  if (view_.mode == DriveMode::tour && push_ == way_.size()) endTour(observer);
  const bool far = steered_ && glm::length(glm::dvec2(observer.headEvent().r_m)) > kFar_m;
  if (far && view_.mode == DriveMode::free) sayOnce(saidFar_, texts::message::kFarFromTable);
  if (!far) saidFar_ = false;
  view_.thrust = frame_s > 0.0 ? gained_m_s / (frame_s * strongest_m_s2_) : Vec3(0.0);
}

PlatformMotion::Manoeuvre PlatformMotion::next(const DriveWish& wish, const Observer& observer,
                                               const Vec3& headInRoom_m, const Left& left) {
  switch (view_.mode) {
    case DriveMode::braking:
      return brake(observer, left.platform_s);
    case DriveMode::home:
      return returnHome(observer, headInRoom_m, left);
    case DriveMode::tour:
      return alongWay(left.platform_s);
    case DriveMode::free:
      break;
  }
  return steered(wish.steer, observer, left.platform_s);
}

PlatformMotion::Manoeuvre PlatformMotion::steered(const Vec3& steer, const Observer& observer,
                                                  double left_s) {
  const double asked = glm::length(steer);
  if (!(asked > 0.0)) return steered_ ? coast(observer, left_s) : Manoeuvre{left_s};
  Vec3 thrust_m_s2 = steer * strongest_m_s2_;
  if (asked > 1.0 + 1e-9) {
    thrust_m_s2 /= asked;
    view_.atLimit = 1;
    const double behind_m = c_m_s_ * c_m_s_ / strongest_m_s2_;
    sayOnce(saidStrongest_, fmt::format(texts::message::kStrongestThrust, behind_m));
  }
  const Lorentz& room = observer.boardFromRoom();
  const Lorentz after = room * Lorentz::fromRapidity(thrust_m_s2 * (left_s / c_m_s_), c_m_s_);
  const Vec3 here_m = observer.headEvent().r_m;
  if (!staysInHall(after, here_m)) {
    view_.atLimit = 1;
    return stopAtWall(observer, left_s);
  }
  const double after_u = glm::length(after.u());
  if (after_u <= std::max(most_u_, glm::length(room.u()))) return {left_s, thrust_m_s2};
  view_.atLimit = 1;
  sayOnce(saidFastest_, fmt::format(texts::message::kFastest, most_u_ / std::hypot(1.0, most_u_),
                                    std::hypot(1.0, most_u_)));
  return {left_s};
}

/// Moves on without thrust, after somebody has steered: brakes where the hall would end.
PlatformMotion::Manoeuvre PlatformMotion::coast(const Observer& observer, double left_s) {
  const Lorentz& room = observer.boardFromRoom();
  const Vec3 then_m = observer.headEvent().r_m + room.u() * (c_m_s_ * left_s);
  return staysInHall(room, then_m) ? Manoeuvre{left_s} : stopAtWall(observer, left_s);
}

PlatformMotion::Manoeuvre PlatformMotion::stopAtWall(const Observer& observer, double left_s) {
  sayOnce(saidWall_, texts::message::kHallWall);
  return brake(observer, left_s);
}

/// Returns whether the platform, braked from now on, comes to rest within the hall or at least no further
/// outside than it is. On the hyperbola of the strongest thrust it goes on for (γ − 1) c²/a (Rindler 2006,
/// §3.8).
bool PlatformMotion::staysInHall(const Lorentz& boardFromRoom, const Vec3& place_m) const {
  if (!halfHall_m_) return true;
  const auto outside_m = [&](const Vec3& at_m) {
    return std::max({std::abs(at_m.x) - halfHall_m_->x, std::abs(at_m.y) - halfHall_m_->y, 0.0});
  };
  const Vec3 u = boardFromRoom.u();
  const double size_u = glm::length(u);
  if (!(size_u > kAtRest_u)) return true;
  const double way_m = (std::hypot(1.0, size_u) - 1.0) * c_m_s_ * c_m_s_ / strongest_m_s2_;
  return outside_m(place_m + u * (way_m / size_u)) <= outside_m(place_m);
}

/// Stops the platform. The board moves through the room with u = sinh η: a boost by the same brings the room
/// to rest on it, without turning it. η = aτ/c.
PlatformMotion::Manoeuvre PlatformMotion::brake(const Observer& observer, double left_s) const {
  const Vec3 board_u = observer.boardFromRoom().inverse().u();
  const double u = glm::length(board_u);
  if (!(u > kAtRest_u)) return {left_s};
  const Vec3 along = board_u / u;
  return {std::min(left_s, c_m_s_ * std::asinh(u) / strongest_m_s2_), along * strongest_m_s2_};
}

/// Stops, turns to the initial orientation, and moves straight to the initial position. If the viewer walks
/// meanwhile, the room ends slightly off; then the trip is repeated.
PlatformMotion::Manoeuvre PlatformMotion::returnHome(const Observer& observer, const Vec3& headInRoom_m,
                                                     const Left& left) {
  if (push_ < way_.size()) return alongWay(left.platform_s);
  const Lorentz& room = observer.boardFromRoom();
  if (glm::length(room.u()) > kAtRest_u) return brake(observer, left.platform_s);

  const glm::dquat boardFromRoom = attitudeOf(room);
  glm::dquat turn = glm::conjugate(boardFromRoom) * boardFromHome_.orientation;
  if (turn.w < 0.0) turn = -turn;
  const Vec3 axis(turn.x, turn.y, turn.z);
  const double angle_rad = 2.0 * std::atan2(glm::length(axis), turn.w);
  if (angle_rad > kFacing_rad) {
    const double most_rad = kTurn_rad_s * left.person_s, share = std::min(1.0, most_rad / angle_rad);
    return {share < 1.0 ? left.platform_s : left.platform_s * (angle_rad / most_rad), Vec3(0.0),
            share * angle_rad, axis};
  }
  const Vec3 floor_m = observer.headEvent().r_m - boardFromRoom * headInRoom_m;
  const Vec3 way_m = boardFromHome_.position_m - floor_m;
  if (glm::length(way_m) > kInPlace_m) {
    planTrip(glm::conjugate(boardFromRoom) * way_m);
    return alongWay(left.platform_s);
  }
  leaveWay(DriveMode::free);
  return {left.platform_s};
}

/// Plans a trip from rest to rest: half of the distance accelerating, half decelerating. On the hyperbola γ −
/// 1 = a x/c² = 2 sinh²(η/2) (Rindler 2006, §3.8); if the top speed would be too high, the platform coasts in
/// between: x = c u τ.
void PlatformMotion::planTrip(const Vec3& wayInRoom_m) {
  const double length_m = glm::length(wayInRoom_m);
  const Vec3 thrust_m_s2 = wayInRoom_m * (strongest_m_s2_ / length_m);
  const double perMetre = strongest_m_s2_ / (c_m_s_ * c_m_s_);
  const double off_m = std::min(0.5 * length_m, (std::hypot(1.0, most_u_) - 1.0) / perMetre);
  const double off_s = 2.0 * std::asinh(std::sqrt(0.5 * perMetre * off_m)) * c_m_s_ / strongest_m_s2_;
  const double coast_s = (length_m - 2.0 * off_m) / (c_m_s_ * most_u_);
  take(std::array<Thrust, kTripPushes>{{{off_s, thrust_m_s2}, {coast_s, Vec3(0.0)}, {off_s, -thrust_m_s2}}});
}

PlatformMotion::Manoeuvre PlatformMotion::alongWay(double left_s) {
  while (push_ < way_.size()) {
    const Thrust& push = way_[push_];
    const double rest_s = push.for_s - pushed_s_;
    if (rest_s > left_s) {
      pushed_s_ += left_s;
      return {left_s, push.thrust_m_s2};
    }
    ++push_;
    pushed_s_ = 0.0;
    if (rest_s > 0.0) return {rest_s, push.thrust_m_s2};
  }
  return {view_.mode == DriveMode::home ? 0.0 : left_s};
}

}  // namespace carom
