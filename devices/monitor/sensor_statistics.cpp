#include "devices/monitor/sensor_statistics.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace carom {

namespace {

constexpr double kDropout = 1.5;     // usual intervals
constexpr double kRestTold_s = 2.0;  // at rest for so long, and the noise is known
constexpr double kUsualShare = 0.1;  // of a new interval in the usual one

}  // namespace

void SensorStatistics::add(const TrackerSample& sample) {
  if (!times_s_.empty()) {
    const double interval_s = sample.time_s - times_s_.back();
    const bool isDropout = usual_s_ > 0.0 && interval_s > kDropout * usual_s_;
    if (isDropout) ++dropouts_;
    // A dropout moves the usual interval no further than the longest usual one: a slower rate is learnt too.
    const double counted_s = isDropout ? kDropout * usual_s_ : interval_s;
    usual_s_ = usual_s_ > 0.0 ? usual_s_ + kUsualShare * (counted_s - usual_s_) : interval_s;
  }
  const auto kept = std::lower_bound(times_s_.begin(), times_s_.end(), sample.time_s - kMemory_s);
  times_s_.erase(times_s_.begin(), kept);
  times_s_.push_back(sample.time_s);
  ++samples_;
  quality_ = sample.quality;

  noise_.add(sample.time_s, sample.pose.position_m);
  if (!noise_.isStill()) {
    stillSince_s_ = SensorFigures::kUnknown;
    return;
  }
  if (std::isnan(stillSince_s_)) {
    stillSince_s_ = sample.time_s;
    restNoise_ = TrackerNoise();
  }
  restNoise_.add(sample.time_s, sample.pose.position_m);
  if (sample.time_s - stillSince_s_ >= kRestTold_s) rest_m_ = restNoise_.sigma_m();
}

SensorFigures SensorStatistics::figures(double now_s) const {
  SensorFigures figures;
  figures.samples = samples_;
  figures.dropouts = dropouts_;
  figures.quality = quality_;
  figures.battery = battery_;
  figures.rest_m = rest_m_;
  if (times_s_.empty()) return figures;
  figures.age_s = now_s - times_s_.back();
  const auto first = std::lower_bound(times_s_.begin(), times_s_.end(), now_s - kMemory_s);
  const auto count = std::distance(first, times_s_.end());
  if (count < 2) {
    figures.rate_hz = 0.0;
    return figures;
  }
  const double mean_s = (times_s_.back() - *first) / static_cast<double>(count - 1);
  double squares_s2 = 0.0;
  for (auto time = first; std::next(time) != times_s_.end(); ++time) {
    const double off_s = *std::next(time) - *time - mean_s;
    squares_s2 += off_s * off_s;
  }
  // Over the whole memory, or since the first sample: a sensor that has fallen silent slows down to nothing.
  figures.rate_hz = 1.0 / mean_s;
  if (figures.age_s > 2.0 * mean_s) figures.rate_hz = static_cast<double>(count) / (now_s - *first);
  figures.jitter_s = std::sqrt(squares_s2 / static_cast<double>(count - 1));
  return figures;
}

}  // namespace carom
