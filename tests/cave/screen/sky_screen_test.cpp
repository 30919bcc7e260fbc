// Pictures by direction: where each direction lies in them, against formulas the other way round.
#include "cave/screen/sky_screen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "cave/room/off_axis.h"
#include "cave/screen/true_screens.h"

namespace carom {
namespace {

using namespace test;

struct Case {
  Sky sky;
  glm::ivec2 picture_px;
};

Sky skyOf(SkyKind kind, double fov_deg, double tilt_deg) {
  const double tilt = tilt_deg * kDegree;
  return {kind,
          fov_deg * kDegree,
          {0.0, std::cos(tilt), -std::sin(tilt)},
          {0.0, -std::sin(tilt), -std::cos(tilt)},
          {0.3, 1.7, -0.2}};
}

std::vector<Case> cases() {
  return {{skyOf(SkyKind::fisheye, 180.0, 0.0), {2048, 2048}},
          {skyOf(SkyKind::fisheye, 230.0, 20.0), {1024, 1024}},
          {skyOf(SkyKind::equirectangular, 180.0, 0.0), {2048, 1024}},
          {skyOf(SkyKind::equirectangular, 180.0, 35.0), {1024, 512}},
          {skyOf(SkyKind::cubemap, 180.0, 10.0), {1536, 256}}};
}

/// Right, up and forward of a direction, in the sky's own axes.
glm::dvec3 inSky(const Sky& sky, const glm::dvec3& along) {
  return {glm::dot(along, glm::cross(sky.front, sky.axis)), glm::dot(along, sky.axis),
          glm::dot(along, sky.front)};
}

/// Returns the place of a direction, by the squares' own axes as a list of what lies to the right and above.
glm::dvec2 inCubemap(const glm::dvec3& d) {
  const glm::dvec3 size = glm::abs(d);
  const double most = std::max({size.x, size.y, size.z});
  int square = 0;
  glm::dvec2 at(0.0);
  if (size.x == most) {
    square = d.x > 0.0 ? 0 : 1;
    at = {d.x > 0.0 ? -d.z : d.z, d.y};
  } else if (size.y == most) {
    square = d.y > 0.0 ? 2 : 3;
    at = {d.x, d.y > 0.0 ? -d.z : d.z};
  } else {
    square = d.z > 0.0 ? 5 : 4;
    at = {d.z > 0.0 ? d.x : -d.x, d.y};
  }
  return {(square + 0.5 + 0.5 * at.x / most) / 6.0, 0.5 + 0.5 * at.y / most};
}

glm::dvec2 inPicture(const Sky& sky, const glm::dvec3& along) {
  const glm::dvec3 d = glm::normalize(inSky(sky, along));
  if (sky.kind == SkyKind::fisheye) {
    const double share = std::acos(std::clamp(d.y, -1.0, 1.0)) / (0.5 * sky.fov_rad);
    return 0.5 + 0.5 * share * glm::normalize(glm::dvec2(d.x, -d.z));
  }
  if (sky.kind == SkyKind::equirectangular)
    return {0.5 + std::atan2(d.x, d.z) / (2.0 * std::numbers::pi),
            0.5 + std::asin(std::clamp(d.y, -1.0, 1.0)) / std::numbers::pi};
  return inCubemap(d);
}

bool isInside(const Sky& sky, const glm::dvec2& place) {
  return sky.kind != SkyKind::fisheye || glm::length(2.0 * place - 1.0) < 0.999;
}

TEST(SkyScreen, EachDirectionIsAtItsPlaceWhereverTheEyesAre) {
  std::mt19937_64 random(61);
  std::uniform_real_distribution<double> share(0.001, 0.999);
  for (const Case& one : cases()) {
    const CurvedScreen screen = screenOf(one.sky, one.picture_px, 1.25);
    double most_px = 0.0;
    for (int i = 0; i < 400; ++i) {
      const glm::dvec2 place(share(random), share(random));
      if (!isInside(one.sky, place)) continue;
      EXPECT_LT(glm::distance(inPicture(one.sky, directionOf(one.sky, place, one.picture_px)), place), 1e-9);
      const std::optional<glm::dvec3> drawn_m = inRoom_m(screen.mesh, place);
      ASSERT_TRUE(drawn_m) << place.x << " " << place.y;
      const glm::dvec3 eye_m = eyeNear(one.sky.middle_m, random);
      // Off in the picture, which is stretched across near the poles; so the angle between the directions.
      const glm::dvec3 shown = glm::normalize(*drawn_m - eye_m);
      const glm::dvec3 wished = directionOf(one.sky, place, one.picture_px);
      const double pixel_rad =
          one.sky.kind == SkyKind::cubemap
              ? 1.0 / one.picture_px.y
              : (one.sky.kind == SkyKind::fisheye ? one.sky.fov_rad : std::numbers::pi) / one.picture_px.y;
      const double off_px = glm::distance(shown, wished) / pixel_rad;
      most_px = std::max(most_px, off_px);
      ASSERT_LE(off_px, 0.1) << kSkyKinds[static_cast<std::size_t>(one.sky.kind)] << " at " << place.x << " "
                             << place.y;
    }
    fmt::print("{} of {} × {}: at most {:.4f} px off\n", kSkyKinds[static_cast<std::size_t>(one.sky.kind)],
               one.picture_px.x, one.picture_px.y, most_px);
  }
}

TEST(SkyScreen, EachPieceShowsAllThatItsPixelsNeed) {
  for (const Case& one : cases()) {
    const CurvedScreen screen = screenOf(one.sky, one.picture_px, 1.25);
    ASSERT_FALSE(screen.pieces.empty());
    double texels = 0.0, shown_px2 = 0.0;
    for (const FlatPiece& piece : screen.pieces) {
      texels += static_cast<double>(piece.wall.pixels.x) * piece.wall.pixels.y;
      const auto clip = clipFromRoom(piece.wall, one.sky.middle_m + glm::dvec3(1.0, 0.2, -1.0));
      ASSERT_TRUE(clip);
      for (const ScreenTriangle& triangle : piece.mesh) {
        shown_px2 += 0.5 * std::abs(windowArea(triangle)) * one.picture_px.x * one.picture_px.y;
        for (const ScreenPoint& point : triangle) {
          const glm::dvec4 at = *clip * glm::dvec4(point.inRoom_m, 1.0);
          ASSERT_GT(at.w, 0.0);
          ASSERT_LE(std::abs(at.x / at.w), 1.0);
          ASSERT_LE(std::abs(at.y / at.w), 1.0);
        }
      }
    }
    const double whole_px2 = static_cast<double>(one.picture_px.x) * one.picture_px.y;
    const double expected_px2 =
        one.sky.kind == SkyKind::fisheye ? std::numbers::pi / 4.0 * whole_px2 : whole_px2;
    EXPECT_NEAR(shown_px2, expected_px2, 0.001 * whole_px2);
    fmt::print("{} of {} × {}: {} pieces, {:.2f} texels a pixel\n",
               kSkyKinds[static_cast<std::size_t>(one.sky.kind)], one.picture_px.x, one.picture_px.y,
               screen.pieces.size(), texels / shown_px2);
  }
}

// The front is at a fisheye's bottom and its left at the left; in the middle of longitude and latitude; in
// the last square of a cubemap, above which the lower edge of "up" goes on.
TEST(SkyScreen, TheFrontIsWhereTheRuleHasIt) {
  const auto seen = [](SkyKind kind, const glm::dvec2& place) {
    return inSky(skyOf(kind, 180.0, 0.0), directionOf(skyOf(kind, 180.0, 0.0), place, {600, 600}));
  };
  const auto expect = [&](SkyKind kind, const glm::dvec2& place, const glm::dvec3& direction) {
    EXPECT_LT(glm::distance(seen(kind, place), glm::normalize(direction)), 1e-12)
        << kSkyKinds[static_cast<std::size_t>(kind)] << " " << place.x << " " << place.y;
  };
  expect(SkyKind::fisheye, {0.5, 0.5}, {0, 1, 0});
  expect(SkyKind::fisheye, {0.5, 0.0}, {0, 0, 1});
  expect(SkyKind::fisheye, {0.0, 0.5}, {-1, 0, 0});
  expect(SkyKind::equirectangular, {0.5, 0.5}, {0, 0, 1});
  expect(SkyKind::equirectangular, {0.75, 0.5}, {1, 0, 0});
  expect(SkyKind::equirectangular, {0.3, 1.0}, {0, 1, 0});
  const std::array<glm::dvec3, 6> middles{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, -1}, {0, 0, 1}}};
  for (std::size_t i = 0; i < middles.size(); ++i)
    expect(SkyKind::cubemap, {(static_cast<double>(i) + 0.5) / 6.0, 0.5}, middles[i]);
  expect(SkyKind::cubemap, {2.5 / 6.0, 0.0}, {0, 1, 1});
  expect(SkyKind::cubemap, {3.5 / 6.0, 1.0}, {0, -1, 1});
  expect(SkyKind::cubemap, {5.5 / 6.0, 1.0}, {0, 1, 1});
  expect(SkyKind::cubemap, {0.25 / 6.0, 0.5}, {1, 0, 0.5});
}

}  // namespace
}  // namespace carom
