#include "devices/tracker/recorded_tracker.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

std::vector<TrackerSample> trace(std::initializer_list<double> times_s) {
  std::vector<TrackerSample> samples;
  for (const double time_s : times_s) {
    samples.push_back({time_s, 0, {glm::dvec3(time_s, 0, 0), glm::dquat(1, 0, 0, 0)}, true});
  }
  return samples;
}

std::vector<double> timesUntil(RecordedTracker& tracker, double now_s) {
  std::vector<TrackerSample> samples;
  tracker.poll(now_s, samples);
  std::vector<double> times_s;
  for (const TrackerSample& sample : samples) times_s.push_back(sample.time_s);
  return times_s;
}

TEST(RecordedTracker, BeginsAtZeroAndKeepsItsSpacing) {
  RecordedTracker tracker(trace({100.0, 100.5, 101.75}));
  EXPECT_EQ(timesUntil(tracker, 0.0), std::vector<double>({0.0}));
  EXPECT_EQ(timesUntil(tracker, 0.4), std::vector<double>());
  EXPECT_EQ(timesUntil(tracker, 1.75), std::vector<double>({0.5, 1.75}));
}

TEST(RecordedTracker, HoldsTheLastPoseAtTheEnd) {
  RecordedTracker tracker(trace({0.0, 0.25, 0.5, 2.5}));
  std::vector<TrackerSample> samples;
  tracker.poll(3.1, samples);
  ASSERT_EQ(samples.size(), 6u);
  EXPECT_EQ(samples[4].time_s, 2.75);
  EXPECT_EQ(samples[5].time_s, 3.0);
  EXPECT_EQ(samples[5].pose.position_m.x, 2.5);
}

TEST(RecordedTracker, OneSampleIsEnoughAndNoneIsRefused) {
  RecordedTracker tracker(trace({5.0}));
  EXPECT_EQ(timesUntil(tracker, 1.0 / 60.0).size(), 2u);
  EXPECT_THROW(RecordedTracker(std::vector<TrackerSample>{}), std::invalid_argument);
}

TEST(RecordedTracker, PollsInAnyPortionsGiveTheSameSamples) {
  RecordedTracker one(trace({0.0, 0.3, 0.7, 1.1})), other(trace({0.0, 0.3, 0.7, 1.1}));
  std::vector<double> portions_s;
  for (int i = 0; i <= 50; ++i) {
    for (const double time_s : timesUntil(one, i * 0.1)) portions_s.push_back(time_s);
  }
  EXPECT_EQ(portions_s, timesUntil(other, 5.0));
}

}  // namespace
}  // namespace carom
