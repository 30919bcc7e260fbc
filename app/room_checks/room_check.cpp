#include "app/room_checks/room_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include "app/room_checks/curved_checks.h"
#include "app/room_checks/wall_checks.h"
#include "app/room_checks/wall_pair_checks.h"
#include "app/room_checks/wall_shape.h"

namespace carom {
namespace {

// Adult eyes are 52 to 78 mm apart (N. A. Dodgson, "Variation and extrema of human interpupillary distance",
// 2004); the limits leave a margin for glasses that fit badly.
constexpr double kNarrowestEyes_m = 0.050, kWidestEyes_m = 0.080;
// Eye heights above the floor of a seated child and of a very tall person.
constexpr double kLowestEyes_m = 0.9, kHighestEyes_m = 2.2;
constexpr double kSmallestWall_m = 0.1, kLargestWall_m = 20.0;

struct Unit {
  std::string_view name;
  double metres;
};
constexpr std::array<Unit, 5> kUnits{
    {{"mm", 1e-3}, {"cm", 1e-2}, {"in", 0.0254}, {"ft", 0.3048}, {"m", 1.0}}};

void judgeEyes(Verdict& verdict) {
  const double apart_m = verdict.room.eyeSeparation_m;
  const bool stereo = std::any_of(verdict.room.walls.begin(), verdict.room.walls.end(),
                                  [](const RoomWall& wall) { return wall.wall.stereo != StereoMode::mono; });
  if (apart_m == 0.0 && !stereo) return;
  if (apart_m >= kNarrowestEyes_m && apart_m <= kWidestEyes_m) return;
  verdict.warn(verdict.room.eyeSeparationAt,
               fmt::format("the eyes are {:.1f} mm apart, expected {:.0f} to {:.0f} mm{}", mm(apart_m),
                           mm(kNarrowestEyes_m), mm(kWidestEyes_m),
                           otherUnits(apart_m, verdict.room.unit_m, kNarrowestEyes_m, kWidestEyes_m)));
}

void judgeSize(Verdict& verdict) {
  for (const RoomWall& wall : verdict.room.walls) {
    if (wall.wall.screen) continue;
    const double longer_m = std::max(width_m(wall.wall), height_m(wall.wall));
    if (longer_m >= kSmallestWall_m && longer_m <= kLargestWall_m) continue;
    return verdict.warn(
        wall.at.corner,
        fmt::format("wall '{}' is {:.0f} × {:.0f} mm, expected an edge of {:.0f} to {:.0f} mm{}",
                    wall.wall.name, mm(width_m(wall.wall)), mm(height_m(wall.wall)), mm(kSmallestWall_m),
                    mm(kLargestWall_m), otherUnits(longer_m, verdict.room.unit_m, 0.5, kFarthestWall_m)));
  }
}

void judgeHeight(Verdict& verdict) {
  const auto floor_m = floorHeight_m(verdict.room);
  if (!floor_m) return;
  for (const Viewer& viewer : verdict.room.viewers) {
    const double eyes_m = glm::dot(viewer.eyes_m, verdict.room.axes.up) - *floor_m;
    if (eyes_m >= kLowestEyes_m && eyes_m <= kHighestEyes_m) continue;
    verdict.warn(viewer.at,
                 fmt::format("{} has the eyes {:.0f} mm above the floor, expected {:.0f} to {:.0f} mm{}",
                             viewer.words, mm(eyes_m), mm(kLowestEyes_m), mm(kHighestEyes_m),
                             otherUnits(eyes_m, verdict.room.unit_m, kLowestEyes_m, kHighestEyes_m)));
  }
}

void judgeRanks(Verdict& verdict) {
  std::set<int> drawing;
  for (const RoomWall& wall : verdict.room.walls) drawing.insert(wall.wall.node);
  for (std::size_t i = 0; i < verdict.room.nodes.size(); ++i) {
    const NodeSetup& node = verdict.room.nodes[i];
    for (int rank = node.rank; rank < node.rank + node.slots; ++rank) {
      if (drawing.contains(rank)) continue;
      const std::string where = node.display.empty() ? "host " + node.host : "display " + node.display;
      verdict.warn(verdict.room.nodesAt[i],
                   fmt::format("rank {} has {} but no wall to draw on it", rank, where));
    }
  }
  for (const RoomWall& wall : verdict.room.walls) {
    const int below = wall.wall.node - 1;
    if (below < 0 || drawing.contains(below)) continue;
    verdict.warn(
        wall.at.node,
        fmt::format("wall '{}' is drawn by rank {}, but rank {} has no wall: expected ranks from 0 on "
                    "without gaps",
                    wall.wall.name, wall.wall.node, below));
    drawing.insert(below);
  }
}

/// Returns what it costs that a screen is no rectangle; empty for one that is.
std::string skewWords(const Wall& wall) {
  if (!wall.skewed) return {};
  const SkewCost cost = costOf(*wall.skewed, {width_m(wall), height_m(wall)}, wall.pixels);
  return fmt::format(
      "\n  skewed: its corners lie up to {:.1f} mm ({:.1f} pixels) inside the rectangle for which the "
      "picture is "
      "drawn, and {:.1f} mm off one plane;\n"
      "  {:.1f} % of the pixels fall beside the screen; a pixel of the projector shows {:.2f} to {:.2f} "
      "pixels of "
      "the picture, across",
      mm(cost.inset_m), cost.inset_px, mm(wall.skewed->offPlane_m), 1e2 * cost.lost, cost.least, cost.most);
}

}  // namespace

std::string otherUnits(double value_m, double unit_m, double least_m, double most_m) {
  std::string words;
  for (const Unit& unit : kUnits) {
    const double other_m = value_m / unit_m * unit.metres;
    if (unit.metres == unit_m || !(other_m >= least_m && other_m <= most_m)) continue;
    words += fmt::format("{} {:.6g} {} would be {:.1f} mm", words.empty() ? ";" : ",", value_m / unit_m,
                         unit.name, mm(other_m));
  }
  return words;
}

std::optional<double> floorHeight_m(const Room& room) {
  constexpr double kLevel = 0.985;  // cosine of 10 degrees
  std::optional<double> lowest_m;
  for (const RoomWall& wall : room.walls) {
    if (wall.wall.screen) continue;
    if (glm::dot(normal(wall.wall), room.axes.up) < kLevel) continue;
    const double height = glm::dot(middle(wall.wall), room.axes.up);
    if (!lowest_m || height < *lowest_m) lowest_m = height;
  }
  return lowest_m ? lowest_m : room.floor_m;
}

std::vector<Finding> judgeRoom(const Room& room) {
  Verdict verdict{room, {}};
  judgeEyes(verdict);
  judgeSize(verdict);
  for (const RoomWall& wall : room.walls) judgeWall(wall, verdict);
  judgeHeight(verdict);
  const std::vector<ScreenEnd> ends = screenEndsOf(room);
  for (std::size_t i = 0; i < room.walls.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!room.walls[i].wall.screen && !room.walls[j].wall.screen)
        judgePair(room.walls[j], room.walls[i], verdict);
      else if (!ends.empty())
        judgeRims(room.walls[j], room.walls[i], ends[j], ends[i], verdict);
    }
  }
  if (!room.hasErrors()) judgeRanks(verdict);
  std::vector<Finding> findings = verdict.findings.all();
  std::stable_sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
    return std::pair(a.at.line, a.at.column) < std::pair(b.at.line, b.at.column);
  });
  return findings;
}

std::string_view sideOf(const Wall& wall, const RoomAxes& axes) { return lookedAt(wall, axes).name; }

std::string wordsFor(const RoomWall& wall, const Room& room) {
  if (wall.wall.screen) return wordsForCurved(wall, room);
  constexpr double kMetresPerFoot = 0.3048;
  constexpr std::array<std::string_view, 10> kStereo{"mono",
                                                     "the left eye alone",
                                                     "the right eye alone",
                                                     "stereo by quad-buffer",
                                                     "stereo side by side",
                                                     "stereo top and bottom",
                                                     "stereo in red and cyan",
                                                     "stereo in alternate lines",
                                                     "stereo in a checkerboard",
                                                     "stereo in red and cyan, without colours"};
  const double width = width_m(wall.wall), height = height_m(wall.wall);
  const double right = wall.wall.pixels.x / width, up = wall.wall.pixels.y / height;
  const bool equal = std::abs(width - height) <= kMeet_m;
  const bool square = std::max(right, up) <= (1.0 + kSquarePixels) * std::min(right, up);
  const double before_m =
      glm::dot(normal(wall.wall), room.viewerOf(wall.wall).eyes_m - wall.wall.lowerLeft_m);
  const std::string feet =
      equal ? fmt::format("{:.3g} ft", width / kMetresPerFoot)
            : fmt::format("{:.3g} × {:.3g} ft", width / kMetresPerFoot, height / kMetresPerFoot);
  const std::string density =
      square ? fmt::format("{:.0f} px/m", right) : fmt::format("{:.0f} × {:.0f} px/m", right, up);
  const std::string place = before_m > 0.0
                                ? fmt::format("{:.2f} m {}", before_m, lookedAt(wall.wall, room.axes).where)
                                : fmt::format("{:.2f} m off, turned away", -before_m);
  return fmt::format(
      "{}: {:.3f} × {:.3f} m ({}), {}, {}\n"
      "  {:.0f} × {:.0f} mm, {} × {} pixels an eye, {}, drawn by rank {}{}",
      wall.wall.name, width, height, feet, density, place, mm(width), mm(height), wall.wall.pixels.x,
      wall.wall.pixels.y, kStereo[static_cast<std::size_t>(wall.wall.stereo)], wall.wall.node,
      skewWords(wall.wall));
}

}  // namespace carom
