#pragma once
// A wall of the room that is not flat: where each place of its window is in the room, and the flat walls on
// which it is drawn.

#include <variant>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/screen/flat_pieces.h"
#include "cave/screen/measured_screen.h"
#include "cave/screen/screen_mesh.h"
#include "cave/screen/screen_shape.h"
#include "cave/screen/sky.h"

namespace carom {

struct CurvedScreen {
  /// Its formula, or the file that it has been read from, if it has one.
  std::variant<std::monostate, CylinderScreen, DomeScreen, Sky, MeasuredScreen> shape;
  ScreenMesh mesh;                ///< all of it
  std::vector<FlatPiece> pieces;  ///< those on the window's left half come first
  std::size_t leftPieces = 0;     ///< how many lie on the left half
  glm::ivec2 window_px{0};        ///< for which the pieces have their pixels
  glm::dvec3 eyesMiddle_m{0.0};   ///< of the eyes for which the pieces are made
  double slide_px = 0.0;  ///< how far, as predicted, a picture is off its place between the mesh's points
};

/// Returns places where the eyes of somebody may be who stands within `reach_m` of a place between the eyes.
std::vector<glm::dvec3> eyesAround(const glm::dvec3& middle_m, const glm::dvec3& up, double reach_m);

/// Returns the largest distance in pixels of the window by which a picture is off its place on the screen
/// between the points of the mesh, since a screen is curved there and its triangles are flat: the sagitta of
/// an edge e, on which the screen's normal n turns, is |e · Δn|/8; an eye that looks aslant sees it as so
/// much aside, times the tangent of its angle from the normal.
double slideOf_px(const ScreenMesh& mesh, const glm::ivec2& window_px, std::span<const glm::dvec3> eyes_m);

/// Returns the screen with its pieces; `wishes.eyes_m` as in flatPieces. Without pieces, the screen cannot be
/// drawn on so few flat walls.
CurvedScreen curvedScreen(ScreenMesh mesh, const PieceWishes& wishes);

/// Returns the flat walls of a wall with a curved screen, each as a wall of its node and viewer with its
/// name, and with as many pixels as the wall's own ask for; those of a flat wall are the wall itself.
std::vector<Wall> flatWallsOf(const Wall& wall);

}  // namespace carom
