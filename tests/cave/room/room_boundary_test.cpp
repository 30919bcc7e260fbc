#include "cave/room/room_boundary.h"

#include <gtest/gtest.h>

#include <vector>

namespace carom {
namespace {

Wall wallOf(const std::string& name, const glm::dvec3& lowerLeft_m, const glm::dvec3& lowerRight_m) {
  Wall wall;
  wall.name = name;
  wall.lowerLeft_m = lowerLeft_m;
  wall.lowerRight_m = lowerRight_m;
  wall.upperLeft_m = lowerLeft_m + glm::dvec3(0.0, 3.0, 0.0);
  return wall;
}

// Said once each time that the head goes behind a wall, not while it stays there, nor for a tracker's
// centimetre.
TEST(RoomBoundary, IsSaidOnceEachTime) {
  const std::vector<Wall> walls{wallOf("front", {-1.5, 0.0, -1.5}, {1.5, 0.0, -1.5}),
                                wallOf("left", {-1.5, 0.0, 1.5}, {-1.5, 0.0, -1.5})};
  RoomBoundary roomBoundary(walls);
  EXPECT_FALSE(roomBoundary.look({0.0, 1.7, 0.0}));
  EXPECT_FALSE(roomBoundary.look({0.0, 1.7, 9.0})) << "no wall closes the room there";
  EXPECT_FALSE(roomBoundary.look({-1.52, 1.7, 0.0}));
  EXPECT_EQ(roomBoundary.look({-1.6, 1.7, 0.0}), &walls[1]);
  EXPECT_FALSE(roomBoundary.look({-1.7, 1.7, 0.0}));
  EXPECT_FALSE(roomBoundary.look({0.0, 1.7, -1.6})) << "still outside";
  EXPECT_FALSE(roomBoundary.look({0.0, 1.7, -1.4}));
  EXPECT_TRUE(roomBoundary.look({0.0, 1.7, -1.6}));
}

}  // namespace
}  // namespace carom
