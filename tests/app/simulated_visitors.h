#pragma once
// Visitors who come, play and leave, in simulated time: keys, mouse and drive at random, from a seed; some
// press Escape, and some discuss a question for minutes without touching anything. Everything is as in `carom
// cave --unattended`, without its pictures: settings, programme, games, session files, the lock of the keys.

#include <GLFW/glfw3.h>
#include <dirent.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "app/hand/ray_picking.h"
#include "app/input/end_question.h"
#include "app/input/key_lock.h"
#include "app/journal/journal.h"
#include "app/live/live_source.h"
#include "app/operator/visitor_choices.h"
#include "app/scenario/starting_histories.h"
#include "app/session/director.h"
#include "app/session/game_settings.h"
#include "app/session/session_listeners.h"
#include "app/toml/config_folder.h"
#include "cave/frame/bodies.h"
#include "engine/random_world.h"
#include "log_lines.h"
#include "places.h"

namespace carom::test {

/// What the next visitor finds, and what the process holds then.
struct Found {
  double at_s = 0.0;
  OperatorSettings settings;
  FrameRecord record;  ///< of the first frame
  std::size_t knots = 0, events = 0;
  std::size_t bytes = 0;  ///< allocated
  long handles = 0;       ///< open files
};

class SimulatedVisitors {
 public:
  static constexpr double kHz = 20.0, kPatience_s = 60.0;

  SimulatedVisitors(std::uint64_t seed, std::filesystem::path folder)
      : random_(seed),
        folder_(std::move(folder)),
        rig_(readRig(CAROM_CONFIG_DIR "/rigs/play.toml")),
        scenario_(readScenario(fileOfGame(kWelcome))) {
    rig_.display_hz = kHz;
    world_ = {startingHistories(scenario_), {}};
    source_ = std::make_unique<LiveSource>(rig_, scenario_, world_, LiveStart{});
    leader_ = std::make_unique<FrameLeader>(
        *source_, KeysOf::session, settingsOf(rig_, scenario_, fileOfGame(kWelcome), beginning_),
        [this](const WindowInput& input, bool asks) { return desk(input, asks); }, kPatience_s);
    write(false);
  }

  /// Plays until so many visitors have come and gone, or for at most so long. Returns what each found, and
  /// what one more would find.
  std::vector<Found> run(std::size_t visitors, double most_s) {
    std::vector<Found> found;
    found.reserve(visitors + 1);  // what they find is no memory that the program keeps
    comes_s_ = random_.in(1.0, 10.0);
    isFirstFrame_ = isWelcome_ = true;
    for (long frame = 0; now_s() < most_s && found.size() <= visitors; ++frame) {
      step();
      if (isFirstFrame_ && isWelcome_) found.push_back(find());
      isFirstFrame_ = false;
      if (decision_.frame.record.last) begin(leader_->takeNextGame());
    }
    return found;
  }

  std::size_t games() const { return games_; }
  std::size_t strokes() const { return strokes_; }
  std::size_t attractions() const { return attractions_; }
  std::size_t escapes() const { return escapes_; }          ///< presses of Escape or Q
  std::size_t ends() const { return ends_; }                ///< times that they ended the session
  std::size_t discussions() const { return discussions_; }  ///< of more than the patience
  std::size_t thrownOut() const { return thrownOut_; }      ///< in the middle of a discussion
  std::size_t countdowns() const { return countdowns_; }    ///< seconds that were counted down
  std::filesystem::path file() const { return folder_ / "visit.db"; }
  double now_s() const { return decision_.frame.record.display_s; }

 private:
  enum class Mood { away, aims, draws, drives, looks };

  void step() {
    const FrameTimes times = pacer_.next();
    visit(times.display_s);
    WindowInput input;
    if (!isFirstFrame_) {  // which is what a visitor finds
      if (pressed_) input.keys = {{*pressed_, true}, {*pressed_, false}};
      pressed_.reset();
    }
    for (const KeyInput& key : input.keys)
      escapes_ += key.pressed && (key.key == GLFW_KEY_ESCAPE || key.key == GLFW_KEY_Q) ? 1 : 0;
    const WindowInput& passed = lock_.pass(input);
    ends_ += ending_.take(passed) ? 1 : 0;
    const Notice before = decision_.frame.record.viewers[0].notice;
    leader_->decide(times, passed, decision_);
    const Notice& said = decision_.frame.record.viewers[0].notice;
    countdowns_ += said != before && said.words().starts_with("Still there") ? 1 : 0;
    strokes_ += decision_.strokes.size();
    applyFrame(decision_.frame, world_);
    journal_.shown(decision_);
    pacer_.awaitTick(0.0);
    pacer_.swapped();
  }

  /// Decides what the visitor does now: they come, stay for a while, and leave without a word.
  void visit(double now_s) {
    if (now_s < comes_s_) return;
    if (mood_ == Mood::away && now_s > leaves_s_) leaves_s_ = now_s + random_.in(8.0, 30.0);
    if (now_s > leaves_s_) {
      mood_ = Mood::away;
      const bool isQuiet = random_.in(0.0, 1.0) < 0.15;  // otherwise some come before all is put back
      comes_s_ = now_s + kPatience_s + (isQuiet ? random_.in(60.0, 110.0) : random_.in(-3.0, 12.0));
      return;
    }
    if (now_s < changes_s_) return;
    if (discusses()) {
      mood_ = Mood::looks;
      changes_s_ = now_s + random_.in(1.1, 4.5) * kPatience_s;
      leaves_s_ = std::max(leaves_s_, changes_s_ + 5.0);
      discussedUntil_s_ = changes_s_;
      discussed_ = games_;
      ++discussions_;
      return;
    }
    changes_s_ = now_s + random_.in(0.3, 2.0);
    mood_ = mood_ == Mood::aims ? Mood::draws : random_.in(0.0, 1.0) < 0.6 ? Mood::aims : Mood::drives;
    if (mood_ == Mood::aims) puck_ = static_cast<std::size_t>(random_.in(0.0, 0.999 * pucks()));
    pull_m_ = random_.in(0.05, 0.5);
    turn_rad_ = random_.in(-std::numbers::pi, std::numbers::pi);
    if (random_.in(0.0, 1.0) > 0.4) return;
    constexpr std::array kKeys{
        GLFW_KEY_1, GLFW_KEY_2,      GLFW_KEY_3,  GLFW_KEY_4,  GLFW_KEY_5,     GLFW_KEY_N,
        GLFW_KEY_M, GLFW_KEY_P,      GLFW_KEY_E,  GLFW_KEY_C,  GLFW_KEY_U,     GLFW_KEY_V,
        GLFW_KEY_F, GLFW_KEY_H,      GLFW_KEY_B,  GLFW_KEY_X,  GLFW_KEY_EQUAL, GLFW_KEY_K,
        GLFW_KEY_J, GLFW_KEY_T,      GLFW_KEY_Y,  GLFW_KEY_F5, GLFW_KEY_F6,    GLFW_KEY_F7,
        GLFW_KEY_G, GLFW_KEY_F2,     GLFW_KEY_F3, GLFW_KEY_Z,  GLFW_KEY_ENTER, GLFW_KEY_RIGHT_BRACKET,
        GLFW_KEY_Q, GLFW_KEY_ESCAPE, GLFW_KEY_F6};
    pressed_ = kKeys[static_cast<std::size_t>(random_.in(0.0, 0.999 * kKeys.size()))];
  }

  /// Decides whether the visitors stand before a question now and discuss it.
  bool discusses() {
    // One discussion a game, and by somebody who has done something since they came.
    const bool isNew = discussed_ != games_ && mood_ != Mood::away;
    return isNew && leader_->settings().lesson.phase == LessonPhase::asks && random_.in(0.0, 1.0) < 0.3;
  }

  double pucks() const { return static_cast<double>(scenario_.billiard.pucks.size()); }

  /// Returns the desk's input: the mouse over a puck as it was just seen, or drawn back along the cloth; keys
  /// held.
  DeskInput desk(const WindowInput&, bool) {
    DeskInput desk;
    if (isFirstFrame_) return desk;
    if (mood_ == Mood::drives) desk.steer = {std::cos(turn_rad_), std::sin(turn_rad_), 0.0};
    const FrameRecord& before = decision_.frame.record;
    if (mood_ != Mood::aims && mood_ != Mood::draws) return desk;
    if (puck_ >= scenario_.billiard.pucks.size()) return desk;
    const EyeView& eye = before.viewers[0].observer.middle;
    Vec3 along = aim_.seenInRoom_m(world_.histories[kFirstPuck + puck_],
                                   {before.viewers[0].observer, Eye::middle, before.switches}) -
                 eye.positionInRoom_m;
    if (mood_ == Mood::draws) along += pull_m_ * Vec3(std::cos(turn_rad_), 0.0, std::sin(turn_rad_));
    desk.mouse = PointedWall{eye.positionInRoom_m + glm::normalize(along), Eye::middle};
    desk.mouseHeld = changes_s_ - before.display_s > 0.15;
    return desk;
  }

  /// Begins the game that the leader has chosen, as a session does.
  void begin(const NextGame& next) {
    ASSERT_FALSE(next.file.empty());
    ++games_;
    const bool stood = leader_->settings().lesson.phase == LessonPhase::asks;  // the question, to the end
    thrownOut_ += next.isForNextVisitor && stood && now_s() < discussedUntil_s_ ? 1 : 0;
    attractions_ += next.attracts ? 1 : 0;
    scenario_ = readScenario(next.file);
    world_ = {startingHistories(scenario_), {}};
    source_->playAnew();
    write(next.attracts);
    leader_->begin(settingsOfNext(leader_->settings(), next, rig_, scenario_, beginning_));
    isFirstFrame_ = true;
    isWelcome_ = next.isForNextVisitor;
  }

  /// Writes the game to the session file of the day, unless it is there to attract people.
  void write(bool attracts) {
    journal_.keep(nullptr);
    if (attracts) return;
    const bool isThere = std::filesystem::exists(file());
    SessionFacts facts{"carom", "play.toml", "game.toml", "", "", scenario_.billiard.lightSpeed_m_s};
    for (const Puck& puck : scenario_.billiard.pucks) facts.pucks.push_back(puck.name);
    facts.isAnotherGame = isThere;
    journal_.keep(std::make_unique<Journal>(file(), facts, isThere));
  }

  Found find() const {
    Found found{now_s(), leader_->settings(), decision_.frame.record, 0, world_.events.size(), 0, 0};
    for (const WorldLine& line : world_.histories) found.knots += line.knots().size();
    found.bytes = mallinfo2().uordblks;
    DIR* const folder = opendir("/proc/self/fd");
    while (readdir(folder)) ++found.handles;
    closedir(folder);
    return found;
  }

  Random random_;
  std::filesystem::path folder_;
  Rig rig_;
  Scenario scenario_;
  Beginning beginning_;
  World world_;
  SimulatedClock clock_;
  Pacer pacer_{clock_, kHz, 0.0, false, 0};
  std::unique_ptr<LiveSource> source_;
  std::unique_ptr<FrameLeader> leader_;
  JournalListener journal_;
  KeyLock lock_{"", true};
  EndQuestion ending_;
  Decision decision_;
  RayPicking aim_;
  bool isFirstFrame_ = true, isWelcome_ = true;
  std::size_t games_ = 0, strokes_ = 0, attractions_ = 0;
  std::size_t escapes_ = 0, ends_ = 0, discussions_ = 0, thrownOut_ = 0, countdowns_ = 0;
  double discussedUntil_s_ = -1.0;
  std::optional<std::size_t> discussed_;  ///< the number of the game whose question was discussed last
  Mood mood_ = Mood::away;
  double comes_s_ = 0.0, leaves_s_ = -1.0, changes_s_ = 0.0, pull_m_ = 0.0, turn_rad_ = 0.0;
  std::size_t puck_ = 0;
  std::optional<int> pressed_;
};

/// Expects that a visitor finds what the first one found: nothing of those who were there before, but for the
/// least energies of tasks, which are those of the session. The room, its eyes and its tracker are where they
/// are.
inline void expectNothingOfOthers(const Found& found, const Found& first) {
  OperatorSettings settings = found.settings;
  settings.bestOfTask_j = first.settings.bestOfTask_j;
  EXPECT_EQ(settings, first.settings);
  const FrameRecord &here = found.record, &there = first.record;
  EXPECT_EQ(here.viewers[0].observer.middle.observation.t_s,
            there.viewers[0].observer.middle.observation.t_s);
  // The tracker goes on, and with it the rounding of where the head is.
  constexpr double kRounding_m = 1e-9;
  EXPECT_LT(glm::distance(here.viewers[0].observer.middle.observation.r_m,
                          there.viewers[0].observer.middle.observation.r_m),
            kRounding_m);
  EXPECT_EQ(here.viewers[0].observer.properTime_s, there.viewers[0].observer.properTime_s);
  EXPECT_EQ(here.boardFromRoom.matrix(), there.boardFromRoom.matrix());
  EXPECT_EQ(here.switches, there.switches);
  EXPECT_EQ(here.views, there.views);
  EXPECT_EQ(here.controls, there.controls);
  EXPECT_EQ(here.lightSpeed_m_s, there.lightSpeed_m_s);
  EXPECT_EQ(here.lesson, there.lesson);
  EXPECT_EQ(here.viewers[0].score, there.viewers[0].score);
  EXPECT_EQ(here.viewers[0].notice.words(), there.viewers[0].notice.words());
  EXPECT_EQ(here.drive.mode, there.drive.mode);
  EXPECT_EQ(here.drive.thrust, there.drive.thrust);
  EXPECT_EQ(here.viewers[0].hand.pulling, there.viewers[0].hand.pulling);
  EXPECT_EQ(found.knots, first.knots);
  EXPECT_EQ(found.events, first.events);
}

}  // namespace carom::test
