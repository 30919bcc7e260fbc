#include "app/viewer/platform_motion.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <limits>
#include <numbers>
#include <utility>

#include "cave/frame/hall.h"
#include "cave/texts/texts.h"
#include "engine/base/bisection.h"
#include "engine/base/limits.h"
#include "engine/spacetime/attitude.h"
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

using Heads = std::array<Head, kMostViewers>;

/// Returns the heads at a fraction of a frame in which they move from where `before` has them to `heads`.
Heads headsOnTheWay(const Observers& before, std::span<const Head> heads, double share) {
  Heads there;
  for (std::size_t i = 0; i < heads.size(); ++i) {
    there[i] = heads[i];
    there[i].roomFromHead.position_m =
        glm::mix(before[i].head.roomFromHead.position_m, heads[i].roomFromHead.position_m, share);
  }
  return there;
}

/// Returns a trip from rest to rest: half of the distance accelerating, half decelerating. On the hyperbola γ
/// − 1 = a x/c² = 2 sinh²(η/2) (Rindler 2006, §3.8); if the top speed would be too high, the platform coasts
/// in between: x = c u τ.
std::array<Thrust, kTripPushes> tripAlong(const Vec3& wayInRoom_m, double strongest_m_s2, double most_u,
                                          double c_m_s) {
  const double length_m = glm::length(wayInRoom_m);
  const Vec3 thrust_m_s2 = wayInRoom_m * (strongest_m_s2 / length_m);
  const double perMetre = strongest_m_s2 / (c_m_s * c_m_s);
  const double off_m = std::min(0.5 * length_m, (std::hypot(1.0, most_u) - 1.0) / perMetre);
  const double off_s = 2.0 * std::asinh(std::sqrt(0.5 * perMetre * off_m)) * c_m_s / strongest_m_s2;
  const double coast_s = (length_m - 2.0 * off_m) / (c_m_s * most_u);
  return {{{off_s, thrust_m_s2}, {coast_s, Vec3(0.0)}, {off_s, -thrust_m_s2}}};
}

constexpr int kHalvings = 60;  // of a frame: below rounding
constexpr double kEndless_s = std::numeric_limits<double>::infinity();

}  // namespace

double PlatformMotion::Left::lasts_s(double part, const Vec3& thrust_m_s2) const {
  if (observers.size() == 1) return part * frame.platform_s(thrust_m_s2);
  const Heads there = headsOnTheWay(frame.before, frame.heads, 1.0 - share + part);
  return observers.roomTimeOf_s(part * frame.person_s, std::span(there).first(frame.heads.size()), frame.pace,
                                thrust_m_s2, frame.steering);
}

double PlatformMotion::Left::partThatLasts(double for_s, const Vec3& thrust_m_s2) const {
  if (observers.size() == 1) return for_s / frame.platform_s(thrust_m_s2);
  const auto isShorter = [&](double part) { return lasts_s(part, thrust_m_s2) < for_s; };
  return bisect({0.0, share}, kHalvings, isShorter).high;
}

/// Returns the mean thrust over the rest of a frame. `gain_m_s`: what the room's rapidity, times c, gains in
/// so much of its time.
template <typename Gain>
Vec3 PlatformMotion::Left::meanOf(const Gain& gain_m_s) const {
  constexpr double kLeastLapse = 0.25;  // 1/2 less what observers move in a frame
  const auto isShorter = [&](double rest_s) { return platform_s(gain_m_s(rest_s) / rest_s) > rest_s; };
  const double most_s = bisect({0.0, platform_s() / kLeastLapse}, kHalvings, isShorter).high;
  return most_s > 0.0 ? gain_m_s(most_s) / most_s : Vec3(0.0);
}

PlatformMotion::PlatformMotion(const Scenario& scenario, const RoomAxes& axes, bool begins)
    : c_m_s_(scenario.billiard.lightSpeed_m_s),
      strongest_m_s2_(strongestThrust_m_s2(c_m_s_)),
      most_u_(scenario.most_u),
      up_(axes.up),
      boardFromHome_{scenario.observer.position_m, attitudeOf(startingRoom(scenario.observer, axes, c_m_s_))},
      atStart_u_(startingRoom(scenario.observer, axes, c_m_s_).u()),
      way_(std::max(2 * scenario.tour.size(), kTripPushes)) {
  if (const auto& board = scenario.billiard.board)
    halfHall_m_ = 0.5 * hallFloor_m({board->length_m, board->width_m}) - kToWall_m;
  double at_s = 0.0;
  for (const ThrustLeg& leg : scenario.tour) {
    if (leg.from_s > at_s) tour_.thrusts.push_back({leg.from_s - at_s, Vec3(0.0)});
    const Vec3& thrust = leg.thrust_m_s2;
    tour_.thrusts.push_back(
        {leg.for_s, axes.right * thrust.x + axes.forward * thrust.y + axes.up * thrust.z});
    at_s = leg.from_s + leg.for_s;
  }
  if (begins && scenario.tourAtOnce) setOut();
}

void PlatformMotion::begin(const Observers& observers) {
  tour_.isDue = false;
  const Vec3 u = observers.boardFromRoom().u();
  if (tour_.thrusts.empty()) {
    notices_.latest = texts::message::kNoFlight;
  } else if (view_.mode == DriveMode::tour) {
    notices_.latest = texts::message::kFlightUnderWay;
  } else if (glm::length(u) > kTourFrom_u && glm::length(u - atStart_u_) > kTourFrom_u) {
    notices_.latest = texts::message::kFlightBeginsAtRest;
  } else {
    way_.take(tour_.thrusts);
    view_.mode = DriveMode::tour;
    tour_.hasSetOut = false;
  }
}

void PlatformMotion::endTour(const Observers& observers) {
  leaveWay(DriveMode::free);
  const double board_s = observers.headEvent(tour_.by).t_s - tour_.setOut_s,
               own_s = observers.properTime_s(tour_.by) - tour_.setOutOwn_s;
  notices_.latest = texts::say(texts::message::kFlightFinished, board_s, own_s);
}

void PlatformMotion::leaveWay(DriveMode mode) {
  way_.leave();
  view_.mode = mode;
}

void PlatformMotion::apply(const DriveWish& wish) {
  const bool steers = glm::length(wish.steer) > kMeant;
  steered_ = steered_ || steers;
  if (view_.mode == DriveMode::tour && (wish.home || wish.brake || steers))
    notices_.latest = texts::message::kFlightInterrupted;
  if (wish.home) {
    if (view_.mode != DriveMode::home) leaveWay(DriveMode::home);
  } else if (wish.brake) {
    leaveWay(DriveMode::braking);
  } else if (steers || view_.mode == DriveMode::braking) {
    leaveWay(DriveMode::free);
  }
}

void PlatformMotion::advance(const DriveWish& wish, double dtau_s, double pace, std::span<const Head> heads,
                             Observers& observers, std::size_t steering) {
  steering_ = steering;
  strongest_m_s2_ = strongestThrust_m_s2(c_m_s_, observers.farthestFrom_m(steering));
  if (tour_.isDue) begin(observers);
  apply(wish);
  view_.atLimit = 0;
  observers.beginFrame();
  const Observers before = observers;
  const bool turns = view_.mode == DriveMode::free || view_.mode == DriveMode::braking;
  if (turns && wish.turn_rad != 0.0) observers.turn({wish.turn_rad, up_}, steering);
  const Frame frame{before, heads, dtau_s, pace, steering};
  Vec3 gained_m_s(0.0);
  double elapsed = 0.0;  // fraction of the frame
  for (int count = 0; elapsed < 1.0 && count < kMostStretches; ++count) {
    const Heads here = headsOnTheWay(before, heads, elapsed);
    const Left left{frame, observers, 1.0 - elapsed};
    const Manoeuvre stretch = next(wish, observers, here[steering].roomFromHead.position_m, left);
    if (view_.mode == DriveMode::tour && stretch.thrust_m_s2 != Vec3(0.0) &&
        !std::exchange(tour_.hasSetOut, true)) {
      tour_.by = steering;
      tour_.setOut_s = observers.headEvent(steering).t_s;
      tour_.setOutOwn_s = observers.properTime_s(steering);
    }
    const double until = stretch.for_s < left.platform_s(stretch.thrust_m_s2)
                             ? elapsed + left.partThatLasts(stretch.for_s, stretch.thrust_m_s2)
                             : 1.0;
    const double lasts_s = left.lasts_s(until - elapsed, stretch.thrust_m_s2);
    const Heads there = headsOnTheWay(before, heads, until);
    observers.step((until - elapsed) * dtau_s, std::span(there).first(heads.size()), pace,
                   stretch.thrust_m_s2, steering, {stretch.turn_rad, stretch.turnAxisInRoom});
    gained_m_s += stretch.thrust_m_s2 * lasts_s;
    elapsed = until;
  }
  if (elapsed < 1.0) observers.step((1.0 - elapsed) * dtau_s, heads, pace, Vec3(0.0), steering);
  if (view_.mode == DriveMode::tour && way_.isOver()) endTour(observers);
  const bool far = steered_ && glm::length(glm::dvec2(observers.headEvent(steering).r_m)) > kFar_m;
  if (far && view_.mode == DriveMode::free) notices_.sayOnce(notices_.saidFar, texts::message::kFarFromTable);
  if (!far) notices_.saidFar = false;
  const double frame_s = observers.size() > 1 ? observers.room_s() - before.room_s() : frame.platform_s();
  view_.thrust_m_s2 = frame_s > 0.0 ? gained_m_s / frame_s : Vec3(0.0);
  view_.thrust = frame_s > 0.0 ? gained_m_s / (frame_s * strongest_m_s2_) : Vec3(0.0);
}

PlatformMotion::Manoeuvre PlatformMotion::next(const DriveWish& wish, const Observers& observers,
                                               const Vec3& headInRoom_m, const Left& left) {
  switch (view_.mode) {
    case DriveMode::braking:
      return brake(observers, left);
    case DriveMode::home:
      return returnHome(observers, headInRoom_m, left);
    case DriveMode::tour:
      return alongWay(left);
    case DriveMode::free:
      break;
  }
  return steered(wish.steer, observers, left);
}

PlatformMotion::Manoeuvre PlatformMotion::steered(const Vec3& steer, const Observers& observers,
                                                  const Left& left) {
  const double asked = glm::length(steer);
  if (!(asked > 0.0)) return steered_ ? coast(observers, left) : Manoeuvre{left.platform_s()};
  Vec3 thrust_m_s2 = steer * strongest_m_s2_;
  if (asked > 1.0 + 1e-9) {
    thrust_m_s2 /= asked;
    view_.atLimit = 1;
    notices_.sayOnce(notices_.saidStrongest, texts::message::kStrongestThrust);
  }
  const double left_s = left.platform_s(thrust_m_s2);
  const Lorentz& room = observers.boardFromRoom();
  const Lorentz after = room * Lorentz::fromRapidity(thrust_m_s2 * (left_s / c_m_s_), c_m_s_);
  const Vec3 here_m = observers.headEvent(steering_).r_m;
  if (!staysInHall(after, here_m)) {
    view_.atLimit = 1;
    return stopAtWall(observers, left);
  }
  const double after_u = glm::length(after.u());
  if (after_u <= std::max(most_u_, glm::length(room.u()))) return {left_s, thrust_m_s2};
  view_.atLimit = 1;
  notices_.sayOnce(
      notices_.saidFastest,
      texts::say(texts::message::kFastest, most_u_ / std::hypot(1.0, most_u_), std::hypot(1.0, most_u_)));
  return {left.platform_s()};
}

/// Moves on without thrust, after somebody has steered: brakes where the hall would end.
PlatformMotion::Manoeuvre PlatformMotion::coast(const Observers& observers, const Left& left) {
  const double left_s = left.platform_s();
  const Lorentz& room = observers.boardFromRoom();
  const Vec3 then_m = observers.headEvent(steering_).r_m + room.u() * (c_m_s_ * left_s);
  return staysInHall(room, then_m) ? Manoeuvre{left_s} : stopAtWall(observers, left);
}

PlatformMotion::Manoeuvre PlatformMotion::stopAtWall(const Observers& observers, const Left& left) {
  notices_.sayOnce(notices_.saidWall, texts::message::kHallWall);
  return brake(observers, left);
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
PlatformMotion::Manoeuvre PlatformMotion::brake(const Observers& observers, const Left& left) const {
  const Vec3 board_u = observers.boardFromRoom().inverse().u();
  const double u = glm::length(board_u);
  if (!(u > kAtRest_u)) return {left.platform_s()};
  const Vec3 along = board_u / u;
  const Vec3 thrust_m_s2 = along * strongest_m_s2_;
  const double stops_s = c_m_s_ * std::asinh(u) / strongest_m_s2_;
  if (left.observers.size() > 1)
    return {kEndless_s, left.meanOf([&](double for_s) { return thrust_m_s2 * std::min(for_s, stops_s); })};
  return {std::min(left.platform_s(thrust_m_s2), stops_s), thrust_m_s2};
}

/// Stops, turns to the initial orientation, and moves straight to the initial position. If the viewer walks
/// meanwhile, the room ends slightly off; then the trip is repeated.
PlatformMotion::Manoeuvre PlatformMotion::returnHome(const Observers& observers, const Vec3& headInRoom_m,
                                                     const Left& left) {
  if (!way_.isOver()) return alongWay(left);
  const Lorentz& room = observers.boardFromRoom();
  if (glm::length(room.u()) > kAtRest_u) return brake(observers, left);

  const glm::dquat boardFromRoom = attitudeOf(room);
  glm::dquat turn = glm::conjugate(boardFromRoom) * boardFromHome_.orientation;
  if (turn.w < 0.0) turn = -turn;
  const Vec3 axis(turn.x, turn.y, turn.z);
  const double angle_rad = 2.0 * std::atan2(glm::length(axis), turn.w);
  if (angle_rad > kFacing_rad) {
    const double most_rad = kTurn_rad_s * left.person_s(), share = std::min(1.0, most_rad / angle_rad);
    return {share < 1.0 ? left.platform_s() : left.platform_s() * (angle_rad / most_rad), Vec3(0.0),
            share * angle_rad, axis};
  }
  const Vec3 floor_m = observers.headEvent(steering_).r_m - boardFromRoom * headInRoom_m;
  const Vec3 way_m = boardFromHome_.position_m - floor_m;
  if (glm::length(way_m) > kInPlace_m) {
    way_.take(tripAlong(glm::conjugate(boardFromRoom) * way_m, strongest_m_s2_, most_u_, c_m_s_));
    return alongWay(left);
  }
  leaveWay(DriveMode::free);
  return {left.platform_s()};
}

// Several observers' clocks run differently with each thrust. Over a whole frame the room has the mean of its
// thrusts, so that one lapse holds for each observer and the fastest lives exactly the display's time;
// rapidities add up to the same.
PlatformMotion::Manoeuvre PlatformMotion::alongWay(const Left& left) {
  if (left.observers.size() > 1) {
    const Vec3 mean_m_s2 = left.meanOf([&](double for_s) { return way_.gain_m_s(for_s, strongest_m_s2_); });
    way_.pass(left.platform_s(mean_m_s2), strongest_m_s2_);
    return {kEndless_s, mean_m_s2};
  }
  const auto next = way_.next([&](const Vec3& thrust_m_s2) { return left.platform_s(thrust_m_s2); });
  if (next) return {next->for_s, next->thrust_m_s2};
  return {view_.mode == DriveMode::home ? 0.0 : left.platform_s()};
}

}  // namespace carom
