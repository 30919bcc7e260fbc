#include "devices/filter/tracker_noise.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kMemory_s = 2.0;  // over which the estimate is averaged
constexpr double kRecent_s = 0.5;  // over which stillness is judged
// Samples closer than that are left out: what a tracker's own smoothing makes alike is noise, too.
constexpr double kLeastInterval_s = 0.011;
constexpr double kLongestInterval_s = 0.3;   // what lies further apart is not compared
constexpr double kSmoothInterval_s = 0.055;  // up to it a moving path looks like a polynomial
constexpr double kStillSpread = 2.0;         // a still sensor's spread, in units of its noise variance: 1
constexpr double kFirstWeight = 3.0;         // differences that an estimate to begin with counts for
constexpr double kKnown = 12.0;              // differences that tell a standard deviation to a quarter
// One difference in a thousand is larger, of white noise; an outlier counts no more than this.
constexpr double kOutlier = 5.4;
constexpr double kLeastVariance_m2 = 1e-10;  // less is none: an estimate of nothing can grow again

}  // namespace

TrackerNoise::TrackerNoise(double sigma_m) : variance_m2_(sigma_m * sigma_m), averaged_(kFirstWeight) {}

void TrackerNoise::doubt() { averaged_ = std::min(averaged_, kFirstWeight); }

void TrackerNoise::add(double time_s, const glm::dvec3& position_m) {
  if (count_ > 0 && time_s - times_s_.back() < kLeastInterval_s) return;
  if (count_ > 0 && time_s - times_s_.back() > kLongestInterval_s) count_ = 0;
  std::rotate(times_s_.begin(), times_s_.begin() + 1, times_s_.end());
  std::rotate(positions_m_.begin(), positions_m_.begin() + 1, positions_m_.end());
  times_s_.back() = time_s;
  positions_m_.back() = position_m;
  count_ = std::min(count_ + 1, kPoints);
  if (count_ < kPoints) return;

  const double now_m2 = noise_m2();
  const glm::dvec3 step_m = positions_m_.back() - positions_m_.front();
  const double spread_m2 = glm::dot(step_m, step_m) / 6.0;
  const double interval_s = (times_s_.back() - times_s_.front()) / (kPoints - 1);
  const double recentShare = -std::expm1(-interval_s / kRecent_s);
  recentNoise_m2_ += recentShare * (now_m2 - recentNoise_m2_);
  recentSpread_m2_ += recentShare * (spread_m2 - recentSpread_m2_);
  if (interval_s > kSmoothInterval_s && !isStill()) return;

  // A plain mean at first, one that forgets later.
  const double most_m2 = isKnown() ? kOutlier * std::max(variance_m2_, kLeastVariance_m2) : now_m2;
  averaged_ += 1.0;
  const double share = std::max(1.0 / averaged_, -std::expm1(-interval_s / kMemory_s));
  variance_m2_ += share * (std::min(now_m2, most_m2) - variance_m2_);
}

// Fifth divided difference Σ c_i x_i with c_i = Π_{j≠i} 1/(t_i − t_j); white noise of variance σ² gives it
// the variance σ² Σ c_i² in each coordinate. Times are scaled, so that nothing overflows.
double TrackerNoise::noise_m2() const {
  const double span_s = times_s_.back() - times_s_.front();
  glm::dvec3 difference(0.0);
  double sumOfSquares = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    double weight = 1.0;
    for (int j = 0; j < kPoints; ++j) {
      if (j != i) weight *= span_s / (times_s_[i] - times_s_[j]);
    }
    difference += weight * positions_m_[i];
    sumOfSquares += weight * weight;
  }
  return glm::dot(difference, difference) / (3.0 * sumOfSquares);
}

bool TrackerNoise::isKnown() const { return averaged_ >= kKnown; }

bool TrackerNoise::isStill() const {
  return count_ == kPoints && recentSpread_m2_ <= kStillSpread * std::max(recentNoise_m2_, kLeastVariance_m2);
}

double TrackerNoise::sigma_m() const { return std::sqrt(variance_m2_); }

}  // namespace carom
