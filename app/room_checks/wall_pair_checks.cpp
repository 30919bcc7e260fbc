#include "app/room_checks/wall_pair_checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "app/room_checks/wall_shape.h"
#include "cave/room/wall_eyes.h"

namespace carom {
namespace {

void judgeEyesOfOneWall(const RoomWall& a, const RoomWall& b, double off_m, Verdict& verdict) {
  const auto cornersA = cornersOf(a.wall), cornersB = cornersOf(b.wall);
  double worst_m = 0.0;
  for (std::size_t i = 0; i < 4; ++i) worst_m = std::max(worst_m, glm::distance(cornersA[i], cornersB[i]));
  const std::vector<ViewerEye> ofA = eyesOf(a.wall), ofB = eyesOf(b.wall);
  const bool eyes = std::none_of(ofA.begin(), ofA.end(), [&](const ViewerEye& eye) {
    const auto isSeen = [&eye](const ViewerEye& other) {
      const bool both = eye.eye == Eye::middle || other.eye == Eye::middle;
      return eye.viewer == other.viewer && (both || eye.eye == other.eye);
    };
    return std::any_of(ofB.begin(), ofB.end(), isSeen);
  });
  if (!eyes) {
    verdict.warn(
        b.at.wall,
        fmt::format("walls '{}' and '{}' are on the same place and show the same eyes; for a projector "
                    "an eye, stereo is left on one and right on the other",
                    a.wall.name, b.wall.name));
  }
  if (worst_m > kMeet_m) {
    verdict.warn(
        b.at.corner,
        fmt::format("{} '{}' and '{}' differ by {:.1f} mm at a corner{}, expected at most {:.0f} mm",
                    eyes ? "the two eyes' walls" : "walls", a.wall.name, b.wall.name, mm(worst_m),
                    off_m > kMeet_m ? fmt::format(" and are {:.1f} mm off one plane", mm(off_m)) : "",
                    mm(kMeet_m)));
  }
}

void judgePlanes(const RoomWall& a, const RoomWall& b, Verdict& verdict) {
  constexpr double kParallel = 0.9994;  // cosine of 2 degrees; a curved row of screens has more
  if (glm::dot(normal(a.wall), normal(b.wall)) < kParallel) return;
  const glm::dvec3 right = glm::normalize(across(a.wall)), up = glm::normalize(upwards(a.wall));
  glm::dvec2 low(1e300), high(-1e300);
  double off_m = 0.0;
  for (const glm::dvec3& corner : cornersOf(b.wall)) {
    const glm::dvec3 from_m = corner - a.wall.lowerLeft_m;
    const glm::dvec2 in(glm::dot(from_m, right), glm::dot(from_m, up));
    low = glm::min(low, in);
    high = glm::max(high, in);
    off_m = std::max(off_m, std::abs(glm::dot(from_m, normal(a.wall))));
  }
  const glm::dvec2 size(width_m(a.wall), height_m(a.wall));
  const glm::dvec2 shared = glm::min(high, size) - glm::max(low, glm::dvec2(0.0));
  if (shared.x < -kNear_m || shared.y < -kNear_m || off_m > kNear_m) return;
  const glm::dvec2 smaller = glm::min(size, high - low);
  const bool onTop = shared.x > 0.8 * smaller.x && shared.y > 0.8 * smaller.y && smaller.x > 0.8 * size.x &&
                     smaller.y > 0.8 * size.y;
  if (onTop) {
    judgeEyesOfOneWall(a, b, off_m, verdict);
  } else if (off_m > kMeet_m) {
    verdict.warn(b.at.corner,
                 fmt::format("tiles '{}' and '{}' are {:.1f} mm off one plane, expected at most {:.0f} mm",
                             a.wall.name, b.wall.name, mm(off_m), mm(kMeet_m)));
  }
}

double edgeMiss_m(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r, const glm::dvec3& s) {
  constexpr double kAlong = 0.9994;  // cosine of 2 degrees
  const double length_m = glm::distance(p, q), other_m = glm::distance(r, s);
  const glm::dvec3 along = (q - p) / length_m;
  if (std::abs(glm::dot(along, s - r)) < kAlong * other_m) return 0.0;
  const double rAt_m = glm::dot(r - p, along), sAt_m = glm::dot(s - p, along);
  const double shared_m = std::min(length_m, std::max(rAt_m, sAt_m)) - std::max(0.0, std::min(rAt_m, sAt_m));
  if (shared_m < 0.5 * std::min(length_m, other_m)) return 0.0;
  const double apart_m = std::max(glm::length(r - p - rAt_m * along), glm::length(s - p - sAt_m * along));
  if (apart_m > kNear_m) return 0.0;
  double worst_m = apart_m;
  for (const glm::dvec3& end : {r, s}) {
    const double near_m = std::min(glm::distance(end, p), glm::distance(end, q));
    if (near_m <= kNear_m) worst_m = std::max(worst_m, near_m);
  }
  return worst_m;
}

void judgeEdges(const RoomWall& a, const RoomWall& b, Verdict& verdict) {
  constexpr double kCorner = 0.985;  // cosine of 10 degrees; a room's corners have more
  if (std::abs(glm::dot(normal(a.wall), normal(b.wall))) > kCorner) return;
  const auto cornersA = cornersOf(a.wall), cornersB = cornersOf(b.wall);
  double worst_m = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      worst_m = std::max(worst_m,
                         edgeMiss_m(cornersA[i], cornersA[(i + 1) % 4], cornersB[j], cornersB[(j + 1) % 4]));
    }
  }
  if (worst_m <= kMeet_m) return;
  verdict.warn(
      b.at.corner,
      fmt::format("the edges of walls '{}' and '{}' miss each other by {:.1f} mm where they should meet, "
                  "expected at most {:.0f} mm",
                  a.wall.name, b.wall.name, mm(worst_m), mm(kMeet_m)));
}

double cutDepth_m(const Wall& a, const Wall& b) {
  const auto corners = cornersOf(a);
  const glm::dvec3 right = glm::normalize(across(b)), up = glm::normalize(upwards(b));
  double deepest_m = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec3 &p = corners[i], &q = corners[(i + 1) % 4];
    const double pSide_m = glm::dot(normal(b), p - b.lowerLeft_m),
                 qSide_m = glm::dot(normal(b), q - b.lowerLeft_m);
    if (std::min(pSide_m, qSide_m) > -kNear_m || std::max(pSide_m, qSide_m) < kNear_m) continue;
    const glm::dvec3 at_m = p + pSide_m / (pSide_m - qSide_m) * (q - p) - b.lowerLeft_m;
    const double x_m = glm::dot(at_m, right), y_m = glm::dot(at_m, up);
    deepest_m = std::max(deepest_m, std::min({x_m, width_m(b) - x_m, y_m, height_m(b) - y_m}));
  }
  return deepest_m;
}

void judgeCut(const RoomWall& a, const RoomWall& b, Verdict& verdict) {
  const double depth_m = std::max(cutDepth_m(a.wall, b.wall), cutDepth_m(b.wall, a.wall));
  if (depth_m <= kNear_m) return;
  verdict.warn(
      b.at.wall,
      fmt::format("walls '{}' and '{}' cut through each other, {:.0f} mm inside the edge, expected walls "
                  "that meet at their edges",
                  a.wall.name, b.wall.name, mm(depth_m)));
}

void judgeWindows(const RoomWall& a, const RoomWall& b, Verdict& verdict) {
  const WindowPlacement &p = a.wall.window, &q = b.wall.window;
  if (verdict.room.oneWindow || a.wall.node != b.wall.node || p.monitor != q.monitor ||
      p.monitorNames != q.monitorNames)
    return;
  if (a.wall.viewport && b.wall.viewport && p == q) return;  // the same window
  const glm::ivec2 shared =
      glm::min(p.position_px + p.size_px, q.position_px + q.size_px) - glm::max(p.position_px, q.position_px);
  if (shared.x <= 0 || shared.y <= 0) return;
  const std::string monitor = p.monitorNames.empty()
                                  ? fmt::format("monitor {}", p.monitor)
                                  : fmt::format("monitor {}", fmt::join(p.monitorNames, " and "));
  verdict.warn(b.at.window,
               fmt::format("the windows of walls '{}' and '{}' overlap by {} × {} pixels on {} of rank {}, "
                           "expected them apart",
                           a.wall.name, b.wall.name, shared.x, shared.y, monitor, a.wall.node));
}

}  // namespace

void judgePair(const RoomWall& a, const RoomWall& b, Verdict& verdict) {
  judgePlanes(a, b, verdict);
  judgeEdges(a, b, verdict);
  judgeCut(a, b, verdict);
  judgeWindows(a, b, verdict);
}

}  // namespace carom
