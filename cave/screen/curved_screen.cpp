#include "cave/screen/curved_screen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace carom {
namespace {

/// A place in the room to a hundredth of a millimetre: points of triangles that share a corner share it.
std::array<std::int64_t, 3> cornerOf(const glm::dvec3& place_m) {
  constexpr double kSame_m = 1e-5;
  return {std::llround(place_m.x / kSame_m), std::llround(place_m.y / kSame_m),
          std::llround(place_m.z / kSame_m)};
}

glm::dvec3 areaOf_m2(const ScreenTriangle& t) {
  return 0.5 * glm::cross(t[1].inRoom_m - t[0].inRoom_m, t[2].inRoom_m - t[0].inRoom_m);
}

/// Returns the tangent of the largest angle between the screen's normal and the way to an eye before it.
double mostTangent(const glm::dvec3& at_m, const glm::dvec3& normal, std::span<const glm::dvec3> eyes_m) {
  double most = 0.0;
  for (const glm::dvec3& eye_m : eyes_m) {
    const glm::dvec3 way = eye_m - at_m;
    const double along = std::abs(glm::dot(way, normal));
    most = std::max(most, glm::length(glm::cross(way, normal)) / along);
  }
  return most;
}

}  // namespace

std::vector<glm::dvec3> eyesAround(const glm::dvec3& middle_m, const glm::dvec3& up, double reach_m) {
  constexpr int kAround = 8;
  constexpr std::array kHeights{-0.5, 0.0, 0.3};  // of the reach
  const glm::dvec3 aside =
      glm::normalize(glm::cross(up, std::abs(up.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 ahead = glm::cross(aside, up);
  std::vector<glm::dvec3> eyes{middle_m};
  for (const double height : kHeights) {
    for (int i = 0; i < kAround; ++i) {
      const double angle_rad = 2.0 * std::numbers::pi * i / kAround;
      eyes.push_back(middle_m +
                     reach_m * (height * up + std::cos(angle_rad) * ahead + std::sin(angle_rad) * aside));
    }
  }
  return eyes;
}

double slideOf_px(const ScreenMesh& mesh, const glm::ivec2& window_px, std::span<const glm::dvec3> eyes_m) {
  std::map<std::array<std::int64_t, 3>, glm::dvec3> normals;
  for (const ScreenTriangle& t : mesh) {
    const glm::dvec3 area = (windowArea(t) < 0.0 ? -1.0 : 1.0) * areaOf_m2(t);
    for (const ScreenPoint& point : t) normals[cornerOf(point.inRoom_m)] += area;
  }
  for (auto& [corner, normal] : normals) normal = glm::normalize(normal);
  double most_px = 0.0;
  for (const ScreenTriangle& t : mesh) {
    const double area_m2 = glm::length(areaOf_m2(t));
    const double area_px2 = 0.5 * std::abs(windowArea(t)) * window_px.x * window_px.y;
    if (!(area_m2 > 0.0)) continue;
    double sagitta_m = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const ScreenPoint &a = t[i], &b = t[(i + 1) % 3];
      const glm::dvec3 &normalA = normals[cornerOf(a.inRoom_m)], &normalB = normals[cornerOf(b.inRoom_m)];
      sagitta_m = std::max(sagitta_m, std::abs(glm::dot(b.inRoom_m - a.inRoom_m, normalB - normalA)) / 8.0);
    }
    const glm::dvec3 middle_m = (t[0].inRoom_m + t[1].inRoom_m + t[2].inRoom_m) / 3.0;
    const double tangent = mostTangent(middle_m, glm::normalize(areaOf_m2(t)), eyes_m);
    most_px = std::max(most_px, sagitta_m * tangent * std::sqrt(area_px2 / area_m2));
  }
  return most_px;
}

CurvedScreen curvedScreen(ScreenMesh mesh, const PieceWishes& wishes) {
  CurvedScreen screen;
  screen.mesh = std::move(mesh);
  screen.window_px = wishes.window_px;
  screen.pieces = flatPieces(screen.mesh, wishes);
  for (const glm::dvec3& eye_m : wishes.eyes_m)
    screen.eyesMiddle_m += eye_m / static_cast<double>(wishes.eyes_m.size());
  screen.slide_px = slideOf_px(screen.mesh, wishes.window_px, wishes.eyes_m);
  screen.leftPieces = static_cast<std::size_t>(
      std::count_if(screen.pieces.begin(), screen.pieces.end(), [](const FlatPiece& piece) {
        const ScreenTriangle& any = piece.mesh.front();
        return any[0].inWindow.x + any[1].inWindow.x + any[2].inWindow.x < 1.5;  // none lies on both halves
      }));
  return screen;
}

std::vector<Wall> flatWallsOf(const Wall& wall) {
  if (!wall.screen) return {wall};
  std::vector<Wall> walls;
  const glm::dvec2 scale = glm::dvec2(wall.pixels) / glm::dvec2(wall.screen->window_px);
  for (const FlatPiece& piece : wall.screen->pieces) {
    Wall& flat = walls.emplace_back(wall);
    flat.screen.reset();
    flat.lowerLeft_m = piece.wall.lowerLeft_m;
    flat.lowerRight_m = piece.wall.lowerRight_m;
    flat.upperLeft_m = piece.wall.upperLeft_m;
    flat.pixels = glm::max(glm::ivec2(glm::round(glm::dvec2(piece.wall.pixels) * scale)), 1);
    flat.piece = static_cast<int>(walls.size());
    flat.heldFrames = 0;
  }
  return walls;
}

}  // namespace carom
