// What a session's keys change.
#include "app/input/keys.h"
#include "engine/base/limits.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace carom {
namespace {

constexpr std::array kPlaces{KeysOf::session, KeysOf::replay, KeysOf::patterns};

WindowInput pressing(int key) { return {{{key, true}, {key, false}}, false}; }

void press(int key, Controls& controls, KeysOf place = KeysOf::session) {
  obeyKeys(pressing(key), place, 10.0, controls);
}

TEST(Keys, TGoesThroughThePatternsAndBackToTheSession) {
  Controls controls;
  std::set<Shown> seen;
  do {
    press(GLFW_KEY_T, controls);
    seen.insert(controls.walls.shown);
  } while (controls.walls.shown != Shown::session && seen.size() < 9);
  EXPECT_TRUE(seen.contains(Shown::calibrationPattern) && seen.contains(Shown::alignmentPattern));
  EXPECT_EQ(controls, Controls{});
}

TEST(Keys, WithoutASessionTNeverGoesToOne) {
  Controls controls;
  controls.walls.shown = Shown::calibrationPattern;
  for (int i = 0; i < 9; ++i) {
    press(GLFW_KEY_T, controls, KeysOf::patterns);
    EXPECT_NE(controls.walls.shown, Shown::session);
  }
}

TEST(Keys, PressedTwiceMostKeysChangeNothing) {
  const std::set<int> steps{GLFW_KEY_T,     GLFW_KEY_EQUAL,        GLFW_KEY_KP_ADD,
                            GLFW_KEY_MINUS, GLFW_KEY_KP_SUBTRACT,  GLFW_KEY_LEFT,
                            GLFW_KEY_RIGHT, GLFW_KEY_UP,           GLFW_KEY_DOWN,
                            GLFW_KEY_HOME,  GLFW_KEY_LEFT_BRACKET, GLFW_KEY_RIGHT_BRACKET,
                            GLFW_KEY_G};
  for (const KeysOf place : kPlaces) {
    for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key) {
      if (steps.contains(key)) continue;
      Controls controls;
      press(key, controls, place);
      press(key, controls, place);
      EXPECT_EQ(controls, Controls{}) << key;
    }
  }
}

TEST(Keys, TheKeyForAThingChangesThatThingAlone) {
  std::vector<std::string> things{"walls", "eyes", "shown", "latency", "tracker cross"};
  for (const NamedSwitch& s : kNamedSwitches) {
    things.emplace_back(s.name);
    things.emplace_back(std::string("beside: ") + s.name);
  }
  for (const char* view : {"board-now", "my-now", "paths", "events", "clocks", "split", "frozen"})
    things.emplace_back(view);
  for (const std::string& thing : things) {
    const KeyLine line = keyFor(KeysOf::session, thing);
    ASSERT_EQ(line.keys.size(), 1u) << thing;
    Controls controls;
    press(line.keys.front(), controls);  // GLFW's numbers of letters and digits are theirs
    const std::vector<ControlChange> changes = changesOf(Controls{}, controls);
    ASSERT_EQ(changes.size(), 1u) << thing;
    EXPECT_EQ(changes.front().what, thing);
  }
  EXPECT_EQ(keyFor(KeysOf::replay, "playback").keys, "Space");
  EXPECT_TRUE(keyFor(KeysOf::replay, "light speed").keys.empty());
  EXPECT_TRUE(keyFor(KeysOf::session, "no such thing").does.empty());
}

TEST(Keys, EveryGIsAWishToSetOut) {
  Controls controls;
  press(GLFW_KEY_G, controls);
  press(GLFW_KEY_G, controls);
  EXPECT_EQ(controls.tours, 2u);
  press(GLFW_KEY_G, controls, KeysOf::replay);
  EXPECT_EQ(controls.tours, 2u) << "a recorded person goes where they went";
}

TEST(Keys, PlusAndMinusSetTheEyesAMillimetreFurtherAndCloser) {
  for (const auto& [further, closer] :
       {std::pair{GLFW_KEY_EQUAL, GLFW_KEY_MINUS}, std::pair{GLFW_KEY_KP_ADD, GLFW_KEY_KP_SUBTRACT}}) {
    Controls controls;
    double& apart_m = controls.eyeSeparation_m;
    press(further, controls);
    EXPECT_DOUBLE_EQ(apart_m, 0.065);
    for (int i = 0; i < 40; ++i) press(further, controls);
    EXPECT_DOUBLE_EQ(apart_m, 0.080);
    press(closer, controls);
    EXPECT_DOUBLE_EQ(apart_m, 0.079);
    for (int i = 0; i < 100; ++i) press(closer, controls);
    EXPECT_EQ(apart_m, 0.0);
    press(further, controls);
    EXPECT_DOUBLE_EQ(apart_m, 0.001);
  }
}

TEST(Keys, BracketsChangeTheSpeedOfLightWithinItsBounds) {
  Controls controls;
  press(GLFW_KEY_RIGHT_BRACKET, controls);
  EXPECT_GT(controls.lightSpeed_m_s, Controls{}.lightSpeed_m_s);
  press(GLFW_KEY_LEFT_BRACKET, controls);
  EXPECT_NEAR(controls.lightSpeed_m_s, Controls{}.lightSpeed_m_s, 1e-12);
  for (int i = 0; i < 200; ++i) press(GLFW_KEY_LEFT_BRACKET, controls);
  EXPECT_EQ(controls.lightSpeed_m_s, kLeastLightSpeed_m_s);
  for (int i = 0; i < 200; ++i) press(GLFW_KEY_RIGHT_BRACKET, controls);
  EXPECT_EQ(controls.lightSpeed_m_s, kMostLightSpeed_m_s);
}

TEST(Keys, ArrowsGoThroughARecordingAndMeanNothingInASession) {
  Controls controls;
  press(GLFW_KEY_RIGHT, controls, KeysOf::replay);
  EXPECT_EQ(controls.playback, (Playback{false, 1.0, 1, 11.0}));
  press(GLFW_KEY_LEFT, controls, KeysOf::replay);
  EXPECT_EQ(controls.playback, (Playback{false, 1.0, 2, 9.0}));
  press(GLFW_KEY_UP, controls, KeysOf::replay);
  press(GLFW_KEY_R, controls, KeysOf::replay);
  press(GLFW_KEY_SPACE, controls, KeysOf::replay);
  EXPECT_EQ(controls.playback, (Playback{true, -2.0, 2, 9.0}));
  for (int i = 0; i < 20; ++i) press(GLFW_KEY_DOWN, controls, KeysOf::replay);
  EXPECT_EQ(controls.playback.rate, -1.0 / 16.0);

  Controls live;
  for (const int key : {GLFW_KEY_RIGHT, GLFW_KEY_LEFT, GLFW_KEY_UP, GLFW_KEY_R, GLFW_KEY_SPACE})
    press(key, live);
  EXPECT_EQ(live, Controls{});
}

TEST(Keys, WhileALessonAsksDigitsAnswerAndDoNothingElse) {
  for (const int digit : {0, 1, 2, 3, 4, 9}) {
    Controls controls;
    controls.lesson.phase = LessonPhase::asks;
    controls.lessonAnswers = 3;
    const Controls asking = controls;
    press(GLFW_KEY_0 + digit, controls);
    EXPECT_EQ(controls.switches, asking.switches) << digit;
    EXPECT_EQ(controls.views, asking.views) << digit;
    const bool answers = digit >= 1 && digit <= 3;
    EXPECT_EQ(controls.lesson,
              answers ? (LessonState{LessonPhase::shows, static_cast<std::uint8_t>(digit)}) : asking.lesson);
    EXPECT_EQ(changesOf(asking, controls).size(), answers ? 1 : 0);
  }
}

TEST(Keys, OnceItIsAnsweredDigitsAreSwitchesAgainAndEnterGoesOn) {
  Controls controls;
  controls.lesson.phase = LessonPhase::asks;
  controls.lessonAnswers = 3;
  press(GLFW_KEY_KP_2, controls);
  EXPECT_EQ(controls.lesson, (LessonState{LessonPhase::shows, 2}));
  press(GLFW_KEY_1, controls);
  EXPECT_EQ(controls.switches.retardation, 0);
  EXPECT_EQ(controls.lesson.answer, 2);
  press(GLFW_KEY_ENTER, controls);
  EXPECT_EQ(controls.lesson.phase, LessonPhase::explains);
  press(GLFW_KEY_KP_ENTER, controls);
  EXPECT_EQ(controls.lesson.phase, LessonPhase::shows);
}

TEST(Keys, InARecordingTheLessonIsAsItWas) {
  Controls controls;
  controls.lesson.phase = LessonPhase::asks;
  controls.lessonAnswers = 3;
  press(GLFW_KEY_2, controls, KeysOf::replay);
  press(GLFW_KEY_ENTER, controls, KeysOf::replay);
  EXPECT_EQ(controls.lesson.phase, LessonPhase::asks);
  EXPECT_EQ(controls.switches.contraction, 0) << "digits are switches";
}

TEST(Keys, EveryChangeIsSaidInWords) {
  for (const KeysOf place : kPlaces) {
    for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key) {
      Controls controls;
      press(key, controls, place);
      EXPECT_EQ(changesOf(Controls{}, controls).size(), controls == Controls{} ? 0 : 1) << key;
    }
  }
}

TEST(Keys, TheMapNamesEveryKeyOnce) {
  for (const KeysOf place : kPlaces) {
    std::set<std::string> keys;
    for (const KeyLine& line : keyMap(place)) {
      EXPECT_FALSE(line.does.empty());
      EXPECT_TRUE(keys.insert(line.keys).second) << line.keys;
    }
  }
}

}  // namespace
}  // namespace carom
