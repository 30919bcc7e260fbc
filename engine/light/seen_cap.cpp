#include "engine/light/seen_cap.h"

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

namespace carom {
namespace {

/// Returns the whole transform of displacements; a leg has its rows of the three places. With
/// g = diag(−1, 1, 1, 1), Lᵀ g L = g gives the row of the time: T₀² = 1 + Σ Xk₀², T₀ Tᵢ = Σ Xk₀ Xkᵢ.
glm::dmat4 seenFromLeg(const LegView& leg) {
  const glm::dvec4 &x = leg.toSeenX, &y = leg.toSeenY, &z = leg.toSeenZ;
  const double t0 = std::sqrt(1.0 + x[0] * x[0] + y[0] * y[0] + z[0] * z[0]);
  glm::dvec4 t = (x[0] * x + y[0] * y + z[0] * z) / t0;
  t[0] = t0;
  return glm::transpose(glm::dmat4(t, x, y, z));
}

/// Returns whether the moment that is shown is one of the frame in which the leg is shown, so that nothing
/// looks longer than at rest: the head's moment shown without aberration is not.
bool isMomentOf(const glm::dmat4& seenFromLeg, const LegView& leg) {
  constexpr double kRounding = 1e-9;
  return glm::distance(glm::transpose(seenFromLeg)[0], leg.toMoment) < kRounding * leg.toMoment.x;
}

/// Returns the largest v/c that a body has on these legs. The first row of a leg's transform to the board is
/// (γ, u); a glide is fastest at its turn.
double fastestOf(const BodyView& view) {
  double fastest_u = 0.0;
  for (const LegView& leg : view.legs) {
    const Vec3 u(leg.toBoardTime.y, leg.toBoardTime.z, leg.toBoardTime.w);
    fastest_u = std::max({fastest_u, glm::length(u), leg.glide.w > 0.0 ? leg.glideTimes.x : 0.0});
  }
  return fastest_u / std::sqrt(1.0 + fastest_u * fastest_u);
}

}  // namespace

SeenCaps::SeenCaps(const BodyView& view, const ViewFrame& frame)
    : contracted_(view.contracted), retarded_(view.retarded), drawnFromBoard_(frame.drawnFromBoard.matrix()) {
  if (view.legs.size() != 1) return;
  leg_ = view.legs.front();
  const bool glides = leg_.glide.w > 0.0;
  if (!retarded_) {
    if (!glides && (!contracted_ || isMomentOf(seenFromLeg(leg_), leg_))) kind_ = Kind::moment;
    drawnFromSphere_ = frame.drawnFromSeen.matrix();
    return;
  }
  kind_ = glides ? Kind::gliding : Kind::straight;
  drawnFromSphere_ = seenFromLeg(leg_);
  fastest_ = fastestOf(view);
  const glm::dmat4 boardFromSeen = frame.seenFromBoard.inverse().matrix();
  centreOnBoard_m_ = kernel::rayThrough(boardFromSeen, leg_.seenCentre);
}

SphericalCap SeenCaps::of(const Vec3& middle_m, double radius_m) const {
  if (kind_ != Kind::wholeSky && leg_.spin.w > 0.0 && middle_m != Vec3(0.0))
    return of(Vec3(0.0), glm::length(middle_m) + radius_m);
  switch (kind_) {
    case Kind::wholeSky:
      return {};
    case Kind::gliding:
      return around(glm::length(middle_m) + radius_m);
    case Kind::moment: {
      const kernel::vec4 event = kernel::emissionOnLeg(leg_, middle_m, false, contracted_);
      return carried(capOfSphere(kernel::seenFromEye(leg_, event), radius_m), drawnFromSphere_);
    }
    case Kind::straight:
      break;
  }
  if (contracted_) return carried(capOfSphere(middle_m - leg_.eye, radius_m), drawnFromSphere_);
  const Vec3 stretched_m = kernel::stretched(leg_, middle_m);
  return carried(capOfSphere(stretched_m - leg_.eye, leg_.toBoardTime.x * radius_m), drawnFromSphere_);
}

// A displacement (c t, x) of the leg's frame has the time γ c t − u·x in the head's. At a moment, drawn
// places are a linear map of the body's in which nothing is longer: the drawn distance is the distance, and
// nothing bends.
std::optional<SeenCaps::RestView> SeenCaps::restView() const {
  if (!contracted_ || leg_.spin.w > 0.0) return std::nullopt;
  if (kind_ == Kind::moment)
    return RestView{-kernel::seenFromEye(leg_, kernel::emissionOnLeg(leg_, Vec3(0.0), false, true)),
                    Vec3(0.0)};
  if (kind_ != Kind::straight) return std::nullopt;
  const glm::dvec4 time = glm::transpose(drawnFromSphere_)[0];
  return RestView{leg_.eye, -Vec3(time.y, time.z, time.w)};
}

// Light from a point within R of the centre at each board time left at t, the centre's at t_c:
//   c |t − t_c| ≤ |x − x_c| ≤ R + β c |t − t_c|,   so |x − x_c| ≤ R/(1 − β).
SphericalCap SeenCaps::around(double radius_m) const {
  if (kind_ == Kind::wholeSky) return {};
  if (kind_ == Kind::moment) return carried(capOfSphere(leg_.seenCentre, radius_m), drawnFromSphere_);
  return carried(capOfSphere(centreOnBoard_m_, radius_m / (1.0 - fastest_)), drawnFromBoard_);
}

}  // namespace carom
