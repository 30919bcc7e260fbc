// The tree of transforms and screens of nDisplay.
#include "app/room_formats/ndisplay_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <string>

#include "app/room_formats/read_room.h"

namespace carom {
namespace {

using test::allFindings;

TEST(NdisplayFile, RotationsAreThoseOfThreePlainTurns) {
  // By another way: FRotator turns by roll about x, then pitch, then yaw, each with Unreal's sign.
  for (const glm::dvec3 turn : {glm::dvec3(10, 20, 30), glm::dvec3(-80, 170, 5), glm::dvec3(90, 0, 45)}) {
    const glm::dvec3 a = glm::radians(turn);
    const auto about = [](int from, int to, double angle) {
      glm::dmat3 m(1.0);
      m[from][from] = m[to][to] = std::cos(angle);
      m[from][to] = std::sin(angle);
      m[to][from] = -std::sin(angle);
      return m;
    };
    // Yaw takes x to y, pitch x to z; roll takes z to y.
    const glm::dmat3 expected = about(0, 1, a.y) * about(0, 2, a.x) * about(2, 1, a.z);
    const glm::dmat3 got = unrealRotation(turn.x, turn.y, turn.z);
    for (int i = 0; i < 3; ++i)
      EXPECT_LT(glm::distance(expected[i], got[i]), 1e-12) << turn.x << " column " << i;
  }
}

SceneNode node(const std::string& id, const std::string& parent, const glm::dvec3& position_m,
               double yaw_deg = 0.0) {
  SceneNode made{.id = id, .parent = parent};
  made.local = {position_m, unrealRotation(0.0, yaw_deg, 0.0)};
  made.at = made.parentAt = {7, 3};
  return made;
}

// Unreal's x is forward, its y right and its z up: a quarter turn to the right puts ahead to the right.
TEST(NdisplayScene, APlaceIsMovedAndTurnedByAllItsParents) {
  Room room;
  NdisplayScene scene(room);
  scene.add(node("root", "", {1, 0, 0}, 90));
  scene.add(node("arm", "root", {2, 0, 0}, 90));
  SceneNode screen = node("screen", "arm", {3, 0, 0.5});
  screen.width_m = 4.0;
  screen.height_m = 2.0;
  scene.add(screen);
  const auto place = scene.placeOf("screen");
  ASSERT_TRUE(place);
  EXPECT_LT(glm::distance(place->position_m, {-2, 2, 0.5}), 1e-12) << "1 ahead, 2 right, 3 back, 0.5 up";
  EXPECT_LT(glm::distance(place->matrix[0], {-1, 0, 0}), 1e-12) << "it faces back";
  const auto corners = scene.cornersOf("screen");
  ASSERT_TRUE(corners);
  // In the room x is right, y up, z back: the middle is at (2, 0.5, 2), its right is to the left.
  EXPECT_LT(glm::distance(corners->lowerLeft_m, {4, -0.5, 2}), 1e-12);
  EXPECT_LT(glm::distance(corners->lowerRight_m, {0, -0.5, 2}), 1e-12);
  EXPECT_LT(glm::distance(corners->upperLeft_m, {4, 1.5, 2}), 1e-12);
  EXPECT_TRUE(scene.hangsOn("screen", "root"));
  EXPECT_FALSE(scene.hangsOn("root", "screen"));
  EXPECT_EQ(allFindings(room), "");
}

TEST(NdisplayScene, NamesWhatIsNoTree) {
  Room room;
  NdisplayScene scene(room);
  scene.add(node("a", "b", {}));
  scene.add(node("b", "a", {}));
  scene.add(node("lost", "gone", {}));
  scene.add(node("lost", "", {}));
  scene.add(node("spare", "", {}));
  EXPECT_FALSE(scene.placeOf("a"));
  EXPECT_FALSE(scene.placeOf("lost"));
  EXPECT_FALSE(scene.placeOf("lost")) << "which is told once";
  EXPECT_EQ(room.findings.size(), 3u) << allFindings(room);
  const std::string said = allFindings(room);
  EXPECT_NE(said.find("7:3: the name 'lost' is taken in line 7"), std::string::npos) << said;
  EXPECT_NE(said.find("hangs on itself through its parent"), std::string::npos) << said;
  EXPECT_NE(said.find("there is no parent 'gone' for 'lost'"), std::string::npos) << said;
  scene.tellUnused({"a", "lost"}, "");
  EXPECT_NE(allFindings(room).find("component 'spare' is left out"), std::string::npos) << allFindings(room);
  EXPECT_EQ(room.findings.size(), 4u) << allFindings(room);
}

}  // namespace
}  // namespace carom
