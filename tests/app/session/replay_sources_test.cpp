// Going to and fro in a recorded session, and visiting a recorded game: which frames come, when, and what the
// eyes in them see, against the session as it was lived and against the game as the physics plays it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <sstream>

#include "app/files/starting_histories.h"
#include "app/journal/journal.h"
#include "app/play/game.h"
#include "app/session/recorded_source.h"
#include "app/session/replay_visitor_source.h"
#include "app/temporary_folder.h"
#include "app/viewer/viewers.h"
#include "cave/record/frame_digest.h"
#include "engine/billiard/billiard.h"
#include "engine/light/light_cone.h"
#include "places.h"

namespace carom {
namespace {

using test::TemporaryFolder;

constexpr std::uint64_t kFrames = 240;
constexpr double kHz = 60.0, kPeriod_s = 1.0 / kHz;
constexpr double kSame_s = 1e-11;  // board times and light paths of seconds, in double

std::string walkText(double seconds, double speed_m_s) {
  std::ostringstream text("time_s,x_m,y_m,z_m\n", std::ios::ate);
  text.precision(17);
  for (double t_s = 0.0; t_s <= seconds; t_s += 0.01) {
    text << t_s << ',' << 0.3 * std::sin(speed_m_s * t_s / 0.3) << ",1.6," << 0.1 * std::cos(t_s) << '\n';
  }
  return text.str();
}

double latest_s(const ObserverView& observer) {
  double t_s = observer.left.observation.t_s;
  for (const EyeView& eye : observer.all()) t_s = std::max(t_s, eye.observation.t_s);
  return t_s;
}

/// Where and when the light left that each eye receives from points of all bodies.
std::vector<Event> lightOf(std::span<const WorldLine> histories, const ObserverView& observer) {
  std::vector<Event> light;
  for (const WorldLine& line : histories) {
    const double r_m = line.radius_m();
    for (const Vec3& point :
         {Vec3(0.0), Vec3(r_m, 0, 0), Vec3(-r_m, 0, 0), Vec3(0, r_m, 0), Vec3(0, -r_m, 0)}) {
      for (const EyeView& eye : observer.all()) {
        const auto emitted = emission(line, point, eye.observation, observer.headFromBoard);
        light.push_back(emitted ? emitted->event : Event{-1e300, {}});
      }
    }
  }
  return light;
}

void expectSame(const std::vector<Event>& a, const std::vector<Event>& b, double c_m_s) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_LT(std::abs(a[i].t_s - b[i].t_s), kSame_s) << "point " << i;
    ASSERT_LT(glm::distance(a[i].r_m, b[i].r_m), kSame_s * c_m_s) << "point " << i;
  }
}

template <typename T>
bool sameBits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Of all fields; what lies between them is nothing.
bool sameBits(const FrameRecord& a, const FrameRecord& b) {
  return digestOf(FrameState{a, {}, {}, {}, {}}, World{}) == digestOf(FrameState{b, {}, {}, {}, {}}, World{});
}

void expectSameGame(const World& a, const World& b) {
  ASSERT_EQ(a.histories.size(), b.histories.size());
  for (std::size_t body = 0; body < a.histories.size(); ++body) {
    const auto these = a.histories[body].knots(), those = b.histories[body].knots();
    ASSERT_EQ(these.size(), those.size()) << "body " << body;
    for (std::size_t k = 0; k < these.size(); ++k) {
      ASSERT_EQ(these[k].turn.t_s, those[k].turn.t_s) << "body " << body << " knot " << k;
      ASSERT_EQ(these[k].u, those[k].u) << "body " << body << " knot " << k;
    }
  }
  ASSERT_EQ(a.events.size(), b.events.size());
  for (std::size_t i = 0; i < a.events.size(); ++i) ASSERT_EQ(a.events[i].number, b.events[i].number);
}

/// A session of four seconds: as it was lived, and its file. Colour is on from frame 30 to 59.
class ReplaySources : public testing::Test {
 protected:
  ReplaySources()
      : rig_(rigBesideItsTrace()),
        scenario_(readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml")),
        atStart_(startingHistories(scenario_)) {
    play();
    session_ = std::make_unique<SessionFile>(folder_ / "game.db");
    Billiard billiard(scenario_.billiard);
    billiard.advanceTo(30.0);
    truth_ = atStart_;
    for (std::size_t i = 0; i < billiard.worldLines().size(); ++i) truth_[i + 1] = billiard.worldLines()[i];
  }

  Rig rigBesideItsTrace() const {
    folder_.file("walk.csv", walkText(9.0, 0.4));
    return readRig(
        folder_.file("room.toml",
                     "unit = \"m\"\naxes = \"x-right y-up z-back\"\n[head]\ntracker = \"walker\"\n"
                     "[[tracker]]\nname = \"walker\"\nkind = \"recorded\"\nsource = \"walk.csv\"\n"
                     "[[wall]]\nname = \"front\"\nlower_left = [-1, 0, -1]\nlower_right = [1, 0, -1]\n"
                     "upper_left = [-1, 2, -1]\npixels = [64, 64]\nstereo = \"mono\"\n"
                     "window = { position = [0, 0], size = [64, 64] }\n"));
  }

  void play() {
    SimulatedClock clock;
    Pacer pacer(clock, kHz, 0.0);
    Viewers person(rig_, scenario_, {});
    Game game(scenario_);
    Journal journal(
        folder_ / "game.db",
        {"carom", folder_ / "room.toml", "three-pucks.toml", "", "", scenario_.billiard.lightSpeed_m_s},
        false);
    while (lived_.size() < kFrames) {
      const FrameTimes times = pacer.next();
      FrameState& frame = lived_.emplace_back();
      frame.record.viewers[0].observer = person.at(times, 0.064)[0];
      frame.record.number = times.number;
      frame.record.display_s = times.display_s;
      frame.record.boardFromRoom = person.boardFromRoom();
      frame.record.lightSpeed_m_s = c_m_s();
      frame.record.switches.colour = times.number >= 30 && times.number < 60;
      frame.record.viewers[0].tracked = person.tracked();
      game.advance(latest_s(frame.record.viewers[0].observer), frame);
      journal.add(frame, {&person.head(), 1}, std::vector<TrackerSamples>{{0, person.samples()}});
      pacer.awaitTick(0.0);
      pacer.swapped();
    }
  }

  /// What was seen in a frame of the session, as the game was known then.
  std::vector<Event> livedLight(std::uint64_t number) const {
    World world{atStart_, {}};
    for (std::uint64_t i = 0; i <= number; ++i) applyFrame(lived_[i], world);
    return lightOf(world.histories, lived_[number].record.viewers[0].observer);
  }

  double c_m_s() const { return scenario_.billiard.lightSpeed_m_s; }

  const TemporaryFolder folder_;
  Rig rig_;
  Scenario scenario_;
  std::vector<WorldLine> atStart_;
  std::vector<FrameState> lived_;
  std::unique_ptr<SessionFile> session_;
  std::vector<WorldLine> truth_;  ///< much longer than the session
};

/// A source with an operator, and the world that its frames make.
struct Show {
  Show(FrameSource& frames, FramePacer& frameTimes, std::vector<WorldLine> atStart)
      : source(frames), pacer(frameTimes), world{std::move(atStart), {}} {}

  const FrameRecord& next() {
    const FrameTimes times = pacer.next();
    source.next(times, {commands, {}}, settings, decision);
    commands.clear();
    applyFrame(decision.frame, world);
    pacer.awaitTick(decision.stay_s);
    pacer.swapped();
    return decision.frame.record;
  }
  /// As the frame loop does with what the operator asks for.
  void command(const Command& wanted) {
    apply(wanted, settings);
    commands.push_back(wanted);
  }
  void goTo(double session_s) { command(Seek{session_s}); }

  FrameSource& source;
  FramePacer& pacer;
  World world;
  OperatorSettings settings;
  Commands commands;
  Decision decision;
  const FrameState& frame = decision.frame;
};

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
}  // namespace carom
