#pragma once
// A round part of an eye's sky: in which directions a sphere is seen, from any frame.
//
// In its rest frame a sphere (middle p from the eye, radius ρ) is seen within the cap {n : n·a ≥ cos α},
// a = p/|p|, sin α = ρ/|p|. A cone of light stays a cone under a boost (Penrose 1959, "The apparent shape of
// a relativistically moving sphere"): light from the direction n has the null vector N = (−1, n), and with
// S = (−cos α, a)
//   N·S = n·a − cos α ≥ 0    (metric −+++)
// holds in every frame or in none. In another frame S becomes (s₀, s), so that the cap there has the axis
// s/|s| and cos α' = −s₀/|s|. Since S·S = sin²α stays too, sin α' = sin α/|s|.
// Theory: app/doc/physics.md, Aberration and cells.

#include <glm/mat4x4.hpp>

#include "engine/spacetime/event.h"

namespace carom {

/// Directions within an angle α of an axis, and the least distance of anything seen there.
struct SphericalCap {
  Vec3 axis{0.0, 0.0, 1.0};  ///< unit vector, from the eye
  double cosine = -1.0;      ///< of α; −1: all directions
  double sine = 0.0;         ///< of α
  double nearest_m = 0.0;    ///< nothing is seen nearer to the eye than this

  bool isWholeSky() const { return cosine <= -1.0; }
};

/// Returns the cap in which a sphere at rest is seen, whose middle is at `middleFromEye_m`: the whole sky for
/// an eye in the sphere.
SphericalCap capOfSphere(const Vec3& middleFromEye_m, double radius_m);

/// Returns the same cap in another frame, for an eye at the same event. The matrix is a Lorentz transform's
/// (engine/spacetime/lorentz.h).
SphericalCap carried(const SphericalCap& cap, const glm::dmat4& otherFromThis);

}  // namespace carom
