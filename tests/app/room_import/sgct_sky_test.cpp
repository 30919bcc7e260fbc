// Projections of SGCT that show a picture by direction or a cylinder.
#include "app/room_import/sgct_sky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>
#include <string>
#include <variant>

#include "app/room_import/sgct_text.h"
#include "cave/screen/curved_screen.h"
#include "cave/screen/screen_facts.h"

namespace carom {
namespace {

namespace sgct = test::sgct;
using test::sgct::projected;

void expectVector(const glm::dvec3& found, const glm::dvec3& expected) {
  EXPECT_LT(glm::distance(found, expected), 1e-12) << found.x << ' ' << found.y << ' ' << found.z;
}

/// Returns the sky of a room's only wall.
Sky skyIn(const Room& room) {
  for (const Finding& finding : room.findings) EXPECT_NE(finding.kind, Finding::Kind::error) << finding.text;
  if (room.walls.size() != 1 || !room.walls[0].wall.screen) throw std::runtime_error("no picture");
  EXPECT_EQ(room.walls[0].wall.name, "sky");
  return std::get<Sky>(room.walls[0].wall.screen->shape);
}

// "A value of 90 would result in the forward facing direction being at the center" (SGCT's own schema).
TEST(SgctFile, AFisheyeBecomesASky) {
  const Room room =
      sgct::read(projected(R"("type": "FisheyeProjection", "fov": 165, "tilt": 30, "crop": {})"));
  const Sky sky = skyIn(room);
  EXPECT_EQ(sky.kind, SkyKind::fisheye);
  EXPECT_NEAR(sky.fov_rad, 165.0 / 180.0 * std::numbers::pi, 1e-12);
  const double leaning = std::sqrt(3.0) / 2.0;
  expectVector(sky.axis, {0.0, leaning, -0.5});
  expectVector(sky.front, {0.0, -0.5, -leaning});
  ASSERT_EQ(room.findings.size(), 1u);
  EXPECT_NE(room.findings[0].text.find("crop"), std::string::npos) << room.findings[0].text;
  EXPECT_EQ(room.walls[0].wall.sky->from_m, glm::dvec3(0, 0, 4)) << "the user's place, who is not tracked";
}

TEST(SgctFile, AnEquirectangularPictureIsSeenByAHeadThatIsTracked) {
  std::string text = projected(R"("type": "EquirectangularProjection")");
  const std::size_t at = text.find("\"projection\"");
  const Room room = sgct::read(text.insert(at, R"("tracked": true, )"));
  EXPECT_EQ(skyIn(room).kind, SkyKind::equirectangular);
  EXPECT_FALSE(room.walls[0].wall.sky->from_m);
}

// SGCT's window goes once round, the front at its left edge; its heights are in radii above the user.
TEST(SgctFile, ACylinderStandsRoundTheUser) {
  const Room room = sgct::read(
      projected(R"("type": "CylindricalProjection", "rotation": 90, "heightoffset": -0.5, "radius": 3)"));
  ASSERT_EQ(room.walls.size(), 1u);
  const auto& screen = std::get<CylinderScreen>(room.walls[0].wall.screen->shape);
  expectVector(screen.foot_m, {0, 0, 4});
  expectVector(screen.ahead, {0, 0, -1});
  EXPECT_EQ(screen.radius_m, 3.0);
  EXPECT_EQ(screen.bottom_m, -1.5);
  EXPECT_EQ(screen.top_m, 1.5);
  EXPECT_NEAR(screen.from_rad, -std::numbers::pi / 2.0, 1e-12);
  EXPECT_NEAR(screen.to_rad, 1.5 * std::numbers::pi, 1e-12);
  const Wall& wall = room.walls[0].wall;
  EXPECT_NEAR(factsOf(*wall.screen, wall.pixels, screen.foot_m).turns_rad, 2.0 * std::numbers::pi, 1e-12)
      << "as carom check says";
}

TEST(SgctFile, AMirrorsMeshesAreNamed) {
  const Room room = sgct::read(projected(
      R"("type": "SphericalMirrorProjection", "geometry": { "bottom": "b.obj", "left": "l.obj" })"));
  EXPECT_EQ(skyIn(room).kind, SkyKind::fisheye);
  ASSERT_EQ(room.findings.size(), 1u);
  EXPECT_NE(room.findings[0].text.find("bottom 'b.obj', left 'l.obj'"), std::string::npos)
      << room.findings[0].text;
}

TEST(SgctFile, PicturesOfWrongNumbersAreRefused) {
  for (const char* projection :
       {R"("type": "FisheyeProjection", "fov": 360)", R"("type": "FisheyeProjection", "tilt": "steep")",
        R"("type": "CylindricalProjection", "radius": 0)"}) {
    SCOPED_TRACE(projection);
    const Room room = sgct::read(projected(projection));
    EXPECT_TRUE(room.walls.empty());
    EXPECT_TRUE(room.hasErrors());
  }
}

}  // namespace
}  // namespace carom
