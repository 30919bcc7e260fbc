#pragma once
// A tracker that delivers what a test gave it, and a rig whose wand may be one.

#include <vector>

#include "app/rig/rig.h"
#include "devices/tracker/tracker.h"

namespace carom::test {

/// Delivers what it was given.
class FedTracker : public Tracker {
 public:
  void poll(double now_s, std::vector<TrackerSample>& samples) override {
    for (TrackerSample sample : fed) {
      sample.time_s = now_s;
      samples.push_back(sample);
    }
  }
  void takeInputs(std::vector<Reading>& inputs) override {
    inputs.insert(inputs.end(), readings.begin(), readings.end());
    readings.clear();
  }
  void press(int index, bool down, int sensor = 0) {
    readings.push_back(reading(Reading::Kind::button, sensor, index, down ? 1.0 : 0.0));
  }
  void push(int index, double value, int sensor = 0) {
    readings.push_back(reading(Reading::Kind::axis, sensor, index, value));
  }

  TrackerHealth health(double) const override { return fares; }

  std::vector<TrackerSample> fed;
  std::vector<Reading> readings;
  TrackerHealth fares{TrackerHealth::State::delivering, {}, {}, {}};

 private:
  static Reading reading(Reading::Kind kind, int sensor, int index, double value) {
    Reading made;
    made.kind = kind;
    made.sensor = sensor;
    made.index = index;
    made.value = value;
    return made;
  }
};

/// Returns a sample of that sensor.
inline TrackerSample at(int sensor, const glm::dvec3& place_m, const glm::dquat& turn = {1, 0, 0, 0}) {
  TrackerSample sample;
  sample.sensor = sensor;
  sample.pose = {place_m, turn};
  return sample;
}

/// Returns a rig with a wand of `kind` as sensor 3 of its own tracker, and a SpaceMouse; x right, y up, z
/// back.
inline Rig rigWith(TrackerKind kind) {
  Rig rig;
  rig.trackers.resize(3);
  rig.trackers[0].name = "head";
  rig.trackers[1].name = "wand";
  rig.trackers[1].kind = kind;
  rig.trackers[1].roomFromTracker = {{0.0, 1.0, 0.0}, {1, 0, 0, 0}};
  rig.trackers[2].name = "cap";
  rig.trackers[2].kind = TrackerKind::spaceMouse;
  rig.viewers.front().hand = HandSetup{{1, 3}, {}};
  return rig;
}

}  // namespace carom::test
