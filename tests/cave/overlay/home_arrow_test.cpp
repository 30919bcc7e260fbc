// Which way the table is.
#include "cave/overlay/home_arrow.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "cave/overlay/one_wall.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::oneWall;
using test::recordAt;
using test::wall;

TEST(HomeArrow, AtRestTheTableIsSeenWhereItIs) {
  const SeenTable seen = seenTable(recordAt({0.0, -2.0, 1.0}, Vec3(0.0)));
  EXPECT_NEAR(seen.distance_m, std::sqrt(5.0), 1e-12);
  const Vec3 expected = Vec3(0.0, -1.0, -2.0) / std::sqrt(5.0);  // ahead and below
  EXPECT_NEAR(glm::distance(seen.towards, expected), 0.0, 1e-12);
}

// cos θ' = (cos θ + β)/(1 + β cos θ), where θ is between the motion and the direction in which the source is
// (Rindler 2006, §4.3).
TEST(HomeArrow, InAMovingRoomTheDirectionIsAberrated) {
  test::Random random(5);
  for (int number = 0; number < 100; ++number) {
    SCOPED_TRACE(number);
    const Vec3 eye_m(random.in(-9.0, 9.0), random.in(-9.0, 9.0), random.in(0.5, 2.0));
    const double beta = random.in(-0.95, 0.95);
    const SeenTable seen = seenTable(recordAt(eye_m, {beta, 0.0, 0.0}));
    const double cosine = -eye_m.x / glm::length(eye_m);
    EXPECT_NEAR(seen.towards.x, (cosine + beta) / (1.0 + beta * cosine), 1e-9);
    EXPECT_NEAR(glm::length(seen.towards), 1.0, 1e-12);
  }
}

TEST(HomeArrow, PointsToTheSideOnWhichTheTableIs) {
  const RoomGeometry room = oneWall();
  EXPECT_FALSE(wayHome(room, recordAt({0.0, -3.0, 1.0}, Vec3(0.0)))) << "it is in sight";
  const auto left = wayHome(room, recordAt({9.0, -1.0, 1.0}, Vec3(0.0)));
  const auto right = wayHome(room, recordAt({-9.0, -1.0, 1.0}, Vec3(0.0)));
  const auto behind = wayHome(room, recordAt({1.0, 8.0, 1.0}, Vec3(0.0)));
  ASSERT_TRUE(left && right && behind);
  EXPECT_LT(left->x, -0.9);
  EXPECT_GT(right->x, 0.9);
  EXPECT_NEAR(std::abs(behind->x), 1.0, 1e-12);
  const auto below = wayHome(room, recordAt({0.0, -0.1, 1.6}, Vec3(0.0)));
  ASSERT_TRUE(below);
  EXPECT_LT(below->y, -0.9);
}

TEST(HomeArrow, AWallAtTheSideThatShowsTheTableIsEnough) {
  RoomGeometry room = oneWall();
  const FrameRecord record = recordAt({9.0, -1.0, 1.0}, Vec3(0.0));
  ASSERT_TRUE(wayHome(room, record));
  room.walls.push_back(wall({-1.0, 0.0, 1.0}, {-1.0, 0.0, -1.0}, {-1.0, 2.3, 1.0}));
  EXPECT_FALSE(wayHome(room, record));
}

TEST(HomeArrow, IsAwayOnAScriptedFlightAndInALesson) {
  FrameRecord record = recordAt({9.0, -1.0, 1.0}, Vec3(0.0));
  record.drive.mode = DriveMode::tour;
  EXPECT_FALSE(wayHome(oneWall(), record));
  record.drive.mode = DriveMode::home;
  EXPECT_TRUE(wayHome(oneWall(), record));
  for (const LessonPhase phase : {LessonPhase::asks, LessonPhase::shows, LessonPhase::explains}) {
    record.lesson.phase = phase;
    EXPECT_FALSE(wayHome(oneWall(), record));
  }
}

}  // namespace
}  // namespace carom
