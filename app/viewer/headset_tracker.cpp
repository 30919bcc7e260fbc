#include "app/viewer/headset_tracker.h"

#include <array>

namespace carom {
namespace {

constexpr int kHead = 0, kHand = 1;

}  // namespace

void HeadsetTracker::poll(double now_s, std::vector<TrackerSample>& samples) {
  if (frame_.isTracked) samples.push_back({now_s, kHead, headBetween(frame_.eyes), true});
  const HeadsetHand& hand = frame_.hands[frame_.aiming];
  if (hand.isTracked) samples.push_back({now_s, kHand, hand.roomFromAim, true});
}

/// The trigger is that of the hand that aims; either hand's buttons and stick serve.
void HeadsetTracker::takeInputs(std::vector<Reading>& inputs) {
  const auto& [left, right] = frame_.hands;
  const std::array<bool, 4> buttons{frame_.hands[frame_.aiming].trigger, left.first || right.first,
                                    left.second || right.second, left.menu || right.menu};
  const glm::dvec2 stick = left.stick + right.stick;
  const auto add = [&](Reading::Kind kind, int index, double value) {
    Reading reading;
    reading.kind = kind;
    reading.sensor = kHand;
    reading.index = index;
    reading.value = value;
    inputs.push_back(reading);
  };
  for (int i = 0; i < 4; ++i) add(Reading::Kind::button, i, buttons[static_cast<std::size_t>(i)] ? 1.0 : 0.0);
  for (int i = 0; i < 2; ++i) add(Reading::Kind::axis, i, stick[i]);
}

TrackerHealth HeadsetTracker::health(double) const {
  TrackerHealth health;
  health.state = frame_.isTracked ? TrackerHealth::State::delivering : TrackerHealth::State::silent;
  return health;
}

}  // namespace carom
