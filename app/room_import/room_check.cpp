#include "app/room_import/room_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>
#include <set>

#include "cave/room/rectangle.h"

namespace carom {

namespace {

// What is told apart from measuring with a tape.
constexpr double kMeet_m = kCornerMiss_m;
// Edges and planes further apart than this are apart on purpose.
constexpr double kNear_m = 0.1;
constexpr double kSquarePixels = 0.02;
// Eyes of adults are 52 to 78 mm apart (N. A. Dodgson, "Variation and extrema of human interpupillary
// distance", 2004); a little more for glasses that sit badly.
constexpr double kNarrowestEyes_m = 0.050, kWidestEyes_m = 0.080;
// Eyes of a seated child and of a very tall person, above the floor.
constexpr double kLowestEyes_m = 0.9, kHighestEyes_m = 2.2;
constexpr double kNearestWall_m = 0.2, kFarthestWall_m = 10.0;
constexpr double kSmallestWall_m = 0.1, kLargestWall_m = 20.0;
// A person is before a wall or behind it by more than this; as in the projection.
constexpr double kBefore_m = 1e-3;

double mm(double length_m) { return length_m * 1e3; }

glm::dvec3 across(const Wall& wall) { return wall.lowerRight_m - wall.lowerLeft_m; }
glm::dvec3 upwards(const Wall& wall) { return wall.upperLeft_m - wall.lowerLeft_m; }
/// Points to the side that the wall is seen from.
glm::dvec3 normal(const Wall& wall) { return glm::normalize(glm::cross(across(wall), upwards(wall))); }
glm::dvec3 middle(const Wall& wall) { return wall.lowerLeft_m + 0.5 * (across(wall) + upwards(wall)); }
double width_m(const Wall& wall) { return glm::length(across(wall)); }
double height_m(const Wall& wall) { return glm::length(upwards(wall)); }

std::array<glm::dvec3, 4> cornersOf(const Wall& wall) {
  return {wall.lowerLeft_m, wall.lowerRight_m, wall.lowerRight_m + upwards(wall), wall.upperLeft_m};
}

struct Unit {
  std::string_view name;
  double metres;
};
constexpr std::array<Unit, 5> kUnits{
    {{"mm", 1e-3}, {"cm", 1e-2}, {"in", 0.0254}, {"ft", 0.3048}, {"m", 1.0}}};

/// "; 0.21 ft would be 64.0 mm" for the units in which the file's number would be plausible.
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

struct Side {
  std::string_view name;   // of the wall there
  std::string_view where;  // as seen by a person
  glm::dvec3 direction;
};

std::array<Side, 6> sidesOf(const RoomAxes& axes) {
  return {{{"front", "ahead", axes.forward},
           {"back", "behind", -axes.forward},
           {"left", "on the left", -axes.right},
           {"right", "on the right", axes.right},
           {"floor", "below", -axes.up},
           {"ceiling", "above", axes.up}}};
}

/// The side whose direction is nearest to the one in which the wall is looked at squarely.
Side lookedAt(const Wall& wall, const RoomAxes& axes) {
  const auto sides = sidesOf(axes);
  return *std::max_element(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
    return glm::dot(a.direction, -normal(wall)) < glm::dot(b.direction, -normal(wall));
  });
}

class Judge {
 public:
  explicit Judge(const Room& room) : room_(room) {}

  std::vector<Finding> judge() {
    judgeEyes();
    judgeSize();
    for (const RoomWall& wall : room_.walls) {
      judgePixels(wall);
      judgeWindow(wall);
      judgeName(wall);
      judgeDistance(wall);
    }
    judgeHeight();
    for (std::size_t i = 0; i < room_.walls.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        judgePlanes(room_.walls[j], room_.walls[i]);
        judgeEdges(room_.walls[j], room_.walls[i]);
        judgeCut(room_.walls[j], room_.walls[i]);
        judgeWindows(room_.walls[j], room_.walls[i]);
      }
    }
    if (!room_.hasErrors()) judgeRanks();
    std::stable_sort(findings_.begin(), findings_.end(), [](const Finding& a, const Finding& b) {
      return std::pair(a.at.line, a.at.column) < std::pair(b.at.line, b.at.column);
    });
    return std::move(findings_);
  }

 private:
  void warn(FilePlace at, std::string text) {
    findings_.push_back({Finding::Kind::warning, at, std::move(text)});
  }

  void judgeEyes() {
    const double apart_m = room_.eyeSeparation_m;
    const bool stereo = std::any_of(room_.walls.begin(), room_.walls.end(), [](const RoomWall& wall) {
      return wall.wall.stereo != StereoMode::mono;
    });
    if (apart_m == 0.0 && !stereo) return;
    if (apart_m >= kNarrowestEyes_m && apart_m <= kWidestEyes_m) return;
    warn(room_.eyeSeparationAt,
         fmt::format("the eyes are {:.1f} mm apart, expected {:.0f} to {:.0f} mm{}", mm(apart_m),
                     mm(kNarrowestEyes_m), mm(kWidestEyes_m),
                     otherUnits(apart_m, room_.unit_m, kNarrowestEyes_m, kWidestEyes_m)));
  }

  /// One word for the whole room: a wrong unit makes all walls wrong.
  void judgeSize() {
    for (const RoomWall& wall : room_.walls) {
      const double longer_m = std::max(width_m(wall.wall), height_m(wall.wall));
      if (longer_m >= kSmallestWall_m && longer_m <= kLargestWall_m) continue;
      return warn(
          wall.at.corner,
          fmt::format("wall '{}' is {:.0f} × {:.0f} mm, expected an edge of {:.0f} to {:.0f} mm{}",
                      wall.wall.name, mm(width_m(wall.wall)), mm(height_m(wall.wall)), mm(kSmallestWall_m),
                      mm(kLargestWall_m), otherUnits(longer_m, room_.unit_m, 0.5, kFarthestWall_m)));
    }
  }

  void judgePixels(const RoomWall& wall) {
    const double right = wall.wall.pixels.x / width_m(wall.wall);
    const double up = wall.wall.pixels.y / height_m(wall.wall);
    const double ratio = std::max(right, up) / std::min(right, up) - 1.0;
    if (ratio <= kSquarePixels) return;
    warn(wall.at.pixels,
         fmt::format("pixels of wall '{}' are not square: {:.1f} px/m across, {:.1f} px/m up ({:.0f} % "
                     "apart), expected within {:.0f} %",
                     wall.wall.name, right, up, 1e2 * ratio, 1e2 * kSquarePixels));
  }

  /// The window scales the picture; it should not stretch it. Packed pictures may keep their shape or be
  /// squeezed into their halves, as televisions take them.
  void judgeWindow(const RoomWall& wall) {
    const glm::dvec2 window(wall.wall.viewport ? wall.wall.viewport->size_px : wall.wall.window.size_px);
    const glm::dvec2 picture(wall.wall.pixels);
    const bool sideBySide = wall.wall.stereo == StereoMode::sideBySide;
    const bool topBottom = wall.wall.stereo == StereoMode::topBottom;
    const auto fits = [&](double stretch) {
      const double miss = window.x / window.y * picture.y / picture.x / stretch;
      return std::max(miss, 1.0 / miss) - 1.0 <= kSquarePixels;
    };
    if (fits(1.0) || (sideBySide && fits(2.0)) || (topBottom && fits(0.5))) return;
    warn(wall.at.window,
         fmt::format("the window of wall '{}', {} × {} pixels, stretches its picture of {} × {} pixels: "
                     "expected the same shape{}",
                     wall.wall.name, window.x, window.y, picture.x, picture.y,
                     sideBySide  ? " or twice as wide"
                     : topBottom ? " or twice as high"
                                 : ""));
  }

  void judgeName(const RoomWall& wall) {
    const auto named = namedSide(wall.wall);
    if (!named) return;
    const glm::dvec3 seen_m = middle(wall.wall) - room_.viewer.eyes_m;
    const double squarely = glm::dot(named->direction, -normal(wall.wall));
    const double towards = glm::dot(named->direction, seen_m) / std::max(glm::length(seen_m), kBefore_m);
    constexpr double kSlanted = 0.3;  // side walls folded open by up to 70 degrees
    if (std::max(squarely, towards) >= kSlanted || (towards > 0.0 && isTile(wall))) return;
    const Side side = lookedAt(wall.wall, room_.axes);
    warn(wall.at.name,
         fmt::format("wall '{}' is {}, against its name: its middle is {:.0f} mm to the {}, {:.0f} mm {} and "
                     "{:.0f} mm "
                     "{} the eyes",
                     wall.wall.name, side.where, mm(std::abs(glm::dot(seen_m, room_.axes.right))),
                     glm::dot(seen_m, room_.axes.right) < 0.0 ? "left" : "right",
                     mm(std::abs(glm::dot(seen_m, room_.axes.forward))),
                     glm::dot(seen_m, room_.axes.forward) < 0.0 ? "behind" : "ahead",
                     mm(std::abs(glm::dot(seen_m, room_.axes.up))),
                     glm::dot(seen_m, room_.axes.up) < 0.0 ? "below" : "above"));
  }

  /// The side that a wall's name promises. None where it has no word for one, or words that may mean a tile
  /// ("front-left") or an eye.
  std::optional<Side> namedSide(const Wall& wall) const {
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
      for (const Side& known : sidesOf(room_.axes)) {
        if (known.name == side) found.push_back(known);
      }
    }
    if (found.empty()) return {};
    const bool handed = found.front().name == "left" || found.front().name == "right";
    const bool anEye = wall.stereo == StereoMode::left || wall.stereo == StereoMode::right;
    if (handed && (found.size() > 1 || anEye)) return {};
    return found.front();
  }

  /// Whether another wall goes on in its plane.
  bool isTile(const RoomWall& wall) const {
    return std::any_of(room_.walls.begin(), room_.walls.end(), [&](const RoomWall& other) {
      return &other != &wall && glm::dot(normal(wall.wall), normal(other.wall)) > 0.99 &&
             std::abs(glm::dot(normal(wall.wall), middle(other.wall) - wall.wall.lowerLeft_m)) <= kNear_m;
    });
  }

  void judgeDistance(const RoomWall& wall) {
    const double before_m = glm::dot(normal(wall.wall), room_.viewer.eyes_m - wall.wall.lowerLeft_m);
    const std::string& viewer = room_.viewer.words;
    const std::string& name = wall.wall.name;
    if (std::abs(before_m) <= kBefore_m) {
      warn(wall.at.wall,
           fmt::format("{} is in the plane of wall '{}', {:.1f} mm before it, and would see nothing on it",
                       viewer, name, mm(before_m)));
    } else if (before_m < 0.0) {
      warn(
          wall.at.wall,
          fmt::format("{} is {:.0f} mm behind wall '{}', which then stays black: expected before it. Corners "
                      "count as seen from inside; mirrored ones turn a wall away",
                      viewer, -mm(before_m), name));
    } else if (before_m < kNearestWall_m) {
      warn(wall.at.wall, fmt::format("{} is {:.0f} mm before wall '{}', expected at least {:.0f} mm", viewer,
                                     mm(before_m), name, mm(kNearestWall_m)));
    } else if (before_m > kFarthestWall_m) {
      warn(wall.at.wall, fmt::format("{} is {:.0f} mm before wall '{}', expected at most {:.0f} mm{}", viewer,
                                     mm(before_m), name, mm(kFarthestWall_m),
                                     otherUnits(before_m, room_.unit_m, kNearestWall_m, kFarthestWall_m)));
    }
  }

  void judgeHeight() {
    const auto floor_m = floorHeight_m(room_);
    if (!floor_m) return;
    const double eyes_m = glm::dot(room_.viewer.eyes_m, room_.axes.up) - *floor_m;
    if (eyes_m >= kLowestEyes_m && eyes_m <= kHighestEyes_m) return;
    warn(room_.viewer.at,
         fmt::format("{} has the eyes {:.0f} mm above the floor, expected {:.0f} to {:.0f} mm{}",
                     room_.viewer.words, mm(eyes_m), mm(kLowestEyes_m), mm(kHighestEyes_m),
                     otherUnits(eyes_m, room_.unit_m, kLowestEyes_m, kHighestEyes_m)));
  }

  /// Walls that lie flat against each other: tiles of one screen, or one screen for each eye.
  void judgePlanes(const RoomWall& a, const RoomWall& b) {
    constexpr double kParallel = 0.9994;  // to 2 degrees; a bent row of screens has more
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
      judgeEyesOfOneWall(a, b, off_m);
    } else if (off_m > kMeet_m) {
      warn(b.at.corner,
           fmt::format("tiles '{}' and '{}' are {:.1f} mm off one plane, expected at most {:.0f} mm",
                       a.wall.name, b.wall.name, mm(off_m), mm(kMeet_m)));
    }
  }

  void judgeEyesOfOneWall(const RoomWall& a, const RoomWall& b, double off_m) {
    const auto cornersA = cornersOf(a.wall), cornersB = cornersOf(b.wall);
    double worst_m = 0.0;
    for (std::size_t i = 0; i < 4; ++i) worst_m = std::max(worst_m, glm::distance(cornersA[i], cornersB[i]));
    const auto isEye = [](StereoMode mode) { return mode == StereoMode::left || mode == StereoMode::right; };
    const bool eyes = isEye(a.wall.stereo) && isEye(b.wall.stereo) && a.wall.stereo != b.wall.stereo;
    if (!eyes) {
      warn(b.at.wall,
           fmt::format("walls '{}' and '{}' are on the same place and show the same eyes; for a projector "
                       "an eye, stereo is left on one and right on the other",
                       a.wall.name, b.wall.name));
    }
    if (worst_m > kMeet_m) {
      warn(b.at.corner,
           fmt::format("{} '{}' and '{}' differ by {:.1f} mm at a corner{}, expected at most {:.0f} mm",
                       eyes ? "the two eyes' walls" : "walls", a.wall.name, b.wall.name, mm(worst_m),
                       off_m > kMeet_m ? fmt::format(" and are {:.1f} mm off one plane", mm(off_m)) : "",
                       mm(kMeet_m)));
    }
  }

  /// Edges that run along each other should meet, and so should their ends.
  void judgeEdges(const RoomWall& a, const RoomWall& b) {
    constexpr double kCorner = 0.985;  // less than 10 degrees between them is no corner of a room
    if (std::abs(glm::dot(normal(a.wall), normal(b.wall))) > kCorner) return;
    const auto cornersA = cornersOf(a.wall), cornersB = cornersOf(b.wall);
    double worst_m = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        worst_m = std::max(
            worst_m, edgeMiss_m(cornersA[i], cornersA[(i + 1) % 4], cornersB[j], cornersB[(j + 1) % 4]));
      }
    }
    if (worst_m <= kMeet_m) return;
    warn(b.at.corner,
         fmt::format("the edges of walls '{}' and '{}' miss each other by {:.1f} mm where they should meet, "
                     "expected at most {:.0f} mm",
                     a.wall.name, b.wall.name, mm(worst_m), mm(kMeet_m)));
  }

  /// How far edge pq is from edge rs where they run along each other no further than kNear_m apart; 0
  /// elsewhere.
  static double edgeMiss_m(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r,
                           const glm::dvec3& s) {
    constexpr double kAlong = 0.9994;  // to 2 degrees
    const double length_m = glm::distance(p, q), other_m = glm::distance(r, s);
    const glm::dvec3 along = (q - p) / length_m;
    if (std::abs(glm::dot(along, s - r)) < kAlong * other_m) return 0.0;
    const double rAt_m = glm::dot(r - p, along), sAt_m = glm::dot(s - p, along);
    const double shared_m =
        std::min(length_m, std::max(rAt_m, sAt_m)) - std::max(0.0, std::min(rAt_m, sAt_m));
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

  void judgeCut(const RoomWall& a, const RoomWall& b) {
    const double depth_m = std::max(cutDepth_m(a.wall, b.wall), cutDepth_m(b.wall, a.wall));
    if (depth_m <= kNear_m) return;
    warn(b.at.wall,
         fmt::format("walls '{}' and '{}' cut through each other, {:.0f} mm inside the edge, expected walls "
                     "that meet at their edges",
                     a.wall.name, b.wall.name, mm(depth_m)));
  }

  /// How far inside wall b an edge of wall a goes through it; 0 where none does.
  static double cutDepth_m(const Wall& a, const Wall& b) {
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

  void judgeWindows(const RoomWall& a, const RoomWall& b) {
    if (room_.oneWindow || a.wall.node != b.wall.node || a.wall.window.monitor != b.wall.window.monitor)
      return;
    const WindowPlacement &p = a.wall.window, &q = b.wall.window;
    if (a.wall.viewport && b.wall.viewport && p == q) return;  // the same window
    const glm::ivec2 shared = glm::min(p.position_px + p.size_px, q.position_px + q.size_px) -
                              glm::max(p.position_px, q.position_px);
    if (shared.x <= 0 || shared.y <= 0) return;
    warn(b.at.window,
         fmt::format("the windows of walls '{}' and '{}' overlap by {} × {} pixels on monitor {} of rank {}, "
                     "expected them apart",
                     a.wall.name, b.wall.name, shared.x, shared.y, p.monitor, a.wall.node));
  }

  /// A job is started with as many ranks as there are nodes: each should have something to draw.
  void judgeRanks() {
    std::set<int> drawing;
    for (const RoomWall& wall : room_.walls) drawing.insert(wall.wall.node);
    for (std::size_t i = 0; i < room_.nodes.size(); ++i) {
      if (drawing.contains(room_.nodes[i].rank)) continue;
      warn(room_.nodesAt[i], fmt::format("rank {} has display {} but no wall to draw on it",
                                         room_.nodes[i].rank, room_.nodes[i].display));
    }
    for (const RoomWall& wall : room_.walls) {
      const int below = wall.wall.node - 1;
      if (below < 0 || drawing.contains(below)) continue;
      warn(wall.at.node,
           fmt::format("wall '{}' is drawn by rank {}, but rank {} has no wall: expected ranks from 0 on "
                       "without gaps",
                       wall.wall.name, wall.wall.node, below));
      drawing.insert(below);
    }
  }

  const Room& room_;
  std::vector<Finding> findings_;
};

}  // namespace

std::optional<double> floorHeight_m(const Room& room) {
  constexpr double kLevel = 0.985;  // to 10 degrees
  std::optional<double> lowest_m;
  for (const RoomWall& wall : room.walls) {
    if (glm::dot(normal(wall.wall), room.axes.up) < kLevel) continue;
    const double height = glm::dot(middle(wall.wall), room.axes.up);
    if (!lowest_m || height < *lowest_m) lowest_m = height;
  }
  return lowest_m ? lowest_m : room.floor_m;
}

std::vector<Finding> judgeRoom(const Room& room) { return Judge(room).judge(); }

std::string_view sideOf(const Wall& wall, const RoomAxes& axes) { return lookedAt(wall, axes).name; }

std::string wordsFor(const RoomWall& wall, const Room& room) {
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
  const double before_m = glm::dot(normal(wall.wall), room.viewer.eyes_m - wall.wall.lowerLeft_m);
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
      "  {:.0f} × {:.0f} mm, {} × {} pixels an eye, {}, drawn by rank {}",
      wall.wall.name, width, height, feet, density, place, mm(width), mm(height), wall.wall.pixels.x,
      wall.wall.pixels.y, kStereo[static_cast<std::size_t>(wall.wall.stereo)], wall.wall.node);
}

}  // namespace carom
