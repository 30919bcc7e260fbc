#pragma once
// Which directions of an eye's sky lie on a wall.

#include <array>

#include <glm/mat4x4.hpp>

#include "engine/spacetime/spherical_cap.h"

namespace carom {

/// What a wall shows lies within four planes through the eye, each given by its normal m, which points
/// inwards, and m·δ: places x are counted from a point that is δ from the eye, which is 0 unless the view is
/// frozen. Inside is m·(x + δ) ≥ 0.
class WallPyramid {
 public:
  /// `clipFromDrawn` takes places in the frame in which walls draw to OpenGL's clip coordinates, (x, y, z, w)
  /// with |x| ≤ w and |y| ≤ w on the wall. So the planes are w ± x = 0 and w ± y = 0.
  explicit WallPyramid(const glm::dmat4& clipFromDrawn);

  /// Returns whether anything that is seen within the cap may lie on the wall. False is certain, also for the
  /// straight edges and faces that are drawn between the seen points, and after rounding to single precision;
  /// true is not, where a cap lies beside a corner of the wall.
  bool mayShow(const SphericalCap& cap) const;

 private:
  struct Plane {
    Vec3 inwards{0.0};
    double eyeInside_m = 0.0;
  };
  std::array<Plane, 4> planes_;
};

}  // namespace carom
