// Screens as triangles: cut along the window, looked up by it, and hit by rays.
#include "cave/screen/screen_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <string>

#include <glm/geometric.hpp>

namespace carom {
namespace {

/// A plane that is linear in the window: its place in the room is exact everywhere.
glm::dvec3 placeOf(const glm::dvec2& inWindow) {
  return {3.0 * inWindow.x - 1.0, 0.5 + 2.0 * inWindow.y, -2.0 + 0.5 * inWindow.x};
}

ScreenTriangle triangleOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return {{{a, placeOf(a)}, {b, placeOf(b)}, {c, placeOf(c)}}};
}

/// The whole window, of triangles of both senses.
ScreenMesh window() {
  return {triangleOf({0, 0}, {1, 0}, {0.4, 0.7}), triangleOf({1, 1}, {1, 0}, {0.4, 0.7}),
          triangleOf({1, 1}, {0, 1}, {0.4, 0.7}), triangleOf({0, 0}, {0, 1}, {0.4, 0.7})};
}

double areaOf(const ScreenMesh& mesh) {
  double twice = 0.0;
  for (const ScreenTriangle& triangle : mesh) twice += std::abs(windowArea(triangle));
  return 0.5 * twice;
}

TEST(ScreenMesh, AreaIsPositiveAnticlockwise) {
  EXPECT_EQ(windowArea(triangleOf({0, 0}, {0.5, 0}, {0, 0.25})), 0.125);
  EXPECT_EQ(windowArea(triangleOf({0, 0}, {0, 0.25}, {0.5, 0})), -0.125);
}

TEST(ScreenMesh, ACutPartsTheWindowAtItsLine) {
  std::mt19937_64 random(61);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const int axis = i % 2;
    const double at = share(random);
    SCOPED_TRACE("seed 61, case " + std::to_string(i) + ", at " + std::to_string(at));
    const ScreenMesh below = cutAt(window(), axis, at, false), above = cutAt(window(), axis, at, true);
    EXPECT_NEAR(areaOf(below), at, 1e-12);
    EXPECT_NEAR(areaOf(above), 1.0 - at, 1e-12);
    for (const bool isAbove : {false, true}) {
      for (const ScreenTriangle& triangle : isAbove ? above : below) {
        for (const ScreenPoint& point : triangle) {
          EXPECT_TRUE(isAbove ? point.inWindow[axis] >= at : point.inWindow[axis] <= at);
          EXPECT_LT(glm::distance(point.inRoom_m, placeOf(point.inWindow)), 1e-12);
        }
      }
    }
  }
  EXPECT_TRUE(cutAt(window(), 0, 0.0, false).empty());
  EXPECT_EQ(cutAt(window(), 0, 0.0, true).size(), window().size());
}

TEST(ScreenMesh, PlacesOfTheWindowAreFoundAndHit) {
  std::mt19937_64 random(62);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const ScreenMesh mesh = window();
  const glm::dvec3 eye_m(0.3, 1.6, 1.0);
  for (int i = 0; i < 500; ++i) {
    const glm::dvec2 place(share(random), share(random));
    SCOPED_TRACE("seed 62, case " + std::to_string(i));
    const std::optional<glm::dvec3> found_m = inRoom_m(mesh, place);
    ASSERT_TRUE(found_m);
    EXPECT_LT(glm::distance(*found_m, placeOf(place)), 1e-12);
    const auto point = hit(mesh, eye_m, 0.25 * (placeOf(place) - eye_m));
    ASSERT_TRUE(point);
    EXPECT_LT(glm::distance(point->inWindow, place), 1e-12);
    EXPECT_FALSE(hit(mesh, eye_m, eye_m - placeOf(place))) << "behind the eye there is none";
  }
  for (const glm::dvec2& outside : {glm::dvec2(-0.001, 0.5), {1.001, 0.5}, {0.5, -0.001}, {0.5, 1.001}})
    EXPECT_FALSE(inRoom_m(mesh, outside));
}

TEST(ScreenMesh, OfTwoSheetsTheNearerIsHit) {
  ScreenMesh sheets = window();
  for (const ScreenTriangle& triangle : window()) {
    ScreenTriangle& nearer = sheets.emplace_back(triangle);
    for (ScreenPoint& point : nearer) point.inRoom_m.z += 0.5;
  }
  const glm::dvec3 eye_m(0.5, 1.5, 3.0), along(0.0, 0.0, -1.0);
  const auto first = hit(sheets, eye_m, along), last = hit(window(), eye_m, along);
  ASSERT_TRUE(first && last);
  EXPECT_NEAR(first->inRoom_m.z, last->inRoom_m.z + 0.5, 1e-12);
}

}  // namespace
}  // namespace carom
