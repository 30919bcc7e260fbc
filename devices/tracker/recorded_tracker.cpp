#include "devices/tracker/recorded_tracker.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace carom {
namespace {

constexpr double kUsualSpacing_s = 1.0 / 60.0;   // where a single sample tells none
constexpr double kLeastSpacingOfTrace_s = 1e-3;  // no tracker is faster; a trace may be

double medianSpacing_s(const std::vector<TrackerSample>& samples) {
  std::vector<double> spacings_s;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    spacings_s.push_back(samples[i].time_s - samples[i - 1].time_s);
  }
  if (spacings_s.empty()) return kUsualSpacing_s;
  const auto middle = spacings_s.begin() + static_cast<std::ptrdiff_t>(spacings_s.size() / 2);
  std::nth_element(spacings_s.begin(), middle, spacings_s.end());
  return std::max(*middle, kLeastSpacingOfTrace_s);
}

}  // namespace

RecordedTracker::RecordedTracker(std::vector<TrackerSample> samples)
    : samples_(std::move(samples)), spacing_s_(medianSpacing_s(samples_)) {
  if (samples_.empty()) throw std::invalid_argument("RecordedTracker: no samples");
  const double first_s = samples_.front().time_s;
  for (TrackerSample& sample : samples_) sample.time_s -= first_s;
}

TrackerSample RecordedTracker::at(std::size_t index) const {
  if (index < samples_.size()) return samples_[index];
  TrackerSample held = samples_.back();
  held.time_s += spacing_s_ * static_cast<double>(index + 1 - samples_.size());
  return held;
}

void RecordedTracker::poll(double now_s, std::vector<TrackerSample>& samples) {
  for (TrackerSample next = at(next_); next.time_s <= now_s; next = at(++next_)) samples.push_back(next);
}

TrackerHealth RecordedTracker::health(double now_s) const {
  TrackerHealth health = Tracker::health(now_s);
  health.samples = next_;
  return health;
}

}  // namespace carom
