#include "app/room_checks/wall_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "app/room_checks/curved_checks.h"
#include "app/room_checks/wall_shape.h"

namespace carom {
namespace {

// Smallest distance by which a viewer is in front of a wall or behind it, as in the projection.
constexpr double kBefore_m = 1e-3;

std::array<Side, 6> sidesOf(const RoomAxes& axes) {
  return {{{"front", "ahead", axes.forward},
           {"back", "behind", -axes.forward},
           {"left", "on the left", -axes.right},
           {"right", "on the right", axes.right},
           {"floor", "below", -axes.up},
           {"ceiling", "above", axes.up}}};
}

void judgePixels(const RoomWall& wall, Verdict& verdict) {
  const double right = wall.wall.pixels.x / width_m(wall.wall);
  const double up = wall.wall.pixels.y / height_m(wall.wall);
  const double ratio = std::max(right, up) / std::min(right, up) - 1.0;
  if (ratio <= kSquarePixels) return;
  verdict.warn(wall.at.pixels,
               fmt::format("pixels of wall '{}' are not square: {:.1f} px/m across, {:.1f} px/m up ({:.0f} % "
                           "apart), expected within {:.0f} %",
                           wall.wall.name, right, up, 1e2 * ratio, 1e2 * kSquarePixels));
}

void judgeWindow(const RoomWall& wall, Verdict& verdict) {
  const glm::dvec2 window(wall.wall.viewport ? wall.wall.viewport->size_px : wall.wall.window.size_px);
  const glm::dvec2 picture(wall.wall.pixels);
  const bool sideBySide = wall.wall.stereo == StereoMode::sideBySide;
  const bool topBottom = wall.wall.stereo == StereoMode::topBottom;
  const auto fits = [&](double stretch) {
    const double miss = window.x / window.y * picture.y / picture.x / stretch;
    return std::max(miss, 1.0 / miss) - 1.0 <= kSquarePixels;
  };
  if (fits(1.0) || (sideBySide && fits(2.0)) || (topBottom && fits(0.5))) return;
  verdict.warn(
      wall.at.window,
      fmt::format("the window of wall '{}', {} × {} pixels, stretches its picture of {} × {} pixels: "
                  "expected the same shape{}",
                  wall.wall.name, window.x, window.y, picture.x, picture.y,
                  sideBySide  ? " or twice as wide"
                  : topBottom ? " or twice as high"
                              : ""));
}

std::optional<Side> namedSide(const Wall& wall, const RoomAxes& axes) {
  std::vector<std::string> words(1);
  bool wasLower = false;
  for (const char c : wall.name) {
    const auto letter = static_cast<unsigned char>(c);
    if (!std::isalpha(letter) || (wasLower && std::isupper(letter))) words.emplace_back();
    wasLower = std::islower(letter) != 0;
    if (std::isalpha(letter)) words.back() += static_cast<char>(std::tolower(letter));
  }
  std::vector<Side> found;
  for (const std::string& word : words) {
    const std::string_view side = word == "rear" ? "back" : std::string_view(word);
    for (const Side& known : sidesOf(axes)) {
      if (known.name == side) found.push_back(known);
    }
  }
  if (found.empty()) return {};
  const bool handed = found.front().name == "left" || found.front().name == "right";
  const bool anEye = wall.stereo == StereoMode::left || wall.stereo == StereoMode::right;
  if (handed && (found.size() > 1 || anEye)) return {};
  return found.front();
}

bool isTile(const RoomWall& wall, const Room& room) {
  return std::any_of(room.walls.begin(), room.walls.end(), [&](const RoomWall& other) {
    return &other != &wall && glm::dot(normal(wall.wall), normal(other.wall)) > 0.99 &&
           std::abs(glm::dot(normal(wall.wall), middle(other.wall) - wall.wall.lowerLeft_m)) <= kNear_m;
  });
}

void judgePlane(const RoomWall& wall, Verdict& verdict) {
  if (!wall.wall.skewed || wall.wall.skewed->offPlane_m <= kMeet_m) return;
  verdict.warn(
      wall.at.corner,
      fmt::format("the corners of wall '{}' are {:.1f} mm off one plane, which no straight picture mends, "
                  "expected at most {:.0f} mm",
                  wall.wall.name, mm(wall.wall.skewed->offPlane_m), mm(kMeet_m)));
}

void judgeName(const RoomWall& wall, Verdict& verdict) {
  const auto named = namedSide(wall.wall, verdict.room.axes);
  if (!named) return;
  const glm::dvec3 seen_m = middle(wall.wall) - verdict.room.viewerOf(wall.wall).eyes_m;
  const double squarely = glm::dot(named->direction, -normal(wall.wall));
  const double towards = glm::dot(named->direction, seen_m) / std::max(glm::length(seen_m), kBefore_m);
  constexpr double kSlanted = 0.3;  // side walls may be folded open by up to 70 degrees
  if (std::max(squarely, towards) >= kSlanted || (towards > 0.0 && isTile(wall, verdict.room))) return;
  const Side side = lookedAt(wall.wall, verdict.room.axes);
  verdict.warn(
      wall.at.name,
      fmt::format("wall '{}' is {}, against its name: its middle is {:.0f} mm to the {}, {:.0f} mm {} and "
                  "{:.0f} mm "
                  "{} the eyes",
                  wall.wall.name, side.where, mm(std::abs(glm::dot(seen_m, verdict.room.axes.right))),
                  glm::dot(seen_m, verdict.room.axes.right) < 0.0 ? "left" : "right",
                  mm(std::abs(glm::dot(seen_m, verdict.room.axes.forward))),
                  glm::dot(seen_m, verdict.room.axes.forward) < 0.0 ? "behind" : "ahead",
                  mm(std::abs(glm::dot(seen_m, verdict.room.axes.up))),
                  glm::dot(seen_m, verdict.room.axes.up) < 0.0 ? "below" : "above"));
}

void judgeDistance(const RoomWall& wall, Verdict& verdict) {
  const auto& [eyes_m, at, viewer] = verdict.room.viewerOf(wall.wall);
  const double before_m = glm::dot(normal(wall.wall), eyes_m - wall.wall.lowerLeft_m);
  const std::string& name = wall.wall.name;
  if (std::abs(before_m) <= kBefore_m) {
    verdict.warn(
        wall.at.wall,
        fmt::format("{} is in the plane of wall '{}', {:.1f} mm before it, and would see nothing on it",
                    viewer, name, mm(before_m)));
  } else if (before_m < 0.0) {
    verdict.warn(
        wall.at.wall,
        fmt::format("{} is {:.0f} mm behind wall '{}', which then stays black: expected before it. Corners "
                    "count as seen from inside; mirrored ones turn a wall away",
                    viewer, -mm(before_m), name));
  } else if (before_m < kNearestWall_m) {
    verdict.warn(wall.at.wall, fmt::format("{} is {:.0f} mm before wall '{}', expected at least {:.0f} mm",
                                           viewer, mm(before_m), name, mm(kNearestWall_m)));
  } else if (before_m > kFarthestWall_m) {
    verdict.warn(wall.at.wall,
                 fmt::format("{} is {:.0f} mm before wall '{}', expected at most {:.0f} mm{}", viewer,
                             mm(before_m), name, mm(kFarthestWall_m),
                             otherUnits(before_m, verdict.room.unit_m, kNearestWall_m, kFarthestWall_m)));
  }
}

}  // namespace

Side lookedAt(const Wall& wall, const RoomAxes& axes) {
  const auto sides = sidesOf(axes);
  return *std::max_element(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
    return glm::dot(a.direction, -normal(wall)) < glm::dot(b.direction, -normal(wall));
  });
}

void judgeWall(const RoomWall& wall, Verdict& verdict) {
  if (wall.wall.screen) {
    judgeCurved(wall, verdict);
    if (!wall.wall.sky) judgeName({chordOf(wall.wall), wall.at}, verdict);
    return;
  }
  judgePlane(wall, verdict);
  judgePixels(wall, verdict);
  judgeWindow(wall, verdict);
  judgeName(wall, verdict);
  judgeDistance(wall, verdict);
}

}  // namespace carom
