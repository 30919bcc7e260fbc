#include "devices/filter/jump_judge.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "devices/recorded_head.h"
#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kInterval_s = 1.0 / 60.0;

/// A head and the filter that follows what is believed of it.
struct Followed {
  test::Random random{91};
  CelerityFilter filter{kTrackerNoise_m};
  JumpJudge judge;
  double time_s = 0.0;

  Followed() {
    filter.start(0.0, {});
    judge.start({});
  }
  /// Judges the next sample, `interval_s` later, and believes it unless it is doubted.
  Jump take(const glm::dvec3& place_m, double interval_s = kInterval_s) {
    time_s += interval_s;
    const glm::dvec3 seen_m = place_m + kTrackerNoise_m * glm::dvec3(normal(), normal(), normal());
    const Jump jump = judge.judge(filter, time_s, seen_m);
    if (jump == Jump::none || jump == Jump::quick) {
      judge.use(filter, time_s, seen_m);
      filter.update(time_s, seen_m);
    }
    return jump;
  }
  double normal() {
    return std::sqrt(-2.0 * std::log(random.in(1e-12, 1.0))) * std::cos(random.in(0.0, 2.0 * M_PI));
  }
  void stand(const glm::dvec3& place_m, int samples) {
    for (int i = 0; i < samples; ++i) EXPECT_EQ(take(place_m), Jump::none) << "sample " << i;
  }
};

TEST(JumpJudge, AHeadThatStandsIsBelieved) { Followed().stand({}, 3000); }

TEST(JumpJudge, AnOutlierIsDoubtedAndLeavesNoTrace) {
  Followed head;
  head.stand({}, 120);
  EXPECT_EQ(head.take({0.005, 0.0, 0.0}), Jump::doubted);
  EXPECT_TRUE(head.judge.doubts());
  EXPECT_EQ(head.judge.doubted_s(), head.time_s);
  head.stand({}, 120);
  EXPECT_FALSE(head.judge.doubts());
  EXPECT_LT(glm::length(head.filter.position_m()), 0.001);
}

// Samples that jump about are no motion of a head, even if one comes near the one before.
TEST(JumpJudge, SamplesThatJumpAboutAreDoubted) {
  Followed head;
  head.stand({}, 120);
  for (const double x_m : {0.2, -0.2, 0.2, 0.209})
    EXPECT_EQ(head.take({x_m, 0.0, 0.0}), Jump::doubted) << x_m;
  head.stand({}, 120);
  EXPECT_LT(glm::length(head.filter.position_m()), 0.001);
}

TEST(JumpJudge, AStepOfTheTrackerIsShiftedByWhatItIs) {
  Followed head;
  head.stand({}, 120);
  const glm::dvec3 step_m{0.3, -0.2, 0.4};
  Jump jump = Jump::doubted;
  const double begins_s = head.time_s;
  while (jump == Jump::doubted && head.time_s < begins_s + 1.0) jump = head.take(step_m);
  EXPECT_EQ(jump, Jump::shifted);
  EXPECT_NEAR(head.time_s - begins_s, 0.045, 2.5 * kInterval_s);
  EXPECT_LT(glm::length(head.judge.offset_m() - step_m), 0.002);
}

// From rest with 10 m/s² for a fifth of a second, and on at 2 m/s.
TEST(JumpJudge, AQuickHeadIsNoJump) {
  Followed head;
  head.stand({}, 120);
  double x_m = 0.0, v_m_s = 0.0;
  int doubted = 0;
  for (int i = 0; i < 60; ++i) {
    v_m_s = std::min(2.0, v_m_s + 10.0 * kInterval_s);
    x_m += v_m_s * kInterval_s;
    const Jump jump = head.take({x_m, 0.0, 0.0});
    EXPECT_NE(jump, Jump::shifted);
    EXPECT_NE(jump, Jump::elsewhere);
    doubted += jump == Jump::doubted ? 1 : 0;
  }
  EXPECT_LE(doubted, 5);
  EXPECT_NEAR(head.filter.position_m().x, x_m, 0.05);
}

TEST(JumpJudge, AfterAGapItIsBelievedAtOnce) {
  Followed head;
  head.stand({}, 120);
  EXPECT_EQ(head.take({0.1, 0.0, 0.0}, 0.5), Jump::none) << "where a head can get";
  Followed other;
  other.stand({}, 120);
  EXPECT_EQ(other.take({9.0, 0.0, 0.0}, 0.5), Jump::elsewhere);
}

}  // namespace
}  // namespace carom
