#include "devices/monitor/sensor_statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace carom {
namespace {

TrackerSample sampleAt(double time_s, const glm::dvec3& position_m = {}) {
  TrackerSample sample;
  sample.time_s = time_s;
  sample.pose.position_m = position_m;
  return sample;
}

TEST(SensorStatistics, KnowsNothingAtFirst) {
  const SensorFigures figures = SensorStatistics().figures(3.0);
  EXPECT_EQ(figures.samples, 0u);
  for (const double figure :
       {figures.rate_hz, figures.age_s, figures.jitter_s, figures.rest_m, figures.quality, figures.battery}) {
    EXPECT_TRUE(std::isnan(figure));
  }
}

TEST(SensorStatistics, TellsRateAgeAndJitter) {
  SensorStatistics monitor;
  std::mt19937_64 random(71);
  std::normal_distribution<double> jitter(0.0, 0.0005);
  for (int i = 0; i < 600; ++i) monitor.add(sampleAt(i / 100.0 + jitter(random)));
  const SensorFigures figures = monitor.figures(6.0);
  EXPECT_NEAR(figures.rate_hz, 100.0, 0.2);
  EXPECT_NEAR(figures.age_s, 0.01, 0.003);
  // An interval has the jitter of both its ends; two hundred tell it to a tenth.
  EXPECT_NEAR(figures.jitter_s / (std::sqrt(2.0) * 0.0005), 1.0, 0.2);
  EXPECT_EQ(figures.samples, 600u);
  EXPECT_EQ(figures.dropouts, 0u);
}

TEST(SensorStatistics, CountsDropoutsAndLearnsASlowerRate) {
  SensorStatistics monitor;
  double time_s = 0.0;
  for (int i = 0; i < 300; ++i) monitor.add(sampleAt(time_s += i % 50 == 49 ? 0.030 : 0.010));
  EXPECT_EQ(monitor.figures(time_s).dropouts, 6u);
  for (int i = 0; i < 600; ++i) monitor.add(sampleAt(time_s += 0.020));  // half the rate from now on
  const std::size_t learnt = monitor.figures(time_s).dropouts;
  EXPECT_LE(learnt, 20u);
  for (int i = 0; i < 600; ++i) monitor.add(sampleAt(time_s += 0.020));
  EXPECT_EQ(monitor.figures(time_s).dropouts, learnt);
  EXPECT_NEAR(monitor.figures(time_s).rate_hz, 50.0, 0.1);
}

TEST(SensorStatistics, ASilentSensorSlowsDown) {
  SensorStatistics monitor;
  for (int i = 0; i <= 600; ++i) monitor.add(sampleAt(i / 60.0));
  EXPECT_NEAR(monitor.figures(10.0).rate_hz, 60.0, 0.5);
  EXPECT_NEAR(monitor.figures(11.0).rate_hz, 30.0, 1.0);
  EXPECT_EQ(monitor.figures(15.0).rate_hz, 0.0);
  EXPECT_NEAR(monitor.figures(15.0).age_s, 5.0, 1e-9);
}

// What the samples have, and nothing that the estimate began with: from the first moment that it is told, at
// any rate above 4 Hz.
TEST(SensorStatistics, TellsTheNoiseAtRestAsItIs) {
  for (const double rate_hz : {5.0, 10.0, 19.0, 60.0, 240.0}) {
    for (const double sigma_m : {0.0, 0.00005, 0.0003, 0.002}) {
      for (const bool moves : {false, true}) {
        std::mt19937_64 random(73);
        std::normal_distribution<double> noise(0.0, 1.0);
        SensorStatistics monitor;
        const double begin_s = moves ? 4.0 : 0.0;
        for (int i = 0; i < (begin_s + 15.0) * rate_hz; ++i) {
          const double time_s = i / rate_hz;
          const double x = noise(random), y = noise(random), z = noise(random);
          const double way_m = 0.5 * std::min(time_s, begin_s);
          monitor.add(sampleAt(time_s, glm::dvec3(way_m, 1.7, 0.0) + sigma_m * glm::dvec3(x, y, z)));
          const double rest_m = monitor.figures(time_s).rest_m;
          if (std::isnan(rest_m)) continue;
          // Thirty coordinates at 5 Hz, and neighbours share five of six samples; 1e-9 m is for rounding.
          const double spread = rate_hz < 15.0 ? 0.6 : 0.35;
          ASSERT_TRUE(std::abs(rest_m - sigma_m) <= spread * sigma_m + 1e-9)
              << rest_m << " for " << sigma_m << " m at " << rate_hz << " Hz after " << time_s << " s";
        }
        EXPECT_FALSE(std::isnan(monitor.figures(begin_s + 15.0).rest_m)) << sigma_m << " m at " << rate_hz;
      }
    }
  }
}

TEST(SensorStatistics, TellsTheNoiseAtRestOnceAtRest) {
  SensorStatistics monitor;
  std::mt19937_64 random(72);
  std::normal_distribution<double> noise(0.0, 0.0005);
  double time_s = 0.0;
  const auto go = [&](double seconds, double speed_m_s) {
    for (const double end_s = time_s + seconds; time_s < end_s; time_s += 1.0 / 60.0) {
      const double x = noise(random), y = noise(random), z = noise(random);
      monitor.add(sampleAt(time_s, glm::dvec3(speed_m_s * time_s + x, y, z)));
    }
  };
  go(5.0, 1.0);
  EXPECT_TRUE(std::isnan(monitor.figures(time_s).rest_m));
  go(10.0, 0.0);
  const double rest_m = monitor.figures(time_s).rest_m;
  EXPECT_NEAR(rest_m / 0.0005, 1.0, 0.2);
  go(5.0, 1.0);
  EXPECT_NEAR(monitor.figures(time_s).rest_m / rest_m, 1.0, 0.1);  // kept
}

TEST(SensorStatistics, PassesOnQualityAndBattery) {
  SensorStatistics monitor;
  TrackerSample sample = sampleAt(1.0);
  sample.quality = 0.75;
  monitor.add(sample);
  monitor.setBattery(0.5);
  EXPECT_EQ(monitor.figures(1.0).quality, 0.75);
  EXPECT_EQ(monitor.figures(1.0).battery, 0.5);
}

}  // namespace
}  // namespace carom
