#pragma once
// In which directions an eye can see the parts of a body, without solving for any of their points.
// Theory: app/doc/physics.md, Aberration and cells.

#include <optional>

#include <glm/mat4x4.hpp>

#include "engine/light/light_cone.h"
#include "engine/spacetime/spherical_cap.h"

namespace carom {

/// How one eye sees spheres that are fixed to a body.
///
/// For light from a body that keeps to one straight leg the cap is exact: it is that of the sphere in the
/// leg's rest frame (without contraction γ times as large, around its stretched middle), carried to the frame
/// in which walls draw. At a moment of the board's or the head's, a sphere is drawn within a sphere of the
/// same radius, since nothing is longer there than at rest (the head's moment without aberration: the whole
/// sky). A sphere of a spinning body is within a larger one around its centre. Of a body that glides under
/// friction, the cap is that of a larger sphere at rest on the board. A body between two legs may be seen
/// anywhere: the whole sky.
class SeenCaps {
 public:
  /// `view` is the body in `frame`, which viewBody and ViewFrame made with the same switches.
  SeenCaps(const BodyView& view, const ViewFrame& frame);

  /// Returns where the points are drawn that are at most `radius_m` from `middle_m` (in the body's rest
  /// frame, from its centre): in the frame in which walls draw.
  SphericalCap of(const Vec3& middle_m, double radius_m) const;

  /// A body at rest, as an eye sees it: the eye's place, from the body's centre, and its head's γβ.
  struct RestView {
    Vec3 eye_m{0.0}, u{0.0};
  };
  /// Returns how the whole body is seen in its rest frame. Nothing of a body that keeps to no straight leg,
  /// that spins or that is drawn uncontracted.
  std::optional<RestView> restView() const;

  /// Returns where everything is drawn that is at rest to the body's centre on the board within `radius_m` of
  /// the place from which the centre's light came: larger than `of` in most cases, and good for a shadow,
  /// which goes with its body but is no part of it.
  SphericalCap around(double radius_m) const;

 private:
  enum class Kind { wholeSky, straight, moment, gliding };
  Kind kind_ = Kind::wholeSky;
  LegView leg_;
  bool contracted_;
  bool retarded_;
  double fastest_ = 0.0;        // the body's largest v/c on the board
  Vec3 centreOnBoard_m_{0.0};   // seen, from the eye
  glm::dmat4 drawnFromSphere_;  // from the frame in which the sphere rests
  glm::dmat4 drawnFromBoard_;
};

}  // namespace carom
