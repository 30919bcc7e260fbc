#include "devices/filter/tracker_noise.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kMemory_s = 2.0;            // over which the estimate is averaged
constexpr double kRecent_s = 0.5;            // over which stillness is judged
constexpr double kLongestInterval_s = 0.3;   // what lies further apart is not compared
constexpr double kSmoothInterval_s = 0.055;  // up to it a moving path looks like a polynomial
constexpr double kStillSpread = 2.0;         // a still sensor's spread, in units of its noise variance: 1
constexpr double kFirstWeight = 3.0;         // differences that an estimate to begin with counts for
constexpr double kKnown = 12.0;              // differences that tell a standard deviation to a quarter
// An outlier counts no more than this. Of white noise one difference in a thousand is beyond 5.4, but real
// trackers err more often by much.
constexpr double kOutlier = 8.0;
constexpr double kLeastVariance_m2 = 1e-10;  // less is none: an estimate of nothing can grow again
// Ratios of two variances up to this are chance, and so much of those above it is.
constexpr double kChance = 1.3;
// Of variances: what a wider spacing shows beyond this may be the head's motion.
constexpr double kMostColour = 4.0;
// Beyond this spacing quick shakes of the head show a little: nothing is extrapolated from what it shows.
constexpr double kExtrapolated_s = 0.03;

}  // namespace

bool TrackerNoise::Spacing::take(double time_s, const glm::dvec3& position_m) {
  if (count_ > 0 && time_s - times_s_.back() < least_s_) return false;
  if (count_ > 0 && time_s - times_s_.back() > kLongestInterval_s) count_ = 0;
  std::rotate(times_s_.begin(), times_s_.begin() + 1, times_s_.end());
  std::rotate(positions_m_.begin(), positions_m_.begin() + 1, positions_m_.end());
  times_s_.back() = time_s;
  positions_m_.back() = position_m;
  count_ = std::min(count_ + 1, kPoints);
  if (!isFull()) return false;
  noise_m2_ = differenced_m2();
  return true;
}

bool TrackerNoise::Spacing::isKnown() const { return averaged_ >= kKnown; }

void TrackerNoise::Spacing::doubt(double weight) { averaged_ = std::min(averaged_, weight); }

// A plain mean at first, one that forgets later.
void TrackerNoise::Spacing::learn() {
  const double most_m2 = isKnown() ? kOutlier * std::max(variance_m2_, kLeastVariance_m2) : noise_m2_;
  averaged_ += 1.0;
  const double share = std::max(1.0 / averaged_, -std::expm1(-interval_s() / kMemory_s));
  variance_m2_ += share * (std::min(noise_m2_, most_m2) - variance_m2_);
}

double TrackerNoise::Spacing::spread_m2() const {
  const glm::dvec3 step_m = positions_m_.back() - positions_m_.front();
  return glm::dot(step_m, step_m) / 6.0;
}

// Fifth divided difference Σ c_i x_i with c_i = Π_{j≠i} 1/(t_i − t_j); white noise of variance σ² gives it
// the variance σ² Σ c_i² in each coordinate. Times are scaled, so that nothing overflows.
double TrackerNoise::Spacing::differenced_m2() const {
  const double perSpan_1_s = 1.0 / (times_s_.back() - times_s_.front());
  glm::dvec3 difference(0.0);
  double sumOfSquares = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    double product = 1.0;
    for (int j = 0; j < kPoints; ++j) {
      if (j != i) product *= (times_s_[i] - times_s_[j]) * perSpan_1_s;
    }
    const double weight = 1.0 / product;
    difference += weight * positions_m_[i];
    sumOfSquares += weight * weight;
  }
  return glm::dot(difference, difference) / (3.0 * sumOfSquares);
}

TrackerNoise::TrackerNoise(double sigma_m)
    : near_(kNear_s, sigma_m * sigma_m, kFirstWeight), sigma_m_(sigma_m) {}

void TrackerNoise::interrupt() {
  for (Spacing* spacing : {&all_, &near_, &far_}) spacing->interrupt();
}

void TrackerNoise::doubt() {
  near_.doubt(kFirstWeight);
  for (Spacing* spacing : {&all_, &far_}) spacing->doubt(0.0);
  estimate();
}

void TrackerNoise::add(double time_s, const glm::dvec3& position_m) {
  for (Spacing* spacing : {&all_, &far_}) {
    if (spacing->take(time_s, position_m) && spacing->interval_s() <= kSmoothInterval_s) {
      spacing->learn();
    }
  }
  if (!near_.take(time_s, position_m)) return;
  const double interval_s = near_.interval_s();
  const double recentShare = -std::expm1(-interval_s / kRecent_s);
  recentNoise_m2_ += recentShare * (near_.noise_m2() - recentNoise_m2_);
  recentSpread_m2_ += recentShare * (near_.spread_m2() - recentSpread_m2_);
  if (interval_s <= kSmoothInterval_s || isStill()) near_.learn();
  estimate();
}

// Fifth differences of samples T apart see the noise's power at 1/(2T), those of samples 2T apart at 1/(4T).
// Where only neighbours are correlated the power is linear in cos 2πfT: at the low end it is twice the latter
// less the former. So it is taken from one spacing to the next, though they are seldom just twice as wide.
void TrackerNoise::estimate() {
  const auto lowEnd = [](const Spacing& wide, const Spacing& narrow) {
    const double ratio = wide.variance_m2() / (kChance * std::max(narrow.variance_m2(), kLeastVariance_m2));
    if (!wide.isKnown() || !narrow.isKnown()) return 1.0;
    return std::max(1.0, wide.interval_s() < kExtrapolated_s ? 2.0 * ratio - 1.0 : ratio);
  };
  double colour = lowEnd(far_, near_);
  if (all_.interval_s() < kNear_s) colour *= lowEnd(near_, all_);
  sigma_m_ = std::sqrt(near_.variance_m2() * std::min(colour, kMostColour));
}

bool TrackerNoise::isStill() const {
  return near_.isFull() && recentSpread_m2_ <= kStillSpread * std::max(recentNoise_m2_, kLeastVariance_m2);
}

}  // namespace carom
