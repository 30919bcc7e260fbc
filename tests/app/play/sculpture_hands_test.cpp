// Hands on the sculpture of spacetime: what a pull at each of its parts does, for a wand, a mouse and a hand.
#include "app/play/sculpture_hands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kLight_m_s = 1.42, kTop_m = 0.04;

class SculptureHandsTest : public testing::Test {
 protected:
  SculptureHandsTest() {
    view_.place.roomFromFoot = {{1.0, 0.0, -0.5}, glm::dquat(std::sqrt(0.5), -std::sqrt(0.5), 0.0, 0.0)};
    view_.place.past_s = 5.0;
  }
  SculptureMap map() const { return {view_.place, present_, kLight_m_s}; }
  Vec3 inRoom(const Vec3& own_m) const { return view_.place.roomFromFoot * own_m; }

  /// Points from a place to another; `held`: with the button.
  SculptureHands::Outcome point(const Vec3& from_m, const Vec3& to_m, bool held) {
    HandInput hand;
    hand.device = device_;
    hand.from_m = from_m;
    hand.along = glm::normalize(to_m - from_m);
    hand.pressed = held && !held_;
    hand.held = held_ = held;
    return hands_.step(hand, 0, map(), events_, kTop_m, view_);
  }
  /// Takes a point of the sculpture, given in its own axes, and moves the hand with its ray by `pull_m`.
  SculptureHands::Outcome pull(const Vec3& own_m, const Vec3& pull_m) {
    const Vec3 at_m = inRoom(own_m), from_m = at_m + inRoom({0.0, -1.0, 0.1}) - inRoom(Vec3(0.0));
    const Vec3 moved_m = inRoom(pull_m) - inRoom(Vec3(0.0));
    point(from_m, at_m, true);
    const SculptureHands::Outcome outcome = point(from_m + moved_m, at_m + moved_m, true);
    EXPECT_TRUE(outcome.takes);
    EXPECT_TRUE(hands_.holds());
    point(from_m + moved_m, at_m + moved_m, false);
    EXPECT_FALSE(hands_.holds());
    return outcome;
  }
  double present_m() const { return map().present_m() * view_.place.scale; }
  double ring_m() const { return kSculptureRing_m * view_.place.scale; }

  std::string_view device_ = "wand";
  SculptureHands hands_;
  SculptureView view_;
  Event present_{7.0, {0.2, -1.6, 0.9}};
  std::vector<GameEvent> events_;
  bool held_ = false;
};

TEST_F(SculptureHandsTest, TheRingBoostsByRapidity) {
  for (const std::string_view device : {"wand", "mouse", "hand"}) {
    device_ = device;
    view_.place.beta = Vec3(0.0);
    const SculptureHands::Outcome outcome = pull({0.0, -ring_m(), present_m()}, {0.2, -0.1, 0.0});
    EXPECT_TRUE(outcome.boosts);
    EXPECT_FALSE(outcome.atLimit);
    const double size_m = std::hypot(0.2, 0.1);
    const double speed = std::tanh(size_m / SculptureHands::kRapidity_m);
    EXPECT_NEAR(view_.place.beta.x, speed * 0.2 / size_m, 1e-9);
    EXPECT_NEAR(view_.place.beta.y, -speed * 0.1 / size_m, 1e-9);
    EXPECT_EQ(view_.place.beta.z, 0.0);
    pull({0.0, -ring_m(), present_m()}, {-0.2, 0.1, 0.0});
    EXPECT_LT(glm::length(view_.place.beta), 1e-9) << "pulled back";
  }
}

TEST_F(SculptureHandsTest, ABoostEndsAtItsLimit) {
  const SculptureHands::Outcome outcome = pull({0.0, -ring_m(), present_m()}, {5.0, 0.0, 0.0});
  EXPECT_TRUE(outcome.atLimit);
  EXPECT_NEAR(view_.place.beta.x, kMostSculptureBeta, 1e-12);
}

TEST_F(SculptureHandsTest, TheFootMovesItOverTheFloor) {
  const Vec3 was = inRoom(Vec3(0.0));
  const Vec3 expected = inRoom({0.3, 0.2, 0.0});
  pull({0.0, 0.0, 0.1}, {0.3, 0.2, 0.5});
  EXPECT_LT(glm::distance(view_.place.roomFromFoot.position_m, expected), 1e-9);
  EXPECT_NEAR(view_.place.roomFromFoot.position_m.y, was.y, 1e-12) << "on the floor";
}

TEST_F(SculptureHandsTest, TheTopScalesIt) {
  const SculpturePlace was = view_.place;
  pull({0.0, 0.0, 2.1}, {0.0, 0.0, 0.25});
  const double factor = std::exp(0.25 / SculptureHands::kFactor_m);
  EXPECT_NEAR(view_.place.scale, was.scale * factor, 1e-9);
  EXPECT_NEAR(view_.place.height_m, was.height_m * factor, 1e-9);
  pull({0.0, 0.0, 0.95 * view_.place.height_m}, {0.0, 0.0, -50.0});
  EXPECT_GE(view_.place.scale, 0.02);
}

// A point of its near side follows the hand.
TEST_F(SculptureHandsTest, TheMiddleTurnsItWithTheHand) {
  const Vec3 near = inRoom({0.0, -0.2, 1.0}), right = inRoom({1.0, 0.0, 0.0}) - inRoom(Vec3(0.0));
  pull({0.0, 0.0, 1.0}, {0.06, 0.0, 0.0});
  const Vec3 now = inRoom({0.0, -0.2, 1.0});
  EXPECT_GT(glm::dot(now - near, right), 0.02);
  EXPECT_NEAR(2.0 * std::asin(glm::distance(now, near) / 0.4), 0.06 / SculptureHands::kTurn_m, 1e-6);
  EXPECT_NEAR(now.y, near.y, 1e-12);
}

TEST_F(SculptureHandsTest, BeadsArePickedOneAfterTheOther) {
  test::Random random(3630);
  for (std::uint64_t number = 0; number < 5; ++number) {
    GameEvent event;
    event.number = number;
    event.at = {present_.t_s - 0.5 - static_cast<double>(number) * 0.7,
                {random.in(-1.0, 1.0), random.in(-0.6, 0.6), 0.02}};
    events_.push_back(event);
  }
  const auto placeOf = [&](std::size_t i) {
    Event at = events_[i].at;
    at.r_m.z = kTop_m;
    return map().room_m(at);
  };
  const Vec3 eye(1.0, 1.6, 1.0);
  for (std::size_t i = 0; i < events_.size(); ++i) {
    EXPECT_TRUE(point(eye, placeOf(i), true).picked);
    EXPECT_EQ(view_.picked, i + 1);
    EXPECT_EQ(view_.compared, i);
    point(eye, placeOf(i), false);
  }
  EXPECT_TRUE(point(eye, placeOf(4), true).picked);
  EXPECT_EQ(view_.picked, 0u) << "let go of";
  EXPECT_EQ(view_.compared, 0u);
}

TEST_F(SculptureHandsTest, AHandThatPointsElsewhereIsFree) {
  const SculptureView before = view_;
  EXPECT_FALSE(point({1.0, 1.6, 1.0}, {-3.0, 1.0, -1.0}, true).takes);
  EXPECT_FALSE(hands_.holds());
  EXPECT_EQ(view_.place.beta, before.place.beta);
  point({1.0, 1.6, 1.0}, {-3.0, 1.0, -1.0}, false);
  // A press that begins elsewhere takes nothing when it comes to the sculpture.
  point({1.0, 1.6, 1.0}, {-3.0, 1.0, -1.0}, true);
  EXPECT_FALSE(point({1.0, 1.6, 1.0}, inRoom({0.0, 0.0, 1.0}), true).takes);
  HandInput lost;
  hands_.step(lost, 0, map(), events_, kTop_m, view_);
  EXPECT_FALSE(hands_.holds());
}

}  // namespace
}  // namespace carom
