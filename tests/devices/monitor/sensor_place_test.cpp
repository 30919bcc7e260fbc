#include "devices/monitor/sensor_place.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace carom {
namespace {

TrackerSample sampleAt(double time_s, const glm::dvec3& place_m, int sensor) {
  TrackerSample sample;
  sample.time_s = time_s;
  sample.sensor = sensor;
  sample.pose.position_m = place_m;
  return sample;
}

TEST(SensorPlace, IsThatOfTheNewestSampleInTheRoom) {
  const glm::dquat quarter = glm::angleAxis(0.5 * M_PI, glm::dvec3(0.0, 1.0, 0.0));
  SensorPlace place(2, {{1.0, 0.0, 0.0}, quarter});
  EXPECT_FALSE(place.isKnown(0.0));
  EXPECT_TRUE(std::isnan(place.newest_s()));
  const std::vector<TrackerSample> samples{sampleAt(0.9, {0.0, 1.0, 0.0}, 2),
                                           sampleAt(0.95, {0.0, 0.0, 2.0}, 2),
                                           sampleAt(0.99, {9.0, 9.0, 9.0}, 1)};
  place.see(1.0, samples);
  EXPECT_TRUE(place.isKnown(1.0));
  EXPECT_TRUE(place.isKnown(1.0 + 0.99 * kHandLost_s));
  EXPECT_FALSE(place.isKnown(1.01 + kHandLost_s));
  EXPECT_EQ(place.newest_s(), 0.95);
  // Two metres along the tracker's z are along the room's x after a quarter turn about y.
  EXPECT_NEAR(place.roomFromSensor().position_m.x, 3.0, 1e-12);
  EXPECT_NEAR(place.roomFromSensor().position_m.z, 0.0, 1e-12);
}

TEST(SensorPlace, CountsTheSamplesOfASecond) {
  SensorPlace place(0, {});
  EXPECT_TRUE(std::isnan(place.rate_hz()));
  for (int poll = 1; poll <= 100; ++poll) {
    const double now_s = poll / 30.0;
    const std::vector<TrackerSample> two{sampleAt(now_s - 0.02, {}, 0), sampleAt(now_s, {}, 0)};
    place.see(now_s, two);
  }
  EXPECT_NEAR(place.rate_hz(), 60.0, 2.0);
}

}  // namespace
}  // namespace carom
