// The best shot, as it was seen.
#include "app/play/shot_memory.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

/// Plays a shot for so long, at 20 frames a second, that is a carom off so many cushions half way.
void shoot(ShotMemory& shots, double from_s, double for_s, std::optional<std::size_t> cushions) {
  shots.struck();
  bool isCounted = false;
  for (double now_s = from_s; now_s < from_s + for_s; now_s += 0.05) {
    ShotView view;
    view.shown_s = view.observer.properTime_s = now_s;
    shots.see(view);
    if (!cushions || isCounted || now_s < from_s + 0.5 * for_s) continue;
    isCounted = true;
    shots.carom(*cushions, now_s);
  }
}

double startOf(const ShotMemory& shots) { return shots.at(0.0)->shown_s; }

TEST(ShotMemory, AShotThatIsNoCaromIsNotKept) {
  ShotMemory shots;
  shoot(shots, 1.0, 8.0, {});
  EXPECT_FALSE(shots.hasBest());
  EXPECT_EQ(shots.at(0.0), nullptr);
}

TEST(ShotMemory, ShowsTheShotFromItsStrokeToAMomentAfterTheSecondTouch) {
  ShotMemory shots;
  shoot(shots, 10.0, 8.0, 1);
  ASSERT_TRUE(shots.hasBest());
  EXPECT_EQ(shots.bestCushions(), 1U);
  EXPECT_EQ(startOf(shots), 10.0);
  ASSERT_TRUE(shots.at(3.02));
  EXPECT_NEAR(shots.at(3.02)->shown_s, 13.0, 0.03);
  EXPECT_TRUE(shots.at(4.0 + ShotMemory::kAfter_s - 0.1));
  EXPECT_FALSE(shots.at(4.0 + ShotMemory::kAfter_s + 0.2));
}

TEST(ShotMemory, TheBestIsOffTheMostCushionsAndOfTheseTheLatest) {
  ShotMemory shots;
  shoot(shots, 10.0, 8.0, 2);
  shoot(shots, 30.0, 8.0, 1);
  EXPECT_EQ(startOf(shots), 10.0);
  shoot(shots, 50.0, 8.0, 2);
  EXPECT_EQ(startOf(shots), 50.0);
  shoot(shots, 70.0, 8.0, 3);
  EXPECT_EQ(startOf(shots), 70.0);
  EXPECT_EQ(shots.bestCushions(), 3U);
}

TEST(ShotMemory, ALongShotIsNotKeptAndNothingGrows) {
  ShotMemory shots;
  shoot(shots, 0.0, 1000.0, 5);
  EXPECT_FALSE(shots.hasBest());
}

TEST(ShotMemory, TheGameMayForgetWhatAnOldShotShowed) {
  ShotMemory shots;
  ObserverView now;
  now.properTime_s = 100.0;
  EXPECT_EQ(shots.earliest(now, 100.0).properTime_s, 100.0);
  shoot(shots, 10.0, 8.0, 0);
  EXPECT_EQ(shots.earliest(now, 100.0).properTime_s, 10.0);
  EXPECT_EQ(shots.earliest(now, 20.0 + ShotMemory::kKept_s).properTime_s, 100.0);
  EXPECT_FALSE(shots.hasBest());
}

}  // namespace
}  // namespace carom
