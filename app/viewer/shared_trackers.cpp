#include "app/viewer/shared_trackers.h"

#include <limits>
#include <utility>

#include "devices/setup/tracker_factory.h"

namespace carom {

/// A tracker and what it delivered when it was last polled.
struct SharedTrackers::Opened {
  std::unique_ptr<Tracker> tracker;
  double polled_s = -std::numeric_limits<double>::infinity();
  std::vector<TrackerSample> samples;
  std::vector<Reading> inputs;
};

/// One of those who follow a tracker. The first to poll at a time polls the tracker for all.
class SharedTrackers::Follower : public Tracker {
 public:
  explicit Follower(std::shared_ptr<Opened> opened) : opened_(std::move(opened)) {}

  void poll(double now_s, std::vector<TrackerSample>& samples) override {
    Opened& shared = *opened_;
    if (now_s != shared.polled_s) {
      shared.samples.clear();
      shared.inputs.clear();
      shared.tracker->poll(now_s, shared.samples);
      shared.tracker->takeInputs(shared.inputs);
      shared.polled_s = now_s;
    }
    samples.insert(samples.end(), shared.samples.begin(), shared.samples.end());
  }
  void takeInputs(std::vector<Reading>& inputs) override {
    inputs.insert(inputs.end(), opened_->inputs.begin(), opened_->inputs.end());
  }
  TrackerHealth health(double now_s) const override { return opened_->tracker->health(now_s); }

 private:
  std::shared_ptr<Opened> opened_;
};

std::unique_ptr<Tracker> SharedTrackers::follow(std::size_t tracker) {
  const std::shared_ptr<Opened>& opened = opened_.at(tracker);
  if (!opened) take(tracker, createTracker(setups_[tracker], axes_, sessionStart_));
  return std::make_unique<Follower>(opened);
}

void SharedTrackers::take(std::size_t tracker, std::unique_ptr<Tracker> opened) {
  std::shared_ptr<Opened>& shared = opened_.at(tracker);
  shared = std::make_shared<Opened>();
  shared->tracker = std::move(opened);
  shared->samples.reserve(kMostSamples);
  shared->inputs.reserve(kMostSamples);
}

}  // namespace carom
