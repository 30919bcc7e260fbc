#pragma once
// The cue's force: drawing it back by d stores the energy that the stroke gives to a puck at rest, in
// rapidity. With the puck's mass m, the light speed c, and the draw d0 of one unit of rapidity:
//
//   eta = d/d0     p = m c sinh eta     W = s m c^2 (cosh eta - 1) = s times the struck puck's kinetic energy
//   F = dW/dd = s (m c^2/d0) sinh eta     k = dF/dd = s (m c^2/d0^2) cosh eta
//
// Equal draws add equal rapidity, and each costs e times as much as the last. The scale s lowers force and
// stiffness to what a device can do.
// Theory: app/doc/physics.md, Force in the hand.

namespace carom {

/// The speed, as a share of c, up to which the scale keeps the force within a device's limits.
inline constexpr double kScaledBeta = 0.99;

/// The strongest force comes or goes in this time at the quickest.
inline constexpr double kSlew_s = 0.020;

/// What a device can do.
struct ForceLimits {
  double force_n = 9.0;          ///< the strongest force
  double stiffness_n_m = 600.0;  ///< the stiffest spring that it holds without trembling
  double period_s = 1e-3;        ///< of its loop
  double spring_s = 1e-3;        ///< period at which it holds a spring: its loop's, or a server's faster one
  double damping_ns_m = 0.3;     ///< of the device itself
  double leastRate_hz = 500.0;   ///< below this rate of its loop it is switched off
  double count_m = 2e-5;         ///< the step of its encoder
  int delay_ticks = 1;           ///< after which a force is at its motors
};

/// Returns the stiffest spring that is passive when it is sampled: 2 (b - B)/T, with the device's own damping
/// b, the damping B of the law and the period T of the spring. Source: Colgate and Schenkel (1997, "Passivity
/// of a class of sampled-data systems").
double passiveStiffness_n_m(const ForceLimits& limits, double lawDamping_ns_m = 0.0);

/// Returns the stiffest spring that settles in a hand in spite of the device's delay t:
/// (b + b_hand)/(T/2 + t), where the hand damps by at least 4 N s/m.
double settlingStiffness_n_m(const ForceLimits& limits);

/// Returns the damping that a held puck's coupling may have beside its spring, with the delay t of the
/// device: B = b - K (T/2 + t).
double couplingDamping_ns_m(const ForceLimits& limits, double stiffness_n_m);

/// Returns s = min(1, F_max d0/(m c^2 sinh eta_max), K_max d0^2/(m c^2 cosh eta_max)), where eta_max is the
/// rapidity of kScaledBeta.
double forceScale(double restEnergy_j, double d0_m, const ForceLimits& limits);

/// The law of one cue.
struct CueForce {
  double restEnergy_j = 0.0;  ///< m c^2 of the puck that it strikes
  double d0_m = 0.08;         ///< draw of one unit of rapidity
  double scale = 1.0;         ///< s

  double force_n(double draw_m) const;
  double energy_j(double draw_m) const;       ///< stored in the draw: W
  double stiffness_n_m(double draw_m) const;  ///< k
  double beta(double draw_m) const;           ///< of a puck at rest after the stroke: tanh eta
};

/// Returns u = gamma beta = sinh eta that a draw gives to a puck at rest.
double uOfDraw(double draw_m, double d0_m);

}  // namespace carom
