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
constexpr double kBlock_s = 0.1;  // of the means that show how long errors last
// The steps of means over half a second, in units of their fifth differences, as variances: of white noise 1,
// of errors that last for 50 ms 2, of a head that moves many.
constexpr double kCourseOfStill = 4.0;
constexpr double kColourByChance = 1.7;  // what two seconds of white noise hardly ever show
// Errors of 1 mm that last for 100 ms, at 60 Hz. Those that last longer are not told from a head's sway.
constexpr double kMostStillColour = 36.0;
constexpr double kMostRounding_m = 0.002;  // coarser steps are judged as jumps (jump_judge.h)
constexpr int kAgreeing = 16;              // as many on end are no chance
constexpr double kMostMultiple = 16.0;     // of squares; the next ones lie too close together to tell
constexpr double kMultipleWithin = 0.02;

}  // namespace

void TrackerNoise::Rounding::add(const glm::dvec3& position_m) {
  const glm::dvec3 step_m = position_m - last_m_;
  const double square_m2 = glm::dot(step_m, step_m);
  const bool isFirst = !hasLast_;
  last_m_ = position_m;
  hasLast_ = true;
  if (isFirst) return;
  if (square_m2 == 0.0 || square_m2_ == 0.0) {
    ++agreeing_;
    square_m2_ = std::max(square_m2, square_m2_);
    return;
  }
  const double multiple = std::max(square_m2, square_m2_) / std::min(square_m2, square_m2_);
  if (square_m2 > square_m2_ && multiple > kMostMultiple) return;
  agreeing_ = std::abs(multiple - std::round(multiple)) <= kMultipleWithin ? agreeing_ + 1 : 0;
  square_m2_ = agreeing_ > 0 ? std::min(square_m2, square_m2_) : square_m2;
}

double TrackerNoise::Rounding::step_m() const {
  const double step_m = std::sqrt(square_m2_);
  return agreeing_ >= kAgreeing && step_m <= kMostRounding_m ? step_m : 0.0;
}

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
  for (Spacing* spacing : {&all_, &near_, &far_, &means_}) spacing->interrupt();
  block_ = {};
}

void TrackerNoise::doubt() {
  near_.doubt(kFirstWeight);
  for (Spacing* spacing : {&all_, &far_, &means_}) spacing->doubt(0.0);
  estimate();
}

void TrackerNoise::add(double time_s, const glm::dvec3& position_m) {
  for (Spacing* spacing : {&all_, &far_}) {
    if (spacing->take(time_s, position_m) && spacing->interval_s() <= kSmoothInterval_s) {
      spacing->learn();
    }
  }
  rounding_.add(position_m);
  addToBlock(time_s, position_m);
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
  colour = std::max(std::min(colour, kMostColour), stillColour_);
  const double rounding_m2 = rounding_.step_m() * rounding_.step_m() / 12.0;
  sigma_m_ = std::sqrt(std::max(near_.variance_m2() * colour, rounding_m2));
}

void TrackerNoise::addToBlock(double time_s, const glm::dvec3& position_m) {
  if (block_.count > 0 && time_s >= block_.begin_s + kBlock_s) {
    const double perCount = 1.0 / block_.count;
    if (means_.take(perCount * block_.sum_s, perCount * block_.sum_m)) learnColour();
    block_ = {};
  }
  if (block_.count == 0) block_.begin_s = time_s;
  ++block_.count;
  block_.sum_s += time_s;
  block_.sum_m += position_m;
}

// A mean over n samples of white noise of variance σ² has the variance σ²/n: n times what the means show is
// the variance of white noise that has as much power at their low frequencies.
void TrackerNoise::learnColour() {
  const double recentShare = -std::expm1(-means_.interval_s() / kRecent_s);
  recentMeans_m2_ += recentShare * (means_.noise_m2() - recentMeans_m2_);
  recentCourse_m2_ += recentShare * (means_.spread_m2() - recentCourse_m2_);
  if (recentCourse_m2_ > kCourseOfStill * recentMeans_m2_) return;
  means_.learn();
  if (!means_.isKnown() || !near_.isKnown() || !all_.isFull()) return;
  const double samples = means_.interval_s() / all_.interval_s();
  const double ratio = samples * means_.variance_m2() / std::max(near_.variance_m2(), kLeastVariance_m2);
  stillColour_ = std::clamp(ratio / kColourByChance, 1.0, kMostStillColour);
}

bool TrackerNoise::isStill() const {
  return near_.isFull() && recentSpread_m2_ <= kStillSpread * std::max(recentNoise_m2_, kLeastVariance_m2);
}

}  // namespace carom
