#include "cave/frame/pacer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace carom {
namespace {

constexpr double kRounding_s = 1e-9;

/// A display seen through a clock: swaps return at its ticks, or at once.
class Display {
 public:
  Display(double period_s, double phase_s) : period_s_(period_s), phase_s_(phase_s) {}

  /// Draws for so long and swaps; when the photons of the frame left.
  double show(SimulatedClock& clock, Pacer& pacer, double drawing_s, bool waits) {
    clock.sleepUntil(clock.now_s() + drawing_s);
    pacer.awaitTick(0.0);
    if (waits) clock.sleepUntil(tickAfter(clock.now_s()));
    const double shown_s = clock.now_s();
    pacer.swapped();
    return shown_s;
  }

 private:
  double tickAfter(double t_s) const {
    return phase_s_ + std::ceil((t_s - phase_s_) / period_s_) * period_s_;
  }

  double period_s_, phase_s_;
};

TEST(Pacer, SimulatedTimeGoesByTheDisplayAndIsTheSameInEveryRun) {
  std::vector<double> runs[2];
  for (std::vector<double>& run : runs) {
    SimulatedClock clock;
    Pacer pacer(clock, 60.0, 0.005);
    for (int i = 0; i < 100; ++i) {
      const FrameTimes times = pacer.next();
      EXPECT_EQ(times.number, static_cast<std::uint64_t>(i));
      EXPECT_NEAR(times.display_s, (i + 1) / 60.0 + 0.005, kRounding_s);
      EXPECT_NEAR(times.step_s, i == 0 ? 0.0 : 1 / 60.0, kRounding_s);
      EXPECT_LE(times.begin_s, times.display_s);
      run.push_back(times.begin_s);
      pacer.awaitTick(0.0);
      pacer.swapped();
    }
  }
  EXPECT_EQ(runs[0], runs[1]);
}

TEST(Pacer, ADisplaysTicksAreFollowedAndFramesBeginAsLateAsIsSafe) {
  for (const double hz : {59.94, 60.0, 60.3}) {
    SimulatedClock clock;
    Pacer pacer(clock, 60.0, 0.0, true);
    Display display(1.0 / hz, 0.0071);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> drawing_s(0.004, 0.006);
    for (int i = 0; i < 600; ++i) {
      const FrameTimes times = pacer.next();
      const double shown_s = display.show(clock, pacer, drawing_s(random), true);
      if (i < 200) continue;
      EXPECT_NEAR(times.display_s, shown_s, 0.0001) << hz << " Hz, frame " << i;  // 0.1 mm of walking
      EXPECT_NEAR(times.step_s, 1.0 / hz, 0.0001) << hz << " Hz, frame " << i;
      EXPECT_LT(shown_s - times.begin_s, 0.006 + 0.002) << "latency: the longest drawing and a margin";
    }
  }
}

TEST(Pacer, WithoutWaitingSwapsFramesAreEvenAllTheSame) {
  SimulatedClock clock;
  Pacer pacer(clock, 60.0, 0.0);
  Display display(1.0, 0.0);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> drawing_s(0.002, 0.009);
  double last_s = 0.0;
  for (int i = 0; i < 300; ++i) {
    const FrameTimes times = pacer.next();
    const double shown_s = display.show(clock, pacer, drawing_s(random), false);
    EXPECT_NEAR(shown_s, times.display_s, kRounding_s) << "frame " << i;
    if (i > 0) {
      EXPECT_NEAR(shown_s - last_s, 1 / 60.0, kRounding_s) << "frame " << i;
    }
    last_s = shown_s;
  }
}

TEST(Pacer, AHiccupCostsTheFramesItLastsAndThePersonLivesThemAll) {
  SimulatedClock clock;
  Pacer pacer(clock, 60.0, 0.0);
  Display display(1.0, 0.0);
  double lived_s = 0.0;
  int late = 0;
  for (int i = 0; i < 100; ++i) {
    const FrameTimes times = pacer.next();
    lived_s += times.step_s;
    EXPECT_NEAR(lived_s + 1 / 60.0, times.display_s, kRounding_s) << "frame " << i;
    if (i != 51) {
      EXPECT_LT(times.step_s, 1.5 / 60.0) << "frame " << i;
    }
    const double shown_s = display.show(clock, pacer, i == 50 ? 3.4 / 60.0 : 0.005, false);
    if (shown_s - times.display_s > 0.5 / 60.0) ++late;
  }
  EXPECT_EQ(late, 1);
}

TEST(Pacer, DrawingThatTakesLongerThanAPeriodTakesEverySecondTick) {
  SimulatedClock clock;
  Pacer pacer(clock, 60.0, 0.0);
  Display display(1.0, 0.0);
  for (int i = 0; i < 200; ++i) {
    const FrameTimes times = pacer.next();
    const double shown_s = display.show(clock, pacer, 0.021, false);
    if (i < 50) continue;
    EXPECT_NEAR(times.step_s, 2 / 60.0, kRounding_s) << "frame " << i;
    EXPECT_NEAR(shown_s, times.display_s, kRounding_s) << "frame " << i;
  }
}

TEST(Pacer, SwapsThatWaitAreToldFromThoseThatDoNot) {
  std::vector<double> waiting_s, immediate_s, slow_s;
  for (int i = 0; i < 12; ++i) {
    waiting_s.push_back(i < 3 ? i * 0.0001 : i / 59.94);  // the first ones only fill a queue
    immediate_s.push_back(i * 0.0004);
    slow_s.push_back(i * 0.1);
  }
  EXPECT_TRUE(swapsWaitFor(60.0, waiting_s));
  EXPECT_FALSE(swapsWaitFor(60.0, immediate_s));
  EXPECT_FALSE(swapsWaitFor(60.0, slow_s));
  EXPECT_FALSE(swapsWaitFor(60.0, {}));
}

TEST(RecordingPacer, ShowsFramesAsLongAfterEachOtherAsTheyWereThen) {
  SimulatedClock clock;
  clock.sleepUntil(5.0);
  RecordingPacer pacer(clock);
  double due_s = 5.0;
  for (const double stay_s : {0.0, 0.25, 0.0, 0.125}) {
    pacer.next();
    pacer.awaitTick(stay_s);
    EXPECT_EQ(clock.now_s(), due_s += stay_s);
  }
  clock.sleepUntil(7.0);  // drawing took long: the frame is shown at once
  EXPECT_EQ(pacer.next().number, 4u);
  pacer.awaitTick(0.25);
  EXPECT_EQ(clock.now_s(), 7.0);
}

TEST(FramePacer, NeverWaitsAndCounts) {
  FramePacer pacer;
  for (std::uint64_t number = 0; number < 3; ++number) {
    EXPECT_EQ(pacer.next().number, number);
    pacer.awaitTick(1e9);
    pacer.swapped();
  }
}

TEST(Pacer, TheSteadyClockIsWaitedFor) {
  SteadyClock clock;
  Pacer pacer(clock, 200.0, 0.0);
  pacer.next();
  pacer.awaitTick(0.0);
  pacer.swapped();
  const FrameTimes second = pacer.next();
  EXPECT_GE(clock.now_s(), second.begin_s);
}

}  // namespace
}  // namespace carom
