#include "app/room_checks/curved_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <variant>

#include "app/room_checks/wall_shape.h"
#include "cave/screen/mesh_faults.h"
#include "cave/screen/screen_facts.h"

namespace carom {
namespace {

constexpr double kRadian = 180.0 / std::numbers::pi;

ScreenFacts factsFor(const RoomWall& wall, const Room& room) {
  return factsOf(*wall.wall.screen, wall.wall.pixels, room.viewerOf(wall.wall).eyes_m);
}

/// Describes a picture by direction: its place, pixels and flat pieces.
std::string wordsForSky(const RoomWall& wall) {
  const CurvedScreen& screen = *wall.wall.screen;
  const auto& from_m = wall.wall.sky->from_m;
  const std::string eyes =
      from_m ? fmt::format("the place {:.2f}, {:.2f}, {:.2f} m of the room", from_m->x, from_m->y, from_m->z)
             : "the tracked head";
  const ScreenFacts facts = factsOf(screen, wall.wall.pixels, screen.eyesMiddle_m);
  return fmt::format(
      "{}: a picture by direction, as seen from {}\n"
      "  {} × {} pixels an eye, drawn by rank {} on {} flat pieces with {:.2f} texels a pixel",
      wall.wall.name, eyes, wall.wall.pixels.x, wall.wall.pixels.y, wall.wall.node, screen.pieces.size(),
      facts.texelsPerPixel);
}

/// Returns the mesh of a flat wall.
ScreenMesh flatMesh(const Wall& wall) {
  const auto corners = cornersOf(wall);
  const ScreenPoint a{{0, 0}, corners[0]}, b{{1, 0}, corners[1]}, c{{1, 1}, corners[2]},
      d{{0, 1}, corners[3]};
  return {{a, b, c}, {a, c, d}};
}

/// Returns the place of a segment that is nearest to a point.
glm::dvec3 nearestOn(const std::array<ScreenPoint, 2>& segment, const glm::dvec3& point_m) {
  const glm::dvec3 along = segment[1].inRoom_m - segment[0].inRoom_m;
  const double length2 = glm::dot(along, along);
  const double at = length2 > 0.0 ? glm::dot(point_m - segment[0].inRoom_m, along) / length2 : 0.0;
  return segment[0].inRoom_m + std::clamp(at, 0.0, 1.0) * along;
}

/// Returns by how much a screen misses another at its own rim, where both rims run side by side: how far it
/// is from the other's rim, or, where the other is before or behind it, from the other's surface.
double rimsMiss_m(const ScreenEnd& screen, const ScreenEnd& other, const glm::dvec3& eyes_m) {
  constexpr std::size_t kSamples = 200;
  constexpr double kAlong = 0.985;                   // cosine of 10 degrees
  constexpr double kBeyond = 0.3, kBeyond_m = 5e-4;  // where one rim goes on as the other, they miss nothing
  double worst_m = 0.0;
  const std::size_t step = std::max<std::size_t>(1, screen.rim.size() / kSamples);
  for (std::size_t i = 0; i < screen.rim.size(); i += step) {
    const auto& [from, to] = screen.rim[i];
    const glm::dvec3 place_m = 0.5 * (from.inRoom_m + to.inRoom_m),
                     along = glm::normalize(to.inRoom_m - from.inRoom_m);
    double apart_m = kNear_m;
    for (const auto& segment : other.rim) {
      const glm::dvec3 way = segment[1].inRoom_m - segment[0].inRoom_m;
      if (std::abs(glm::dot(way, along)) < kAlong * glm::length(way)) continue;
      const glm::dvec3 off_m = nearestOn(segment, place_m) - place_m;
      const bool isBeside = std::abs(glm::dot(off_m, along)) <= kBeyond * glm::length(off_m) + kBeyond_m;
      if (isBeside) apart_m = std::min(apart_m, glm::length(off_m));
    }
    if (apart_m >= kNear_m || apart_m <= worst_m) continue;
    const auto behind = hit(other.mesh, eyes_m, place_m - eyes_m);
    if (behind) apart_m = std::min(apart_m, glm::distance(behind->inRoom_m, place_m));
    worst_m = std::max(worst_m, apart_m);
  }
  return worst_m;
}

}  // namespace

void judgeCurved(const RoomWall& wall, Verdict& verdict) {
  if (wall.wall.sky) return;  // it stands nowhere
  constexpr double kMostIncidence_deg = 75.0, kMostVaried = 3.0, kMostSlide_px = 0.25, kLeastCovered = 0.9;
  const ScreenFacts facts = factsFor(wall, verdict.room);
  const Viewer& viewer = verdict.room.viewerOf(wall.wall);
  const std::string& name = wall.wall.name;
  if (facts.isBehind) {
    verdict.fail(
        wall.at.wall,
        fmt::format("{} is behind the whole screen of wall '{}', which then stays black: expected before it",
                    viewer.words, name));
    return;
  }
  if (facts.isMirrored) {
    verdict.warn(
        wall.at.wall,
        fmt::format("the window of wall '{}' runs mirrored over its screen, as for projection from behind: "
                    "expected that its left is on the left as {} looks at it",
                    name, viewer.words));
  }
  const double incidence_deg = facts.mostIncidence_rad * kRadian;
  if (incidence_deg > kMostIncidence_deg) {
    verdict.warn(
        wall.at.wall,
        fmt::format(
            "{} looks at the screen of wall '{}' up to {:.0f}° from its normal, expected at most {:.0f}°",
            viewer.words, name, incidence_deg, kMostIncidence_deg));
  }
  if (facts.mostPerMetre > kMostVaried * facts.leastPerMetre) {
    verdict.warn(
        wall.at.pixels,
        fmt::format(
            "wall '{}' has {:.0f} to {:.0f} px/m, expected that they vary by a factor of {:.0f} at most",
            name, facts.leastPerMetre, facts.mostPerMetre, kMostVaried));
  }
  if (wall.wall.screen->slide_px > kMostSlide_px) {
    verdict.warn(
        wall.at.wall,
        fmt::format("between the points of its mesh the picture of wall '{}' slides by up to {:.2f} pixels, "
                    "expected at most {:.2f}: it needs more points",
                    name, wall.wall.screen->slide_px, kMostSlide_px));
  }
  // A dome's circle leaves so much of a square.
  const double circle =
      std::holds_alternative<DomeScreen>(wall.wall.screen->shape) ? std::numbers::pi / 4.0 : 1.0;
  if (facts.covered < kLeastCovered * circle) {
    verdict.warn(wall.at.window,
                 fmt::format("only {:.0f} % of the window of wall '{}' show screen, expected {:.0f} % at "
                             "least",
                             1e2 * facts.covered, name, 1e2 * kLeastCovered * circle));
  }
}

std::vector<ScreenEnd> screenEndsOf(const Room& room) {
  const bool isCurved = std::any_of(room.walls.begin(), room.walls.end(),
                                    [](const RoomWall& wall) { return wall.wall.screen && !wall.wall.sky; });
  if (!isCurved) return {};
  std::vector<ScreenEnd> ends;
  for (const RoomWall& wall : room.walls) {
    ScreenEnd& end = ends.emplace_back();
    end.isCurved = wall.wall.screen && !wall.wall.sky;
    if (wall.wall.sky) continue;
    end.mesh = wall.wall.screen ? wall.wall.screen->mesh : flatMesh(wall.wall);
    end.rim = rimOf(end.mesh);
  }
  return ends;
}

void judgeRims(const RoomWall& a, const RoomWall& b, const ScreenEnd& endA, const ScreenEnd& endB,
               Verdict& verdict) {
  if ((!endA.isCurved && !endB.isCurved) || endA.rim.empty() || endB.rim.empty()) return;
  const glm::dvec3& eyes_m = verdict.room.viewerOf(b.wall).eyes_m;
  const double miss_m = std::max(rimsMiss_m(endA, endB, eyes_m), rimsMiss_m(endB, endA, eyes_m));
  if (miss_m <= kMeet_m) return;
  verdict.warn(b.at.wall,
               fmt::format("the rims of walls '{}' and '{}' miss each other by {:.1f} mm where they should "
                           "meet, expected at most {:.0f} mm",
                           a.wall.name, b.wall.name, mm(miss_m), mm(kMeet_m)));
}

Wall chordOf(const Wall& wall) {
  glm::dvec3 area(0.0), middle_m(0.0);
  for (const ScreenTriangle& t : wall.screen->mesh) {
    const double side = windowArea(t) < 0.0 ? -1.0 : 1.0;
    area += side * glm::cross(t[1].inRoom_m - t[0].inRoom_m, t[2].inRoom_m - t[0].inRoom_m);
    middle_m += (t[0].inRoom_m + t[1].inRoom_m + t[2].inRoom_m) /
                (3.0 * static_cast<double>(wall.screen->mesh.size()));
  }
  const glm::dvec3 normal = glm::normalize(area);
  const glm::dvec3 right = glm::normalize(
      glm::cross(std::abs(normal.y) < 0.8 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1), normal));
  const glm::dvec3 up = glm::cross(normal, right);
  Wall chord = wall;
  chord.screen.reset();
  chord.lowerLeft_m = middle_m - 0.5 * right - 0.5 * up;
  chord.lowerRight_m = chord.lowerLeft_m + right;
  chord.upperLeft_m = chord.lowerLeft_m + up;
  return chord;
}

std::string wordsForCurved(const RoomWall& wall, const Room& room) {
  if (wall.wall.sky) return wordsForSky(wall);
  const ScreenFacts facts = factsFor(wall, room);
  const CurvedScreen& screen = *wall.wall.screen;
  return fmt::format(
      "{}: curved, {:.3f} × {:.3f} m along it, turns by {:.0f}°, {:.0f} to {:.0f} px/m, {:.2f} to {:.2f} m "
      "from the eyes\n"
      "  {} × {} pixels an eye, drawn by rank {} on {} flat pieces with {:.2f} texels a pixel; its mesh is "
      "right to "
      "{:.2f} pixels",
      wall.wall.name, facts.width_m, facts.height_m, facts.turns_rad * kRadian, facts.leastPerMetre,
      facts.mostPerMetre, facts.nearest_m, facts.farthest_m, wall.wall.pixels.x, wall.wall.pixels.y,
      wall.wall.node, screen.pieces.size(), facts.texelsPerPixel, screen.slide_px);
}

}  // namespace carom
