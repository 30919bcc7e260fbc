#pragma once
// Keeps a force device passive: over any time, the hand gets no more energy out of it than it put in. A
// sampled spring makes some energy, because its force is late. Source: Hannaford and Ryu (2002, "Time-domain
// passivity control of haptic interfaces"). Their controller acts once the energy is below zero; this one
// also looks ahead over the device's delay and the time in which a force can go, so that little is left to be
// made up for.
// Theory: app/doc/physics.md, Force in the hand.

#include <glm/vec3.hpp>

#include "devices/force_law/cue_force.h"

namespace carom {

class PortPassivity {
 public:
  explicit PortPassivity(const ForceLimits& limits) : limits_(limits) {}

  /// Observes a tick: the device moved by `moved_m` while its motors had the force `held_n`,
  ///   E += -F dx.
  /// The force that was just computed would be the wrong one: the motors had not got it yet. `stored_j` is
  /// the energy that the law holds and may give back: after a second above zero, E is at most that, so that
  /// losses in friction are not kept for later.
  void observe(const glm::dvec3& moved_m, const glm::dvec3& held_n, double stored_j);

  /// Returns the force, less what along the motion would give out more energy than there is. At the speed v,
  /// with the delay t and the slew s, a force F that is taken back gives F v (t + F/(2 s)) until it is gone:
  ///   F <= s (sqrt(t^2 + 2 E/(s v)) - t),   and for E < 0 F <= E/dx, as by -alpha dx with alpha = -E/dx^2.
  /// The damper alpha T is at most m/(T + 2 t): a stronger one, with its delay, would itself make a light
  /// device tremble. A step below two counts of the encoder is none.
  glm::dvec3 limited(const glm::dvec3& wished_n);

  double energy_j() const { return energy_j_; }
  bool acts() const { return acts_; }  ///< it changed the last force

 private:
  ForceLimits limits_;
  glm::dvec3 moved_m_{0.0};
  double energy_j_ = 0.0, above_s_ = 0.0;
  bool acts_ = false;
};

}  // namespace carom
