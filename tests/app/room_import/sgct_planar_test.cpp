// Flat screens of SGCT that are given by angles.
#include "app/room_import/sgct_planar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "app/room_import/sgct_text.h"

namespace carom {
namespace {

namespace sgct = test::sgct;
using test::sgct::projected;

// A screen by angles lies where SGCT draws it: 10 m along -z unless told, turned, then moved.
TEST(SgctFile, TakesPlanarProjectionsAsSgctDrawsThem) {
  const Room room = sgct::read(projected(R"("type": "PlanarProjection", "fov": { "hfov": 90, "vfov": 60 })"));
  ASSERT_EQ(room.walls.size(), 1u);
  const double half_m = 10.0 / std::sqrt(3.0);  // tan 30°
  const auto expectNear = [](const glm::dvec3& found_m, const glm::dvec3& expected_m) {
    EXPECT_LT(glm::distance(found_m, expected_m), 1e-9) << found_m.x << ' ' << found_m.y << ' ' << found_m.z;
  };
  expectNear(room.walls[0].wall.lowerLeft_m, {-10, -half_m, -10});
  expectNear(room.walls[0].wall.lowerRight_m, {10, -half_m, -10});
  expectNear(room.walls[0].wall.upperLeft_m, {-10, half_m, -10});
  ASSERT_EQ(room.findings.size(), 1u);
  EXPECT_EQ(room.findings[0].kind, Finding::Kind::warning);
  EXPECT_NE(room.findings[0].text.find("20.00 × 11.55 m, 10 m from the origin"), std::string::npos)
      << room.findings[0].text;
  // Yaw turns to the right, pitch up, roll clockwise; the offset comes last.
  const Room turned = sgct::read(projected(
      R"("type": "PlanarProjection", "distance": 2, "offset": { "x": 0, "y": 1, "z": 0 },
      "orientation": { "yaw": 90, "pitch": 0, "roll": 0 },
      "fov": { "left": 45, "right": 0, "down": 0, "up": 45 })"));
  ASSERT_EQ(turned.walls.size(), 1u);
  expectNear(turned.walls[0].wall.lowerLeft_m, {2, 1, -2});
  expectNear(turned.walls[0].wall.lowerRight_m, {2, 1, 0});
  expectNear(turned.walls[0].wall.upperLeft_m, {2, 3, -2});
  const Room up =
      sgct::read(projected(R"("type": "PlanarProjection", "orientation": { "yaw": 0, "pitch": 90, "roll": 0 },
      "fov": { "hfov": 90, "vfov": 90, "distance": 3 })"));
  expectNear(up.walls.at(0).wall.lowerLeft_m, {-3, 3, -3});
  expectNear(up.walls.at(0).wall.upperLeft_m, {-3, 3, 3});
  const Room quaternion = sgct::read(projected(R"("type": "PlanarProjection",
      "orientation": { "x": 0, "y": -0.70710678, "z": 0, "w": 0.70710678 },
      "fov": { "hfov": 90, "vfov": 90, "distance": 1 })"));
  EXPECT_LT(glm::distance(quaternion.walls.at(0).wall.lowerLeft_m, glm::dvec3(1, -1, -1)), 1e-7);
}

TEST(SgctFile, NamesWhatIsWrongInAPlanarProjection) {
  const auto says = [](const std::string& rest, const std::string& words) {
    const Room room = sgct::read(projected(R"("type": "PlanarProjection", )" + rest));
    ASSERT_FALSE(room.findings.empty()) << rest;
    EXPECT_TRUE(room.hasErrors()) << rest;
    EXPECT_NE(room.findings[0].text.find(words), std::string::npos) << room.findings[0].text;
  };
  says(R"("distance": 1)", "fov is missing");
  says(R"("fov": 80)", "expected an object");
  says(R"("fov": { "hfov": 80 })", "vfov, or down and up, is missing in fov");
  says(R"("fov": { "hfov": 80, "down": 3 })", "vfov, or down and up, is missing in fov");
  says(R"("fov": { "hfov": 180, "vfov": 60 })", "hfov is 180, expected");
  says(R"("fov": { "hfov": 80, "left": 10, "right": -10, "vfov": 60 })", "together are 0 degrees");
  says(R"("fov": { "hfov": 80, "vfov": 60 }, "distance": 0)", "distance is 0, expected");
  says(R"("fov": { "hfov": 80, "vfov": 60 }, "orientation": { "yaw": 1, "pitch": 2 })", "roll is missing");
  says(R"("fov": { "hfov": 80, "vfov": 60 }, "orientation": { "x": 0, "y": 0, "z": 0, "w": 0 })", "length 0");
  says(R"("fov": { "hfov": 80, "vfov": 60 }, "offset": { "x": 0, "y": 0 })", "z is missing in offset");
}

}  // namespace
}  // namespace carom
