#pragma once
// How noisy a tracker is, told from its own samples, moving or not.

#include <array>
#include <glm/vec3.hpp>

namespace carom {

/// Estimates the standard deviation of a tracker's position noise per axis. Noise is what fifth differences
/// hold: a path that is locally a polynomial of degree four cancels in them, and of a component at 2 Hz, the
/// quickest that is large in a head's motion, a ten-thousandth is left at 120 Hz and four at 60 Hz. Below
/// 30 Hz more would be left, and the estimate then stays as it is while the sensor moves.
class TrackerNoise {
 public:
  /// With an estimate to begin with, which counts as much as a few samples.
  explicit TrackerNoise(double sigma_m);
  /// With none: sigma_m() is 0 before the first six samples.
  TrackerNoise() = default;

  /// The next position, at a later time.
  void add(double time_s, const glm::dvec3& position_m);

  /// Forgets the positions (not the estimate): what comes next does not continue them.
  void interrupt() { count_ = 0; }

  /// What the estimate holds counts for no more than one to begin with.
  void doubt();

  double sigma_m() const;

  /// Whether enough samples were seen for the estimate to be theirs and not the one to begin with.
  bool isKnown() const;

  /// Whether the sensor keeps its place at present, as far as its noise lets one see.
  bool isStill() const;

 private:
  static constexpr int kPoints = 6;
  double noise_m2() const;

  std::array<double, kPoints> times_s_{};
  std::array<glm::dvec3, kPoints> positions_m_{};
  int count_ = 0;
  double variance_m2_ = 0.0;
  double averaged_ = 0.0;         // how many differences the estimate holds
  double recentNoise_m2_ = 0.0;   // of fifth differences, as variance of one coordinate
  double recentSpread_m2_ = 0.0;  // of steps over five intervals, the same way
};

}  // namespace carom
