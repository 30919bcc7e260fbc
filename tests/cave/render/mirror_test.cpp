// Mirror images of lamps in the floor and in the table's wood: they stand where the lamps' mirror points are
// seen, and come when light has had the time for the way from there.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "cave/frame/bodies.h"
#include "cave/glowing_puck.h"
#include "cave/pictures/image.h"
#include "cave/render/wall_renderer.h"
#include "cave/scene/scene_builder.h"
#include "engine/light_speed.h"

namespace carom {
namespace {

using test::kC_m_s;

constexpr double kRailTop_m = 0.045, kRailMiddle_m = 0.71 + 0.105;
const glm::ivec2 kMirror_px{600, 600};

/// The table and its hall, the mirror so smooth that the image of a lamp is a point, and nothing else bright.
Scene mirrorScene(Paint mirror, const Hall& hall) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC_m_s;
  setup.board = Board{2.84, 1.42};
  Scene scene = buildScene(setup, {}, {}, hall, {});
  for (ScenePart& part : scene.parts) {
    part.colour = glm::vec3(0.0F);
    part.roughness = part.paint == mirror ? 0.002F : 0.0F;
  }
  return scene;
}

/// The middle of what is bright within 10 pixels of here, if anything is.
std::optional<glm::dvec2> brightPlace_px(const Image& image, const glm::dvec2& near_px) {
  glm::dvec2 sum(0.0);
  double weight = 0.0;
  for (int y = 0; y < kMirror_px.y; ++y) {
    for (int x = 0; x < kMirror_px.x; ++x) {
      const glm::dvec2 at(x + 0.5, y + 0.5);
      const std::size_t pixel =
          3 * (static_cast<std::size_t>(y) * kMirror_px.x + static_cast<std::size_t>(x));
      if (glm::distance(at, near_px) > 10.0 || image.rgb[pixel] < 240) continue;
      sum += at;
      weight += 1.0;
    }
  }
  if (weight == 0.0) return {};
  return sum / weight;
}

class Mirror : public testing::TestWithParam<Paint> {
 protected:
  /// Where the wall shows what rests at this place of the board.
  static glm::dvec2 seenAt_px(const Wall& wall, const Vec3& fromEye_m, const Lorentz& headFromBoard) {
    const Vec3 seen = (headFromBoard * Displacement{-glm::length(fromEye_m) / kC_m_s, fromEye_m}).dr_m;
    const Vec3 right = wall.lowerRight_m - wall.lowerLeft_m, up = wall.upperLeft_m - wall.lowerLeft_m;
    const Vec3 normal = glm::cross(right, up);
    const Vec3 at = seen * (glm::dot(wall.lowerLeft_m, normal) / glm::dot(seen, normal)) - wall.lowerLeft_m;
    return {glm::dot(at, right) / glm::dot(right, right) * kMirror_px.x,
            glm::dot(at, up) / glm::dot(up, up) * kMirror_px.y};
  }

  /// Compares the picture of an eye that sees the third lamp in the middle of the near rail, between its
  /// diamonds, or on the floor before the table. `seen`: whether its light has come.
  void compare(double t_s, const Vec3& beta, const Hall& hall, bool seen = true) {
    const Scene scene = mirrorScene(GetParam(), hall);
    const bool isFloor = GetParam() == Paint::floor;
    const double mirror_m = isFloor ? hall.floor_m : kRailTop_m;
    const Vec3& lamp_m = scene.lamps_m[2];
    const double up_m = 0.9 - mirror_m, lampUp_m = lamp_m.z - mirror_m;
    const Vec3 eye_m(lamp_m.x + 0.19, -(isFloor ? 1.9 : kRailMiddle_m) * (up_m + lampUp_m) / lampUp_m, 0.9);
    const Vec3 image_m(lamp_m.x, lamp_m.y, mirror_m - lampUp_m);

    const Lorentz headFromBoard = Lorentz::boost(uFromBeta(beta), kC_m_s).inverse();
    WallRenderer renderer(graphics_, scene, kC_m_s, 1);
    const EyeView eye{{t_s, eye_m}, Vec3(0.0)};
    std::array<BodyView, 1> views;
    viewBody(WorldLine(Knot{}, kC_m_s, 20.0), eye.observation, headFromBoard, views[0], {});
    const Vec3 towards =
        (headFromBoard * Displacement{-glm::length(image_m - eye_m) / kC_m_s, image_m - eye_m}).dr_m;
    const Wall wall = test::wallTowards({0, 0, 0}, towards, kMirror_px);
    RenderTarget picture(kMirror_px);
    renderer.look(headFromBoard, eye, views, {});
    ASSERT_TRUE(renderer.draw(wall, eye.positionInRoom_m, picture));
    const glm::dvec2 expected_px = seenAt_px(wall, image_m - eye_m, headFromBoard);
    const auto found_px = brightPlace_px(readBack(picture), expected_px);
    ASSERT_EQ(found_px.has_value(), seen);
    if (!seen) return;
    EXPECT_LT(glm::distance(*found_px, expected_px), 1.0)
        << "at " << found_px->x << ", " << found_px->y << ", expected " << expected_px.x << ", "
        << expected_px.y;
  }

  Graphics graphics_;
};

TEST_P(Mirror, ShowsALampAtItsMirrorPoint) {
  for (const Vec3& beta : {Vec3(0.0), Vec3(0.6, 0.0, 0.0), Vec3(-0.3, 0.5, 0.0)}) {
    SCOPED_TRACE(testing::Message() << "beta " << beta.x << ", " << beta.y);
    compare(3.0, beta, {});
  }
}

// The mirrored way is as long as the straight way from the mirror point.
TEST_P(Mirror, ShowsALampOnceItsLightHasComeByTheMirror) {
  Hall hall;
  const Vec3 lamp_m(0.95, 0.0, 1.4);
  hall.lamps.assign(kMostLamps, {lamp_m, 1.0, glm::vec3(3.0F)});
  const bool isFloor = GetParam() == Paint::floor;
  const double mirror_m = isFloor ? hall.floor_m : kRailTop_m;
  const double up_m = 0.9 - mirror_m, lampUp_m = lamp_m.z - mirror_m;
  const Vec3 eye_m(lamp_m.x + 0.19, -(isFloor ? 1.9 : kRailMiddle_m) * (up_m + lampUp_m) / lampUp_m, 0.9);
  const double comes_s = 1.0 + glm::distance(eye_m, {lamp_m.x, 0.0, mirror_m - lampUp_m}) / kC_m_s;
  for (const Vec3& beta : {Vec3(0.0), Vec3(0.0, 0.6, 0.0)}) {
    SCOPED_TRACE(testing::Message() << "beta " << beta.y);
    compare(comes_s - 0.02, beta, hall, false);
    compare(comes_s + 0.02, beta, hall, true);
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Mirror, testing::Values(Paint::floor, Paint::wood),
                         [](const auto& about) { return about.param == Paint::floor ? "Floor" : "Wood"; });

}  // namespace
}  // namespace carom
