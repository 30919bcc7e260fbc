#include "devices/tracker/standing_clock.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

TEST(StandingClock, NewsUnderTheSameTimeShowThatItStands) {
  StandingClock clock;
  for (int pose = 0; pose < 7; ++pose) clock.see(true, true);
  EXPECT_FALSE(clock.stands());
  clock.see(true, true);
  EXPECT_TRUE(clock.stands());
  for (int pose = 0; pose < 7; ++pose) clock.see(false, true);
  EXPECT_TRUE(clock.stands()) << "as much against it as for it is needed";
  for (int pose = 0; pose < 9; ++pose) clock.see(false, true);
  EXPECT_FALSE(clock.stands());
}

TEST(StandingClock, OneMeasurementSentManyTimesShowsNothing) {
  StandingClock clock;
  for (int pose = 0; pose < 1000; ++pose) clock.see(pose % 4 != 0, pose % 4 == 0);
  EXPECT_FALSE(clock.stands());
}

// One in eight of a clock's poses advances it.
TEST(StandingClock, ACoarseClockStands) {
  StandingClock clock;
  for (int pose = 0; pose < 100; ++pose) clock.see(pose % 8 != 0, true);
  EXPECT_TRUE(clock.stands());
}

}  // namespace
}  // namespace carom
