#include "devices/tracker_noise.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kMemory_s = 2.0;            // over which the estimate is averaged
constexpr double kRecent_s = 0.5;            // over which stillness is judged
constexpr double kLongestInterval_s = 0.05;  // beyond it motion no longer looks like a parabola
constexpr double kStillSpread = 2.0;         // a still sensor's spread, in units of its noise variance: 1
constexpr double kLeastSigma_m = 0.00001;
constexpr double kMostSigma_m = 0.01;

}  // namespace

void TrackerNoise::add(double time_s, const glm::dvec3& position_m) {
  if (count_ > 0 && time_s - times_s_[3] > kLongestInterval_s) count_ = 0;
  std::rotate(times_s_.begin(), times_s_.begin() + 1, times_s_.end());
  std::rotate(positions_m_.begin(), positions_m_.begin() + 1, positions_m_.end());
  times_s_[3] = time_s;
  positions_m_[3] = position_m;
  count_ = std::min(count_ + 1, 4);
  if (count_ < 4) return;

  // Third divided difference Σ c_i x_i with c_i = Π_{j≠i} 1/(t_i − t_j); white noise of variance σ² gives
  // it the variance σ² Σ c_i² in each coordinate. Times are scaled, so that nothing overflows.
  const double span_s = times_s_[3] - times_s_[0];
  glm::dvec3 difference(0.0);
  double sumOfSquares = 0.0;
  for (int i = 0; i < 4; ++i) {
    double weight = 1.0;
    for (int j = 0; j < 4; ++j) {
      if (j != i) weight *= span_s / (times_s_[i] - times_s_[j]);
    }
    difference += weight * positions_m_[i];
    sumOfSquares += weight * weight;
  }
  const double noise_m2 = glm::dot(difference, difference) / (3.0 * sumOfSquares);
  const glm::dvec3 step_m = positions_m_[3] - positions_m_[0];
  const double spread_m2 = glm::dot(step_m, step_m) / 6.0;

  const double interval_s = span_s / 3.0;
  const double recentShare = -std::expm1(-interval_s / kRecent_s);
  recentNoise_m2_ += recentShare * (noise_m2 - recentNoise_m2_);
  recentSpread_m2_ += recentShare * (spread_m2 - recentSpread_m2_);
  if (isStill()) {
    variance_m2_ += -std::expm1(-interval_s / kMemory_s) * (noise_m2 - variance_m2_);
  }
}

bool TrackerNoise::isStill() const {
  return count_ == 4 && recentSpread_m2_ <= kStillSpread * recentNoise_m2_;
}

double TrackerNoise::sigma_m() const {
  return std::clamp(std::sqrt(variance_m2_), kLeastSigma_m, kMostSigma_m);
}

}  // namespace carom
