// The walls, the viewers and the nodes of a rig that has been read.
#include "app/rig/rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "app/rig/rig_screen.h"
#include "app/rig/rig_text.h"
#include "places.h"

namespace carom {
namespace {

using test::changed;
using test::expectNear;
using test::kGood;
using test::read;

TEST(Rig, ShippedCaveIsAClosedCornerSeenFromInside) {
  for (const char* name : {"/rigs/desk.toml", "/rigs/four-walls-cluster.toml"}) {
    const Rig rig = readRig(std::string(CAROM_CONFIG_DIR) + name);
    ASSERT_EQ(rig.walls.size(), 4u);
    const glm::dvec3 person_m = 1.7 * rig.axes.up;
    for (const Wall& wall : rig.walls) {
      // right × up points from the wall to the person.
      const glm::dvec3 normal =
          glm::cross(wall.lowerRight_m - wall.lowerLeft_m, wall.upperLeft_m - wall.lowerLeft_m);
      EXPECT_GT(glm::dot(normal, person_m - wall.lowerLeft_m), 0.0) << wall.name;
      EXPECT_EQ(wall.stereo, StereoMode::sideBySide);
    }
  }
}

// The room knows where the sensors are in the eyes' frame, the inverse of the file's eyes_from_sensor.
TEST(Rig, ItsRoomHasItsWallsAndItsViewers) {
  const Rig rig =
      read(changed("eye_separation = 62",
                   "eyes_from_sensor = { translation = [0, -100, 50], rotation_deg = [0, 90, 0] }") +
           "[hand]\ntracker = 'cap'\nsensor = 1\n");
  const RoomGeometry room = roomGeometryOf(rig);
  ASSERT_EQ(room.walls.size(), 1u);
  EXPECT_EQ(room.walls[0].name, "front");
  EXPECT_FALSE(room.isHeadset);
  ASSERT_EQ(room.viewers.size(), 1u);
  EXPECT_TRUE(room.viewers[0].hasHand);
  for (const glm::dvec3& at_m : {glm::dvec3(0.0), glm::dvec3(1, 0, 0), glm::dvec3(0.3, -2, 0.5)})
    expectNear(room.viewers[0].sensorFromEyes * (rig.viewers[0].head.eyesFromSensor * at_m), at_m);
}

TEST(Rig, NeedsANodeForEachOfItsWallsAndEntries) {
  EXPECT_EQ(nodesOf(read(kGood)), 1);
  EXPECT_EQ(nodesOf(read(kGood + "node = 2\n")), 3);
  EXPECT_EQ(nodesOf(read(changed("[head]", "[[node]]\nrank = 1\nslots = 4\nhost = 'a'\n[head]"))), 5);
  EXPECT_EQ(displayOf(read(kGood), 0), "") << "its default display";
}

// A curved screen is drawn in flat pieces, which stand in the room in its place.
TEST(Rig, DrawsACurvedWallInFlatPieces) {
  const std::string corners =
      kGood.substr(kGood.find("lower_left"), kGood.find("pixels") - kGood.find("lower_left"));
  const Rig rig = read(
      changed(corners,
              "screen = { shape = 'cylinder', foot = [0, 0, 0], radius = 3000, from_deg = -60, to_deg = 60, "
              "bottom = 0, top = 2000, axis = [0, 1, 0] }\n"));
  const std::vector<Wall> flat = drawnWalls(rig);
  ASSERT_GT(flat.size(), 2u);
  EXPECT_EQ(standingWalls(rig).size(), flat.size());
  EXPECT_EQ(roomGeometryOf(rig).walls.size(), flat.size());
  for (const Wall& piece : flat) {
    for (const glm::dvec3& corner_m : {piece.lowerLeft_m, piece.lowerRight_m})
      EXPECT_GE(std::hypot(corner_m.x, corner_m.z), 3.0 - kUsualSagitta_m) << piece.name;
  }
  EXPECT_EQ(drawnWalls(read(kGood)).size(), 1u);
}

}  // namespace
}  // namespace carom
