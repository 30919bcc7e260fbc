// Bodies with corners as they are drawn: their shadows turn with them, and of bodies that go into each other
// the later one is seen.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <iterator>
#include <vector>

#include "cave/frame/bodies.h"
#include "cave/glowing_puck.h"
#include "cave/pictures/image.h"
#include "cave/render/wall_renderer.h"
#include "cave/room/off_axis.h"
#include "cave/scene/scene_builder.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using namespace test;

constexpr double kBarHeight_m = 0.03;
constexpr glm::ivec2 kPixels(1200, 1200);

using Corners = std::vector<glm::dvec2>;

Corners bar(double length_m, double width_m, double angle_rad = 0.0) {
  Corners corners;
  for (const auto& [x, y] :
       {std::pair{-0.5, -0.5}, std::pair{0.5, -0.5}, std::pair{0.5, 0.5}, std::pair{-0.5, 0.5}}) {
    const glm::dvec2 p(x * length_m, y * width_m), axis(std::cos(angle_rad), std::sin(angle_rad));
    corners.push_back({axis.x * p.x - axis.y * p.y, axis.y * p.x + axis.x * p.y});
  }
  return corners;
}

/// The middle of a wall, with as many pixels.
Wall middleOf(Wall wall, double share) {
  const glm::dvec3 middle_m = 0.5 * (wall.lowerRight_m + wall.upperLeft_m);
  for (glm::dvec3* corner_m : {&wall.lowerLeft_m, &wall.lowerRight_m, &wall.upperLeft_m})
    *corner_m = glm::mix(middle_m, *corner_m, share);
  return wall;
}

WorldLine lineOf(const glm::dvec2& place_m, double beta, const Spin& spin) {
  Knot knot{{0.0, {place_m, 0.5 * kBarHeight_m}}, uFromBeta({beta, 0.0, 0.0}), 0.0, {}, 0.0};
  knot.spin = spin;
  return WorldLine(knot, kC_m_s, 0.2);
}

class DrawnCorners : public testing::Test {
 protected:
  static Scene sceneOf(const std::vector<Corners>& outlines_m) {
    BilliardSetup setup;
    setup.board = Board{2.84, 1.42};
    std::vector<BodyLooks> looks;
    for (const Corners& outline_m : outlines_m)
      looks.push_back(
          {looks.empty() ? "white" : "red", "", glm::length(outline_m[0]), kBarHeight_m, outline_m});
    return buildScene(setup, looks);
  }
  Image draw(const Scene& scene, const std::vector<WorldLine>& lines, const Event& eye,
             const Lorentz& headFromBoard, const Wall& wall) {
    std::vector<BodyView> views(1 + lines.size());
    viewBody(WorldLine(Knot{}, kC_m_s), eye, headFromBoard, views[0]);
    for (std::size_t i = 0; i < lines.size(); ++i) viewBody(lines[i], eye, headFromBoard, views[i + 1]);
    WallRenderer renderer(graphics_, scene, kC_m_s, 1);
    graphics_.makeCurrent();
    RenderTarget picture(wall.pixels);
    renderer.look(headFromBoard, {eye, Vec3(0.0), Vec3(0.0)}, views);
    EXPECT_TRUE(renderer.draw(wall, {0, 0, 0}, picture));
    return readBack(picture);
  }
  Graphics graphics_;
};

std::vector<glm::ivec2> differing(const Image& one, const Image& other, int by) {
  std::vector<glm::ivec2> pixels;
  for (std::size_t i = 0; i < one.rgb.size(); i += 3) {
    int most = 0;
    for (std::size_t k = 0; k < 3; ++k)
      most = std::max(most, std::abs(int{one.rgb[i + k]} - int{other.rgb[i + k]}));
    const int at = static_cast<int>(i / 3);
    if (most > by) pixels.push_back({at % one.size_px.x, at / one.size_px.x});
  }
  return pixels;
}

// A bar that has turned looks, shadow and all, like a bar whose corners were given turned.
TEST_F(DrawnCorners, ATurnedBarHasTheShadowOfATurnedOutline) {
  const Event eye{2.0, {-0.1, -0.5, 0.8}};
  for (const double beta : {0.0, 0.6}) {
    const glm::dvec2 place_m(-beta * kC_m_s * 1.4, 0.0);
    const Wall wall = wallTowards({0, 0, 0}, glm::dvec3(0.0, 0.0, 0.0) - eye.r_m, kPixels);
    for (const double angle_rad : {0.4, 1.2, -2.5}) {
      const Image turned =
          draw(sceneOf({bar(0.12, 0.02)}), {lineOf(place_m, beta, {angle_rad})}, eye, Lorentz(kC_m_s), wall);
      const Image given = draw(sceneOf({bar(0.12, 0.02, angle_rad)}), {lineOf(place_m, beta, {})}, eye,
                               Lorentz(kC_m_s), wall);
      const Image straight =
          draw(sceneOf({bar(0.12, 0.02)}), {lineOf(place_m, beta, {})}, eye, Lorentz(kC_m_s), wall);
      const std::size_t least = differing(given, straight, 5).size();
      EXPECT_GT(least, 300u);
      EXPECT_LT(differing(turned, given, 5).size(), least / 50) << beta << " c, " << angle_rad;
    }
  }
}

// However fast a bar turns, its shadow reaches beside it no farther than that of a bar at rest.
TEST_F(DrawnCorners, TheShadowOfABarThatTurnsStaysWithIt) {
  const Event eye{2.0, {0.05, -0.1, 0.9}};
  const Wall wall = wallTowards({0, 0, 0}, glm::dvec3(0.0) - eye.r_m, kPixels);
  const Scene with = sceneOf({bar(0.12, 0.02)});
  Scene without = with, empty = with;
  std::erase_if(without.parts, [](const ScenePart& part) { return part.paint == Paint::shadow; });
  std::erase_if(empty.parts, [](const ScenePart& part) { return part.body == 1; });
  double atRest_px = 0.0;
  for (const double omega_rad_s : {0.0, 4.0, -9.0, 14.0, 21.0, 23.0}) {
    const std::vector<WorldLine> lines{lineOf({0.0, 0.0}, 0.0, {0.3, omega_rad_s})};
    const Image shaded = draw(with, lines, eye, Lorentz(kC_m_s), wall),
                plain = draw(without, lines, eye, Lorentz(kC_m_s), wall),
                table = draw(empty, lines, eye, Lorentz(kC_m_s), wall);
    const auto body = differing(plain, table, 5), shadow = differing(shaded, plain, 5);
    ASSERT_GT(body.size(), 300u);
    ASSERT_GT(shadow.size(), 300u);
    double farthest_px = 0.0;
    for (const glm::ivec2& dark : shadow) {
      double nearest_px = 1e9;
      for (const glm::ivec2& solid : body)
        nearest_px = std::min(nearest_px, glm::length(glm::dvec2(dark - solid)));
      farthest_px = std::max(farthest_px, nearest_px);
    }
    if (omega_rad_s == 0.0) atRest_px = farthest_px;
    EXPECT_LE(farthest_px, 1.25 * atRest_px + 1.0) << omega_rad_s << " rad/s";
  }
}

// From random places at random speeds: wherever the later body's top is seen, it has the colour that it has
// alone.
TEST_F(DrawnCorners, OfOverlappingBodiesTheLaterIsSeen) {
  test::Random random(77);
  const double side_m = 0.1;
  Scene both = sceneOf({bar(side_m, side_m), bar(side_m, side_m)});
  Scene alone = both;
  std::erase_if(alone.parts, [](const ScenePart& part) { return part.body == 1; });
  for (Scene* scene : {&both, &alone})  // one body's shadow falls beside the other's top, not on it
    std::erase_if(scene->parts, [](const ScenePart& part) { return part.paint == Paint::shadow; });
  std::size_t looked = 0;
  for (int i = 0; i < 12; ++i) {
    CASE(random, i);
    const Event eye{4.0, {random.in(-2.0, 2.0), random.in(-2.0, 2.0), random.in(0.3, 1.2)}};
    const Lorentz head = i % 2 == 0 ? Lorentz(kC_m_s) : Lorentz::boost(random.u(0.6), kC_m_s);
    const std::vector<WorldLine> lines{lineOf({0.0, 0.0}, 0.0, {}), lineOf({0.03, 0.02}, 0.0, {0.3})};
    const auto centre = emission(lines[1], Vec3(0.0), eye, head);
    ASSERT_TRUE(centre);
    const Wall wall = middleOf(wallTowards({0, 0, 0}, centre->seen.dr_m, kPixels), 0.15);
    const glm::dmat4 clip = *clipFromEye(wall, {0, 0, 0});
    const Image together = draw(both, lines, eye, head, wall), single = draw(alone, lines, eye, head, wall);
    for (double x = -0.42; x < 0.43; x += 0.04) {
      for (double y = -0.42; y < 0.43; y += 0.04) {
        const auto seen = emission(lines[1], {side_m * x, side_m * y, 0.5 * kBarHeight_m}, eye, head);
        const glm::dvec4 p = clip * glm::dvec4(seen->seen.dr_m, 1.0);
        const glm::ivec2 at = glm::ivec2(glm::floor((glm::dvec2(p) / p.w + 1.0) * 0.5 * glm::dvec2(kPixels)));
        const std::size_t pixel =
            3 * (static_cast<std::size_t>(at.y) * kPixels.x + static_cast<std::size_t>(at.x));
        for (std::size_t k = 0; k < 3; ++k)
          ASSERT_NEAR(together.rgb[pixel + k], single.rgb[pixel + k], 12) << x << " " << y;
        ++looked;
      }
    }
  }
  EXPECT_GT(looked, 3000u);
}

}  // namespace
}  // namespace carom
