#include "cave/pacer.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

constexpr double kUlp_s = 1e-12;

TEST(Pacer, SimulatedTimeGoesByTheDisplay) {
  SimulatedClock clock;
  Pacer pacer(clock, 60.0, 0.005);
  for (int i = 0; i < 100; ++i) {
    const FrameTimes times = pacer.next();
    EXPECT_EQ(times.number, static_cast<std::uint64_t>(i));
    EXPECT_NEAR(times.begin_s, i / 60.0, kUlp_s);
    EXPECT_NEAR(times.display_s, (i + 1) / 60.0 + 0.005, kUlp_s);
    EXPECT_NEAR(times.step_s, i == 0 ? 0.0 : 1 / 60.0, kUlp_s);
  }
}

TEST(Pacer, ALateFrameSkipsPeriodsAndThePersonLivesThemAll) {
  SimulatedClock clock;
  Pacer pacer(clock, 60.0, 0.0);
  pacer.next();
  clock.sleepUntil(3.4 / 60.0);  // drawing took three periods and a bit
  const FrameTimes late = pacer.next();
  EXPECT_EQ(late.number, 1U);
  EXPECT_NEAR(late.begin_s, 4 / 60.0, kUlp_s);
  EXPECT_NEAR(late.step_s, 4 / 60.0, kUlp_s);
  EXPECT_NEAR(pacer.next().step_s, 1 / 60.0, kUlp_s);
}

TEST(Pacer, TheSteadyClockIsWaitedFor) {
  SteadyClock clock;
  Pacer pacer(clock, 200.0, 0.0);
  pacer.next();
  const FrameTimes second = pacer.next();
  EXPECT_GE(clock.now_s(), second.begin_s);
}

}  // namespace
}  // namespace carom
