// A session as the frame loop plays it, with a mouse that shoots: what its file says afterwards.

#include "app/live/live_source.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <sstream>

#include "app/journal/session_file.h"
#include "app/operator/visitor_choices.h"
#include "app/replay/recorded_source.h"
#include "app/scenario/starting_histories.h"
#include "app/session/session_listeners.h"
#include "app/temporary_folder.h"
#include "cave/overlay/wall_buttons.h"
#include "engine/light/light_cone.h"
#include "engine/random_world.h"
#include "places.h"

namespace carom {
namespace {

using test::TemporaryFolder;

/// A mouse over a wall a metre away that at seeded times aims at a puck as the frame before showed it, draws
/// it back along the cloth for some frames and lets go.
class Mouse {
 public:
  static constexpr std::uint64_t kEvery = 9, kPress = 2, kLetGo = 7;  // frames

  explicit Mouse(std::uint64_t seed) : random_(seed) {}

  DeskInput operator()(const FrameRecord& before, std::span<const WorldLine> histories) {
    const std::uint64_t phase = frame_++ % kEvery;
    if (phase == 0) {
      puck_ = 1 + static_cast<std::size_t>(random_.in(0.0, 3.0));
      const double angle_rad = random_.in(-std::numbers::pi, std::numbers::pi);
      pull_m_ = Vec3(std::cos(angle_rad), 0.0, std::sin(angle_rad)) * random_.in(0.05, 0.6);
    }
    const EyeView& eye = before.viewers[0].observer.middle;
    if (phase <= kPress) {
      along_ =
          aim_.seenInRoom_m(histories[puck_], {before.viewers[0].observer, Eye::middle, before.switches}) -
          eye.positionInRoom_m;
    } else {
      const double toCloth = -eye.observation.r_m.z / along_.y;  // the room stands upright
      along_ += pull_m_ / toCloth / static_cast<double>(kLetGo - kPress - 1);
    }
    DeskInput desk;
    desk.mouse = PointedWall{eye.positionInRoom_m + glm::normalize(along_), Eye::middle};
    desk.mouseHeld = phase >= kPress && phase < kLetGo;
    return desk;
  }

 private:
  test::Random random_;
  std::uint64_t frame_ = 0;
  std::size_t puck_ = 1;
  Vec3 pull_m_{0.0}, along_{0.0, -1.0, 0.0};
  RayPicking aim_;
};

class LiveSession : public testing::Test {
 protected:
  LiveSession() : scenario_(passingBy()), atStart_(startingHistories(scenario_)) {
    std::ostringstream walk("time_s,x_m,y_m,z_m\n", std::ios::ate);
    walk.precision(17);
    for (double t_s = 0.0; t_s <= 12.0; t_s += 0.01)
      walk << t_s << ',' << 0.2 * std::sin(1.5 * t_s) << ",1.6," << 0.1 * std::cos(t_s) << '\n';
    folder_.file("walk.csv", walk.str());
    rig_ = readRig(
        folder_.file("room.toml",
                     "unit = \"m\"\naxes = \"x-right y-up z-back\"\n[head]\ntracker = \"walker\"\n"
                     "[[tracker]]\nname = \"walker\"\nkind = \"recorded\"\nsource = \"walk.csv\"\n"
                     "[[wall]]\nname = \"front\"\nlower_left = [-1, 0, -1]\nlower_right = [1, 0, -1]\n"
                     "upper_left = [-1, 2, -1]\npixels = [64, 64]\nstereo = \"mono\"\n"
                     "window = { position = [0, 0], size = [64, 64] }\n"));
  }

  static Scenario passingBy() {
    Scenario scenario = readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml");
    scenario.observer.beta = {0.95, 0.0, 0.0};
    scenario.observer.position_m = {-8.0, -1.6, -0.75};
    return scenario;
  }

  /// As the frame loop does, on with the file if it is there.
  void play(std::uint64_t frames, Mouse mouse) {
    LiveStart start{{}, {}, frames};
    SimulatedClock clock;
    const bool goesOn = std::filesystem::exists(file());
    if (goesOn) {
      SessionFile session(file());
      session.goTo(session.frames()->second);
      FrameState last;
      session.next(last);
      start.before = last.record;
      start.struck = session.strokes(scenario_.billiard.pucks);
      clock.sleepUntil(last.record.display_s);
    }
    SessionFacts facts{
        "carom", folder_ / "room.toml", "three-pucks.toml", "", "", scenario_.billiard.lightSpeed_m_s};
    for (const Puck& puck : scenario_.billiard.pucks) facts.pucks.push_back(puck.name);
    World world{atStart_, {}};
    LiveSource source(rig_, scenario_, world, start);
    Pacer pacer(clock, rig_.display_hz, rig_.displayLatency_s, false, start.firstFrame());
    JournalListener journal;
    journal.keep(std::make_unique<Journal>(file(), facts, goesOn));
    OperatorSettings settings;
    settings.views.myNow = 1;
    Decision decision;
    const FrameState& frame = decision.frame;
    do {
      FrameInput input;
      if (!frame.knots.empty() || frame.record.number > 0) input.desk = mouse(frame.record, world.histories);
      decision.beginFrame();
      source.next(pacer.next(), input, settings, decision);
      applyFrame(frame, world);
      pacer.awaitTick(0.0);
      pacer.swapped();
      journal.shown(decision);
    } while (!frame.record.last);
  }

  std::filesystem::path file() const { return folder_ / "game.db"; }

  const TemporaryFolder folder_;
  const Scenario scenario_;
  const std::vector<WorldLine> atStart_;
  Rig rig_;
};

bool same(const Event& a, const Event& b) { return a.t_s == b.t_s && a.r_m == b.r_m; }

/// In every frame of the file each eye has seen each puck at the event, to the bit, at which it sees it when
/// all is known.
void expectThatNothingSeenHasChanged(SessionFile& session, std::span<const WorldLine> atStart) {
  const RecordedGame whole = wholeGame(session, atStart);
  World world{{atStart.begin(), atStart.end()}, {}};
  session.goTo(0);
  for (FrameState frame; session.next(frame);) {
    session.apply(frame, world);
    for (std::size_t puck = 1; puck <= whole.pucks; ++puck) {
      for (const EyeView& eye : frame.record.viewers[0].observer.all()) {
        const Lorentz& head = frame.record.viewers[0].observer.headFromBoard;
        const auto then = emission(world.histories[puck], Vec3(0.0), eye.observation, head);
        const auto inTheEnd = emission(whole.world.histories[puck], Vec3(0.0), eye.observation, head);
        ASSERT_TRUE(same(then.value().event, inTheEnd.value().event)) << "frame " << frame.record.number;
      }
    }
  }
}

void expectTheGameOfItsStrokes(SessionFile& session, BilliardSetup setup,
                               std::span<const WorldLine> atStart) {
  const RecordedGame whole = wholeGame(session, atStart);
  setup.strokes = session.strokes(setup.pucks);
  Billiard truth(setup);
  truth.advanceTo(200.0);
  for (std::size_t puck = 0; puck < setup.pucks.size(); ++puck) {
    const auto found = whole.world.histories[puck + 1].knots(), expected = truth.worldLines()[puck].knots();
    ASSERT_GT(found.size(), 3u);
    ASSERT_LE(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_TRUE(same(found[i].turn, expected[i].turn) && found[i].u == expected[i].u)
          << puck << ", knot " << i;
    }
  }
}

TEST_F(LiveSession, NoStrokeChangesWhatWasSeen) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::filesystem::remove(file());
    testing::internal::CaptureStderr();
    play(300, Mouse(seed));
    const std::string said = testing::internal::GetCapturedStderr();
    SessionFile session(file());
    ASSERT_GT(session.strokes(scenario_.billiard.pucks).size(), 4u) << said;
    expectThatNothingSeenHasChanged(session, atStart_);
    expectTheGameOfItsStrokes(session, scenario_.billiard, atStart_);
    // Each stroke is told, and so is each that could not be: in the room, on standard error, in the file.
    SQLite::Database database(file().string());
    const int told = database.execAndGet("SELECT count(*) FROM input WHERE what = 'notice'").getInt();
    const int struck = database
                           .execAndGet(
                               "SELECT count(*) FROM stroke JOIN input USING (frame) WHERE what = 'notice' "
                               "AND value LIKE 'Your stroke runs to ' || puck || ' at the speed of light: % "
                               "s there, % s back%'")
                           .getInt();
    EXPECT_EQ(struck, database.execAndGet("SELECT count(*) FROM stroke").getInt());
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), told);
    const int first = database.execAndGet("SELECT min(frame) FROM input WHERE what = 'notice'").getInt();
    session.goTo(static_cast<std::uint64_t>(first) - 1);
    FrameState frame;
    session.next(frame);
    EXPECT_EQ(frame.record.viewers[0].notice.words(), "");
    session.next(frame);
    EXPECT_EQ(frame.record.viewers[0].notice.words(),
              database.execAndGet("SELECT value FROM input WHERE what = 'notice' ORDER BY frame LIMIT 1")
                  .getString());
  }
}

TEST_F(LiveSession, GoesOnWithItsStrokes) {
  testing::internal::CaptureStderr();
  play(150, Mouse(4));
  const std::size_t first = SessionFile(file()).strokes(scenario_.billiard.pucks).size();
  play(150, Mouse(5));
  testing::internal::GetCapturedStderr();
  SessionFile session(file());
  EXPECT_EQ(session.frames(), (std::pair<std::uint64_t, std::uint64_t>(0, 299)));
  ASSERT_GT(first, 2u);
  ASSERT_GT(session.strokes(scenario_.billiard.pucks).size(), first);
  expectThatNothingSeenHasChanged(session, atStart_);
  expectTheGameOfItsStrokes(session, scenario_.billiard, atStart_);
}

/// Whatever the first game was doing when it was left: another one has nothing of it, and begins at its
/// beginning however long it took to load.
TEST_F(LiveSession, AnotherGameHasNothingOfTheFirst) {
  SimulatedClock clock;
  World world{atStart_, {}};
  LiveSource source(rig_, scenario_, world, {});
  Pacer pacer(clock, rig_.display_hz, rig_.displayLatency_s);
  OperatorSettings settings;
  Decision decision;
  const FrameState& state = decision.frame;
  const auto frame = [&](const DeskInput& desk, const Commands& commands = {}) {
    decision.beginFrame();
    source.next(pacer.next(), {commands, desk}, settings, decision);
    applyFrame(state, world);
    pacer.awaitTick(0.0);
    pacer.swapped();
  };
  const auto aimed = [&](bool held) {
    RayPicking aim;
    const EyeView& eye = state.record.viewers[0].observer.middle;
    const Vec3 way_m =
        aim.seenInRoom_m(world.histories[1], {state.record.viewers[0].observer, Eye::middle, {}}) -
        eye.positionInRoom_m;
    DeskInput desk;
    desk.mouse = PointedWall{eye.positionInRoom_m + glm::normalize(way_m), Eye::middle};
    desk.mouseHeld = held;
    return desk;
  };
  testing::internal::CaptureStderr();
  frame({});
  const FrameRecord first = state.record;
  frame({}, {StartTour{}});  // which this game has not: that is said
  for (int i = 0; i < 29; ++i) frame(aimed(i > 19));
  ASSERT_EQ(state.record.viewers[0].hand.pulling, 1);
  ASSERT_NE(state.record.viewers[0].notice.words(), "");

  settings = {};
  world = {atStart_, {}};
  source.playAnew();
  clock.sleepUntil(clock.now_s() + 2.0);
  for (int i = 0; i < 10; ++i) {
    frame(aimed(true));
    if (i == 0) {
      EXPECT_EQ(state.record.viewers[0].observer.properTime_s, first.viewers[0].observer.properTime_s);
      EXPECT_NEAR(state.record.viewers[0].observer.middle.observation.t_s,
                  first.viewers[0].observer.middle.observation.t_s, 0.5);
    }
    ASSERT_EQ(state.record.viewers[0].hand.pulling, 0) << "the cue is still held, frame " << i;
    ASSERT_EQ(state.record.viewers[0].notice.words(), "") << "frame " << i;
  }
  frame(aimed(false));
  frame(aimed(true));
  EXPECT_EQ(state.record.viewers[0].hand.pulling, 1);
  testing::internal::GetCapturedStderr();
}

/// The mouse presses a choice on the wall: that is a command, and no stroke. A stroke that is let go over a
/// choice is a stroke, and no command.
TEST_F(LiveSession, APressOnAChoiceIsACommandAndNoStroke) {
  Scenario scenario = scenario_;
  scenario.choices = true;
  scenario.observer = {};
  scenario.observer.position_m = {0.0, -1.6, -0.75};
  SimulatedClock clock;
  World world{startingHistories(scenario), {}};
  LiveSource source(rig_, scenario, world, {});
  Pacer pacer(clock, rig_.display_hz, rig_.displayLatency_s);
  OperatorSettings settings;
  Decision decision;
  const auto frame = [&](const Vec3& onWall_m, bool held) {
    DeskInput desk;
    desk.mouse = PointedWall{onWall_m, Eye::middle};
    desk.mouseHeld = held;
    decision.beginFrame();
    source.next(pacer.next(), {{}, desk}, settings, decision);
    applyFrame(decision.frame, world);
    pacer.awaitTick(0.0);
    pacer.swapped();
  };
  const Wall& front = rig_.walls.front();
  const auto tiles = tilesOn(front, false);
  const auto middleOf = [&](Choice choice) {
    const Tile& tile = tiles[static_cast<std::size_t>(choice)];
    const glm::dvec2 at_m = tile.from_m + 0.5 * tile.size_m;
    return front.lowerLeft_m + Vec3(at_m, 0.0);
  };
  const auto command = [&]() -> std::string {
    if (decision.handCommands.empty()) return "";
    const auto* play = std::get_if<PlayScenario>(&decision.handCommands.front().command);
    return play && decision.handCommands.size() == 1 ? play->file : "another";
  };
  testing::internal::CaptureStderr();
  for (const auto& [choice, file] : {std::pair{Choice::play, fileOfGame(kWelcome)},
                                     {Choice::lessons, fileOfGame(kLessons.front())},
                                     {Choice::showMe, fileOfGame(kShowMe)}}) {
    frame(front.lowerLeft_m, false);
    frame(middleOf(choice), false);  // it moves, so the mouse aims
    EXPECT_EQ(command(), "");
    EXPECT_LT(glm::distance(decision.frame.record.viewers[0].hand.to_m, middleOf(choice)), 1e-9);
    frame(middleOf(choice), true);
    EXPECT_EQ(command(), file);
    frame(middleOf(choice), true);
    EXPECT_EQ(command(), "") << "a press is one command";
    EXPECT_EQ(decision.frame.record.viewers[0].hand.pulling, 0);
    frame(middleOf(choice), false);
    EXPECT_TRUE(decision.strokes.empty());
  }
  RayPicking aim;
  const FrameRecord& record = decision.frame.record;
  const Vec3 puck_m = aim.seenInRoom_m(world.histories[1], {record.viewers[0].observer, Eye::middle, {}});
  for (const bool held : {false, true, true}) frame(puck_m, held);
  frame(puck_m + Vec3(0.0, -0.2, 0.0), true);
  ASSERT_EQ(record.viewers[0].hand.pulling, 1);
  frame(middleOf(Choice::play), true);
  EXPECT_EQ(record.viewers[0].hand.pulling, 1) << "the cue stays in the hand";
  frame(middleOf(Choice::play), false);
  EXPECT_EQ(decision.strokes.size(), 1U);
  EXPECT_EQ(command(), "");
  testing::internal::GetCapturedStderr();
}

}  // namespace
}  // namespace carom
