// How dark the edges of sight are, and where it goes.
#include "cave/overlay/comfort_overlay.h"

#include <gtest/gtest.h>

#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "cave/overlay/one_wall.h"

namespace carom {
namespace {

using test::oneWall;
using test::recordAt;
using test::wall;

TEST(ComfortOverlay, TheEdgesDarkenWithTheSpeedOnlyWhereItIsWanted) {
  FrameRecord record = recordAt({0.0, -3.0, 1.0}, {0.3, 0.0, 0.0});
  EXPECT_EQ(shadeOf(record), 0.0);
  record.controls.comfort = 1;
  EXPECT_NEAR(shadeOf(record), 0.3 / ComfortOverlay::kFullBeta, 1e-12);
  record.boardFromRoom = recordAt({0.0, -3.0, 1.0}, {0.9, 0.0, 0.0}).boardFromRoom;
  EXPECT_EQ(shadeOf(record), 1.0);
  record.boardFromRoom = recordAt({0.0, -3.0, 1.0}, Vec3(0.0)).boardFromRoom;
  EXPECT_EQ(shadeOf(record), 0.0);
}

TEST(ComfortOverlay, SightIsTheHeadsOrToTheOnlyWall) {
  FrameRecord record = recordAt({0.0, -3.0, 1.0}, Vec3(0.0));
  const glm::dvec3 toMiddle = glm::normalize(glm::dvec3(0.0, 1.5 - 1.6, -1.0));
  EXPECT_NEAR(glm::distance(sightOf(oneWall(), record), toMiddle), 0.0, 1e-12);
  RoomGeometry room = oneWall();
  room.walls.push_back(wall({-1.0, 0.0, 1.0}, {-1.0, 0.0, -1.0}, {-1.0, 2.3, 1.0}));
  record.viewers[0].tracked.headKnown = 1;
  record.viewers[0].tracked.roomFromHeadSensor.orientation =
      glm::angleAxis(0.5 * std::numbers::pi, glm::dvec3(0, 1, 0));
  EXPECT_NEAR(glm::distance(sightOf(room, record), glm::dvec3(-1.0, 0.0, 0.0)), 0.0, 1e-12);
}

}  // namespace
}  // namespace carom
