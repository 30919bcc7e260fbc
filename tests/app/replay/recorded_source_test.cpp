// Going to and fro in a recorded session: which frames come, when, and what the eyes in them see, against the
// session as it was lived.
#include "app/replay/recorded_source.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "app/replay/recorded_game.h"

namespace carom::test {
namespace {

TEST_F(ReplaySources, LeftAloneEveryFrameComesAsItWasAtItsTime) {
  SimulatedClock clock;
  RecordedSource source(*session_, atStart_, kHz);
  RecordingPacer pacer(clock);
  Show show(source, pacer, atStart_);
  for (std::uint64_t number = 0; number < kFrames; ++number) {
    FrameRecord record = show.next();
    EXPECT_EQ(record.last, number + 1 == kFrames ? 1u : 0u);
    record.last = 0;
    ASSERT_TRUE(sameBits(record, lived_[number].record)) << "frame " << number;
    ASSERT_EQ(show.frame.knots.size(), lived_[number].knots.size()) << "no more is known than was then";
    EXPECT_NEAR(clock.now_s(), static_cast<double>(number) * kPeriod_s, 1e-9);
  }
}

TEST_F(ReplaySources, BegunInTheMiddleEveryFrameComesAsItWasAtItsTime) {
  constexpr std::uint64_t kFrom = 100;
  World known{atStart_, {}};
  session_->goTo(0);
  FrameState recorded;
  for (std::uint64_t number = 0; number < kFrom && session_->next(recorded); ++number)
    session_->apply(recorded, known);
  SimulatedClock clock;
  RecordingPacer pacer(clock);
  SessionFile again(folder_ / "game.db");
  RecordedSource source(again, atStart_, kHz, lived_[kFrom].record.display_s);
  Show seen(source, pacer, atStart_);
  for (std::uint64_t number = kFrom; number < kFrames; ++number) {
    ASSERT_TRUE(session_->next(recorded));
    session_->apply(recorded, known);
    const FrameRecord& record = seen.next();
    ASSERT_EQ(record.number, number);
    EXPECT_EQ(record.last, number + 1 == kFrames ? 1u : 0u);
    ASSERT_TRUE(sameBits(record.viewers[0].observer, lived_[number].record.viewers[0].observer))
        << "frame " << number;
    expectSameGame(seen.world, known);
  }
}

TEST_F(ReplaySources, TheGameIsReadFromTheFramesThatChangeIt) {
  World game{atStart_, {}};
  std::size_t changing = 0, read = 0;
  FrameState frame;
  for (session_->goTo(0); session_->next(frame);) {
    session_->apply(frame, game);
    changing += frame.knots.empty() && frame.events.empty() ? 0 : 1;
  }
  for (session_->goToChanges(); session_->next(frame); ++read)
    EXPECT_FALSE(frame.knots.empty() && frame.events.empty()) << "frame " << frame.record.number;
  EXPECT_EQ(read, changing);
  EXPECT_GT(read, 3u);
  EXPECT_LT(read, kFrames / 4) << "the other frames are not read";
  expectSameGame(wholeGame(*session_, atStart_).world, game);
}

TEST_F(ReplaySources, GoneThroughToAndFroTheRightFramesComeAndSeeTheSame) {
  SimulatedClock clock;
  RecordedSource source(*session_, atStart_, kHz);
  RecordingPacer pacer(clock);
  Show show(source, pacer, atStart_);
  struct Step {
    const char* what;
    std::function<void(Show&)> act;
    std::vector<std::uint64_t> frames;
    double periods;  // of the display, from frame to frame
  };
  const auto rate = [](double value) { return [value](Show& s) { s.command(SetRate{value}); }; };
  const auto pause = [](Show& s) { s.command(Pause{!s.settings.playback.paused}); };
  const auto jump = [](double session_s) { return [session_s](Show& s) { s.goTo(session_s); }; };
  const double first_s = lived_[0].record.display_s;
  EXPECT_EQ(source.status().span_s, std::pair(first_s, lived_[kFrames - 1].record.display_s));
  const std::vector<Step> steps{
      {"from the beginning", rate(1.0), {0, 1, 2, 3, 4, 5}, 1.0},
      {"paused", pause, {5, 5, 5}, 1.0},
      {"and on", pause, {6, 7, 8}, 1.0},
      {"on to 2 s", jump(first_s + 120.4 * kPeriod_s), {120, 121, 122}, 1.0},
      {"half as fast", rate(0.5), {123, 124, 125, 126}, 2.0},
      {"twice as fast", rate(2.0), {128, 130, 132}, 1.0},
      {"backwards", rate(-1.0), {131, 130, 129, 128}, 1.0},
      {"four times, backwards", rate(-4.0), {124, 120, 116}, 1.0},
      {"as it was lived", rate(1.0), {117, 118}, 1.0},
      {"paused there", pause, {118, 118}, 1.0},
      {"elsewhere, and paused", jump(first_s + 10.4 * kPeriod_s), {10, 10}, 1.0},
      {"before the beginning", jump(-3.0), {0, 0}, 1.0},
      {"on, backwards at the beginning",
       [](Show& s) {
         s.command(Pause{false});
         s.command(SetRate{-2.0});
       },
       {0, 0},
       1.0},
      {"after the end", jump(1e6), {239}, 1.0},
      {"backwards from the end", rate(-2.0), {237, 235, 233}, 1.0},
      {"to the end", rate(16.0), {239, 239, 239}, 1.0},
      {"where the last stays", rate(1.0), {239, 239}, 1.0},
      {"and back", jump(first_s + 100.4 * kPeriod_s), {100, 101}, 1.0},
  };
  const std::size_t all =
      wholeGame(*std::make_unique<SessionFile>(folder_ / "game.db"), atStart_).news.knots.size();
  ASSERT_GT(all, 6u) << "a game with bounces";
  bool left = false;
  for (const Step& step : steps) {
    SCOPED_TRACE(step.what);
    step.act(show);
    left = left || std::string(step.what) == "on to 2 s";
    bool first = true;
    for (const std::uint64_t number : step.frames) {
      const double before_s = clock.now_s();
      const FrameRecord& record = show.next();
      ASSERT_EQ(record.number, number);
      EXPECT_EQ(record.last, 0u);
      ASSERT_TRUE(sameBits(record.viewers[0].observer, lived_[number].record.viewers[0].observer))
          << "frame " << number;
      EXPECT_EQ(record.switches, lived_[number].record.switches);
      expectSame(lightOf(show.world.histories, record.viewers[0].observer), livedLight(number), c_m_s());
      if (!first) {
        EXPECT_NEAR(clock.now_s() - before_s, step.periods * kPeriod_s, 1e-9) << "frame " << number;
      }
      EXPECT_LE(clock.now_s() - before_s, 2.0 * kPeriod_s + 1e-9) << "nobody waits for a jump";
      first = false;
      std::size_t known = 0;
      for (std::size_t i = 0; i < atStart_.size(); ++i) {
        known += show.world.histories[i].knots().size() - atStart_[i].knots().size();
      }
      if (left) {
        EXPECT_EQ(known, all) << "frame " << number << ": the histories are whole";
      }
    }
  }
}

TEST_F(ReplaySources, WhatTheOperatorTurnsStaysAndTheRestIsAsItWas) {
  SimulatedClock clock;
  RecordedSource source(*session_, atStart_, kHz);
  RecordingPacer pacer(clock);
  Show show(source, pacer, atStart_);
  for (std::uint64_t number = 0; number < 80; ++number) {
    if (number == 40) show.command(SetSwitch{&Switches::colour, false, false});  // it is on
    if (number == 50) show.command(SetView{&TimeViews::paths, true});
    const FrameRecord& record = show.next();
    const bool lived = lived_[number].record.switches.colour != 0;
    EXPECT_EQ(record.switches.colour != 0, number < 40 && lived) << "frame " << number;
    EXPECT_EQ(record.switches.aberration, 1) << "frame " << number;
    EXPECT_EQ(record.views.paths != 0, number >= 50) << "frame " << number;
  }
}

TEST_F(ReplaySources, AFrozenSightIsWalkedRoundAndEachFreezingTakesItsOwn) {
  SimulatedClock clock;
  RecordedSource source(*session_, atStart_, kHz);
  RecordingPacer pacer(clock);
  Show show(source, pacer, atStart_);
  for (const std::uint64_t begin : {10, 30}) {
    while (show.next().number + 1 < begin) {
    }
    show.command(SetView{&TimeViews::frozen, true});
    for (std::uint64_t number = begin; number < begin + 8; ++number) {
      const FrameRecord& record = show.next();
      ASSERT_EQ(record.number, number);
      for (const EyeView& eye : record.viewers[0].observer.all()) {
        EXPECT_EQ(eye.observation.t_s, lived_[begin].record.viewers[0].observer.middle.observation.t_s);
      }
      EXPECT_EQ(record.viewers[0].observer.left.positionInRoom_m,
                lived_[number].record.viewers[0].observer.left.positionInRoom_m);
    }
    show.command(SetView{&TimeViews::frozen, false});
    const FrameRecord& record = show.next();
    EXPECT_TRUE(sameBits(record.viewers[0].observer, lived_[record.number].record.viewers[0].observer));
  }
}

}  // namespace
}  // namespace carom::test
