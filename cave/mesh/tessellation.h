#pragma once
// How finely meshes must be divided so that their edges, which are drawn straight between vertices, follow
// the curves that slow light makes of them.
//
// In the rest frame of an edge the eye's past cone shows it straight, in the plane through the edge and the
// eye, with unit normal N. Light arriving along the null vector k satisfies k·(0, N) = 0; seen from a head
// that moves through that frame with u = γβ the same vector is (u·N, N'), |N'|² = 1 + (u·N)². The seen edge
// is thus part of a circle on the head's sky (Penrose 1959, "The apparent shape of a relativistically moving
// sphere"), of geodesic curvature cot ψ = u·N, while the drawing between two vertices is the great circle's
// arc. Seen lengths are 1/D times those of the rest frame (D: Doppler factor), most behind the head, where
// 1/D → e^η.
//
// The worst edge of a length lies across the direction straight behind the head, its middle nearest to the
// eye. With a = atan(length/(2 distance)), half its angle at the eye in its rest frame, and χ the angle of
// its middle from straight behind:
//   ends:          cos χe = cos χ cos a, at ±ω of azimuth, tan ω = tan a/sin χ  (right-angled triangle)
//   seen:          tan(χ'/2) = e^η tan(χ/2), middle and ends                    (aberration; azimuths stay)
//   drawn middle:  tan χ'd = tan χ'e cos ω, off by χ' − χ'd
// For short edges this is β γ sin χ/D² · a²/2, D = γ(1 − β cos χ): at 0.95 c up to 6.2 a².

#include <cstddef>
#include <span>

#include <glm/vec3.hpp>

#include "cave/room/wall.h"

namespace carom {

/// The heads and eyes for which meshes are made fine enough: speed relative to the body over c, and distance
/// from its edges in its rest frame.
inline constexpr double kFastestHead_beta = 0.95;
inline constexpr double kNearestEye_m = 0.5;
/// The nearest that an eye comes to what rests, which has levels (cave/mesh/surface_tiles.h).
inline constexpr double kNearestToSurface_m = 0.1;

/// Returns the largest angle, at the eye, between the drawn middle of an edge of this length and the seen
/// edge, in radians: the worst case over all eyes at least `nearest_m` from the edge and all motions up to
/// `beta`.
double worstBend_rad(double edge_m, double beta = kFastestHead_beta, double nearest_m = kNearestEye_m);

/// Returns the longest edge whose worst bend is at most `tolerance_rad`.
double longestEdge_m(double tolerance_rad, double beta = kFastestHead_beta, double nearest_m = kNearestEye_m);

/// Returns the β up to which the worst bend of an edge of this length is at most `tolerance_rad`; at most
/// kFastestHead_beta.
double fastestHead_beta(double edge_m, double tolerance_rad);

/// Returns the smallest angle at which an eye at this place of the room sees a pixel anywhere on these walls.
/// Walls that the eye is on or behind are left out; if none is left, the result is that of a wall with 1000
/// pixels per metre at 1 m.
double finestPixel_rad(std::span<const Wall> walls, const glm::dvec3& eyeInRoom_m);

/// How finely the meshes of a scene are divided.
struct Tessellation {
  double pixel_rad = 0.001;  ///< of the walls they are drawn on
  /// The most vertices of all bodies that do not rest on the board together, shared out evenly. Edges that
  /// would need more vertices stay longer than they should be.
  std::size_t mostVertices = 50000;

  /// Returns the longest edge that is off by at most half a pixel.
  double edge_m() const { return longestEdge_m(0.5 * pixel_rad); }
};

}  // namespace carom
