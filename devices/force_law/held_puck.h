#pragma once
// A puck that the hand holds while it flies by: the hand and a proxy of the puck's mass m, coupled by a
// spring K and a damper B. The hand's frame is carried along at the velocity V0, so the device shows
// deviations from it. Along and across its motion the proxy is as heavy as relativity says, without any rule
// of its own:
//
//   dp/dt = F = K (x - y) + B (x' - y')     v = p/sqrt(m^2 + p^2/c^2)     y' = v - V0
//
// whence the inertia gamma^3 m along the motion and gamma m across. The hand feels -F.
// Theory: app/doc/physics.md, Force in the hand.

#include <glm/vec3.hpp>

namespace carom {

struct HeldPuckLaw {
  double mass_kg = 0.0, lightSpeed_m_s = 0.0;
  glm::dvec3 carried_m_s{0.0};  ///< V0, in the device's axes
  double stiffness_n_m = 0.0, damping_ns_m = 0.0;
};

class HeldPuck {
 public:
  /// Begins with the proxy in the hand, moving with it.
  HeldPuck(const HeldPuckLaw& law, const glm::dvec3& hand_m);

  /// Goes on by one period with the hand at `hand_m`, moving at `hand_m_s`, both in the carried frame.
  /// Returns the force on the hand.
  ///
  /// Backward Euler in p: with w = v(p') - V0 and g = T (K T + B), p' + g v(p') = r is known, p' is along r,
  /// and its size is the root of P + g v(P) - |r|, which increases: dv/dp = 1/(gamma^3 m) > 0. Newton's steps
  /// find it. Explicit steps would explode.
  glm::dvec3 step(const glm::dvec3& hand_m, const glm::dvec3& hand_m_s, double period_s);

  /// Returns the velocity of the proxy on the board.
  glm::dvec3 velocity_m_s() const;
  /// Returns the energy that the law holds: of the spring, and what the proxy's kinetic energy in the carried
  /// frame's momentum is above that of the carried motion: E(p) - E(p0) - V0 (p - p0), which is never
  /// negative.
  double stored_j() const { return stored_j_; }

  static constexpr int kSteps = 6;

 private:
  double speedOf(double momentum) const;

  HeldPuckLaw law_;
  glm::dvec3 momentum_{0.0};     ///< kg m/s
  glm::dvec3 deviation_m_{0.0};  ///< of the proxy, in the carried frame
  double stored_j_ = 0.0;
};

}  // namespace carom
