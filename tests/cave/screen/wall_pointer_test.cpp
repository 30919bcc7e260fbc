// A point of the scene, projected to a pixel of a window and pointed to there, lies on the ray of the eye
// whose picture it is in.
#include "cave/screen/wall_pointer.h"

#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>
#include <memory>

#include "cave/room/off_axis.h"
#include "cave/screen/sky_screen.h"
#include "cave/screen/true_screens.h"
#include "engine/random_world.h"

namespace carom {
namespace {

constexpr Viewport kPane{{130, 40}, {640, 360}};

Wall frontWall(StereoMode stereo, Flip flip) {
  Wall wall;
  wall.lowerLeft_m = {-1.5, 0.0, -1.5};
  wall.lowerRight_m = {1.5, 0.0, -1.5};
  wall.upperLeft_m = {-1.5, 2.0, -1.5};
  wall.stereo = stereo;
  wall.flip = flip;
  return wall;
}

/// Where in the pane an eye's picture has a place, given as shares of the picture, right and down.
glm::dvec2 packed(StereoMode stereo, Eye eye, glm::dvec2 share) {
  if (stereo == StereoMode::sideBySide) share.x = 0.5 * share.x + (eye == Eye::right ? 0.5 : 0.0);
  if (stereo == StereoMode::topBottom) share.y = 0.5 * share.y + (eye == Eye::right ? 0.5 : 0.0);
  return glm::dvec2(kPane.position_px) + share * glm::dvec2(kPane.size_px);
}

/// The eyes that have a picture of their own there, else the middle one.
std::vector<Eye> eyesIn(StereoMode stereo) {
  switch (stereo) {
    case StereoMode::left:
      return {Eye::left};
    case StereoMode::right:
      return {Eye::right};
    case StereoMode::sideBySide:
    case StereoMode::topBottom:
      return {Eye::left, Eye::right};
    default:
      return {Eye::middle};
  }
}

TEST(WallPointer, PointsBackAlongTheRayOfTheEyeThatSees) {
  const std::array<glm::dvec3, 3> eyes_m{{{0.168, 1.6, 0.3}, {0.232, 1.6, 0.3}, {0.2, 1.6, 0.3}}};
  test::Random random(11);
  for (int mode = 0; mode <= static_cast<int>(StereoMode::anaglyphGrey); ++mode) {
    for (const Flip flip : {Flip::none, Flip::horizontal, Flip::vertical, Flip::both}) {
      const Wall wall = frontWall(static_cast<StereoMode>(mode), flip);
      for (int i = 0; i < 50; ++i) {
        const glm::dvec3 point_m(random.in(-1.4, 1.4), random.in(0.1, 1.9), random.in(-2.0, -1.0));
        for (const Eye eye : eyesIn(wall.stereo)) {
          const glm::dvec3& eye_m = eyes_m[static_cast<std::size_t>(eye)];
          const glm::dvec4 clip = *clipFromRoom(wall, eye_m) * glm::dvec4(point_m, 1.0);
          glm::dvec2 share(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w);
          if (share.x < 0.0 || share.x >= 1.0 || share.y < 0.0 || share.y >= 1.0) continue;
          if (flip == Flip::horizontal || flip == Flip::both) share.x = 1.0 - share.x;
          if (flip == Flip::vertical || flip == Flip::both) share.y = 1.0 - share.y;
          const auto pointed = pointedIn(wall, kPane, packed(wall.stereo, eye, share));
          ASSERT_TRUE(pointed) << mode;
          EXPECT_EQ(pointed->eye, eye) << mode;
          const glm::dvec3 along = glm::normalize(pointed->onWall_m - eye_m);
          const double miss_m = glm::length(glm::cross(point_m - eye_m, along));
          EXPECT_LT(miss_m, 1e-9) << "mode " << mode << ", flip " << static_cast<int>(flip);
          EXPECT_NEAR(pointed->onWall_m.z, -1.5, 1e-12);
        }
      }
    }
  }
}

TEST(WallPointer, OutsideThePaneIsNowhere) {
  const Wall wall = frontWall(StereoMode::sideBySide, Flip::none);
  EXPECT_TRUE(pointedIn(wall, kPane, {130.0, 40.0}));
  EXPECT_TRUE(pointedIn(wall, kPane, {769.9, 399.9}));
  for (const glm::dvec2& off : {glm::dvec2(129.9, 200.0), {770.0, 200.0}, {300.0, 39.9}, {300.0, 400.0}})
    EXPECT_FALSE(pointedIn(wall, kPane, off)) << off.x << ", " << off.y;
}

// Beyond its edge the wall's plane goes on: as far again below as the pane is high lies the place as far
// below.
TEST(WallPointer, BeyondThePaneThePlaneGoesOn) {
  const Wall wall = frontWall(StereoMode::mono, Flip::none);
  const glm::dvec2 middle_px = glm::dvec2(kPane.position_px) + 0.5 * glm::dvec2(kPane.size_px);
  const glm::dvec2 below_px = middle_px + glm::dvec2(0.0, kPane.size_px.y);
  const auto middle = pointedIn(wall, kPane, middle_px), below = pointedIn(wall, kPane, below_px, true);
  ASSERT_TRUE(middle && below);
  const glm::dvec3 upwards_m = wall.upperLeft_m - wall.lowerLeft_m;
  EXPECT_LT(glm::distance(below->onWall_m, middle->onWall_m - upwards_m), 1e-12);
  EXPECT_EQ(outside_px(kPane, middle_px), 0.0);
  EXPECT_EQ(outside_px(kPane, below_px), 0.5 * kPane.size_px.y);
}

TEST(WallPointer, APictureByDirectionIsPointedIntoFromItsPlace) {
  const Sky sky{SkyKind::fisheye, 3.5, {0, 1, 0}, {0, 0, -1}, {0.4, 1.5, -0.2}};
  Wall wall;
  wall.pixels = {800, 800};
  wall.screen = std::make_shared<CurvedScreen>(screenOf(sky, wall.pixels, 1.25));
  wall.sky = SkyEyes{sky.middle_m, {1, 0, 0}};
  test::Random random(12);
  constexpr double kPixel_rad = 3.5 / 800.0;
  for (int i = 0; i < 50; ++i) {
    const glm::dvec2 share =
        0.5 + random.in(0.0, 0.49) * glm::normalize(glm::dvec2(random.in(-1.0, 1.0), 0.5));
    const glm::dvec2 pointer_px = glm::dvec2(kPane.position_px) + share * glm::dvec2(kPane.size_px);
    const auto pointed = pointedIn(wall, kPane, pointer_px);
    ASSERT_TRUE(pointed && pointed->from_m);
    const glm::dvec3 along = glm::normalize(pointed->onWall_m - *pointed->from_m);
    EXPECT_LT(glm::distance(along, directionOf(sky, {share.x, 1.0 - share.y}, wall.pixels)),
              0.1 * kPixel_rad);
  }
  EXPECT_FALSE(pointedIn(wall, kPane, glm::dvec2(kPane.position_px) + 2.0)) << "beside the circle";
}

// On a measured screen the pointer finds the place of the room that its pixel shows, and nothing where there
// is no screen.
TEST(WallPointer, AMeasuredScreenIsPointedAtWhereItIs) {
  test::TrueScreen arc = test::cylinder(3.0, -40.0, 50.0, {800, 600});
  arc.isScreen = [](const glm::dvec2& at) { return at.x < 0.8; };
  Wall wall;
  wall.pixels = arc.window_px;
  wall.screen = std::make_shared<CurvedScreen>(test::curved(test::measured(arc, 30, 20)));
  test::Random random(13);
  for (int i = 0; i < 50; ++i) {
    const glm::dvec2 share(random.in(0.0, 0.7), random.in(0.0, 1.0));
    const auto pointed =
        pointedIn(wall, kPane, glm::dvec2(kPane.position_px) + share * glm::dvec2(kPane.size_px));
    ASSERT_TRUE(pointed);
    EXPECT_LT(glm::distance(pointed->onWall_m, arc.placeOn_m({share.x, 1.0 - share.y})), 2e-3);
  }
  EXPECT_FALSE(pointedIn(wall, kPane,
                         glm::dvec2(kPane.position_px) + glm::dvec2(0.9, 0.5) * glm::dvec2(kPane.size_px)));
}

}  // namespace
}  // namespace carom
