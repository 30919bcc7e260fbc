#include "cave/frame/frame_timing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <thread>
#include <vector>

#include "counted_new.h"

namespace carom {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

FrameTiming stampsOf(std::uint64_t frame, FramePart part, float value_s) {
  FrameTiming stamps;
  stamps.frame = frame;
  stamps.parts_s.fill(kNaN);
  stamps[part] = value_s;
  return stamps;
}

/// So many of the values are at most this.
double shareUpTo(const std::vector<float>& values_s, double limit_s) {
  const auto count =
      std::count_if(values_s.begin(), values_s.end(), [&](float value_s) { return value_s <= limit_s; });
  return static_cast<double>(count) / static_cast<double>(values_s.size());
}

TEST(FrameTiming, StatisticsAreThoseOfTheNewestFrames) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::mt19937 random(seed);
    std::lognormal_distribution<float> duration_s(-6.0F, 0.7F);
    FrameHistory history(300);
    std::vector<float> all_s;
    for (std::uint64_t frame = 0; frame < 1000; ++frame) {
      all_s.push_back(duration_s(random));
      history.add(stampsOf(frame, FramePart::draw, all_s.back()));
    }
    EXPECT_EQ(history.newest().frame, 999U);
    for (const std::size_t last : {1UL, 60UL, 300UL, 5000UL}) {
      const std::size_t counted = std::min<std::size_t>(last, 300);
      const std::vector<float> newest_s(all_s.end() - static_cast<std::ptrdiff_t>(counted), all_s.end());
      const PartStatistics statistics = history.statistics(FramePart::draw, last);
      ASSERT_EQ(statistics.frames, counted) << "seed " << seed;
      // The nearest rank: the smallest value that so many are at most.
      const double one = 1.0 / static_cast<double>(counted);
      EXPECT_GE(shareUpTo(newest_s, statistics.p99_s), 0.99 - 1e-12) << "seed " << seed << ", last " << last;
      EXPECT_LT(shareUpTo(newest_s, statistics.p99_s) - one, 0.99) << "seed " << seed << ", last " << last;
      EXPECT_GE(shareUpTo(newest_s, statistics.median_s), 0.5 - 1e-12);
      EXPECT_LT(shareUpTo(newest_s, statistics.median_s) - one, 0.5);
      EXPECT_EQ(statistics.most_s, *std::max_element(newest_s.begin(), newest_s.end()));
      double sum = 0.0, squares = 0.0;
      for (const float value_s : newest_s) {
        sum += static_cast<double>(value_s);
        squares += static_cast<double>(value_s) * static_cast<double>(value_s);
      }
      const double variance = squares * one - sum * one * sum * one;
      EXPECT_NEAR(static_cast<double>(statistics.jitter_s), std::sqrt(std::max(variance, 0.0)), 1e-6)
          << "a microsecond; seed " << seed << ", last " << last;
    }
    EXPECT_EQ(history.statistics(FramePart::late, 300).frames, 0U) << "was never measured";
    EXPECT_TRUE(std::isnan(history.statistics(FramePart::late, 300).p99_s));
  }
}

TEST(FrameTiming, StatisticsTakeNoMemory) {
  FrameHistory history(300);
  const std::size_t before = test::allocationCount();
  for (std::uint64_t frame = 0; frame < 700; ++frame) history.add(stampsOf(frame, FramePart::swap, 0.001F));
  const PartStatistics statistics = history.statistics(FramePart::swap, 300);
  EXPECT_EQ(test::allocationCount(), before);
  EXPECT_EQ(statistics.median_s, 0.001F);
}

TEST(FrameTiming, PartsAddUpToTheFrame) {
  using Seconds = std::chrono::duration<double>;
  FrameStopwatch watch(100.0);
  watch.begin();
  EXPECT_TRUE(std::isnan(watch.swapped(0)[FramePart::late])) << "there is no interval yet";
  const auto start = std::chrono::steady_clock::now();
  watch.begin();
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  watch.mark(FramePart::submit);
  std::this_thread::sleep_for(std::chrono::milliseconds(4));
  watch.mark(FramePart::wait);
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const FrameTiming stamps = watch.swapped(7);
  const double whole_s = Seconds(std::chrono::steady_clock::now() - start).count();
  EXPECT_EQ(stamps.frame, 7U);
  EXPECT_GE(stamps[FramePart::submit], 0.002F);
  EXPECT_GE(stamps[FramePart::wait], 0.004F);
  EXPECT_GE(stamps[FramePart::swap], 0.001F);
  const double parts_s = static_cast<double>(stamps[FramePart::submit]) +
                         static_cast<double>(stamps[FramePart::wait]) +
                         static_cast<double>(stamps[FramePart::swap]);
  EXPECT_LE(parts_s, whole_s + 1e-6);
  EXPECT_LE(static_cast<double>(stamps[FramePart::late]) + 0.01, whole_s + 0.005)
      << "the interval began when the frame before was swapped, just before";
  EXPECT_GE(static_cast<double>(stamps[FramePart::late]) + 0.01, parts_s - 1e-6);
  EXPECT_TRUE(std::isnan(stamps[FramePart::decide])) << "nobody decided";
}

TEST(FrameTiming, ASessionsLatenessIsThatOfItsSortedIntervals) {
  constexpr double kTenthOfAMillisecond_s = 1e-4;
  for (const unsigned seed : {5U, 6U}) {
    std::mt19937 random(seed);
    std::exponential_distribution<float> late_s(1000.0F);
    SessionLateness lateness(60.0);
    std::vector<float> all_s;
    for (int i = 0; i < 5000; ++i) {
      all_s.push_back(late_s(random) - 0.0003F);
      lateness.add(all_s.back());
    }
    lateness.add(kNaN);
    std::sort(all_s.begin(), all_s.end());
    EXPECT_EQ(lateness.frames(), 5000U);
    const double exact_s = static_cast<double>(all_s[4949]);  // 4950 are at most this
    EXPECT_GE(lateness.p99_s(), exact_s) << "seed " << seed;
    EXPECT_LE(lateness.p99_s(), exact_s + kTenthOfAMillisecond_s) << "seed " << seed;
  }
}

TEST(FrameTiming, TicksWithoutAFrameAreMissed) {
  SessionLateness lateness(60.0);
  for (int i = 0; i < 10; ++i) lateness.add(0.001F);
  EXPECT_EQ(lateness.missed(), 0U);
  lateness.add(1.02F / 60.0F);  // two ticks from the last
  lateness.add(3.1F / 60.0F);
  lateness.add(-0.9F / 60.0F);  // two swaps at one tick
  EXPECT_EQ(lateness.missed(), 4U);
  lateness.add(5.0F);
  EXPECT_EQ(lateness.missed(), 304U);
  EXPECT_GE(lateness.p99_s(), 0.0999) << "later than the longest that is told apart";
}

}  // namespace
}  // namespace carom
