#include "cave/patterns/screen_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/patterns/pattern_canvas.h"
#include "cave/room/off_axis.h"
#include "cave/room/wall_eyes.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

using Colour = PatternCanvas::Colour;
constexpr Colour kLine{110, 110, 110}, kRim{255, 255, 255}, kCircle{255, 220, 0};
constexpr int kMarksAcross = 10;
constexpr double kCircle_px = 9.0;
constexpr double kDegree = std::numbers::pi / 180.0;

/// How many lines a point of the screen is from the first one, of each family of lines.
struct InLines {
  const CylinderScreen* cylinder = nullptr;
  const DomeScreen* dome = nullptr;
  const Sky* sky = nullptr;

  glm::dvec3 operator()(const glm::dvec3& place_m) const {
    constexpr double kLine_m = 0.1, kPlane_m = 0.5, kLine_rad = 10.0 * kDegree;
    if (cylinder) {
      const glm::dvec3 from_m = place_m - cylinder->foot_m,
                       right = glm::cross(cylinder->ahead, cylinder->axis);
      const double angle_rad = std::atan2(glm::dot(from_m, right), glm::dot(from_m, cylinder->ahead));
      return {angle_rad * cylinder->radius_m / kLine_m, glm::dot(from_m, cylinder->axis) / kLine_m, 0.5};
    }
    if (dome) return inMeridians(place_m - dome->centre_m, dome->axis, dome->front, kLine_rad);
    if (sky) return inMeridians(place_m - sky->middle_m, sky->axis, sky->front, kLine_rad);
    return place_m / kPlane_m;
  }

 private:
  static glm::dvec3 inMeridians(const glm::dvec3& from_m, const glm::dvec3& axis, const glm::dvec3& front,
                                double line_rad) {
    const double up = glm::dot(from_m, axis) / glm::length(from_m);
    return {std::atan2(glm::dot(from_m, glm::cross(front, axis)), glm::dot(from_m, front)) / line_rad,
            std::acos(std::clamp(up, -1.0, 1.0)) / line_rad, 0.5};
  }
};

InLines linesOf(const CurvedScreen& screen) {
  return {std::get_if<CylinderScreen>(&screen.shape), std::get_if<DomeScreen>(&screen.shape),
          std::get_if<Sky>(&screen.shape)};
}

/// The number of lines at each pixel's centre; NaN where the window shows no screen.
class LineMap {
 public:
  LineMap(const CurvedScreen& screen, const glm::ivec2& size_px)
      : size_px_(size_px),
        at_(static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y), glm::vec3(NAN)) {
    const InLines lines = linesOf(screen);
    for (const ScreenTriangle& triangle : screen.mesh) add(triangle, lines);
  }

  bool isScreen(int x, int y) const { return !std::isnan(of(x, y).x); }
  bool isRim(int x, int y) const {
    return isScreen(x, y) &&
           !(isScreen(x - 1, y) && isScreen(x + 1, y) && isScreen(x, y - 1) && isScreen(x, y + 1));
  }
  /// Returns whether a line passes between this pixel and the one to its left or below it.
  bool isLine(int x, int y) const {
    if (!isScreen(x, y)) return false;
    for (const glm::ivec2& other : {glm::ivec2(x - 1, y), glm::ivec2(x, y - 1)}) {
      if (!isScreen(other.x, other.y)) continue;
      const glm::vec3 here = glm::floor(of(x, y)), there = glm::floor(of(other.x, other.y));
      for (int axis = 0; axis < 3; ++axis) {
        const float apart = std::abs(here[axis] - there[axis]);
        if (apart > 0.0F && apart < 4.0F) return true;  // farther: an angle begins anew
      }
    }
    return false;
  }

 private:
  glm::vec3 of(int x, int y) const {
    if (x < 0 || y < 0 || x >= size_px_.x || y >= size_px_.y) return glm::vec3(NAN);
    return at_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_px_.x) +
               static_cast<std::size_t>(x)];
  }

  void add(const ScreenTriangle& t, const InLines& lines) {
    const double area = windowArea(t);
    const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
    const glm::dvec2 size(size_px_);
    const glm::dvec2 low = glm::min(glm::min(t[0].inWindow, t[1].inWindow), t[2].inWindow) * size,
                     high = glm::max(glm::max(t[0].inWindow, t[1].inWindow), t[2].inWindow) * size;
    for (int y = std::max(0, static_cast<int>(low.y));
         y <= std::min(size_px_.y - 1, static_cast<int>(high.y)); ++y) {
      for (int x = std::max(0, static_cast<int>(low.x));
           x <= std::min(size_px_.x - 1, static_cast<int>(high.x)); ++x) {
        const glm::dvec2 from = glm::dvec2(x + 0.5, y + 0.5) / size - t[0].inWindow;
        const double b = cross(from, t[2].inWindow - t[0].inWindow) / area;
        const double c = cross(t[1].inWindow - t[0].inWindow, from) / area;
        if (!(b >= 0.0 && c >= 0.0 && b + c <= 1.0)) continue;
        at_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_px_.x) +
            static_cast<std::size_t>(x)] =
            lines((1.0 - b - c) * t[0].inRoom_m + b * t[1].inRoom_m + c * t[2].inRoom_m);
      }
    }
  }

  glm::ivec2 size_px_;
  std::vector<glm::vec3> at_;
};

void drawLines(PatternCanvas& canvas, const LineMap& map) {
  for (int y = 0; y < canvas.size_px().y; ++y) {
    for (int x = 0; x < canvas.size_px().x; ++x) {
      if (map.isRim(x, y)) {
        canvas.dot(x, y, kRim);
      } else if (map.isLine(x, y)) {
        canvas.dot(x, y, kLine);
      }
    }
  }
}

void drawCircles(PatternCanvas& canvas, const std::vector<ScreenPoint>& marked) {
  const int reach = static_cast<int>(kCircle_px) + 2;
  for (const ScreenPoint& point : marked) {
    const glm::dvec2 middle = point.inWindow * glm::dvec2(canvas.size_px());
    for (int y = static_cast<int>(middle.y) - reach; y <= middle.y + reach; ++y) {
      for (int x = static_cast<int>(middle.x) - reach; x <= middle.x + reach; ++x) {
        const double off_px = std::abs(glm::distance(glm::dvec2(x + 0.5, y + 0.5), middle) - kCircle_px);
        if (off_px < 0.7) canvas.fill({x, y}, {x + 1, y + 1}, kCircle);
      }
    }
  }
}

/// Writes the room's coordinates of the screen's points nearest to the corners of the window.
void writeRim(PatternCanvas& canvas, const CurvedScreen& screen, double unit_px) {
  for (const glm::dvec2& corner : {glm::dvec2(0.02, 0.035), {0.98, 0.035}, {0.02, 0.965}, {0.98, 0.965}}) {
    std::optional<glm::dvec3> at_m;
    glm::dvec2 place = corner;
    for (double share = 0.0; share < 1.0 && !at_m; share += 0.02) {
      place = glm::mix(corner, glm::dvec2(0.5), share);
      at_m = inRoom_m(screen.mesh, place);
    }
    if (at_m) canvas.write(cornerWords(*at_m), 0.03 * unit_px, place, corner.x < 0.5 ? 0.0 : 1.0, 0.33);
  }
}

}  // namespace

std::vector<ScreenPoint> markedPoints(const CurvedScreen& screen) {
  std::vector<ScreenPoint> marked;
  for (int y = 0; y < kMarksAcross; ++y) {
    for (int x = 0; x < kMarksAcross; ++x) {
      const glm::dvec2 place((x + 0.5) / kMarksAcross, (y + 0.5) / kMarksAcross);
      if (const auto at_m = inRoom_m(screen.mesh, place)) marked.push_back({place, *at_m});
    }
  }
  return marked;
}

Image crossesOn(const FlatPiece& piece, const std::vector<ScreenPoint>& marked,
                const glm::dvec3& eyeInRoom_m) {
  constexpr int kArm_px = 6;
  PatternCanvas canvas(piece.wall.pixels);
  const std::optional<glm::dmat4> clip = clipFromRoom(piece.wall, eyeInRoom_m);
  for (const ScreenPoint& point : marked) {
    if (!clip) break;
    const glm::dvec4 at = *clip * glm::dvec4(point.inRoom_m, 1.0);
    if (!(at.w > 0.0)) continue;
    const glm::ivec2 px = glm::floor((glm::dvec2(at) / at.w * 0.5 + 0.5) * glm::dvec2(piece.wall.pixels));
    canvas.fill(px - glm::ivec2(kArm_px, 0), px + glm::ivec2(kArm_px + 1, 1), PatternCanvas::kWhite);
    canvas.fill(px - glm::ivec2(0, kArm_px), px + glm::ivec2(1, kArm_px + 1), PatternCanvas::kWhite);
  }
  return canvas.take();
}

Image screenPattern(const Wall& wall, Eye eye, Image crosses) {
  PatternCanvas canvas(std::move(crosses));
  drawLines(canvas, LineMap(*wall.screen, wall.pixels));
  drawCircles(canvas, markedPoints(*wall.screen));
  canvas.eyeBar(eye);
  const double unit_px = std::min(wall.pixels.x, wall.pixels.y);
  canvas.write(wall.name, 0.08 * unit_px, {0.5, 0.7}, 0.5);
  canvas.write(nameOf(eye), 0.12 * unit_px, {0.5, 0.57}, 0.5);
  canvas.write(texts::format(texts::pattern::kWall, wall.node, wall.pixels.x, wall.pixels.y), 0.04 * unit_px,
               {0.5, 0.4}, 0.5);
  if (!wall.sky) writeRim(canvas, *wall.screen, unit_px);  // its directions are no places
  return canvas.take();
}

}  // namespace carom
