#pragma once
// How large the cells of a surface may be that are drawn flat, for one eye.
//
// A point at r from the eye (board frame) is seen by light that comes along the null vector (−|r|, r). In the
// frame of a head that moves with u = γβ that is (the boost of Jackson, Classical Electrodynamics, 3rd
// ed., 11.19)
//   X = r + u (u·r)/(γ + 1) + u |r|,   |X| = D |r|,   D = γ + u·n,   n = r/|r|.
// All of it is linear in r but the last term. A triangle is drawn flat between the X of its corners; so a
// point of it is drawn beside its place by exactly u δ, where δ is what linear interpolation adds to |r|
// there. The second derivatives of |r| are at most 1/|r|, so that δ ≤ h²/(8 |r|) for triangles in a cell with
// the diagonal h, and on an edge of the length h. Seen from the eye that is an angle of at most
//   |u| sin χ' δ/|X| = |u| sin χ/D² · h²/(8 |r|²),   sin χ' = sin χ/D,
// χ being the angle from the motion, χ' the same in the head's frame. With D = γ + |u| cos χ the factor sin
// χ/D² has one peak, at cos χ = (γ − √(γ² + 8 u²))/(2 |u|).

#include <glm/vec3.hpp>

#include "cave/mesh/surface_tiles.h"
#include "engine/light/seen_cap.h"

namespace carom {

/// Returns the longest diagonal of a cell, over the root of the angle by which it may be off (radians), that
/// may be drawn flat anywhere in the box for an eye of a head that moves with u = γβ. Nearer than
/// kNearestToSurface_m the result is that for kNearestToSurface_m.
double longestFlat_m(const Extent& box, const glm::dvec3& eye_m, const glm::dvec3& u);

/// Returns the largest angle (radians) by which anything of a body that reaches `reach_m` from its centre is
/// drawn beside its place if its cells, at most `cell_m` long, are drawn flat, and its shape is off by
/// `off_m`: an angle of the eye in the body's rest frame is seen up to 1/D as large. Infinite where it is not
/// known.
double worstOff_rad(const SeenCaps& seen, double reach_m, double cell_m, double off_m);

}  // namespace carom
