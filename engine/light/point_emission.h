#pragma once
// The light of one body-fixed point, for many observations of the same world line.

#include <optional>
#include <vector>

#include "engine/light/light_cone.h"
#include "engine/light/vertex_history.h"

namespace carom {

/// Returns ν_seen/ν_emitted = (k·u_observer)/(k·u_source), with k along the light from source to observer.
/// Where they meet, that of light from the side.
double dopplerFactor(const Displacement& emissionFromEye, const Vec3& uSource, const Vec3& uObserver);

/// A point's whole world line, computed once: each observation then costs as many steps as the number of its
/// pieces has binary digits, and no memory.
class PointEmission {
 public:
  /// `offset_m` is the place of the point from the centre in the body's rest frame.
  PointEmission(const WorldLine& line, const Vec3& offset_m);

  /// Returns what `emission` of light_cone.h, which is made of this, returns.
  std::optional<Emission> seenAt(const Event& observation, const Lorentz& headFromBoard) const;

 private:
  double c_m_s_;
  double appears_s_;
  std::vector<VertexPiece> history_;
};

}  // namespace carom
