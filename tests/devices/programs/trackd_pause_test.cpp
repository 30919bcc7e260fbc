#include "devices/programs/trackd_pause.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace carom {
namespace {

using namespace std::chrono_literals;
using Clock = TrackdPause::Clock;
using std::chrono::microseconds;

/// What a daemon's memory holds: the count of the pose in its first and in its last number, and its time.
struct Memory {
  int first = 0, last = 0, time = 0;
};

/// A daemon with a period, a pause in the midst of each pose, and its time before or after the numbers.
struct Daemon {
  microseconds period, pause;
  bool timeFirst;

  Memory at(microseconds now) const {
    const auto count = static_cast<int>(now / period);
    const bool isHalf = now % period < pause;
    return {count, isHalf ? count - 1 : count, isHalf && !timeFirst ? count - 1 : count};
  }
};

/// Looks at the daemon at random times; returns what was learned. `stall`: in one pose, it pauses for as
/// long.
TrackdPause learned(const Daemon& daemon, microseconds looks, int poses, std::mt19937& random,
                    microseconds stall = 0us) {
  TrackdPause pause;
  std::uniform_int_distribution<int> step(static_cast<int>(looks.count()) / 2,
                                          static_cast<int>(looks.count()) * 3 / 2);
  Memory before = daemon.at(daemon.period);
  for (microseconds now = daemon.period; now < poses * daemon.period; now += microseconds(step(random))) {
    Daemon seen = daemon;
    if (now / daemon.period == poses / 2) seen.pause = std::max(seen.pause, stall);
    const Memory memory = seen.at(now);
    const bool isLater = memory.time != before.time;
    if (isLater || memory.first != before.first || memory.last != before.last)
      pause.changed(isLater, Clock::time_point(now));
    before = memory;
  }
  return pause;
}

TEST(TrackdPause, IsLearnedWhicheverIsWrittenFirst) {
  constexpr unsigned kSeed = 42;
  std::mt19937 random(kSeed);
  for (int test = 0; test < 200; ++test) {
    const microseconds period(std::uniform_int_distribution<int>(1000, 16000)(random));
    const microseconds most = std::min<microseconds>(period * 2 / 5, 1200us);
    const microseconds pause(std::uniform_int_distribution<int>(200, static_cast<int>(most.count()))(random));
    for (const bool timeFirst : {false, true}) {
      const TrackdPause known = learned({period, pause, timeFirst}, 100us, 18, random);
      EXPECT_TRUE(known.isKnown());
      EXPECT_GT(known.settle(), pause) << "seed " << kSeed << ", test " << test << ", a pose every "
                                       << period.count() << " us, pause " << pause.count() << " us";
      EXPECT_LE(known.settle(), std::max<Clock::duration>(TrackdPause::kLeast, pause * 3 / 2 + 400us));
    }
  }
}

TEST(TrackdPause, ADaemonThatDoesNotPauseIsNotWaitedFor) {
  std::mt19937 random(1);
  EXPECT_EQ(learned({4000us, 0us, true}, 300us, 100, random).settle(), TrackdPause::kLeast);
  EXPECT_EQ(TrackdPause().settle(), TrackdPause::kLeast);
}

TEST(TrackdPause, OneStallDoesNotCount) {
  std::mt19937 random(2);
  const TrackdPause known = learned({4000us, 0us, false}, 100us, 60, random, 1500us);
  EXPECT_EQ(known.settle(), TrackdPause::kLeast);
}

// Two poses in quick succession, each with its time, are no pose with a pause.
TEST(TrackdPause, BurstsAreNoPauses) {
  TrackdPause pause;
  auto now = Clock::time_point(1s);
  for (int i = 0; i < 40; ++i) pause.changed(true, now += i % 2 == 0 ? 1ms : 9ms);
  EXPECT_EQ(pause.settle(), TrackdPause::kLeast);
  // Without any times nothing tells the poses apart.
  TrackdPause timeless;
  for (int i = 0; i < 40; ++i) timeless.changed(false, now += 4ms);
  EXPECT_TRUE(timeless.isKnown());
  EXPECT_EQ(timeless.settle(), TrackdPause::kLeast);
}

}  // namespace
}  // namespace carom
