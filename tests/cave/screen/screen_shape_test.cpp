// Cylinders and domes: places of the window by hand, and meshes against the surfaces.
#include "cave/screen/screen_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(ScreenShape, ACylindersWindowRunsAlongItsAngleAndItsAxis) {
  const CylinderScreen screen{.foot_m = {1.0, 0.5, 0.0},
                              .radius_m = 2.0,
                              .from_rad = -0.5 * kPi,
                              .to_rad = 0.5 * kPi,
                              .bottom_m = 0.25,
                              .top_m = 2.25};
  // Somebody who looks along −z with y upwards has +x at the right.
  EXPECT_LT(glm::distance(placeOn_m(screen, {0.0, 0.0}), {-1.0, 0.75, 0.0}), 1e-12);
  EXPECT_LT(glm::distance(placeOn_m(screen, {0.5, 0.5}), {1.0, 1.75, -2.0}), 1e-12);
  EXPECT_LT(glm::distance(placeOn_m(screen, {1.0, 1.0}), {3.0, 2.75, 0.0}), 1e-12);
}

TEST(ScreenShape, ADomesWindowIsTheCircleOfAFisheye) {
  const DomeScreen screen{.radius_m = 4.0, .fov_rad = kPi};
  for (const glm::ivec2& window_px :
       {glm::ivec2(1000, 1000), glm::ivec2(2000, 1000), glm::ivec2(1000, 1500)}) {
    SCOPED_TRACE(std::to_string(window_px.x) + " by " + std::to_string(window_px.y));
    const glm::dvec2 circle = 1000.0 / glm::dvec2(window_px);
    const auto at_m = [&](const glm::dvec2& inCircle) {
      return placeOn_m(screen, 0.5 + 0.5 * circle * inCircle, window_px) - screen.centre_m;
    };
    EXPECT_LT(glm::distance(at_m({0.0, 0.0}), {0.0, 4.0, 0.0}), 1e-12);
    // The front, −z, is at the bottom; halfway to the rim is half the angle.
    EXPECT_LT(glm::distance(at_m({0.0, -1.0}), {0.0, 0.0, -4.0}), 1e-12);
    EXPECT_LT(glm::distance(at_m({0.0, -0.5}), 4.0 * std::sqrt(0.5) * glm::dvec3(0.0, 1.0, -1.0)), 1e-12);
    EXPECT_LT(glm::distance(at_m({1.0, 0.0}), {4.0, 0.0, 0.0}), 1e-12);
  }
}

/// Expects that a mesh is nowhere farther off the true places.
template <typename Screen, typename Place>
void expectNear(const Screen& screen, const glm::ivec2& window_px, const Place& place_m, double most_m) {
  const ScreenMesh mesh = meshOf(screen, window_px);
  std::mt19937_64 random(63);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE("seed 63, case " + std::to_string(i));
    const double radius = 0.99 * std::sqrt(share(random)), angle = 2.0 * kPi * share(random);
    const glm::dvec2 inWindow(0.5 + 0.5 * radius * std::cos(angle), 0.5 + 0.5 * radius * std::sin(angle));
    const auto drawn_m = inRoom_m(mesh, inWindow);
    ASSERT_TRUE(drawn_m);
    EXPECT_LT(glm::distance(*drawn_m, place_m(inWindow)), most_m);
  }
}

// A twentieth of the arc that a pixel shows, for each direction in which the surface bends.
TEST(ScreenShape, MeshesStayNearTheirSurfaces) {
  const CylinderScreen cylinder{.radius_m = 3.0, .from_rad = -1.2, .to_rad = 1.0};
  const glm::ivec2 wide_px(1600, 700);
  expectNear(
      cylinder, wide_px, [&](const glm::dvec2& at) { return placeOn_m(cylinder, at); },
      0.05 * 3.0 * 2.2 / 1600);
  const DomeScreen dome{.radius_m = 5.0, .fov_rad = kPi};
  const glm::ivec2 square_px(1024, 1024);
  expectNear(
      dome, square_px, [&](const glm::dvec2& at) { return placeOn_m(dome, at, square_px); },
      2.0 * 0.05 * 5.0 * kPi / 1024);
}

}  // namespace
}  // namespace carom
