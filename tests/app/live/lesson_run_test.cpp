// The stage of a frame that runs a lesson, alone with a room: passes, the moment that is held, answers.
#include "app/live/lesson_run.h"

#include <gtest/gtest.h>

#include <chrono>

#include "places.h"

namespace carom {
namespace {

class RunningLesson : public testing::Test {
 protected:
  static constexpr double kHz = 60.0;

  RunningLesson() {
    rig_.trackers[0].person = SimulatedMotion::still;
    settings_.lightSpeed_m_s = scenario_.billiard.lightSpeed_m_s;
    run_.begin(room_);
  }
  static Rig deskRig() {
    Rig rig = readRig(CAROM_CONFIG_DIR "/rigs/desk.toml");
    for (TrackerSetup& tracker : rig.trackers) tracker.person = SimulatedMotion::still;
    return rig;
  }

  /// Plays one frame in this phase, and returns the board time that the head has reached.
  double frame_s(LessonPhase phase) {
    settings_.lesson.phase = phase;
    decision_.beginFrame();
    run_.take(settings_.lesson, 0, decision_);
    const double display_s = static_cast<double>(number_) / kHz;
    const FrameTimes times{number_++, display_s, display_s, 1.0 / kHz};
    return run_.move(settings_, {times, 0.064}, room_)[0].middle.observation.t_s;
  }

  Rig rig_ = deskRig();
  const Scenario scenario_ = readScenario(CAROM_CONFIG_DIR "/scenarios/two-cushions.toml");
  const LessonInterval interval_ = scenario_.lesson->plan.interval;
  RoomMotion room_{rig_, scenario_, SharedTrackers(rig_, std::chrono::steady_clock::time_point()), {}};
  LessonRun run_{scenario_};
  OperatorSettings settings_;
  Decision decision_;
  std::uint64_t number_ = 0;
};

TEST_F(RunningLesson, PassesFromTheBeginningToTheEndAndBeginsAgain) {
  double before_s = frame_s(LessonPhase::shows);
  EXPECT_NEAR(before_s, interval_.from_s, 0.1);
  bool wasHeld = false, beganAgain = false;
  for (int frame = 0; frame < 20000 && !beganAgain; ++frame) {
    const double now_s = frame_s(LessonPhase::shows);
    if (run_.isHeld()) {
      wasHeld = true;
      EXPECT_GE(now_s, interval_.until_s - 1e-9);
    }
    beganAgain = now_s < before_s - 0.1;
    before_s = now_s;
  }
  EXPECT_TRUE(wasHeld);
  EXPECT_TRUE(beganAgain);
  EXPECT_NEAR(before_s, interval_.from_s, 0.1);
}

TEST_F(RunningLesson, ItsMomentIsHeldWhileItExplains) {
  frame_s(LessonPhase::shows);
  for (int frame = 0; frame < 5; ++frame) {
    EXPECT_NEAR(frame_s(LessonPhase::explains), interval_.moment_s, 1e-6);
    EXPECT_TRUE(run_.isHeld());
  }
}

TEST_F(RunningLesson, AnAnswerIsNotedOnce) {
  settings_.lesson = {LessonPhase::asks, 0};
  run_.take(settings_.lesson, 0, decision_);
  EXPECT_TRUE(run_.asks());
  EXPECT_TRUE(decision_.answers.empty());
  settings_.lesson = {LessonPhase::shows, 1};
  for (int frame = 0; frame < 3; ++frame) run_.take(settings_.lesson, 2, decision_);
  EXPECT_FALSE(run_.asks());
  ASSERT_EQ(decision_.answers.size(), 1U);
  EXPECT_EQ(decision_.answers[0].viewer, 2U);
  EXPECT_EQ(decision_.answers[0].question, scenario_.lesson->words.question);
}

}  // namespace
}  // namespace carom
