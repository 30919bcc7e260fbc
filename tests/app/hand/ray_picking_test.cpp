// What a hand points to: pucks where they are seen, against a search by another way (light_cone.h
// `emission`), and the cloth as it stands in the room.

#include "app/hand/ray_picking.h"
#include "engine/spacetime/observers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42, kRadius_m = 0.0321;

WorldLine puckAt(const Vec3& place_m, const Vec3& beta) {
  const Event start{0.0, place_m};
  return WorldLine({start, uFromBeta(beta), 0.0, start, 0.0}, kC_m_s, kRadius_m);
}

/// A person 1.6 m from the table's middle on a platform with that motion, whose head moves in the room.
struct Viewer {
  Viewer(const Vec3& beta, const Vec3& celerity_m_s)
      : boardFromRoom(Lorentz::boost(uFromBeta(beta), kC_m_s)),
        head{{{0.3, -0.2, 1.7}, {1.0, 0.0, 0.0, 0.0}}, celerity_m_s},
        observer(Observers::at({5.0, {0.4, -1.5, 0.95}}, 5.0, boardFromRoom, head).view(0.064)) {}
  Lorentz boardFromRoom;
  Head head;
  ObserverView observer;
};

Vec3 directionTo(const Vec3& from_m, const Vec3& to_m) { return glm::normalize(to_m - from_m); }

TEST(RayPicking, SeesThePuckWhereItsLightComesFrom) {
  test::Random random(3);
  RayPicking aim;
  const Switches all;
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    const Viewer person(random.direction() * random.in(0.0, 0.95), random.inBall(1.5));
    const WorldLine puck = test::randomWorldLine(random, kC_m_s, kRadius_m, 8, 0.7, 0.9);
    for (const Eye eye : {Eye::left, Eye::right, Eye::middle}) {
      const EyeView& at = person.observer.of(eye);
      const auto light = emission(puck, Vec3(0.0), at.observation, person.observer.headFromBoard);
      ASSERT_TRUE(light);
      const Vec3 seen_m = aim.seenInRoom_m(puck, {person.observer, eye, all});
      EXPECT_LT(glm::distance(seen_m, at.seenFromInRoom_m + light->seen.dr_m), 1e-11);
    }
  }
}

// Without retardation it is where it is at the eye's board time, without aberration turned into the head's
// axes alone; with neither, Euclid.
TEST(RayPicking, SwitchesMoveWhatIsPointedTo) {
  RayPicking aim;
  const Viewer person({0.0, 0.6, 0.0}, Vec3(0.0));
  const WorldLine puck = puckAt({-1.0, 0.2, 0.01}, {0.5, 0.0, 0.0});
  const EyeView& eye = person.observer.middle;
  Switches switches = kNoSwitches;
  const Vec3 there_m = puck.at(eye.observation.t_s).event.r_m - eye.observation.r_m;
  EXPECT_LT(glm::distance(aim.seenInRoom_m(puck, {person.observer, Eye::middle, switches}),
                          eye.seenFromInRoom_m + there_m),
            1e-12);
  switches.aberration = 1;  // a ray (−|x|, x) that has come straight
  const Vec3 ray_m =
      (person.observer.headFromBoard * Displacement{-glm::length(there_m) / kC_m_s, there_m}).dr_m;
  EXPECT_LT(glm::distance(aim.seenInRoom_m(puck, {person.observer, Eye::middle, switches}),
                          eye.seenFromInRoom_m + ray_m),
            1e-12);
  switches = Switches();
  switches.aberration = 0;
  const Vec3 light_m = centreSeen(puck, eye.observation).event.r_m - eye.observation.r_m;
  EXPECT_LT(glm::distance(aim.seenInRoom_m(puck, {person.observer, Eye::middle, switches}),
                          eye.seenFromInRoom_m + light_m),
            1e-12);
}

// A platform at 0.95 c: what is hit is what is seen; a ray at where the puck is by now, in the room, misses.
TEST(RayPicking, AFastPuckIsHitWhereItIsSeen) {
  RayPicking aim;
  const Switches all;
  const Viewer person({0.95, 0.0, 0.0}, Vec3(0.0));
  const std::array<WorldLine, 2> pucks{puckAt({-2.0, 0.3, 0.01}, {0.6, 0.0, 0.0}),
                                       puckAt({1.3, 0.5, 0.01}, {})};
  const Vec3 hand_m(0.5, -0.1, 1.2);
  for (std::size_t i = 0; i < pucks.size(); ++i) {
    const Vec3 seen_m = aim.seenInRoom_m(pucks[i], {person.observer, Eye::middle, all});
    const PickResult pointed = aim.at({hand_m, directionTo(hand_m, seen_m)}, pucks,
                                      {person.observer, Eye::middle, all}, person.boardFromRoom);
    EXPECT_EQ(pointed.puck, i);
    EXPECT_LT(glm::distance(pointed.end_m, seen_m), 1e-12);
    // Where it is at the head's moment in the room.
    const Event& head = person.observer.middle.observation;
    double now_s = head.t_s;
    for (int k = 0; k < 2000; ++k)
      now_s -= (person.boardFromRoom.inverse() * (pucks[i].at(now_s).event - head)).dt_s * 0.2;
    const Vec3 now_m = person.head.roomFromHead.position_m +
                       (person.boardFromRoom.inverse() * (pucks[i].at(now_s).event - head)).dr_m;
    ASSERT_GT(glm::distance(now_m, seen_m), 0.3);
    EXPECT_NE(aim.at({hand_m, directionTo(hand_m, now_m)}, pucks, {person.observer, Eye::middle, all},
                     person.boardFromRoom)
                  .puck,
              i);
  }
}

class StillRoom : public testing::Test {
 protected:
  PickResult at(const Vec3& from_m, const Vec3& to_m) {
    return aim_.at({from_m, directionTo(from_m, to_m)}, pucks_, {person_.observer, Eye::middle, all_},
                   person_.boardFromRoom);
  }
  Vec3 seen_m(std::size_t puck) {
    return aim_.seenInRoom_m(pucks_[puck], {person_.observer, Eye::middle, all_});
  }

  Viewer person_{Vec3(0.0), Vec3(0.0)};
  Switches all_;
  RayPicking aim_;
  const Vec3 hand_m_{0.2, 0.3, 1.2};
  std::vector<WorldLine> pucks_;
};

TEST_F(StillRoom, TheFirstPuckThatIsHitHidesTheOthers) {
  pucks_ = {puckAt({0.3, 0.9, 0.01}, {}), puckAt({0.3, 0.0, 0.01}, {}), puckAt({0.3, 0.45, 0.01}, {})};
  const Vec3 level(0.0, 1.0, 0.0);
  // Along the row of pucks, in any order of them.
  const Vec3 from_m = seen_m(1) - level;
  EXPECT_EQ(at(from_m, seen_m(0)).puck, 1u);
  EXPECT_EQ(at(seen_m(1) + 0.1 * level, seen_m(0)).puck, 2u) << "the nearest lies behind the hand";
}

TEST_F(StillRoom, AFarPuckIsMeantByARayThatPassesItClosely) {
  pucks_ = {puckAt({0.4, 1.9, 0.01}, {}), puckAt({-0.3, 0.2, 0.01}, {})};
  const Vec3 seen = seen_m(0), across(1.0, 0.0, 0.0);
  const double far_m = glm::distance(hand_m_, seen);
  EXPECT_EQ(at(hand_m_, seen + (0.9 * RayPicking::kNear_rad * far_m + kRadius_m) * across).puck, 0u);
  EXPECT_FALSE(at(hand_m_, seen + (1.2 * RayPicking::kNear_rad * far_m + kRadius_m) * across).puck);
  // One that is hit goes before one that is passed, and of two that are passed the closer.
  pucks_ = {puckAt({0.4, 0.9, 0.01}, {}), puckAt({0.4 + 1.3 * kRadius_m, 0.9, 0.01}, {})};
  EXPECT_EQ(at(hand_m_, seen_m(0) - 1.1 * kRadius_m * across).puck, 0u);
  EXPECT_EQ(at(hand_m_, seen_m(1) + 0.9 * kRadius_m * across).puck, 1u);
}

TEST_F(StillRoom, WhatLiesBehindTheHandIsNotHitButKnown) {
  pucks_ = {puckAt({0.4, 0.9, 0.01}, {})};
  const PickResult away = at(hand_m_, 2.0 * hand_m_ - seen_m(0));
  EXPECT_FALSE(away.puck);
  EXPECT_TRUE(away.behind);
  EXPECT_FALSE(at(hand_m_, hand_m_ + Vec3(1.0, 0.0, 0.0)).behind);
  EXPECT_FALSE(at(hand_m_, seen_m(0)).behind);
}

TEST_F(StillRoom, ARayEndsOnTheClothOrInTheAir) {
  pucks_.clear();
  // The head is at z = 1.7 m of the room and 0.95 m of the board.
  EXPECT_NEAR(at(hand_m_, {0.7, 1.4, 0.9}).end_m.z, 0.75, 1e-12);
  EXPECT_NEAR(glm::distance(at(hand_m_, hand_m_ + Vec3(0.0, 1.0, 0.1)).end_m, hand_m_),
              RayPicking::kLongest_m, 1e-12);
  EXPECT_NEAR(glm::distance(at({0.0, 0.0, 0.2}, {0.0, 0.5, 0.1}).end_m, Vec3(0.0, 0.0, 0.2)),
              RayPicking::kLongest_m, 1e-12)
      << "from below the cloth it does not end there";
}

}  // namespace
}  // namespace carom
