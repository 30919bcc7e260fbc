#pragma once
// The flat walls on which a curved screen is drawn. The eye sees a point P of the screen along the line from
// the eye to P, and that line crosses a flat wall before or behind P at one place: what the eye sees there, a
// wall's picture for this eye holds exactly. So each part of the screen has a wall of its own, fixed in the
// room, that nearly touches it, and each pixel of the window takes its colour where its line crosses that
// wall (cave/projection/screen_picture.h).

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/room/wall.h"
#include "cave/screen/screen_mesh.h"

namespace carom {

/// A part of the screen, and the flat wall on which it is drawn.
struct FlatPiece {
  ScreenMesh mesh;
  Wall wall;              ///< its corners and its pixels; nothing else of it is set
  double stands_m = 0.0;  ///< how far the screen stands off the wall, at most, on both of its sides
};

struct PieceWishes {
  glm::ivec2 window_px{0};
  double texelsPerPixel = 1.25;  ///< of the wall's picture a pixel of the window, at least, each way
  double sagitta_m = 0.1;        ///< how deep a piece of the screen may be; its wall halves this depth
  /// Where eyes may be: each sees its part of the screen within the piece, and with the texels that are
  /// wished for.
  std::span<const glm::dvec3> eyes_m;
  /// A piece has so many times the texels of its part of the window, each way, at most: for an eye that looks
  /// along the screen, and where the window stretches what it shows.
  double most = 3.0;
  /// The window is first cut into so many columns of one width, an even number, so that none lies on both of
  /// its halves.
  int strips = 2;
};

/// Parts of one screen, at most.
inline constexpr std::size_t kMostPieces = 64;

/// Returns the pieces of a screen. Each strip of the window is halved until each part keeps to the sagitta.
/// Returns none if that takes more than kMostPieces.
/// Each wall reaches as far as the lines from all eyes, and two texels farther. A piece on or behind whose
/// wall an eye lies is made for the other eyes.
std::vector<FlatPiece> flatPieces(const ScreenMesh& screen, const PieceWishes& wishes);

}  // namespace carom
