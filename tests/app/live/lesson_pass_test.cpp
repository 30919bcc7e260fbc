// A lesson as the frame loop plays it: slowly, again and again, at rest or in motion, and held at its moment.
#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <sstream>

#include "app/live/live_source.h"
#include "app/operator/command.h"
#include "app/operator/lesson.h"
#include "app/scenario/starting_histories.h"
#include "app/temporary_folder.h"
#include "places.h"

namespace carom {
namespace {

using test::TemporaryFolder;

constexpr double kHz = 60.0, kExact = 1e-9;

/// A lesson of the shipped files, in a room whose head stands still or walks.
class LessonPass : public testing::Test {
 protected:
  static Rig rigWith(const TemporaryFolder& folder, double walk_m) {
    std::ostringstream walk("time_s,x_m,y_m,z_m\n", std::ios::ate);
    for (double t_s = 0.0; t_s <= 40.0; t_s += 0.01)
      walk << t_s << ',' << walk_m * std::sin(2.0 * t_s) << ",1.7,0\n";
    folder.file("walk.csv", walk.str());
    return readRig(
        folder.file("room.toml",
                    "unit = \"m\"\naxes = \"x-right y-up z-back\"\ndisplay_hz = 60.0\n[head]\ntracker = "
                    "\"walker\"\n"
                    "[[tracker]]\nname = \"walker\"\nkind = \"recorded\"\nsource = \"walk.csv\"\n"
                    "[[wall]]\nname = \"front\"\nlower_left = [-1, 0, -1]\nlower_right = [1, 0, -1]\n"
                    "upper_left = [-1, 2, -1]\npixels = [64, 64]\nstereo = \"mono\"\n"
                    "window = { position = [0, 0], size = [64, 64] }\n"));
  }

  explicit LessonPass(double walk_m = 0.0) : rig_(rigWith(folder_, walk_m)) {
    beginLesson(scenario_, true, settings_);
    settings_.lightSpeed_m_s = scenario_.billiard.lightSpeed_m_s;
  }

  const FrameRecord& next(std::span<const Command> commands = {}) {
    decision_.beginFrame();
    const double display_s = static_cast<double>(number_) / kHz;
    source_.next({number_++, display_s, display_s, 1.0 / kHz}, {commands, {}}, settings_, decision_);
    applyFrame(decision_.frame, world_);
    return decision_.frame.record;
  }
  static double board_s(const FrameRecord& record) {
    return record.viewers[0].observer.middle.observation.t_s;
  }

  const TemporaryFolder folder_;
  const Rig rig_;
  const Scenario scenario_ = readScenario(CAROM_CONFIG_DIR "/scenarios/two-cushions.toml");
  const LessonInterval interval_ = scenario_.lesson->plan.interval;
  World world_{startingHistories(scenario_), {}};
  LiveSource source_{rig_, scenario_, world_, {}};
  OperatorSettings settings_;
  Decision decision_;
  std::uint64_t number_ = 0;
};

class WalkingPass : public LessonPass {
 protected:
  WalkingPass() : LessonPass(0.3) {}
};

TEST_F(LessonPass, AsksAtTheBeginningOfItsIntervalWhileTimeStandsStill) {
  for (int i = 0; i < 30; ++i) EXPECT_NEAR(board_s(next()), interval_.from_s, kExact);
}

TEST_F(LessonPass, ShowsItsIntervalSlowlyAndAgain) {
  next();
  settings_.lesson.phase = LessonPhase::shows;
  double before_s = interval_.from_s, longest_s = before_s;
  int passes = 0;
  for (int i = 0; i < 60 * 24; ++i) {
    const double t_s = board_s(next());
    if (t_s < before_s) {
      ++passes;
      EXPECT_NEAR(t_s, interval_.from_s, 1.1 / kHz / interval_.slowness) << "from its beginning";
      EXPECT_GE(before_s, interval_.until_s);
    } else if (before_s < interval_.until_s) {
      EXPECT_NEAR(t_s - before_s, 1.0 / kHz / interval_.slowness, kExact);
    }
    longest_s = std::max(longest_s, t_s);
    before_s = t_s;
  }
  EXPECT_EQ(passes, 2);
  EXPECT_LT(longest_s, interval_.until_s + 1.0 / kHz);
}

TEST_F(LessonPass, HoldsItsMomentWheneverItIsAskedToExplain) {
  for (const int shown : {1, 100, 500}) {
    settings_.lesson.phase = LessonPhase::shows;
    for (int i = 0; i < shown; ++i) next();
    settings_.lesson.phase = LessonPhase::explains;
    const FrameRecord first = next();
    EXPECT_NEAR(board_s(first), interval_.moment_s, kExact) << shown;
    for (int i = 0; i < 200; ++i) EXPECT_EQ(board_s(next()), board_s(first));
  }
}

TEST_F(LessonPass, ObserversOfAllVelocitiesMeetAtTheMoment) {
  settings_.lesson.phase = LessonPhase::explains;
  const Vec3 place_m = next().viewers[0].observer.middle.observation.r_m;
  for (const std::size_t observer : {1U, 2U, 0U}) {
    settings_.lessonObserver = observer;
    const FrameRecord& record = next();
    EXPECT_NEAR(board_s(record), interval_.moment_s, kExact);
    EXPECT_NEAR(glm::distance(record.viewers[0].observer.middle.observation.r_m, place_m), 0.0, kExact);
    const Vec3 beta = betaFromU(record.boardFromRoom.u());
    EXPECT_NEAR(glm::distance(beta, scenario_.lesson->plan.observers[observer].beta), 0.0, kExact);
  }
}

// Aberration moves what is seen ahead; the room of a moving observer is turned as far, unless the lesson is
// about what is now. Light from straight ahead on the table, transformed as a displacement, comes from
// straight ahead in the room.
TEST_F(LessonPass, WhatIsSeenAheadAtRestIsSeenAheadInMotion) {
  Scenario seen = scenario_;
  seen.lesson->views = {};
  settings_.lesson.phase = LessonPhase::explains;
  const Vec3 ahead(std::cos(seen.observer.facing_rad), std::sin(seen.observer.facing_rad), 0.0);
  const double c_m_s = seen.billiard.lightSpeed_m_s;
  LiveSource turned(rig_, seen, world_, {});
  for (const std::size_t observer : {0U, 1U, 2U}) {
    settings_.lessonObserver = observer;
    decision_.beginFrame();
    turned.next({observer, 0.1, 0.1, 1.0 / kHz}, {}, settings_, decision_);
    const Lorentz roomFromBoard = decision_.frame.record.boardFromRoom.inverse();
    const Vec3 from = -glm::normalize((roomFromBoard * Displacement{1.0, -c_m_s * ahead}).dr_m);
    EXPECT_NEAR(glm::dot(from, rig_.axes.right), 0.0, kExact) << observer;
    EXPECT_GT(glm::dot(from, rig_.axes.forward), 0.0) << observer;
  }
}

TEST_F(LessonPass, WhatIsNowAheadStaysAhead) {
  settings_.lesson.phase = LessonPhase::explains;
  for (const std::size_t observer : {1U, 2U}) {
    settings_.lessonObserver = observer;
    const Vec3 u = next().boardFromRoom.inverse().u();  // of the table, in the room
    EXPECT_NEAR(glm::dot(u, rig_.axes.forward), 0.0, kExact) << "it passes sideways";
  }
}

// The message comes first, and with the next frame the effect, whose first picture may take long.
TEST_F(LessonPass, AnEffectIsAnnouncedOneFrameBeforeItChanges) {
  settings_.lesson.phase = LessonPhase::shows;
  next();
  const Command off = SetSwitch{&Switches::retardation, false, false};
  apply(off, settings_);
  const FrameRecord announced = next(std::span(&off, 1));
  EXPECT_EQ(announced.switches.retardation, 1);
  EXPECT_EQ(announced.viewers[0].notice.words(), "light delay (retardation): off");
  const FrameRecord changed = next();
  EXPECT_EQ(changed.switches.retardation, 0);
  EXPECT_EQ(changed.viewers[0].notice.words(), announced.viewers[0].notice.words());
}

// The pucks' histories do not depend on how often the game was begun again.
TEST_F(LessonPass, EveryPassIsTheSameGame) {
  settings_.lesson.phase = LessonPhase::explains;
  next();
  const std::vector<Knot> first(world_.histories[1].knots().begin(), world_.histories[1].knots().end());
  const std::size_t events = world_.events.size();
  settings_.lesson.phase = LessonPhase::shows;
  for (int i = 0; i < 60 * 15; ++i) next();
  settings_.lesson.phase = LessonPhase::explains;
  next();
  const auto again = world_.histories[1].knots();
  ASSERT_GE(again.size(), first.size()) << "more of it is known after a whole pass";
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(again[i].turn.t_s, first[i].turn.t_s);
    EXPECT_EQ(again[i].turn.r_m, first[i].turn.r_m);
    EXPECT_EQ(again[i].u, first[i].u);
  }
  EXPECT_GE(world_.events.size(), events);
  const std::size_t knots = again.size(), known = world_.events.size();
  settings_.lesson.phase = LessonPhase::shows;
  for (int i = 0; i < 60 * 15; ++i) next();
  EXPECT_EQ(world_.histories[1].knots().size(), knots) << "nothing new comes with a further pass";
  EXPECT_EQ(world_.events.size(), known);
}

// Whoever walks while time is slowed is not faster than light: slow motion is the replay's, not the light's.
TEST_F(WalkingPass, WalkingDoesNotHurryTheSlowedTime) {
  settings_.lesson.phase = LessonPhase::shows;
  double before_s = board_s(next()), x_m = 0.0;
  for (int i = 0; i < 120; ++i) {
    const FrameRecord& record = next();
    EXPECT_NEAR(board_s(record) - before_s, 1.0 / kHz / interval_.slowness, kExact);
    EXPECT_EQ(record.lightSpeed_m_s, scenario_.billiard.lightSpeed_m_s);
    before_s = board_s(record);
    x_m = std::max(x_m, record.viewers[0].observer.middle.observation.r_m.x);
  }
  EXPECT_GT(x_m, 0.2) << "they have walked";
}

}  // namespace
}  // namespace carom
