#pragma once
// The mass that a hand feels: the least-squares ratio of the force on it and its own acceleration over the
// last second, F = -M a. Both pass the same low-pass, lambda^2/(s + lambda)^2, which leaves their ratio and
// spares the second difference of an encoder's steps:
//
//   y1 = lambda/(s + lambda) x     y2 = lambda/(s + lambda) y1     a = lambda^2 (x - 2 y1 + y2)
// Theory: app/doc/physics.md, Force in the hand.

#include <array>
#include <cstddef>

#include <glm/vec3.hpp>

namespace carom {

class ShownMass {
 public:
  /// Takes the hand's place and the force on it in a tick of `period_s`.
  void add(const glm::dvec3& hand_m, const glm::dvec3& force_n, double period_s);

  /// Returns the mass in kg; NaN before a second has passed and while the hand is hardly accelerated.
  double mass_kg() const;

  /// Returns whether a spring of `stiffness_n_m` hides a mass that is shaken once a second: where
  /// M (2 pi)^2/K is more than a tenth, the hand moves that much less than the mass.
  static bool isHidden(double mass_kg, double stiffness_n_m);

 private:
  static constexpr std::size_t kParts = 20;
  struct Sums {
    double forceTimesA = 0.0, aTimesA = 0.0;
    int count = 0;
  };
  std::array<Sums, kParts> parts_{};
  std::size_t part_ = 0;
  double partFrom_s_ = 0.0, time_s_ = 0.0;
  bool begun_ = false;
  glm::dvec3 x1_{0.0}, x2_{0.0}, f1_{0.0}, f2_{0.0};
};

}  // namespace carom
