#include "engine/spacetime/observers.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <stdexcept>

#include "engine/base/limits.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;
const Event kOrigin{0.0, Vec3(0.0)};

Head headAt(const Vec3& position_m, const Vec3& celerity_m_s = Vec3(0.0)) {
  return {{position_m, glm::dquat(1.0, 0.0, 0.0, 0.0)}, celerity_m_s};
}

TEST(Observers, StandingStillOnTheBoardBothClocksAgree) {
  Observers observer(Lorentz(kC_m_s), kOrigin, headAt({0.0, 1.7, 0.0}));
  for (int i = 0; i < 600; ++i) observer.step(1.0 / 60.0, headAt({0.0, 1.7, 0.0}));
  EXPECT_NEAR(observer.headEvent().t_s, 10.0, 1e-12);
  EXPECT_NEAR(observer.properTime_s(), 10.0, 1e-12);
}

// Walking at celerity w: β = w/sqrt(c² + w²), board time = γ τ. Never faster than light, at any w.
TEST(Observers, WalkingIsTimelikeAtAnyPace) {
  for (const double celerity_m_s : {0.5, 1.42, 5.0, 11.9}) {
    Observers observer(Lorentz(kC_m_s), kOrigin, headAt(Vec3(0.0)));
    for (int i = 1; i <= 60; ++i) observer.step(1.0 / 60.0, headAt({celerity_m_s * i / 60.0, 0.0, 0.0}));
    const double gamma = std::hypot(1.0, celerity_m_s / kC_m_s);
    EXPECT_NEAR(observer.headEvent().t_s, gamma, 1e-12);
    EXPECT_NEAR(observer.headEvent().r_m.x, celerity_m_s, 1e-12);
    EXPECT_LT(observer.headEvent().r_m.x, kC_m_s * observer.headEvent().t_s);
  }
}

TEST(Observers, AGlitchOfTheTrackerIsNotTravel) {
  Observers observer(Lorentz(kC_m_s), kOrigin, headAt(Vec3(0.0)));
  observer.step(1.0 / 60.0, headAt({1.0, 0.0, 0.0}));  // 60 m/s
  EXPECT_NEAR(observer.headEvent().t_s, 1.0 / 60.0, 1e-15);
  EXPECT_EQ(observer.headEvent().r_m.x, 0.0);
  observer.step(1.0 / 60.0, headAt({NAN, 0.0, 0.0}));
  EXPECT_FALSE(std::isnan(observer.headEvent().t_s));
}

// Two share the room's clock: what one head seems to move above 3 m/s drives neither clock, what it moves
// below does.
TEST(Observers, AStepAbove3mPerSecondDrivesNobodysClock) {
  constexpr double kStep_s = 1.0 / 60.0;
  for (const double speed_m_s : {2.9, 3.1, 60.0}) {
    std::array<Head, 2> heads{headAt(Vec3(0.0)), headAt(Vec3(1.0, 0.0, 0.0))};
    Observers pair(Lorentz(kC_m_s), kOrigin, heads);
    heads[0] = headAt({speed_m_s * kStep_s, 0.0, 0.0});
    pair.beginFrame();
    pair.step(kStep_s, heads);
    const double gamma = speed_m_s < 3.0 ? std::hypot(1.0, speed_m_s / kC_m_s) : 1.0;
    EXPECT_NEAR(pair.properTime_s(0), kStep_s, 1e-15) << speed_m_s << " m/s";
    EXPECT_NEAR(pair.properTime_s(1), gamma * kStep_s, 1e-15) << speed_m_s << " m/s";
    EXPECT_NEAR(pair.room_s(), gamma * kStep_s, 1e-15) << speed_m_s << " m/s";
  }
}

// Eyes simultaneous in the head frame differ on the board by γβ d/c: 93 ms at β = 0.9, 64 mm, c = 1.42 m/s.
TEST(Observers, EyesAreSimultaneousForTheHead) {
  const Lorentz boardFromRoom = Lorentz::boost(uFromBeta({0.9, 0.0, 0.0}), kC_m_s);
  const Observers observer(boardFromRoom, kOrigin, headAt(Vec3(0.0)));
  const ObserverView view = observer.view(0.064);
  const double apart_s = view.right.observation.t_s - view.left.observation.t_s;
  EXPECT_NEAR(apart_s, 0.9 / std::sqrt(1 - 0.81) * 0.064 / kC_m_s, 1e-12);
  EXPECT_NEAR(apart_s, 0.093, 0.0005);
  const Displacement inHead = view.headFromBoard * (view.right.observation - view.left.observation);
  EXPECT_NEAR(inHead.dt_s, 0.0, 1e-14);
  EXPECT_NEAR(inHead.dr_m.x, 0.064, 1e-14);
  // Of who walks in the room, too.
  const Observers walking(boardFromRoom, kOrigin, headAt(Vec3(0.0), {0.7, 0.2, -0.3}));
  const ObserverView seen = walking.view(0.064);
  const Displacement walker = seen.headFromBoard * (seen.right.observation - seen.left.observation);
  EXPECT_NEAR(walker.dt_s, 0.0, 1e-14);
  EXPECT_NEAR(walker.dr_m.x, 0.064, 1e-14);
}

// Two share a moving room: what the second one sees follows from the first one's view and the place alone,
// also if the first one walks.
TEST(Observers, WhoRestsElsewhereInTheRoomSeesByTheSamePresent) {
  test::Random random(23);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    const Lorentz boardFromRoom =
        Lorentz::boost(random.u(0.95), kC_m_s) *
        Lorentz::rotation(glm::angleAxis(random.in(0.0, 6.0), glm::normalize(random.inBox(1.0))), kC_m_s);
    const std::array heads{headAt(random.inBox(2.0), random.inBox(1.0)), headAt(random.inBox(2.0))};
    const Observers observers(boardFromRoom, {3.0, {0.5, -0.2, 0.1}}, heads);
    const Vec3 right_m = random.inBox(0.1);
    const ObserverView expected = observers.view(-right_m, right_m, 1);
    const ObserverView seen =
        viewAtRest(observers.view(0.064, 0), boardFromRoom, 7.0, heads[1].roomFromHead.position_m, right_m);
    EXPECT_EQ(seen.properTime_s, 7.0);
    for (const Eye eye : {Eye::left, Eye::right, Eye::middle}) {
      EXPECT_NEAR(seen.of(eye).observation.t_s, expected.of(eye).observation.t_s, 1e-12);
      EXPECT_LT(glm::distance(seen.of(eye).observation.r_m, expected.of(eye).observation.r_m), 1e-12);
      EXPECT_LT(glm::distance(seen.of(eye).positionInRoom_m, expected.of(eye).positionInRoom_m), 1e-14);
      EXPECT_LT(glm::distance(seen.of(eye).seenFromInRoom_m, expected.of(eye).seenFromInRoom_m), 1e-14);
    }
    EXPECT_LT(glm::distance(seen.headFromBoard.u(), expected.headFromBoard.u()), 1e-12);
  }
}

// Eyes that face elsewhere than the head are as simultaneous for it as its own.
TEST(Observers, TurnedEyesAreSimultaneousForTheHead) {
  const Observers walking(Lorentz::boost(uFromBeta({0.9, 0.0, 0.0}), kC_m_s), kOrigin,
                          headAt({0.3, 1.7, 0.0}, {0.7, 0.2, -0.3}));
  const Vec3 right_m{0.0, 0.01, -0.03};
  const ObserverView head = walking.view(0.064), expected = walking.view(-right_m, right_m);
  const ObserverView seen = viewOfEyes(head.headFromBoard, head.middle, right_m, head.properTime_s);
  for (const Eye eye : {Eye::left, Eye::right, Eye::middle}) {
    EXPECT_NEAR(seen.of(eye).observation.t_s, expected.of(eye).observation.t_s, 1e-13);
    EXPECT_LT(glm::distance(seen.of(eye).observation.r_m, expected.of(eye).observation.r_m), 1e-13);
    EXPECT_LT(glm::distance(seen.of(eye).positionInRoom_m, expected.of(eye).positionInRoom_m), 1e-15);
  }
}

// The walk in the room, boosted by the platform: velocities add as relativity says, w' = γ_w γ_V (…).
TEST(Observers, CelerityOfHeadAndPlatformCompose) {
  const Vec3 platformU = uFromBeta({0.0, 0.6, 0.0});
  const Vec3 celerity_m_s{0.8, 0.0, 0.3};
  const Observers observer(Lorentz::boost(platformU, kC_m_s), kOrigin, headAt(Vec3(0.0), celerity_m_s));
  const Vec3 u = observer.view(0.064).headFromBoard.inverse().u();
  const Vec3 walk = celerity_m_s / kC_m_s;
  EXPECT_NEAR(gammaFromU(u), gammaFromU(platformU) * gammaFromU(walk), 1e-12);  // perpendicular
  EXPECT_NEAR(u.x, walk.x, 1e-12);
  EXPECT_NEAR(u.z, walk.z, 1e-12);
}

// Thrust never moves the head's present event; there and back again the person is younger.
TEST(Observers, ThrustKeepsThePresentEventAndComposesRapidities) {
  Observers observer(Lorentz(kC_m_s), kOrigin, headAt({0.4, 1.7, -1.0}));
  const Event before = observer.headEvent();
  const double tiny_s = 1e-9;  // of a thrust so strong that it is a kick
  for (int i = 0; i < 100; ++i)
    observer.step(tiny_s, headAt({0.4, 1.7, -1.0}), 1.0, {0.01 * kC_m_s / tiny_s, 0.0, 0.0});
  EXPECT_NEAR(observer.headEvent().t_s, before.t_s, 2e-7);
  EXPECT_NEAR(observer.boardFromRoom().u().x, std::sinh(1.0), 1e-12);
}

// A constant proper acceleration a for the time τ leads to t = (c/a) sinh(aτ/c), x = (c²/a)(cosh(aτ/c) − 1),
// in however many steps.
TEST(Observers, ConstantThrustIsHyperbolicMotion) {
  const double a_m_s2 = 0.5, tau_s = 4.0, eta = a_m_s2 * tau_s / kC_m_s;
  for (const int steps : {1, 7, 240}) {
    Observers observer(Lorentz(kC_m_s), kOrigin, headAt(Vec3(0.0)));
    for (int i = 0; i < steps; ++i) observer.step(tau_s / steps, headAt(Vec3(0.0)), 1.0, {a_m_s2, 0.0, 0.0});
    EXPECT_NEAR(observer.headEvent().t_s, kC_m_s / a_m_s2 * std::sinh(eta), 1e-12) << steps;
    EXPECT_NEAR(observer.headEvent().r_m.x, kC_m_s * kC_m_s / a_m_s2 * (std::cosh(eta) - 1), 1e-12) << steps;
    EXPECT_NEAR(observer.properTime_s(), tau_s, 1e-12);
  }
}

/// Three people who walk at random in a room that thrusts, and at times turns, about the first or another.
struct SharedRoom {
  struct Worst {
    double chord = 0.0;         ///< of a world line against its proper time, relative
    double least_pace = 1e9;    ///< own time over the display's
    double fastest_pace = 1.0;  ///< the least of each frame, at its greatest
    double least_lapse = 1e9;
  };

  SharedRoom(test::Random& random, double most_m_s) : random_(random), most_m_s_(most_m_s) {
    for (Head& head : heads_) head = headAt(random.inBox(1.4));
    const Lorentz boardFromRoom = Lorentz::boost(random.inBall(3.0), kC_m_s);
    observers_.emplace(boardFromRoom, Event{random.in(-5.0, 5.0), random.inBox(3.0)}, heads_);
  }

  void live(bool turns, Worst& worst) {
    constexpr double kFrame_s = 1.0 / 60.0;
    const Observers before = *observers_;
    const std::size_t steering = frame_ / 50 % heads_.size();
    if (frame_++ % 50 == 0) {
      const double strongest_m_s2 = strongestThrust_m_s2(kC_m_s, before.farthestFrom_m(steering) + 1.5);
      thrust_m_s2_ = random_.inBall(1.0) * strongest_m_s2;
    }
    for (Head& head : heads_) head.roomFromHead.position_m += random_.inBall(most_m_s_) * kFrame_s;
    observers_->beginFrame();
    if (turns) observers_->turn({random_.in(-0.02, 0.02), {0.0, 0.0, 1.0}}, steering);
    const RoomTurn after{turns ? random_.in(-0.02, 0.02) : 0.0, {0.3, 0.5, 1.0}};
    observers_->step(kFrame_s, heads_, 1.0, thrust_m_s2_, steering, after);
    double least_s = 1e9;
    for (std::size_t i = 0; i < heads_.size(); ++i) {
      const double own_s = observers_->properTime_s(i) - before.properTime_s(i);
      const Displacement chord = observers_->headEvent(i) - before.headEvent(i);
      ASSERT_GT(chord.dt_s, 0.0);
      ASSERT_GT(interval_m2(chord, kC_m_s), 0.0) << "not timelike";
      const double chord_s = std::sqrt(interval_m2(chord, kC_m_s)) / kC_m_s;
      worst.chord = std::max(worst.chord, std::abs(chord_s / own_s - 1.0));
      worst.least_pace = std::min(worst.least_pace, own_s / kFrame_s);
      worst.least_lapse = std::min(worst.least_lapse, (*observers_)[i].lapse);
      least_s = std::min(least_s, own_s);
      expectFormulas(before, i, turns);
      for (std::size_t k = 0; k < i; ++k) {
        const Displacement apart = observers_->headEvent(i) - observers_->headEvent(k);
        ASSERT_LT(interval_m2(apart, kC_m_s), 1e-9) << "one's present lies in the past of another";
      }
    }
    worst.fastest_pace = std::max(worst.fastest_pace, least_s / kFrame_s);
  }

  /// One room time: dτ² = (N dT)² − |dx|²/c² for each, with the values that are reported.
  void expectFormulas(const Observers& before, std::size_t i, bool turns) const {
    if (turns) return;  // a turn carries the others
    const double roomTime_s = observers_->room_s() - before.room_s();
    const double way_s = glm::distance((*observers_)[i].placeInRoom_m, before[i].placeInRoom_m) / kC_m_s;
    const double own_s = observers_->properTime_s(i) - before.properTime_s(i);
    EXPECT_NEAR(std::hypot(own_s, way_s), (*observers_)[i].lapse * roomTime_s, 1e-12);
  }

  test::Random& random_;
  double most_m_s_;
  std::array<Head, 3> heads_;
  std::optional<Observers> observers_;
  Vec3 thrust_m_s2_{0.0};
  std::size_t frame_ = 0;
};

TEST(Observers, SeveralShareOneRoomTime) {
  test::Random random(19);
  SharedRoom::Worst worst;
  for (int room = 0; room < 200; ++room) {
    SharedRoom shared(random, 2.0);
    for (int frame = 0; frame < 200 && !::testing::Test::HasFailure(); ++frame) shared.live(false, worst);
  }
  // A frame's chord is shorter than its world line only by the curvature within the frame.
  EXPECT_LT(worst.chord, 3e-4);
  EXPECT_GT(worst.least_pace, 1.0 - 1e-9) << "nobody's clock is slower than the display's";
  EXPECT_LT(worst.fastest_pace, 1.0 + 1e-9) << "the fastest observer's clock is the display's";
  EXPECT_GT(worst.least_lapse, 0.49);
  EXPECT_LT(worst.least_lapse, 0.7) << "the rooms thrust too little for this test";
}

TEST(Observers, TurnsOfTheRoomCarryTheOthersNoFasterThanLight) {
  test::Random random(20);
  SharedRoom::Worst worst;
  for (int room = 0; room < 50; ++room) {
    SharedRoom shared(random, 2.9);
    for (int frame = 0; frame < 200 && !::testing::Test::HasFailure(); ++frame) shared.live(true, worst);
  }
  EXPECT_GT(worst.least_pace, 1.0 - 1e-9);
}

// The twins in one room: who stands ages by sqrt(1 + w²/c²) of the walker's time, w the walker's celerity.
TEST(Observers, WhoMovesLeastAgesMost) {
  std::array<Head, 2> heads{headAt({0.0, 1.7, 0.0}), headAt({1.0, 1.7, 0.0})};
  Observers observers(Lorentz(kC_m_s), kOrigin, heads);
  for (int i = 1; i <= 60; ++i) {
    heads[1].roomFromHead.position_m.z = 1.2 * i / 60.0;
    observers.beginFrame();
    observers.step(1.0 / 60.0, heads);
  }
  EXPECT_NEAR(observers.properTime_s(1), 1.0, 1e-12);
  EXPECT_NEAR(observers.properTime_s(0), std::hypot(1.0, 1.2 / kC_m_s), 1e-12);
  EXPECT_NEAR(observers.room_s(), observers.properTime_s(0), 1e-12);
  EXPECT_NEAR(observers.headEvent(0).t_s, observers.headEvent(1).t_s, 1e-12);
}

// Where the thrust turns round within a frame, now the one's, now the other's clock runs slower.
TEST(Observers, OverAFrameOfSeveralThrustsTheFastestLivesTheDisplaysTime) {
  constexpr double kFrame_s = 1.0 / 60.0, kThrust_m_s2 = 0.5 * kC_m_s * kC_m_s;
  std::array<Head, 2> heads{headAt({0.0, 1.7, 0.0}, {0.0, 0.0, 0.4}),
                            headAt({1.0, 1.7, 0.0}, {0.0, 0.0, 1.2})};
  Observers observers(Lorentz(kC_m_s), kOrigin, heads);
  for (int frame = 0; frame < 60; ++frame) {
    const std::array<double, 2> before_s{observers.properTime_s(0), observers.properTime_s(1)};
    const Observers before = observers;
    observers.beginFrame();
    for (const double share : {0.3, 0.5, 0.2}) {
      for (Head& head : heads) head.roomFromHead.position_m.z += 0.4 * share * kFrame_s;
      heads[1].roomFromHead.position_m.z += 0.8 * share * kFrame_s;
      observers.step(share * kFrame_s, heads, 1.0, {share == 0.5 ? kThrust_m_s2 : -kThrust_m_s2, 0.0, 0.0});
    }
    double least_s = 1.0;
    for (std::size_t i = 0; i < 2; ++i) {
      const double own_s = observers.properTime_s(i) - before_s[i];
      least_s = std::min(least_s, own_s);
      // The head's celerity is its motion per display time, in the own time of the whole frame; and the lapse
      // that is told is the one with which this own time follows from the room's time.
      EXPECT_NEAR(observers[i].head.celerity_m_s.z, heads[i].celerity_m_s.z * kFrame_s / own_s, 1e-12);
      const double way_m = (i == 0 ? 0.4 : 1.2) * kFrame_s, room_s = observers.room_s() - before.room_s();
      EXPECT_NEAR(observers[i].lapse * room_s, std::hypot(own_s, way_m / kC_m_s), 1e-14);
      const Displacement chord = observers.headEvent(i) - before.headEvent(i);
      EXPECT_GT(interval_m2(chord, kC_m_s), 0.0);
      EXPECT_NEAR(std::sqrt(interval_m2(chord, kC_m_s)) / kC_m_s, own_s, 0.02 * own_s);
    }
    EXPECT_NEAR(least_s, kFrame_s, 1e-14);
  }
}

TEST(Observers, AJumpOfOnesTrackerDrivesNobodysClock) {
  std::array<Head, 2> heads{headAt({0.0, 1.7, 0.0}), headAt({1.0, 1.7, 0.0})};
  Observers observers(Lorentz(kC_m_s), kOrigin, heads);
  heads[1].roomFromHead.position_m.x += 3.1 / 60.0;
  observers.step(1.0 / 60.0, heads);
  EXPECT_EQ(observers.properTime_s(0), 1.0 / 60.0);
  EXPECT_EQ(observers[1].placeInRoom_m.x, 1.0);
  EXPECT_EQ(observers.view(0.064, 1).middle.positionInRoom_m.x, heads[1].roomFromHead.position_m.x);
  EXPECT_NEAR(observers.headEvent(1).r_m.x - observers.headEvent(0).r_m.x, 1.0, 1e-15);
}

TEST(Observers, ARoomHoldsOneToFour) {
  const std::array<Head, 5> heads{};
  EXPECT_THROW(Observers(Lorentz(kC_m_s), kOrigin, heads), std::invalid_argument);
  EXPECT_THROW(Observers(Lorentz(kC_m_s), kOrigin, std::span<const Head>()), std::invalid_argument);
}

}  // namespace
}  // namespace carom
