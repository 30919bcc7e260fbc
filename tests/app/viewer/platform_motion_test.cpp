// What the drive does with the platform, against closed forms of hyperbolic motion and against what must hold
// of any person's world line.
#include "app/viewer/platform_motion.h"
#include "engine/spacetime/observers.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/temporary_folder.h"
#include "engine/base/limits.h"
#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;
const RoomAxes kAxes;

Scenario platform(const ObserverStart& start = {}, std::vector<ThrustLeg> tour = {}) {
  Scenario scenario;
  scenario.billiard.lightSpeed_m_s = kC_m_s;
  scenario.observer = start;
  scenario.tour = std::move(tour);
  return scenario;
}

Vec3 standing(double) { return {0.3, 1.7, -0.4}; }

/// A person on a driven platform, frame by frame.
class Ride {
 public:
  Ride(const Scenario& scenario, Vec3 (*walk)(double), double hz = 60.0, double pace = 1.0,
       bool begins = true)
      : drive(scenario, kAxes, begins),
        walk_(walk),
        period_s_(1.0 / hz),
        pace_(pace),
        head_{{walk(0.0), {1, 0, 0, 0}}, Vec3(0.0)},
        observer(startingRoom(scenario.observer, kAxes, kC_m_s), {0.0, scenario.observer.position_m}, head_) {
  }

  /// A frame. What must hold of every one: the head's world line is timelike and does not jump, board time
  /// grows, the thrust is no stronger than the strongest.
  void advance(const DriveWish& wish = {}) {
    const Event before = observer.headEvent();
    lived_s_ += period_s_;
    const Head head{{walk_(lived_s_), {1, 0, 0, 0}}, Vec3(0.0)};
    drive.advance(wish, period_s_, pace_, {&head, 1}, observer);
    const Event after = observer.headEvent();
    const double dt_s = after.t_s - before.t_s, dr_m = glm::distance(after.r_m, before.r_m);
    ASSERT_GE(dt_s, pace_ * period_s_ * (1.0 - 1e-9));
    ASSERT_LT(dr_m, kC_m_s * dt_s);
    // A chord is no shorter than the person's own time in between: here at most by rounding and by walking.
    const double own_s = std::sqrt(dt_s * dt_s - dr_m * dr_m / (kC_m_s * kC_m_s));
    ASSERT_GE(own_s, pace_ * period_s_ * (1.0 - 1e-6));
    ASSERT_LT(own_s, 1.01 * pace_ * period_s_);
    ASSERT_LE(glm::length(drive.view().thrust), 1.0 + 1e-12);
    head_ = head;
  }
  double speed_u() const { return glm::length(observer.boardFromRoom().u()); }
  Vec3 floor_m() const {
    const Displacement down = observer.boardFromRoom() * Displacement{0.0, -head_.roomFromHead.position_m};
    return observer.headEvent().r_m + down.dr_m;
  }

 private:
  double lived_s_ = 0.0;

 public:
  PlatformMotion drive;

 private:
  Vec3 (*walk_)(double);
  double period_s_, pace_;
  Head head_;

 public:
  Observers observer;
};

Vec3 walking(double t_s) {
  return {0.6 * std::sin(0.7 * t_s), 1.7 + 0.02 * std::sin(5.0 * t_s), 0.5 * std::cos(0.9 * t_s)};
}

double turnBetween_rad(const Lorentz& a, const Lorentz& b) {  // of two that rest
  const glm::dmat4 m = (a.inverse() * b).matrix();
  const Vec3 twice(m[2][3] - m[3][2], m[3][1] - m[1][3], m[1][2] - m[2][1]);
  return std::atan2(0.5 * glm::length(twice), 0.5 * (m[1][1] + m[2][2] + m[3][3] - 1.0));
}

/// t = Σ (c/a)(sinh η' − sinh η), x = Σ (c²/a)(cosh η' − cosh η), η' − η = aτ/c: along one line.
struct Line {
  double t_s = 0.0, x_m = 0.0, rapidity = 0.0;

  void push(double a_m_s2, double tau_s) {
    const double after = rapidity + a_m_s2 * tau_s / kC_m_s;
    if (a_m_s2 == 0.0) {
      t_s += tau_s * std::cosh(rapidity);
      x_m += kC_m_s * tau_s * std::sinh(rapidity);
    } else {
      t_s += kC_m_s / a_m_s2 * (std::sinh(after) - std::sinh(rapidity));
      x_m += kC_m_s * kC_m_s / a_m_s2 * (std::cosh(after) - std::cosh(rapidity));
    }
    rapidity = after;
  }
};

// Legs end inside frames, the way is the same: at every frame rate and light's speed for the person.
TEST(PlatformMotion, ATourIsTheSumOfItsHyperbolae) {
  const std::vector<ThrustLeg> tour{
      {0.35, 1.234, {0.8, 0.0, 0.0}}, {1.584, 2.468, {-0.8, 0.0, 0.0}}, {4.5, 1.234, {0.8, 0.0, 0.0}}};
  Scenario scenario = platform({}, tour);
  scenario.tourAtOnce = true;
  for (const double hz : {10.0, 37.0, 60.0, 144.0}) {
    for (const double pace : {1.0, 2.5}) {
      Ride ride(scenario, standing, hz, pace);
      const Event start = ride.observer.headEvent();
      for (int frame = 1; frame <= 7.0 * hz / pace; ++frame) {
        ride.advance();
        Line line;
        double tau_s = pace * frame / hz;
        double at_s = 0.0;
        for (const ThrustLeg& leg : tour) {
          line.push(0.0, std::clamp(tau_s - at_s, 0.0, leg.from_s - at_s));
          line.push(leg.thrust_m_s2.x, std::clamp(tau_s - leg.from_s, 0.0, leg.for_s));
          at_s = leg.from_s + leg.for_s;
        }
        line.push(0.0, std::max(tau_s - at_s, 0.0));
        const Event& head = ride.observer.headEvent();
        ASSERT_NEAR(head.t_s - start.t_s, line.t_s, 1e-11) << hz << " Hz, " << tau_s << " s";
        ASSERT_NEAR(head.r_m.x - start.r_m.x, line.x_m, 1e-11) << hz << " Hz, " << tau_s << " s";
        ASSERT_NEAR(ride.observer.properTime_s(), tau_s, 1e-11);
      }
      EXPECT_EQ(ride.drive.view().mode, DriveMode::free);
      EXPECT_LT(ride.speed_u(), 1e-12);
    }
  }
}

// The platform's clock measures a tour: it ends at rest, whoever walks about on it.
TEST(PlatformMotion, ATourEndsAtRestUnderAWalkingHead) {
  Ride ride(
      platform({}, {{0.0, 2.0, {0.0, -0.9, 0.0}}, {2.0, 4.0, {0.0, 0.9, 0.0}}, {6.0, 2.0, {0.0, -0.9, 0.0}}}),
      walking);
  EXPECT_EQ(ride.drive.view().mode, DriveMode::free);  // it waits to be asked
  ride.advance();
  ride.drive.setOut();
  double fastest_u = 0.0;
  for (int frame = 0; frame < 8 * 60 + 2; ++frame) {
    ride.advance();
    fastest_u = std::max(fastest_u, ride.speed_u());
  }
  EXPECT_GT(fastest_u, 1.5);
  EXPECT_EQ(ride.drive.view().mode, DriveMode::free);
  EXPECT_LT(ride.speed_u(), 1e-12);
  EXPECT_GT(ride.observer.headEvent().t_s, ride.observer.properTime_s() + 1.0);
}

TEST(PlatformMotion, SteeringTakesOver) {
  Ride ride(platform({}, {{0.0, 5.0, {0.0, 0.5, 0.0}}}), standing);
  ride.drive.setOut();
  ride.advance();
  EXPECT_EQ(ride.drive.view().mode, DriveMode::tour);
  ride.advance({.steer = {0.01, 0.0, 0.0}});  // a device's noise
  EXPECT_EQ(ride.drive.view().mode, DriveMode::tour);
  EXPECT_TRUE(ride.drive.takeNotice().english().empty());
  ride.advance({.steer = {0.5, 0.0, 0.0}});
  EXPECT_EQ(ride.drive.view().mode, DriveMode::free);
  EXPECT_EQ(ride.drive.view().thrust, Vec3(0.5, 0.0, 0.0));
  EXPECT_FALSE(ride.drive.takeNotice().english().empty());
  ride.advance({.home = true});
  EXPECT_EQ(ride.drive.view().mode, DriveMode::home);
  ride.advance({.steer = {0.0, 0.0, -0.5}});
  EXPECT_EQ(ride.drive.view().mode, DriveMode::free);

  Ride untold(platform(), standing);
  untold.drive.setOut();
  untold.advance();
  EXPECT_EQ(untold.drive.takeNotice().english(), "This game has no round trip.");
  EXPECT_EQ(untold.drive.view().mode, DriveMode::free);
}

// A tour that began in motion would not end at home.
TEST(PlatformMotion, ATourBeginsAtRestOnceAndSaysHowItEnded) {
  Ride ride(
      platform({}, {{0.0, 1.0, {0.0, -0.9, 0.0}}, {1.0, 2.0, {0.0, 0.9, 0.0}}, {3.0, 1.0, {0.0, -0.9, 0.0}}}),
      standing);
  ride.advance({.steer = {1.0, 0.0, 0.0}});
  ride.drive.takeNotice();
  ride.drive.setOut();
  ride.advance();
  EXPECT_EQ(ride.drive.view().mode, DriveMode::free);
  EXPECT_EQ(ride.drive.takeNotice().english(),
            "The round trip begins at rest: brake (Space) or return to the table (Home) first.");
  for (int frame = 0; frame < 60; ++frame) ride.advance({.brake = true});
  const double board_s = ride.observer.headEvent().t_s;
  ride.drive.setOut();
  ride.advance();
  EXPECT_EQ(ride.drive.view().mode, DriveMode::tour);
  ride.drive.setOut();
  ride.advance();
  EXPECT_EQ(ride.drive.takeNotice().english(), "The round trip is under way already.");
  for (int frame = 0; frame < 4 * 60; ++frame) ride.advance();
  EXPECT_LT(ride.speed_u(), 1e-12);
  const double phi = 0.9 / 1.42, tour_s = 4.0 * std::sinh(phi) / phi;
  EXPECT_LT(ride.observer.headEvent().t_s, board_s + tour_s + 0.1);
  EXPECT_EQ(ride.drive.takeNotice().english(),
            fmt::format("Flight finished: {:.1f} s on the table's clocks, 4.0 s on yours.", tour_s));
}

TEST(PlatformMotion, WhoSteersFarAwayIsToldOnceOfTheWayHome) {
  Ride ride(platform(), standing);
  ride.advance({.steer = {0.0, 0.0, -0.9}});
  EXPECT_TRUE(ride.drive.takeNotice().english().empty());
  int told = 0;
  for (int frame = 0; frame < 12 * 60; ++frame) {
    ride.advance({.steer = {0.0, 0.0, frame < 3 * 60 ? -0.9 : 0.0}});
    told += ride.drive.takeNotice().english().starts_with("You have left the table far behind") ? 1 : 0;
  }
  EXPECT_GT(glm::length(ride.observer.headEvent().r_m), 10.0);
  EXPECT_EQ(told, 1);
}

// A hall with walls that stop: in any direction and from any speed, the head stays within, and it is told
// once.
TEST(PlatformMotion, TheDriveStopsInFrontOfTheHallsWalls) {
  for (int direction = 0; direction < 8; ++direction) {
    Scenario scenario = platform();
    scenario.billiard.board = Board{2.84, 1.42};
    Ride ride(scenario, standing);
    const double angle_rad = direction * std::numbers::pi / 4.0;
    int told = 0;
    double fastest_u = 0.0;
    for (int frame = 0; frame < 40 * 60; ++frame) {
      ride.advance({.steer = {0.9 * std::cos(angle_rad), 0.0, 0.9 * std::sin(angle_rad)}});
      told += ride.drive.takeNotice().english().starts_with("The drive stops in front of the hall's walls")
                  ? 1
                  : 0;
      fastest_u = std::max(fastest_u, ride.speed_u());
      const Vec3 at_m = ride.observer.headEvent().r_m;
      ASSERT_LE(std::abs(at_m.x), 7.0) << "direction " << direction << ", frame " << frame;
      ASSERT_LE(std::abs(at_m.y), 6.0) << "direction " << direction << ", frame " << frame;
    }
    EXPECT_EQ(told, 1) << direction;
    EXPECT_GT(fastest_u, 1.0) << direction;
    const Vec3 at_m = ride.observer.headEvent().r_m;
    EXPECT_TRUE(std::abs(at_m.x) > 6.0 || std::abs(at_m.y) > 5.0) << "up to the wall, not far before it";
  }
}

// A push and then nothing: the room coasts, and still stops in front of the wall.
TEST(PlatformMotion, ACoastingRoomStopsInFrontOfTheHallsWalls) {
  for (const double push_s : {0.5, 1.0, 2.0}) {
    Scenario scenario = platform();
    scenario.billiard.board = Board{2.84, 1.42};
    Ride ride(scenario, standing);
    for (int frame = 0; frame < 30 * 60; ++frame) {
      ride.advance({.steer = {frame < push_s * 60 ? 0.9 : 0.0, 0.0, 0.0}});
      ASSERT_LE(std::abs(ride.observer.headEvent().r_m.x), 7.0)
          << "after " << push_s << " s, frame " << frame;
    }
    EXPECT_LT(ride.speed_u(), 1e-9);
    EXPECT_GT(ride.observer.headEvent().r_m.x, 5.0);
  }
}

TEST(PlatformMotion, IsNoFasterThanTheGameSays) {
  Scenario scenario = platform();
  scenario.most_u = 0.75;  // 0.6 c
  Ride ride(scenario, standing);
  for (int frame = 0; frame < 10 * 60; ++frame) ride.advance({.steer = {0.3, 0.0, -0.9}});
  EXPECT_LE(ride.speed_u(), 0.75);
  EXPECT_GT(ride.speed_u(), 0.98 * 0.75);
}

// The mouse turns the room about the head: the head stays at its event, the room at its speed.
TEST(PlatformMotion, TurnsAboutTheHead) {
  for (const double beta : {0.0, 0.6}) {
    Ride turned(platform({.beta = {beta, 0.0, 0.0}}), standing),
        still(platform({.beta = {beta, 0.0, 0.0}}), standing);
    turned.advance({.turn_rad = 0.3});
    still.advance();
    EXPECT_LT(glm::distance(turned.observer.headEvent().r_m, still.observer.headEvent().r_m), 1e-12);
    EXPECT_NEAR(turned.speed_u(), still.speed_u(), 1e-12);
    // What lay ahead, −z, lies 0.3 rad to the right now.
    const Vec3 place = (turned.observer.boardFromRoom().inverse() *
                        (still.observer.boardFromRoom() * Displacement{0.0, {0.0, 0.0, -1.0}}))
                           .dr_m;
    EXPECT_NEAR(std::atan2(place.x, -place.z), 0.3, 1e-12) << beta;
  }
}

TEST(PlatformMotion, NoMoreThanTheStrongestThrustAndItSaysSoOnce) {
  Ride ride(platform(), standing);
  ride.advance({.steer = {0.0, 0.0, -1.0}});
  EXPECT_EQ(ride.drive.view().atLimit, 0);
  ride.advance({.steer = {1.0, 0.0, -1.0}});
  EXPECT_EQ(ride.drive.view().atLimit, 1);
  EXPECT_NEAR(glm::length(ride.drive.view().thrust), 1.0, 1e-12);
  EXPECT_EQ(ride.drive.takeNotice().english(), "Full thrust.");
  ride.advance({.steer = {1.0, 0.0, -1.0}});
  EXPECT_TRUE(ride.drive.takeNotice().english().empty());
  EXPECT_NEAR(strongestThrust_m_s2(kC_m_s) * 1.0, kC_m_s * kC_m_s / 2.0, 1e-15);  // times a metre
}

// Held for an hour, the stick makes nobody so fast that the game could not keep up.
TEST(PlatformMotion, MakesNobodyTooFast) {
  Ride ride(platform(), standing);
  for (int frame = 0; frame < 60 * 60; ++frame) ride.advance({.steer = {0.3, 0.0, -0.9}});
  EXPECT_LE(ride.speed_u(), kMostPlatformU);
  EXPECT_GT(ride.speed_u(), 0.98 * kMostPlatformU);
  EXPECT_EQ(ride.drive.view().atLimit, 1);
  EXPECT_EQ(ride.drive.view().thrust, Vec3(0.0));

  Ride born(platform({.beta = {0.9999, 0.0, 0.0}}),
            standing);  // faster than it could become: it may slow down
  const double before_u = born.speed_u();
  for (int frame = 0; frame < 60; ++frame) born.advance({.steer = {0.0, 0.0, 1.0}, .brake = frame > 30});
  EXPECT_LT(born.speed_u(), before_u);
}

class Seeded : public testing::TestWithParam<int> {};

DriveWish seededWish(test::Random& random) {
  Vec3 steer = random.inBall(1.0);
  steer.y = 0.0;
  return {.steer = steer};
}

TEST_P(Seeded, BrakingEndsAtRestAndStays) {
  test::Random random(static_cast<std::uint64_t>(GetParam()));
  for (const auto walk : {standing, walking}) {
    const ObserverStart start{.facing_rad = random.in(-4.0, 4.0), .beta = random.inBall(0.97)};
    SCOPED_TRACE(testing::Message() << "β " << start.beta.x << ' ' << start.beta.y << ' ' << start.beta.z);
    Ride ride(platform(start), walk, random.in(20.0, 120.0));
    for (int frame = 0; frame < 50; ++frame) ride.advance(seededWish(random));
    const double needs_s = std::asinh(ride.speed_u()) * kC_m_s / strongestThrust_m_s2(kC_m_s);
    const double began_s = ride.observer.properTime_s();
    double last_u = ride.speed_u();
    while (ride.speed_u() > 1e-12 && ride.observer.properTime_s() < began_s + 20.0) {
      ride.advance({.brake = true});
      EXPECT_EQ(ride.drive.view().mode, DriveMode::braking);
      ASSERT_LT(ride.speed_u(), last_u);
      last_u = ride.speed_u();
    }
    if (walk == standing) {
      EXPECT_NEAR(ride.observer.properTime_s() - began_s, needs_s, 1.0 / 20.0);
    }
    const Lorentz rests = ride.observer.boardFromRoom();
    for (int frame = 0; frame < 20; ++frame) {
      ride.advance({.brake = true});
      EXPECT_EQ(ride.drive.view().thrust, Vec3(0.0));
      EXPECT_EQ(ride.observer.boardFromRoom().matrix(), rests.matrix());
    }
    EXPECT_LT(ride.speed_u(), 1e-12);
  }
}

TEST_P(Seeded, HomeIsWhereItStartedAtRestAsItStood) {
  test::Random random(static_cast<std::uint64_t>(100 + GetParam()));
  for (const auto walk : {standing, walking}) {
    const ObserverStart start{.position_m = random.inBox(2.0),
                              .facing_rad = random.in(-4.0, 4.0),
                              .beta = GetParam() % 2 == 0 ? Vec3(0.0) : random.inBall(0.8)};
    Ride ride(platform(start), walk, random.in(20.0, 120.0));
    DriveWish wish;
    for (int frame = 0; frame < 400; ++frame) {
      if (frame % 25 == 0) wish = seededWish(random);
      ride.advance(wish);
    }
    ride.advance({.home = true});
    int frames = 0;
    while (ride.drive.view().mode == DriveMode::home && ++frames < 40000) ride.advance();
    SCOPED_TRACE(testing::Message() << "after " << frames << " frames");
    EXPECT_EQ(ride.drive.view().mode, DriveMode::free);
    EXPECT_LT(ride.speed_u(), 1e-12);
    EXPECT_LT(glm::distance(ride.floor_m(), start.position_m), 1e-3);
    ObserverStart rests = start;
    rests.beta = Vec3(0.0);
    EXPECT_LT(turnBetween_rad(startingRoom(rests, kAxes, kC_m_s), ride.observer.boardFromRoom()), 1e-8);
  }
}

INSTANTIATE_TEST_SUITE_P(PlatformMotion, Seeded, testing::Range(0, 12));

// Straight there and back, with nobody walking: at the strongest thrust half the way, γ − 1 = a x/c².
TEST(PlatformMotion, TheWayHomeIsTheShortestThatTheDriveCanDo) {
  Ride ride(platform(), standing);
  const double a_m_s2 = strongestThrust_m_s2(kC_m_s);
  for (int frame = 0; frame < 120; ++frame) ride.advance({.steer = {0.0, 0.0, -1.0}});
  while (ride.speed_u() > 1e-12) ride.advance({.brake = true});
  const double away_m = glm::distance(ride.floor_m(), ObserverStart{}.position_m);
  ASSERT_GT(away_m, 2.0);
  const double needs_s = 2.0 * kC_m_s / a_m_s2 * std::acosh(1.0 + a_m_s2 * 0.5 * away_m / (kC_m_s * kC_m_s));
  const double began_s = ride.observer.properTime_s();
  ride.advance({.home = true});
  while (ride.drive.view().mode == DriveMode::home) ride.advance();
  EXPECT_NEAR(ride.observer.properTime_s() - began_s, needs_s, 1.5 / 60.0);
}

// Thomas precession: thrust to the right, ahead, to the left and back leaves a turn about the vertical, which
// the way home undoes at no more than 30° a second.
TEST(PlatformMotion, HomeUndoesTheTurnOfSidewaysThrust) {
  Ride ride(platform(), standing);
  for (int frame = 0; frame < 400; ++frame) {
    const double angle_rad = 2.0 * std::numbers::pi * frame / 200.0;
    ride.advance({.steer = {std::cos(angle_rad), 0.0, std::sin(angle_rad)}});
  }
  while (ride.speed_u() > 1e-12) ride.advance({.brake = true});
  const Lorentz home = startingRoom({}, kAxes, kC_m_s);
  const double turned_rad = turnBetween_rad(home, ride.observer.boardFromRoom());
  ASSERT_GT(turned_rad, 0.2);
  ride.advance({.home = true});
  double last_rad = turnBetween_rad(home, ride.observer.boardFromRoom());
  ASSERT_LT(last_rad, turned_rad);
  while (last_rad > 1e-8) {
    ride.advance();
    const double rad = turnBetween_rad(home, ride.observer.boardFromRoom());
    ASSERT_LT(rad, last_rad);
    ASSERT_LT(last_rad - rad, std::numbers::pi / 6.0 / 60.0 + 1e-9);
    last_rad = rad;
  }
  while (ride.drive.view().mode == DriveMode::home) ride.advance();
  EXPECT_LT(glm::distance(ride.floor_m(), ObserverStart{}.position_m), 1e-3);
}

// Steered for minutes by a person who walks about: Ride::live holds in every frame.
TEST(PlatformMotion, BoardTimeGrowsWhateverHandsAndFeetDo) {
  test::Random random(7);
  Ride ride(platform(), walking);
  DriveWish wish;
  for (int frame = 0; frame < 60 * 180; ++frame) {
    if (frame % 40 == 0) {
      wish = {.steer = random.inBall(1.2), .brake = random.in(0.0, 1.0) < 0.3};
      wish.home = random.in(0.0, 1.0) < 0.1;
    }
    ride.advance(wish);
  }
}

}  // namespace
}  // namespace carom
