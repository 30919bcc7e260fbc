// The best shot, as it was seen.
#include "app/play/shot_memory.h"

#include <gtest/gtest.h>

#include <algorithm>

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

TEST(ShotReplay, EndsWithTheShotOrWhenThePersonInterruptsIt) {
  ShotMemory shots;
  shoot(shots, 10.0, 8.0, 1);
  ShotReplay replay;
  EXPECT_FALSE(replay.look(shots, 30.0, false));
  EXPECT_FALSE(replay.view(shots, 30.0));
  for (const double interrupted_s : {33.0, 1e9}) {
    replay.begin(30.0, false);
    double now_s = 30.1;
    for (; replay.look(shots, now_s, now_s > interrupted_s) && replay.isOn(); now_s += 0.1)
      ASSERT_NEAR(replay.view(shots, now_s)->shown_s, now_s - 20.0, 0.06);
    EXPECT_NEAR(now_s, std::min(interrupted_s, 34.0 + ShotMemory::kAfter_s), 0.21);
    EXPECT_FALSE(replay.view(shots, now_s)) << "the game is seen at once";
  }
}

TEST(ShotReplay, WhereItEndsAGameTheGameIsNotSeenWhileTheWallsGoDark) {
  ShotMemory shots;
  shoot(shots, 10.0, 8.0, 1);
  ShotReplay replay;
  for (const double interrupted_s : {33.0, 1e9}) {
    replay.begin(30.0, true);
    double now_s = 30.1;
    while (replay.look(shots, now_s, now_s > interrupted_s) && replay.isOn()) now_s += 0.1;
    const double over_s = now_s;
    for (; now_s < over_s + 0.9 * ShotReplay::kHeld_s; now_s += 0.1) {
      replay.look(shots, now_s, false);
      ASSERT_FALSE(replay.isOn()) << "the next game may come";
      ASSERT_TRUE(replay.view(shots, now_s)) << now_s;
      EXPECT_NEAR(replay.view(shots, now_s)->shown_s, std::min(now_s - 20.0, shots.last().shown_s), 0.06);
    }
    replay.look(shots, over_s + 1.2 * ShotReplay::kHeld_s, false);
    EXPECT_FALSE(replay.view(shots, over_s + 1.2 * ShotReplay::kHeld_s)) << "no other game has come";
  }
}

TEST(ShotReplay, ItsLastViewAloneIsShownForAMoment) {
  ShotMemory shots;
  shoot(shots, 10.0, 8.0, 1);
  ShotReplay replay;
  replay.begin(20.0, false);
  replay.beginAtEnd(30.0);
  double now_s = 30.0;
  for (; replay.look(shots, now_s, false) && replay.isOn(); now_s += 0.1)
    ASSERT_EQ(replay.view(shots, now_s), &shots.last());
  EXPECT_NEAR(now_s, 30.0 + ShotReplay::kStill_s, 0.21);
  EXPECT_FALSE(replay.view(shots, now_s));
  replay.begin(40.0, false);
  replay.look(shots, 40.1, false);
  EXPECT_NEAR(replay.view(shots, 40.1)->shown_s, 10.1, 0.06) << "the whole shot again";
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
