#include "cave/room/skewed_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <string_view>

#include "cave/room/rectangle.h"

namespace carom {
namespace {

constexpr std::size_t kLowerLeft = 0, kLowerRight = 1, kUpperLeft = 2, kUpperRight = 3;
constexpr std::array<std::string_view, 4> kNames{"lower_left", "lower_right", "upper_left", "upper_right"};
/// Around the screen, as its person sees it, anticlockwise.
constexpr std::array<std::size_t, 4> kAround{kLowerLeft, kLowerRight, kUpperRight, kUpperLeft};
constexpr double kSharpest_deg = 60.0, kBluntest_deg = 120.0;

double cross2(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Returns the fault of the corners in their plane; empty if they are those of a screen.
std::string faultOf(const std::array<glm::dvec2, 4>& corners_m) {
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t here = kAround[i], next = kAround[(i + 1) % 4];
    if (glm::distance(corners_m[here], corners_m[next]) >= kShortestEdge_m) continue;
    return fmt::format("{} and {} are one place, expected four corners", kNames[here], kNames[next]);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2& here_m = corners_m[kAround[i]];
    const glm::dvec2 on_m = corners_m[kAround[(i + 1) % 4]] - here_m;
    const glm::dvec2 back_m = corners_m[kAround[(i + 3) % 4]] - here_m;
    const double angle_deg =
        std::atan2(cross2(on_m, back_m), glm::dot(on_m, back_m)) * 180.0 / std::numbers::pi;
    if (angle_deg >= kSharpest_deg && angle_deg <= kBluntest_deg) continue;
    return fmt::format(
        "the angle at {} is {:.0f} degrees, expected {:.0f} to {:.0f}: are two corners exchanged?",
        kNames[kAround[i]], angle_deg, kSharpest_deg, kBluntest_deg);
  }
  return {};
}

}  // namespace

/// The plane parallel to both diagonals, midway between them, has all four corners at one distance, and no
/// plane has a smaller largest one.
AroundScreen around(const std::array<glm::dvec3, 4>& corners_m) {
  AroundScreen result;
  const glm::dvec3 area = glm::cross(corners_m[kUpperRight] - corners_m[kLowerLeft],
                                     corners_m[kUpperLeft] - corners_m[kLowerRight]);
  const glm::dvec3 across_m =
      corners_m[kLowerRight] - corners_m[kLowerLeft] + corners_m[kUpperRight] - corners_m[kUpperLeft];
  if (!(glm::length(area) >= kShortestEdge_m * kShortestEdge_m) || !(glm::length(across_m) > 0.0)) {
    result.fault = "the four corners span no screen, expected four corners apart";
    return result;
  }
  const glm::dvec3 normal = glm::normalize(area);
  const glm::dvec3 right = glm::normalize(across_m - glm::dot(across_m, normal) * normal);
  const glm::dvec3 up = glm::cross(normal, right);
  const glm::dvec3 middle_m = 0.25 * (corners_m[0] + corners_m[1] + corners_m[2] + corners_m[3]);
  std::array<glm::dvec2, 4> inPlane_m;
  glm::dvec2 low_m(0.0), high_m(0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec3 from_m = corners_m[i] - middle_m;
    inPlane_m[i] = {glm::dot(from_m, right), glm::dot(from_m, up)};
    low_m = glm::min(low_m, inPlane_m[i]);
    high_m = glm::max(high_m, inPlane_m[i]);
    result.screen.offPlane_m = std::max(result.screen.offPlane_m, std::abs(glm::dot(from_m, normal)));
  }
  result.fault = faultOf(inPlane_m);
  if (!(result.screen.offPlane_m <= kMostOffPlane_m)) {
    result.fault = fmt::format(
        "the four corners are {:.1f} mm off one plane, expected at most {:.0f} mm: a bent screen needs a "
        "warp mesh",
        1e3 * result.screen.offPlane_m, 1e3 * kMostOffPlane_m);
  }
  if (!result.fault.empty()) return result;
  const auto place = [&](double x_m, double y_m) { return middle_m + x_m * right + y_m * up; };
  result.lowerLeft_m = place(low_m.x, low_m.y);
  result.lowerRight_m = place(high_m.x, low_m.y);
  result.upperLeft_m = place(low_m.x, high_m.y);
  result.screen.corners_m = corners_m;
  for (std::size_t i = 0; i < 4; ++i) {
    result.screen.inPicture[i] = (inPlane_m[i] - low_m) / (high_m - low_m);
  }
  return result;
}

/// P. S. Heckbert, "Fundamentals of Texture Mapping and Image Warping" (1989), section 2.2.3: the projective
/// map of the unit square to a quadrilateral.
glm::dmat3 pictureFromWindow(const SkewedScreen& screen) {
  const glm::dvec2 &p0 = screen.inPicture[kLowerLeft], &p1 = screen.inPicture[kLowerRight],
                   &p2 = screen.inPicture[kUpperRight], &p3 = screen.inPicture[kUpperLeft];
  const glm::dvec2 d1 = p1 - p2, d2 = p3 - p2, sum = p0 - p1 + p2 - p3;
  const double g = cross2(sum, d2) / cross2(d1, d2);
  const double h = cross2(d1, sum) / cross2(d1, d2);
  return {glm::dvec3(p1 - p0 + g * p1, g), glm::dvec3(p3 - p0 + h * p3, h), glm::dvec3(p0, 1.0)};
}

/// The area of the picture within an area of the window is det H / w³, with w the third coordinate, which is
/// linear: it is extreme at corners.
SkewCost costOf(const SkewedScreen& screen, const glm::dvec2& size_m, const glm::ivec2& pixels) {
  constexpr std::array<glm::dvec2, 4> kCorners{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};
  const glm::dmat3 homography = pictureFromWindow(screen);
  SkewCost cost{.least = 1e300, .most = 0.0};
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 inset = screen.inPicture[i] - kCorners[i];
    cost.inset_m = std::max(cost.inset_m, glm::length(inset * size_m));
    cost.inset_px = std::max(cost.inset_px, glm::length(inset * glm::dvec2(pixels)));
    const double w = (homography * glm::dvec3(kCorners[i], 1.0)).z;
    const double shown = std::sqrt(glm::determinant(homography) / (w * w * w));
    cost.least = std::min(cost.least, shown);
    cost.most = std::max(cost.most, shown);
  }
  // The area of a quadrilateral is half the cross product of its diagonals.
  cost.lost = 1.0 - 0.5 * cross2(screen.inPicture[kUpperRight] - screen.inPicture[kLowerLeft],
                                 screen.inPicture[kUpperLeft] - screen.inPicture[kLowerRight]);
  return cost;
}

}  // namespace carom
