#include "app/room_import/curved_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "app/room_import/wall_shape.h"
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
  const double circle = std::numbers::pi / 4.0;  // what a dome's circle leaves of a square
  if (facts.covered < kLeastCovered * circle) {
    verdict.warn(wall.at.window,
                 fmt::format("only {:.0f} % of the window of wall '{}' show screen, expected {:.0f} % at "
                             "least",
                             1e2 * facts.covered, name, 1e2 * kLeastCovered * circle));
  }
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
