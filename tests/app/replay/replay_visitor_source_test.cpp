// Visiting a recorded game: what a visitor sees, against the game as the physics plays it.
#include "app/replay/replay_visitor_source.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/replay/recorded_game.h"
#include "app/replay/recorded_source.h"

namespace carom::test {
namespace {

TEST_F(ReplaySources, AVisitorSeesTheGameAsSomeoneWhoLivesThere) {
  const auto trace = folder_.file("other.csv", walkText(3.0, 0.9));
  for (const Vec3& beta : {Vec3(0.0), Vec3(0.5, -0.2, 0.0)}) {
    SimulatedClock clock, livedClock;
    ReplayVisitorSource source(rig_, scenario_, {trace, beta, false}, wholeGame(*session_, atStart_), {});
    Pacer visitPacer(clock, kHz, 0.0);
    Show show(source, visitPacer, atStart_);
    Rig rig = rig_;
    rig.trackers[0].source = trace;
    Scenario scenario = scenario_;
    scenario.observer.beta = beta;
    Viewers person(rig, scenario, {});
    Pacer pacer(livedClock, kHz, 0.0);
    std::uint64_t frames = 0;
    while (!show.frame.record.last) {
      const FrameRecord& record = show.next();
      const FrameTimes times = pacer.next();
      ASSERT_TRUE(sameBits(record.viewers[0].observer,
                           person.at(times, rig_.viewers.front().head.eyeSeparation_m)[0]))
          << "frame " << frames;
      ASSERT_EQ(record.display_s, times.display_s);
      pacer.awaitTick(0.0);
      pacer.swapped();
      expectSame(lightOf(show.world.histories, record.viewers[0].observer),
                 lightOf(truth_, record.viewers[0].observer), c_m_s());
      ++frames;
    }
    EXPECT_NEAR(static_cast<double>(frames), 3.0 * kHz, 2.0) << "as long as the trace";
  }
}

/// The room's time of the head: its own frame's, from where and when it began.
double roomTime_s(const ObserverView& view, const ObserverStart& start, double c_m_s) {
  const Vec3 beta = start.beta;
  const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(beta, beta));
  const Event& head = view.middle.observation;
  return gamma * (head.t_s - glm::dot(beta, head.r_m - start.position_m) / c_m_s);
}

TEST_F(ReplaySources, AVisitorsRoomTimeGoesAsTheOperatorWishes) {
  for (const Vec3& beta : {Vec3(0.0), Vec3(0.4, 0.3, 0.0)}) {
    SimulatedClock clock;
    Visitor visitor{{}, beta, true};
    ReplayVisitorSource source(rig_, scenario_, visitor, wholeGame(*session_, atStart_), {});
    Pacer pacer(clock, kHz, 0.0);
    Show show(source, pacer, atStart_);
    ObserverStart start = scenario_.observer;
    start.beta = beta;
    const auto now_s = [&] { return roomTime_s(show.frame.record.viewers[0].observer, start, c_m_s()); };
    const auto play = [&](int frames) {
      for (int i = 0; i < frames; ++i) {
        const FrameRecord& record = show.next();
        expectSame(lightOf(show.world.histories, record.viewers[0].observer),
                   lightOf(truth_, record.viewers[0].observer), c_m_s());
      }
    };
    play(40);
    double before_s = now_s();
    EXPECT_GT(before_s, 39 * kPeriod_s) << "who walks has more of the room's time go by than of their own";
    for (const double rate : {2.0, 0.5, -1.0}) {
      show.command(SetRate{rate});
      play(12);
      EXPECT_NEAR(now_s() - before_s, 12 * rate * kPeriod_s, 1e-12) << rate;
      EXPECT_LT(
          glm::distance(betaFromU(show.frame.record.viewers[0].observer.headFromBoard.inverse().u()), beta),
          1e-14)
          << "their own motion is not seen";
      before_s = now_s();
    }
    show.command(Pause{true});
    show.command(SetRate{1.0});
    play(9);
    EXPECT_NEAR(now_s(), before_s, 1e-12) << "paused";
    show.command(Pause{false});
    show.goTo(show.frame.record.display_s + 1.0);
    play(1);
    EXPECT_NEAR(now_s() - before_s, 1.0, 1e-12) << "a second on";
    before_s = now_s();
    show.goTo(show.frame.record.display_s - 1.0);
    play(1);
    EXPECT_NEAR(now_s() - before_s, -1.0, 1e-12) << "a second back";
    show.goTo(0.0);
    play(1);
    EXPECT_NEAR(now_s(), 0.0, 1e-12) << "the beginning";
    show.command(SetRate{-4.0});
    play(5);
    EXPECT_NEAR(now_s(), 0.0, 1e-12) << "there is nothing before it";
  }
}

TEST_F(ReplaySources, NobodySeesWhatWasNotRecorded) {
  // A trace that goes on for longer than the game: the frames end.
  const auto trace = folder_.file("long.csv", walkText(9.0, 0.4));
  SimulatedClock clock;
  ReplayVisitorSource source(rig_, scenario_, {trace, {}, false}, wholeGame(*session_, atStart_), {});
  Pacer pacer(clock, kHz, 0.0);
  Show show(source, pacer, atStart_);
  std::uint64_t frames = 0;
  for (; !show.frame.record.last; ++frames) {
    const FrameRecord& record = show.next();
    expectSame(lightOf(show.world.histories, record.viewers[0].observer),
               lightOf(truth_, record.viewers[0].observer), c_m_s());
    ASSERT_LT(frames, 9.0 * kHz);
  }
  EXPECT_GT(frames, kFrames) << "what is far is seen late";

  // Who may stay stays where it ends, and may go back.
  SimulatedClock stayingClock;
  ReplayVisitorSource staying(rig_, scenario_, {trace, {}, true}, wholeGame(*session_, atStart_), {});
  Pacer stayingPacer(stayingClock, kHz, 0.0);
  Show stay(staying, stayingPacer, atStart_);
  double end_s = 0.0;
  for (int i = 0; i < 8 * 60 - 2; ++i) {
    end_s = stay.next().viewers[0].observer.middle.observation.t_s;
    if (i % 40 == 0)
      expectSame(lightOf(stay.world.histories, stay.frame.record.viewers[0].observer),
                 lightOf(truth_, stay.frame.record.viewers[0].observer), c_m_s());
  }
  EXPECT_FALSE(stay.frame.record.last);
  EXPECT_EQ(stay.next().viewers[0].observer.middle.observation.t_s, end_s) << "time stands still";
  stay.goTo(stay.frame.record.display_s + 1.0);
  EXPECT_NEAR(stay.next().viewers[0].observer.middle.observation.t_s, end_s, 1e-12)
      << "there is nothing to go on to";
  stay.goTo(stay.frame.record.display_s - 1.0);
  EXPECT_NEAR(stay.next().viewers[0].observer.middle.observation.t_s, end_s - 1.0, 1e-12);
}

}  // namespace
}  // namespace carom::test
