// Strokes of a hand in a session that is lived, kept and read again: nothing that was seen changes, the game
// is the one that all strokes make, and a session that goes on has them.

#include "app/play/cue_interaction.h"
#include "engine/spacetime/observers.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <numbers>
#include <set>
#include <sstream>

#include "app/journal/journal.h"
#include "app/journal/session_file.h"
#include "app/replay/recorded_source.h"
#include "app/replay/replay_visitor_source.h"
#include "app/scenario/starting_histories.h"
#include "app/temporary_folder.h"
#include "app/viewer/viewers.h"
#include "cave/record/frame_digest.h"
#include "engine/light/light_cone.h"
#include "engine/random_world.h"
#include "places.h"

namespace carom {
namespace {

using test::TemporaryFolder;

constexpr double kHz = 60.0;

/// Where a light ray from each puck to each eye began.
std::vector<Event> lightOf(std::span<const WorldLine> histories, std::size_t pucks,
                           const ObserverView& observer) {
  std::vector<Event> light;
  for (std::size_t puck = 1; puck <= pucks; ++puck) {
    for (const EyeView& eye : observer.all())
      light.push_back(
          emission(histories[puck], Vec3(0.0), eye.observation, observer.headFromBoard).value().event);
  }
  return light;
}

bool same(const Event& a, const Event& b) { return a.t_s == b.t_s && a.r_m == b.r_m; }

std::size_t differences(const std::vector<Event>& a, const std::vector<Event>& b) {
  EXPECT_EQ(a.size(), b.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += !same(a[i], b[i]);
  return count;
}

bool sameKnots(const WorldLine& a, const WorldLine& b, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const Knot &k = a.knots()[i], &l = b.knots()[i];
    if (!same(k.turn, l.turn) || !same(k.signal, l.signal) || k.u != l.u || k.properTime_s != l.properTime_s)
      return false;
  }
  return true;
}

std::string walkText(double seconds) {
  std::ostringstream text("time_s,x_m,y_m,z_m\n", std::ios::ate);
  text.precision(17);
  for (double t_s = 0.0; t_s <= seconds; t_s += 0.01)
    text << t_s << ',' << 0.3 * std::sin(1.5 * t_s) << ",1.6," << 0.1 * std::cos(t_s) << '\n';
  return text.str();
}

/// A session in simulated time: the frames as LiveSource makes them, with a hand.
class Lived {
 public:
  using Hand = std::function<HandInput(std::uint64_t frame, const ObserverView&, const Game&)>;

  Lived(const TemporaryFolder& folder, const Scenario& played, const char* name)
      : folder_(folder), scenario(played), atStart(startingHistories(played)), file(folder / name) {
    folder.file("walk.csv", walkText(30.0));
    rig =
        readRig(folder.file("room.toml",
                            "unit = \"m\"\naxes = \"x-right y-up z-back\"\n[head]\ntracker = \"walker\"\n"
                            "[[tracker]]\nname = \"walker\"\nkind = \"recorded\"\nsource = \"walk.csv\"\n"
                            "[[wall]]\nname = \"front\"\nlower_left = [-1, 0, -1]\nlower_right = [1, 0, -1]\n"
                            "upper_left = [-1, 2, -1]\npixels = [64, 64]\nstereo = \"mono\"\n"
                            "window = { position = [0, 0], size = [64, 64] }\n"));
  }

  /// Goes on for so many frames, after those that the file has. The person begins again where the scenario
  /// has them.
  void live(std::uint64_t frames, const Hand& hand) {
    SimulatedClock clock;
    Pacer pacer(clock, kHz, 0.0);
    Viewers person(rig, scenario, {});
    std::vector<Stroke> struck;
    const bool goesOn = std::filesystem::exists(file);
    if (goesOn) struck = SessionFile(file).strokes(scenario.billiard.pucks);
    Game game(scenario, struck);
    CueInteraction play(scenario);
    SessionFacts facts{"carom", folder_ / "room.toml", "scenario.toml", "", "", c_m_s()};
    for (const Puck& puck : scenario.billiard.pucks) facts.pucks.push_back(puck.name);
    Journal journal(file, facts, goesOn);
    const std::uint64_t first = number_;
    for (FrameState state; number_ < first + frames; ++number_) {
      const FrameTimes times = pacer.next();
      FrameRecord& record = state.record = {};
      record.viewers[0].observer = person.at(times, 0.064)[0];
      record.boardFromRoom = person.boardFromRoom();
      record.lightSpeed_m_s = c_m_s();
      record.switches = switches;
      const CueInteraction::Outcome outcome =
          play.step(hand(number_, record.viewers[0].observer, game), still, game, record);
      if (isRinged) play.offer(0, game, record);
      if (!outcome.said.empty()) said.push_back(outcome.said.english());
      if (myNow) game.playToNowOf(record.viewers[0].observer);
      game.advance(latestObservation_s(record.viewers[0].observer), state);
      record.number = number_;
      record.display_s = static_cast<double>(number_ + 1) / kHz;
      record.views.myNow = myNow;
      std::vector<HandStroke> made;
      if (outcome.stroke) made.push_back({*outcome.stroke});
      journal.add(state, {&person.head(), 1}, std::vector<TrackerSamples>{{0, person.samples()}}, made);
      if (outcome.stroke) strokes.push_back(*outcome.stroke);
      states.push_back(state);
      pacer.awaitTick(0.0);
      pacer.swapped();
    }
  }

  double c_m_s() const { return scenario.billiard.lightSpeed_m_s; }

 private:
  const TemporaryFolder& folder_;
  std::uint64_t number_ = 0;

 public:
  const Scenario scenario;
  const std::vector<WorldLine> atStart;
  const std::filesystem::path file;
  Rig rig;
  Switches switches;
  bool myNow = true, still = false;
  bool isRinged = false;  // as for a beginner
  std::vector<Stroke> strokes;
  std::vector<std::string> said;
  std::vector<FrameState> states;
};

/// A wand that at seeded times aims at a puck where it is seen, or so far beside it, is drawn back for some
/// frames and let go.
class Player {
 public:
  Player(std::uint64_t seed, std::uint64_t every, const Vec3& aside_m = Vec3(0.0))
      : random_(seed), every_(every), aside_m_(aside_m) {}

  HandInput operator()(std::uint64_t frame, const ObserverView& observer, const Game& game) {
    HandInput hand;
    hand.device = "wand";
    hand.from_m = observer.middle.positionInRoom_m + Vec3(0.2, -0.4, -0.3);
    const std::uint64_t phase = frame % every_;
    if (phase == 0) {
      puck_ = static_cast<std::size_t>(random_.in(0.0, static_cast<double>(game.pucks().size())));
      const double angle_rad = random_.in(-std::numbers::pi, std::numbers::pi);
      pull_m_ = Vec3(std::cos(angle_rad), random_.in(-0.2, 0.2), std::sin(angle_rad)) * random_.in(0.05, 0.5);
    }
    const Vec3 seen_m = aim_.seenInRoom_m(game.pucks()[puck_], {observer, Eye::middle, Switches()});
    hand.along = glm::normalize(seen_m + aside_m_ - hand.from_m);
    hand.held = phase > 3 && phase < 10;
    if (hand.held) hand.pull_m = pull_m_ * (static_cast<double>(phase - 4) / 5.0);
    return hand;
  }

 private:
  test::Random random_;
  std::uint64_t every_;
  Vec3 aside_m_;
  std::size_t puck_ = 0;
  Vec3 pull_m_{0.0};
  RayPicking aim_;
};

Scenario passingBy() {
  Scenario scenario = readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml");
  scenario.observer.beta = {0.95, 0.0, 0.0};
  scenario.observer.position_m = {-4.0, -1.6, -0.75};
  return scenario;
}

// On a platform at 0.95 c, my-now on, with five strokes a second: the game is played seconds ahead of what is
// seen, and of that strokes take back what the light of earlier ones was to do. What each eye saw of each
// puck, with what was known then, is what it would see with all that is known in the end: to the bit.
TEST(CueInteraction, NoStrokeChangesWhatWasSeen) {
  std::size_t takenBack = 0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const TemporaryFolder folder;
    Lived lived(folder, passingBy(), "game.db");
    lived.live(400, Player(seed, 12));
    ASSERT_GT(lived.strokes.size(), 8u) << (lived.said.empty() ? "" : lived.said.front());
    SessionFile session(lived.file);
    const RecordedGame whole = wholeGame(session, lived.atStart);
    session.goTo(0);
    World world{lived.atStart, {}};
    std::size_t compared = 0;
    for (FrameState frame; session.next(frame);) {
      std::size_t before = 0, after = 0;
      for (const WorldLine& line : world.histories) before += line.knots().size();
      session.apply(frame, world);
      for (const WorldLine& line : world.histories) after += line.knots().size();
      takenBack += before + frame.knots.size() - after;
      const ObserverView& observer = frame.record.viewers[0].observer;
      const auto then = lightOf(world.histories, whole.pucks, observer);
      const auto inTheEnd = lightOf(whole.world.histories, whole.pucks, observer);
      compared += then.size();
      ASSERT_EQ(differences(then, inTheEnd), 0u) << "frame " << frame.record.number;
    }
    EXPECT_EQ(compared, 400u * 9u);
  }
  EXPECT_GT(takenBack, 10u) << "knots that had been played ahead, and carried by frames";
}

// Without friction a spin shows only of what has corners.
TEST(CueInteraction, AStrokeBesideTheMiddleTurnsWhatHasCorners) {
  Scenario scenario = readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml");
  Puck& square = scenario.billiard.pucks[1];
  const double half_m = square.radius_m / std::sqrt(2.0);
  square.outline_m = {{-half_m, -half_m}, {half_m, -half_m}, {half_m, half_m}, {-half_m, half_m}};
  square.radius_m = radiusOf_m(square.outline_m);
  int turned = 0, discs = 0;
  for (const double aside_m : {0.02, -0.02}) {
    const TemporaryFolder folder;
    Lived lived(folder, scenario, "game.db");
    lived.live(300, Player(11, 12, {aside_m, 0.0, 0.0}));
    for (const Stroke& stroke : lived.strokes) {
      EXPECT_LE(std::abs(stroke.offset_m), 0.5 * square.radius_m);
      if (stroke.puck == 1) turned += stroke.offset_m * aside_m * stroke.momentum_kg_m_s.y > 0.0 ? 1 : 0;
      if (stroke.puck == 1) continue;
      EXPECT_EQ(stroke.offset_m, 0.0);
      ++discs;
    }
  }
  EXPECT_GT(turned, 4);
  EXPECT_GT(discs, 8);
}

// The same comparison finds a stroke that acts where it was already seen not to.
TEST(CueInteraction, AStrokeFasterThanLightWouldBeFound) {
  const Scenario scenario = passingBy();
  Game game(scenario);
  World before{startingHistories(scenario), {}};
  FrameState state;
  const Observers observer =
      Observers::at({6.0, {0.3, -1.6, 0.9}}, 6.0, Lorentz(scenario.billiard.lightSpeed_m_s),
                    {{{0, 1.6, 0}, {1, 0, 0, 0}}, Vec3(0.0)});
  const ObserverView view = observer.view(0.064);
  game.advance(latestObservation_s(view), state);
  applyFrame(state, before);
  World after = before;
  const Motion seen = centreSeen(before.histories[1], view.middle.observation);
  game.strike({0, seen.event.t_s - 0.01, std::nullopt, {0.1, 0.1}});
  game.advance(latestObservation_s(view), state);
  applyFrame(state, after);
  EXPECT_GT(differences(lightOf(before.histories, 3, view), lightOf(after.histories, 3, view)), 0u);
}

// As the physics plays it that knows of all strokes from the beginning.
TEST(CueInteraction, TheGameOfTheFramesIsTheOneThatAllStrokesMake) {
  const TemporaryFolder folder;
  Lived lived(folder, passingBy(), "game.db");
  lived.live(300, Player(7, 19));
  ASSERT_GT(lived.strokes.size(), 6u);
  SessionFile session(lived.file);
  EXPECT_EQ(session.strokes(lived.scenario.billiard.pucks).size(), lived.strokes.size());
  const RecordedGame whole = wholeGame(session, lived.atStart);
  BilliardSetup setup = lived.scenario.billiard;
  setup.strokes = lived.strokes;
  Billiard truth(setup);
  truth.advanceTo(100.0);
  for (std::size_t puck = 0; puck < 3; ++puck) {
    const WorldLine& found = whole.world.histories[puck + 1];
    ASSERT_GT(found.knots().size(), 3u);
    ASSERT_LE(found.knots().size(), truth.worldLines()[puck].knots().size());
    EXPECT_TRUE(sameKnots(found, truth.worldLines()[puck], found.knots().size())) << "puck " << puck;
  }
  // Each stroke is told once, by its place in the game's list.
  std::set<std::uint32_t> told;
  for (const GameEvent& event : whole.world.events) {
    if (event.kind != EventKind::stroke) continue;
    ASSERT_LT(event.which, lived.strokes.size());
    EXPECT_TRUE(told.insert(event.which).second);
    const Stroke& stroke = lived.strokes[event.which];
    EXPECT_NEAR(event.at.t_s, stroke.at_s, 1e-12);
    EXPECT_LT(glm::distance(event.at.r_m, *stroke.from_m), 1e-12);
    ASSERT_EQ(event.turns.size(), 1u);
    EXPECT_EQ(event.turns[0].puck, stroke.puck);
    EXPECT_LT(std::abs(interval_m2(event.turns[0].event - event.at, lived.c_m_s())), 1e-9)
        << "it came with light";
  }
  EXPECT_GE(told.size() + 2, lived.strokes.size()) << "the last may not have arrived yet";
}

// A session that goes on has the strokes of the first part: every knot and event that the file has is the
// same.
TEST(CueInteraction, ASessionThatGoesOnHasItsStrokes) {
  const TemporaryFolder folder;
  Lived lived(folder, passingBy(), "game.db");
  lived.live(200, Player(5, 21));
  const std::size_t struck = lived.strokes.size();
  ASSERT_GT(struck, 4u);
  std::vector<WorldLine> first;
  std::size_t events = 0;
  {
    SessionFile session(lived.file);
    const RecordedGame game = wholeGame(session, lived.atStart);
    first = game.world.histories;
    events = game.world.events.size();
  }
  lived.live(200, Player(6, 27));
  EXPECT_GT(lived.strokes.size(), struck);
  SessionFile session(lived.file);
  World world{lived.atStart, {}};
  FrameState frame;
  for (int i = 0; i <= 200; ++i) {
    ASSERT_TRUE(session.next(frame));
    session.apply(frame, world);
  }
  // The first frame of the second part has brought all of the game anew, as far as is seen there.
  EXPECT_EQ(frame.record.truncateFrom_s, 0.0);
  std::size_t again = 0;
  for (std::size_t puck = 1; puck <= 3; ++puck) {
    const std::size_t both = std::min(first[puck].knots().size(), world.histories[puck].knots().size());
    again += both;
    EXPECT_TRUE(sameKnots(world.histories[puck], first[puck], both)) << "puck " << puck;
  }
  EXPECT_GT(again, 3u);
  // And in the end the game is that of all strokes of both parts.
  const RecordedGame whole = wholeGame(session, lived.atStart);
  EXPECT_GE(whole.world.events.size(), events / 2);
  BilliardSetup setup = lived.scenario.billiard;
  setup.strokes = session.strokes(setup.pucks);
  ASSERT_EQ(setup.strokes.size(), lived.strokes.size());
  Billiard truth(setup);
  truth.advanceTo(100.0);
  for (std::size_t puck = 0; puck < 3; ++puck) {
    const WorldLine& found = whole.world.histories[puck + 1];
    ASSERT_LE(found.knots().size(), truth.worldLines()[puck].knots().size());
    EXPECT_TRUE(sameKnots(found, truth.worldLines()[puck], found.knots().size())) << "puck " << puck;
  }
}

// A recording with strokes, left alone and looked at by somebody else.
TEST(CueInteraction, ARecordingWithStrokesIsSeenAgain) {
  const TemporaryFolder folder;
  Lived lived(folder, passingBy(), "game.db");
  lived.live(240, Player(8, 20));
  ASSERT_GT(lived.strokes.size(), 5u);
  SessionFile session(lived.file);
  SimulatedClock clock;
  RecordedSource source(session, lived.atStart, kHz);
  RecordingPacer pacer(clock);
  World world{lived.atStart, {}}, known = world;
  OperatorSettings settings;
  Decision decision;
  FrameState& frame = decision.frame;
  for (const FrameState& then : lived.states) {
    applyFrame(then, known);
    source.next(pacer.next(), {}, settings, decision);
    applyFrame(frame, world);
    pacer.awaitTick(decision.stay_s);
    frame.record.last = 0;
    ASSERT_EQ(digestOf(frame, world), digestOf(then, known)) << "frame " << then.record.number;
  }
  SimulatedClock visitClock;
  Scenario standing = lived.scenario;
  standing.observer = {};
  const RecordedGame whole = wholeGame(session, lived.atStart);
  ReplayVisitorSource visit(lived.rig, standing, {{}, Vec3(0.2, 0.1, 0.0), true},
                            wholeGame(session, lived.atStart), {});
  Pacer visitPacer(visitClock, kHz, 0.0);
  world = {lived.atStart, {}};
  for (int i = 0; i < 120; ++i) {
    visit.next(visitPacer.next(), {}, settings, decision);
    applyFrame(frame, world);
    visitPacer.awaitTick(0.0);
    visitPacer.swapped();
    EXPECT_EQ(differences(lightOf(world.histories, 3, frame.record.viewers[0].observer),
                          lightOf(whole.world.histories, 3, frame.record.viewers[0].observer)),
              0u);
  }
}

TEST(CueInteraction, ARecordingSaysThatItCannotBeChanged) {
  const TemporaryFolder folder;
  Lived lived(folder, passingBy(), "game.db");
  lived.live(300, Player(8, 20));
  SessionFile session(lived.file), visited(lived.file);
  SimulatedClock clock, visitClock;
  RecordedSource source(session, lived.atStart, kHz);
  RecordingPacer pacer(clock);
  ReplayVisitorSource visit(lived.rig, lived.scenario, {}, wholeGame(visited, lived.atStart), {});
  Pacer visitPacer(visitClock, kHz, 0.0);
  DeskInput desk, away;
  desk.mouse.emplace();
  desk.mouseHeld = true;
  away.mouseHeld = true;
  using Frames = std::pair<FrameSource*, FramePacer*>;
  for (const auto& [frames, times] : {Frames{&source, &pacer}, Frames{&visit, &visitPacer}}) {
    OperatorSettings settings;
    Decision decision;
    const FrameState& frame = decision.frame;
    const auto said = [&, from = frames, paced = times](const DeskInput& input) {
      from->next(paced->next(), {{}, input}, settings, decision);
      paced->awaitTick(decision.stay_s);
      paced->swapped();
      return std::string(frame.record.viewers[0].notice.words());
    };
    EXPECT_EQ(said({}), "");
    EXPECT_EQ(said(away), "") << "over no wall";
    const std::string words = "A recording cannot be changed: strokes and drive need a live game";
    testing::internal::CaptureStderr();
    int shown = 0;
    for (int i = 0; i < 270 && !frame.record.last; ++i) shown += said(desk) == words;
    EXPECT_NEAR(shown, kNoticeShown_s * kHz, 2.0);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), words + "\n") << "once";
  }
}

/// A person at rest before the table, from where no puck moves.
Scenario stillGame() {
  Scenario scenario = readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml");
  for (Puck& puck : scenario.billiard.pucks) puck.beta = Vec2(0.0);
  return scenario;
}

/// A wand that points at a puck and is pressed in frames 130 to 134 with this pull.
Lived::Hand pulled(std::size_t puck, const Vec3& pull_m, bool away = false) {
  return [=](std::uint64_t frame, const ObserverView& observer, const Game& game) {
    RayPicking aim;
    HandInput hand;
    hand.device = "wand";
    hand.from_m = {0.2, 1.2, -0.3};
    const Vec3 seen_m = aim.seenInRoom_m(game.pucks()[puck], {observer, Eye::middle, Switches()});
    hand.along = glm::normalize(away ? hand.from_m - seen_m : seen_m - hand.from_m);
    hand.held = frame >= 130 && frame < 135;
    if (hand.held) hand.pull_m = pull_m;
    return hand;
  };
}

TEST(CueInteraction, AStrokeGivesItsMomentumWhenItsLightArrivesAndSaysSo) {
  const TemporaryFolder folder;
  Lived lived(folder, stillGame(), "game.db");
  lived.live(240, pulled(2, {0.0, 0.0, 0.12}));  // back: the stroke goes forward, the board's +y
  ASSERT_EQ(lived.strokes.size(), 1u);
  const Stroke& stroke = lived.strokes[0];
  const double u = 0.12 / kPullForOne_m;
  EXPECT_EQ(stroke.puck, 2u);
  EXPECT_NEAR(stroke.momentum_kg_m_s.x, 0.0, 1e-15);
  EXPECT_NEAR(stroke.momentum_kg_m_s.y, 0.2 * 1.42 * u, 1e-15);
  // The room stands on the board: its origin at (0, −1.6, −0.75), its −z along +y.
  EXPECT_LT(glm::distance(*stroke.from_m, Vec3(0.2, -1.6 + 0.3, -0.75 + 1.2)), 1e-12);
  EXPECT_EQ(stroke.at_s, lived.states[135].record.viewers[0].observer.middle.observation.t_s);
  const double light_s = glm::distance(*stroke.from_m, Vec3(0.48, -0.017, 0.01)) / 1.42;
  SessionFile session(lived.file);
  const RecordedGame whole = wholeGame(session, lived.atStart);
  const Knot& turned = whole.world.histories[3].knots()[1];
  EXPECT_NEAR(turned.turn.t_s, stroke.at_s + light_s, 1e-12);
  EXPECT_NEAR(turned.u.y, u, 1e-14);
  // Where the head will be if it moves on as it does now: found by steps of its own way.
  const ObserverView& observer = lived.states[135].record.viewers[0].observer;
  const Vec3 velocity_m_s = 1.42 * betaFromU(observer.headFromBoard.inverse().u());
  double back_s = 0.0;
  for (int step = 0; step < 200; ++step) {
    const Vec3 head_m = observer.middle.observation.r_m + velocity_m_s * (light_s + back_s);
    back_s = glm::distance(head_m, Vec3(0.48, -0.017, 0.01)) / 1.42;
  }
  ASSERT_EQ(lived.said.size(), 1u);
  EXPECT_EQ(lived.said[0],
            fmt::format("Your stroke runs to red at the speed of light: {:.1f} s there, {:.1f} s back",
                        light_s, back_s));
  EXPECT_LT(lived.said[0].size(), Notice().english.text.size());
  // What the room shows: aimed, held, drawn back, let go.
  const auto handAt = [&](std::size_t frame) { return lived.states[frame].record.viewers[0].hand; };
  EXPECT_EQ(handAt(129).target, 3u);
  EXPECT_EQ(handAt(129).pulling, 0);
  EXPECT_EQ(handAt(132).pulling, 1);
  EXPECT_NEAR(handAt(132).u, u, 1e-15);
  EXPECT_LT(glm::distance(handAt(132).towards, Vec3(0, 0, -1)), 1e-15);
  EXPECT_EQ(handAt(132).to_m, handAt(132).target_m);
  EXPECT_EQ(handAt(135).pulling, 0);
  EXPECT_EQ(handAt(135).u, 0.0);
}

// Beside all pucks; a beginner is told of the ring that they see.
TEST(CueInteraction, ARingIsSpokenOfWhereThereIsOne) {
  const TemporaryFolder folder;
  for (const bool isRinged : {false, true}) {
    Lived lived(folder, stillGame(), isRinged ? "ringed.db" : "plain.db");
    lived.isRinged = isRinged;
    lived.live(10, [](std::uint64_t frame, const ObserverView&, const Game&) {
      return HandInput{"mouse", {0, 1.6, 0}, {0, 1, 0}, Eye::middle, frame > 5, Vec3(0.0)};
    });
    EXPECT_EQ(lived.said, std::vector<std::string>{isRinged ? "Point at the ringed puck, then drag back"
                                                            : "Point at a puck, then drag back"});
  }
}

TEST(CueInteraction, WhatCannotBeStruckIsSaidAndTheSessionGoesOn) {
  const TemporaryFolder folder;
  int files = 0;
  const auto saidOf = [&](Scenario scenario, const Lived::Hand& hand, bool still = false) {
    Lived lived(folder, scenario, (std::to_string(files++) + ".db").c_str());
    lived.still = still;
    lived.live(140, hand);
    EXPECT_EQ(lived.strokes.size(), 0u);
    EXPECT_EQ(lived.said.size(), 1u);
    return lived.said.empty() ? "" : lived.said.front();
  };
  EXPECT_EQ(saidOf(stillGame(), pulled(1, {0, 0, 0.01})), "Let go: no stroke");
  EXPECT_EQ(saidOf(stillGame(), pulled(1, {0, 0.3, 0})), "Let go: no stroke");
  EXPECT_EQ(saidOf(stillGame(), pulled(1, {0, 0, 0.2}, true)),
            "The puck is behind your hand: point the other way");
  EXPECT_EQ(saidOf(stillGame(), pulled(1, {0, 0, 0.2}), true),
            "Nothing can be struck while time stands still");
  EXPECT_EQ(saidOf(stillGame(),
                   [](std::uint64_t frame, const ObserverView&, const Game&) {
                     return HandInput{"mouse", {0, 1.6, 0}, {0, 1, 0}, Eye::middle, frame > 5, Vec3(0.0)};
                   }),
            "Point at a puck, then drag back");
  EXPECT_EQ(saidOf(stillGame(),
                   [](std::uint64_t frame, const ObserverView&, const Game&) {
                     HandInput hand;
                     if (frame == 9) hand.refused = texts::message::kCueTaken[0];
                     return hand;
                   }),
            "The cue is in the wand's hand");
  Scenario empty = stillGame();
  empty.billiard.pucks.clear();
  empty.puckMeshes.clear();
  EXPECT_EQ(
      saidOf(empty,
             [](std::uint64_t frame, const ObserverView&, const Game&) {
               return HandInput{"mouse", {0, 1.6, 0}, {0, -0.6, -0.8}, Eye::middle, frame > 5, Vec3(0.0)};
             }),
      "Point at a puck, then drag back");
  // At 0.95 c a hand before the head is earlier on the board: at first, before the game began.
  Scenario early = passingBy();
  early.observer.facing_rad = std::numbers::pi;
  const Lived::Hand atOnce = [](std::uint64_t frame, const ObserverView& observer, const Game& game) {
    RayPicking aim;
    HandInput hand;
    hand.device = "wand";
    hand.from_m = observer.middle.positionInRoom_m + Vec3(0.0, -0.2, -1.0);
    hand.along =
        glm::normalize(aim.seenInRoom_m(game.pucks()[1], {observer, Eye::middle, Switches()}) - hand.from_m);
    hand.held = frame < 4;
    hand.pull_m = {0.2, 0.0, 0.0};
    return hand;
  };
  EXPECT_EQ(saidOf(early, atOnce), "No stroke: where your hand is, the game has not begun yet");
}

// The hand acts where no eye has received light from it yet, however the head moves in the room.
TEST(CueInteraction, NoEyeHasSeenWhatAHandDoes) {
  test::Random random(12);
  int atOnce = 0;
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const double c_m_s = 1.42;
    const Lorentz boardFromRoom = Lorentz::boost(random.u(0.95), c_m_s);
    const Head head{{random.inBox(1.0), {1.0, 0.0, 0.0, 0.0}}, random.inBall(10.0)};
    const Observers observer = Observers::at({10.0, random.inBox(2.0)}, 10.0, boardFromRoom, head);
    const ObserverView view = observer.view(0.08);
    const bool atEye = i % 2 == 0;
    const Vec3 hand_m = atEye ? view.of(i % 4 == 0 ? Eye::left : Eye::right).positionInRoom_m
                              : head.roomFromHead.position_m + random.inBox(0.8);
    FrameRecord record;
    record.viewers[0].observer = view;
    record.boardFromRoom = boardFromRoom;
    const Event hand = handEvent(hand_m, record);
    for (const EyeView& eye : view.all()) {
      const double inside_m =
          c_m_s * (eye.observation.t_s - hand.t_s) - glm::distance(eye.observation.r_m, hand.r_m);
      EXPECT_LT(inside_m, 1e-12) << "seed 12, case " << i;
    }
    const double late_s =
        hand.t_s -
        (view.middle.observation + boardFromRoom * Displacement{0.0, hand_m - head.roomFromHead.position_m})
            .t_s;
    EXPECT_GE(late_s, 0.0);
    // An eye is 4 cm from the head, so that far times γ in the room, and up to that times u/c later there.
    const double u = glm::length(head.celerity_m_s) / c_m_s;
    if (glm::distance(hand_m, head.roomFromHead.position_m) > 0.04 * (std::hypot(1.0, u) + u)) {
      EXPECT_EQ(late_s, 0.0) << "seed 12, case " << i;
      ++atOnce;
    }
  }
  EXPECT_GT(atOnce, 500);
}

// The paper's angles between pucks of one mass, the struck one at rest (design: tan θ1 tan θ2 = 2/(γ + 1)),
// from the rows of a session that a hand has played: rounding is all that they differ by.
TEST(CueInteraction, AnglesOfASessionsTurnsAreThoseOfTheFormula) {
  const TemporaryFolder folder;
  int files = 0;
  for (const double u : {0.2, 0.5, 1.0, 2.0, 3.0}) {
    for (const double offset : {0.15, 0.5, 0.85}) {
      SCOPED_TRACE(testing::Message() << "u = " << u << ", b/2R = " << offset);
      Scenario scenario = stillGame();
      scenario.billiard.board.reset();
      std::vector<Puck>& pucks = scenario.billiard.pucks;
      pucks.resize(2);
      scenario.puckMeshes.resize(2);
      pucks[0].position_m = {-0.3, 0.0};
      pucks[1].position_m = {0.1, offset * 2.0 * pucks[1].radius_m};
      Lived lived(folder, scenario, (std::to_string(files++) + ".db").c_str());
      // To the left: the stroke goes to the right, the board's +x. Slow pucks take a while.
      lived.live(400, pulled(0, {-u * kPullForOne_m, 0.0, 0.0}));
      ASSERT_EQ(lived.strokes.size(), 1u);
      SQLite::Database database(lived.file.string());
      SQLite::Statement row(
          database,
          "SELECT puck, beta_before_x, beta_before_y, beta_after_x, beta_after_y FROM turn JOIN "
          "event ON turn.event = event.number WHERE kind = 'puck-puck' ORDER BY puck");
      const auto next = [&] {
        EXPECT_TRUE(row.executeStep());
        const auto value = [&](int column) { return row.getColumn(column).getDouble(); };
        return std::pair(Vec2(value(1), value(2)), Vec2(value(3), value(4)));
      };
      const auto [whiteBefore, whiteAfter] = next();
      const auto [yellowBefore, yellowAfter] = next();
      EXPECT_FALSE(row.executeStep()) << "they meet once";
      EXPECT_EQ(yellowBefore, Vec2(0.0));
      EXPECT_NEAR(glm::length(whiteBefore), u / std::hypot(1.0, u), 1e-14);
      const auto tanTo = [&](const Vec2& beta) {
        const double along = glm::dot(beta, whiteBefore);
        const double across = beta.x * whiteBefore.y - beta.y * whiteBefore.x;
        return std::abs(across / along);
      };
      const double gamma = std::hypot(1.0, u), tan1 = tanTo(whiteAfter), tan2 = tanTo(yellowAfter);
      constexpr double kRounding = 1e-10;  // of places and momenta of order 1, some hundred operations
      EXPECT_NEAR(tan1 * tan2 * (gamma + 1.0) / 2.0, 1.0, kRounding);
      // Each for itself, with sin ψ = b/2R.
      const double tanPsi = offset / std::sqrt(1.0 - offset * offset);
      EXPECT_NEAR(tan1 * tanPsi, 1.0, kRounding);
      EXPECT_NEAR(tan2 / (2.0 * tanPsi / (gamma + 1.0)), 1.0, kRounding);
    }
  }
}

}  // namespace
}  // namespace carom
