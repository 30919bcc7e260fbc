#include "cave/screen/sky_screen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/screen/screen_shape.h"

namespace carom {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSquares = 6;  // of a cubemap

DomeScreen domeOf(const Sky& sky) { return {sky.middle_m, kSky_m, sky.fov_rad, sky.axis, sky.front}; }

/// A square of a cubemap: what is in its middle, at its right edge and at its upper edge.
struct Square {
  glm::dvec3 middle, right, up;
};

Square squareOf(const Sky& sky, int square) {
  const glm::dvec3 &up = sky.axis, &front = sky.front, right = glm::cross(front, up);
  const std::array<Square, kSquares> squares{{{right, -front, up},
                                              {-right, front, up},
                                              {up, right, -front},
                                              {-up, right, front},
                                              {-front, -right, up},
                                              {front, right, up}}};
  return squares.at(static_cast<std::size_t>(square));
}

/// Returns a place on a square, from its own lower left (0, 0) to its upper right (1, 1): not of length 1.
glm::dvec3 onSquare(const Square& square, const glm::dvec2& place) {
  return square.middle + (2.0 * place.x - 1.0) * square.right + (2.0 * place.y - 1.0) * square.up;
}

/// Returns the mesh of a cubemap. Its squares are flat, so two triangles of each are exact.
ScreenMesh cubeMesh(const Sky& sky) {
  ScreenMesh mesh;
  for (int i = 0; i < kSquares; ++i) {
    const Square square = squareOf(sky, i);
    const auto point = [&](double x, double y) {
      return ScreenPoint{{(i + x) / kSquares, y}, sky.middle_m + kSky_m * onSquare(square, {x, y})};
    };
    mesh.push_back({point(0, 0), point(1, 0), point(1, 1)});
    mesh.push_back({point(0, 0), point(1, 1), point(0, 1)});
  }
  return mesh;
}

// In a cell of Δ longitudes and as many latitudes the places are bilinear but for the chords' sagitta, Δ²/16
// at most aside from a parallel, and for the twist of a quadrilateral near a pole, which its two triangles
// leave out: Δ²/4. A pixel is 2π/width.
ScreenMesh equirectangularMesh(const Sky& sky, const glm::ivec2& picture_px) {
  const double cell_rad = std::sqrt(4.0 * kMostOff_px * 2.0 * kPi / picture_px.x);
  const int columns = static_cast<int>(std::ceil(2.0 * kPi / cell_rad)), rows = (columns + 1) / 2;
  ScreenMesh mesh;
  const auto point = [&](int column, int row) {
    const glm::dvec2 inPicture(static_cast<double>(column) / columns, static_cast<double>(row) / rows);
    return ScreenPoint{inPicture, sky.middle_m + kSky_m * directionOf(sky, inPicture, picture_px)};
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      mesh.push_back({point(column, row), point(column + 1, row), point(column + 1, row + 1)});
      mesh.push_back({point(column, row), point(column + 1, row + 1), point(column, row + 1)});
    }
  }
  return mesh;
}

ScreenMesh meshOf(const Sky& sky, const glm::ivec2& picture_px) {
  switch (sky.kind) {
    case SkyKind::fisheye:
      return meshOf(domeOf(sky), picture_px);
    case SkyKind::equirectangular:
      return equirectangularMesh(sky, picture_px);
    case SkyKind::cubemap:
      break;
  }
  return cubeMesh(sky);
}

}  // namespace

glm::dvec3 directionOf(const Sky& sky, const glm::dvec2& inPicture, const glm::ivec2& picture_px) {
  if (sky.kind == SkyKind::fisheye)
    return (placeOn_m(domeOf(sky), inPicture, picture_px) - sky.middle_m) / kSky_m;
  if (sky.kind == SkyKind::equirectangular) {
    const double longitude = kPi * (2.0 * inPicture.x - 1.0), latitude = kPi * (inPicture.y - 0.5);
    const glm::dvec3 right = glm::cross(sky.front, sky.axis);
    return std::sin(latitude) * sky.axis +
           std::cos(latitude) * (std::cos(longitude) * sky.front + std::sin(longitude) * right);
  }
  const int square = std::clamp(static_cast<int>(inPicture.x * kSquares), 0, kSquares - 1);
  return glm::normalize(onSquare(squareOf(sky, square), {inPicture.x * kSquares - square, inPicture.y}));
}

CurvedScreen screenOf(const Sky& sky, const glm::ivec2& picture_px, double texelsPerPixel) {
  // Seen from the middle each flat piece is exact, so only its texels, sparse in its middle and dense at its
  // rim, limit how deep it may be.
  constexpr double kDepth = 0.15;
  const std::array eyes_m{sky.middle_m};
  PieceWishes wishes{picture_px, texelsPerPixel, kDepth * kSky_m, eyes_m};
  wishes.most = 1.15;  // a flat piece is sparser in its middle than on the whole; near a pole it needs less
  if (sky.kind == SkyKind::cubemap) wishes.strips = kSquares;
  CurvedScreen screen = curvedScreen(meshOf(sky, picture_px), wishes);
  screen.shape = sky;
  return screen;
}

}  // namespace carom
