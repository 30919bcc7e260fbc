#include "devices/monitor/loss_counter.h"

#include <gtest/gtest.h>

#include <vector>

#include "engine/random_world.h"

namespace carom {
namespace {

TrackerSample seenAt(double time_s, int sensor = 0) {
  TrackerSample sample;
  sample.time_s = time_s;
  sample.sensor = sensor;
  return sample;
}

Reading lostAt(double time_s, int sensor = 0) {
  Reading reading;
  reading.kind = Reading::Kind::lost;
  reading.sensor = sensor;
  reading.device_s = time_s;
  return reading;
}

// A sensor that is seen and hidden in turns, in polls of any length: each time that it goes counts once.
TEST(LossCounter, CountsTheTimesThatASensorGoes) {
  test::Random random(77);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    LossCounter counter(0);
    bool isSeen = random.in(0.0, 1.0) < 0.5, wasSeen = false;
    std::size_t losses = 0;
    std::vector<TrackerSample> samples;
    std::vector<Reading> inputs;
    for (int frame = 1; frame < 500; ++frame) {
      if (random.in(0.0, 1.0) < 0.1) isSeen = !isSeen;
      if (isSeen) {
        samples.push_back(seenAt(frame));
      } else {
        inputs.push_back(lostAt(frame));
        losses += wasSeen ? 1 : 0;
      }
      wasSeen = isSeen;
      if (random.in(0.0, 1.0) < 0.3) {
        counter.see(samples, inputs);
        samples.clear();
        inputs.clear();
      }
    }
    counter.see(samples, inputs);
    EXPECT_EQ(counter.count(), losses);
  }
}

TEST(LossCounter, OneThatWasNeverSeenAndOtherSensorsDoNotCount) {
  LossCounter counter(1);
  const std::vector<Reading> lost{lostAt(1.0, 1), lostAt(2.0, 1)}, others{lostAt(4.0, 0)};
  const std::vector<TrackerSample> seen{seenAt(3.0, 0)};
  counter.see({}, lost);
  counter.see(seen, others);
  EXPECT_EQ(counter.count(), 0u);
}

}  // namespace
}  // namespace carom
