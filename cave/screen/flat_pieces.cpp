#include "cave/screen/flat_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>

namespace carom {
namespace {

constexpr double kNear_m = 0.05;  // an eye nearer to a piece's plane sees nothing on it
constexpr int kMargin_px = 2;     // around what is seen, for the filter between texels

/// A plane before which the eyes are: points with normal · r = at_m.
struct Plane {
  glm::dvec3 normal{0.0};
  double at_m = 0.0, stands_m = 0.0;
};

/// Returns the plane at a right angle to the screen's mean normal that halves how far the screen stands off.
Plane planeOf(const ScreenMesh& mesh, std::span<const glm::dvec3> eyes_m) {
  glm::dvec3 area(0.0), middle_m(0.0), eye_m(0.0);
  for (const ScreenTriangle& t : mesh) {
    const double side = windowArea(t) < 0.0 ? -1.0 : 1.0;
    area += side * glm::cross(t[1].inRoom_m - t[0].inRoom_m, t[2].inRoom_m - t[0].inRoom_m);
    middle_m += (t[0].inRoom_m + t[1].inRoom_m + t[2].inRoom_m) / 3.0;
  }
  for (const glm::dvec3& eye : eyes_m) eye_m += eye;
  Plane plane{glm::normalize(area), 0.0, 0.0};
  const glm::dvec3 toEyes_m =
      eye_m / static_cast<double>(eyes_m.size()) - middle_m / static_cast<double>(mesh.size());
  if (glm::dot(plane.normal, toEyes_m) < 0.0) plane.normal = -plane.normal;
  double least_m = std::numeric_limits<double>::infinity(), most_m = -least_m;
  for (const ScreenTriangle& t : mesh) {
    for (const ScreenPoint& point : t) {
      least_m = std::min(least_m, glm::dot(plane.normal, point.inRoom_m));
      most_m = std::max(most_m, glm::dot(plane.normal, point.inRoom_m));
    }
  }
  plane.at_m = 0.5 * (least_m + most_m);
  plane.stands_m = 0.5 * (most_m - least_m);
  return plane;
}

/// Returns how much the mesh covers of the window along an axis.
glm::dvec2 extentOf(const ScreenMesh& mesh, int axis) {
  glm::dvec2 extent(1.0, 0.0);
  for (const ScreenTriangle& t : mesh) {
    for (const ScreenPoint& point : t) {
      extent.x = std::min(extent.x, point.inWindow[axis]);
      extent.y = std::max(extent.y, point.inWindow[axis]);
    }
  }
  return extent;
}

/// The halves of a mesh on both sides of a line of the window.
std::array<ScreenMesh, 2> halves(const ScreenMesh& mesh, int axis) {
  const glm::dvec2 extent = extentOf(mesh, axis);
  const double middle = 0.5 * (extent.x + extent.y);
  return {cutAt(mesh, axis, middle, false), cutAt(mesh, axis, middle, true)};
}

double stands_m(const std::array<ScreenMesh, 2>& parts, std::span<const glm::dvec3> eyes_m) {
  double most_m = 0.0;
  for (const ScreenMesh& part : parts)
    if (!part.empty()) most_m = std::max(most_m, planeOf(part, eyes_m).stands_m);
  return most_m;
}

/// Returns the mesh in two, cut along that axis of the window which leaves the flatter parts.
std::array<ScreenMesh, 2> flatterHalves(const ScreenMesh& mesh, std::span<const glm::dvec3> eyes_m) {
  std::array<ScreenMesh, 2> across = halves(mesh, 0), upwards = halves(mesh, 1);
  return stands_m(across, eyes_m) <= stands_m(upwards, eyes_m) ? std::move(across) : std::move(upwards);
}

/// Axes in a piece's plane: along the window's rows, and upwards.
struct PlaneAxes {
  glm::dvec3 right{0.0}, up{0.0};
};

PlaneAxes axesIn(const Plane& plane, const ScreenMesh& mesh) {
  glm::dvec3 along(0.0);
  for (const ScreenTriangle& t :
       mesh) {  // the room's change along a row of the window, times the triangle's area
    const glm::dvec2 b = t[1].inWindow - t[0].inWindow, c = t[2].inWindow - t[0].inWindow;
    const double side = windowArea(t) < 0.0 ? -1.0 : 1.0;
    along += side * (c.y * (t[1].inRoom_m - t[0].inRoom_m) - b.y * (t[2].inRoom_m - t[0].inRoom_m));
  }
  along -= glm::dot(along, plane.normal) * plane.normal;
  const glm::dvec3 right = glm::normalize(along);
  return {right, glm::cross(plane.normal, right)};
}

/// A rectangle in a piece's plane, and the distance there of two lines of pixels of the window, across and
/// upwards, where they are closest.
struct Needed {
  glm::dvec2 least_m{std::numeric_limits<double>::infinity()},
      most_m{-std::numeric_limits<double>::infinity()};
  glm::dvec2 pixel_m{std::numeric_limits<double>::infinity()};
};

/// Adds what one eye needs of the plane for a triangle of the screen.
void need(const ScreenTriangle& triangle, const std::array<glm::dvec2, 3>& crossed_m,
          const glm::dvec2& window_px, Needed& needed) {
  for (const glm::dvec2& at_m : crossed_m) {
    needed.least_m = glm::min(needed.least_m, at_m);
    needed.most_m = glm::max(needed.most_m, at_m);
  }
  const glm::dmat2 pixels((triangle[1].inWindow - triangle[0].inWindow) * window_px,
                          (triangle[2].inWindow - triangle[0].inWindow) * window_px);
  const glm::dmat2 metres(crossed_m[1] - crossed_m[0], crossed_m[2] - crossed_m[0]);
  constexpr double kNoCell_px2 = 1e-3;
  if (std::abs(glm::determinant(pixels)) < kNoCell_px2) return;
  const glm::dmat2 aPixel_m = metres * glm::inverse(pixels);
  const double area_m2 = std::abs(glm::determinant(aPixel_m));
  const glm::dvec2 apart_m(area_m2 / glm::length(aPixel_m[1]), area_m2 / glm::length(aPixel_m[0]));
  // Rows of pixels that lie aslant in the piece take the closer distance both ways.
  constexpr double kAslant = 0.2;
  const bool aslant = std::abs(aPixel_m[0].y) > kAslant * glm::length(aPixel_m[0]) ||
                      std::abs(aPixel_m[1].x) > kAslant * glm::length(aPixel_m[1]);
  needed.pixel_m = glm::min(needed.pixel_m, aslant ? glm::dvec2(std::min(apart_m.x, apart_m.y)) : apart_m);
}

Needed neededOf(const ScreenMesh& mesh, const Plane& plane, const PlaneAxes& axes,
                const PieceWishes& wishes) {
  Needed needed;
  for (const glm::dvec3& eye_m : wishes.eyes_m) {
    const double before_m = glm::dot(plane.normal, eye_m) - plane.at_m;
    if (before_m < kNear_m) continue;
    for (const ScreenTriangle& triangle : mesh) {
      std::array<glm::dvec2, 3> crossed_m{};
      bool sees = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 line_m = triangle[i].inRoom_m - eye_m;
        const double sinks_m = -glm::dot(plane.normal, line_m);
        sees = sees && sinks_m > kNear_m;
        const glm::dvec3 at_m = eye_m + before_m / sinks_m * line_m;
        crossed_m[i] = {glm::dot(axes.right, at_m), glm::dot(axes.up, at_m)};
      }
      if (sees) need(triangle, crossed_m, wishes.window_px, needed);
    }
  }
  return needed;
}

/// Returns the piece of a part of the screen, or none if no eye sees it.
std::optional<FlatPiece> pieceOf(ScreenMesh mesh, const PieceWishes& wishes) {
  const Plane plane = planeOf(mesh, wishes.eyes_m);
  const PlaneAxes axes = axesIn(plane, mesh);
  Needed needed = neededOf(mesh, plane, axes, wishes);
  if (!(needed.least_m.x < needed.most_m.x && needed.least_m.y < needed.most_m.y)) return std::nullopt;
  const glm::dvec2 window(extentOf(mesh, 0).y - extentOf(mesh, 0).x,
                          extentOf(mesh, 1).y - extentOf(mesh, 1).x);
  const glm::dvec2 size_m = needed.most_m - needed.least_m;
  const glm::dvec2 shown_px = window * glm::dvec2(wishes.window_px);
  const glm::dvec2 texels = glm::min(wishes.texelsPerPixel * size_m / needed.pixel_m,
                                     wishes.most * wishes.texelsPerPixel * shown_px);
  const glm::dvec2 texel_m = size_m / glm::max(glm::ceil(texels), 1.0);
  FlatPiece piece{std::move(mesh), {}, plane.stands_m};
  const glm::dvec2 from_m = needed.least_m - static_cast<double>(kMargin_px) * texel_m,
                   to_m = needed.most_m + static_cast<double>(kMargin_px) * texel_m;
  const auto at_m = [&](double right_m, double up_m) {
    return right_m * axes.right + up_m * axes.up + plane.at_m * plane.normal;
  };
  piece.wall.lowerLeft_m = at_m(from_m.x, from_m.y);
  piece.wall.lowerRight_m = at_m(to_m.x, from_m.y);
  piece.wall.upperLeft_m = at_m(from_m.x, to_m.y);
  piece.wall.pixels = glm::ivec2(glm::max(glm::ceil(texels), 1.0)) + 2 * kMargin_px;
  return piece;
}

}  // namespace

std::vector<FlatPiece> flatPieces(const ScreenMesh& screen, const PieceWishes& wishes) {
  std::vector<FlatPiece> pieces;
  std::vector<ScreenMesh> parts;
  // The rightmost strip first: parts are taken from the end.
  for (int strip = wishes.strips; strip-- > 0;) {
    const double left = static_cast<double>(strip) / wishes.strips,
                 right = static_cast<double>(strip + 1) / wishes.strips;
    parts.push_back(cutAt(cutAt(screen, 0, left, true), 0, right, false));
  }
  while (!parts.empty()) {
    ScreenMesh part = std::move(parts.back());
    parts.pop_back();
    if (part.empty()) continue;
    if (2.0 * planeOf(part, wishes.eyes_m).stands_m > wishes.sagitta_m) {
      if (pieces.size() + parts.size() + 2 > kMostPieces) return {};
      std::array<ScreenMesh, 2> half = flatterHalves(part, wishes.eyes_m);
      parts.push_back(std::move(half[1]));
      parts.push_back(std::move(half[0]));
      continue;
    }
    if (auto piece = pieceOf(std::move(part), wishes)) pieces.push_back(std::move(*piece));
  }
  return pieces;
}

}  // namespace carom
