#pragma once
// How noisy a tracker is, told from its own samples while nothing moves.

#include <array>
#include <glm/vec3.hpp>

namespace carom {

/// Estimates the standard deviation of a tracker's position noise per axis. Noise is what third
/// differences hold (a path that is locally a parabola cancels in them); the estimate follows them while
/// a sensor keeps its place within that noise, and stays as it is while the sensor moves.
class TrackerNoise {
 public:
  explicit TrackerNoise(double sigma_m) : variance_m2_(sigma_m * sigma_m) {}

  /// The next position, at a later time.
  void add(double time_s, const glm::dvec3& position_m);

  /// Forgets the positions (not the estimate): what comes next does not continue them.
  void interrupt() { count_ = 0; }

  double sigma_m() const;

  /// Whether the sensor keeps its place at present, as far as its noise lets one see.
  bool isStill() const;

 private:
  std::array<double, 4> times_s_{};
  std::array<glm::dvec3, 4> positions_m_{};
  int count_ = 0;
  double variance_m2_;
  double recentNoise_m2_ = 0.0;   // of third differences, as variance of one coordinate
  double recentSpread_m2_ = 0.0;  // of steps over three intervals, the same way
};

}  // namespace carom
