// What a session's keys change.
#include "app/keys.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <set>

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
  EXPECT_TRUE(seen.contains(Shown::testPattern) && seen.contains(Shown::seamPattern));
  EXPECT_EQ(controls, Controls{});
}

TEST(Keys, WithoutASessionTNeverGoesToOne) {
  Controls controls;
  controls.walls.shown = Shown::testPattern;
  for (int i = 0; i < 9; ++i) {
    press(GLFW_KEY_T, controls, KeysOf::patterns);
    EXPECT_NE(controls.walls.shown, Shown::session);
  }
}

TEST(Keys, PressedTwiceMostKeysChangeNothing) {
  const std::set<int> steps{GLFW_KEY_T,     GLFW_KEY_EQUAL,        GLFW_KEY_KP_ADD,
                            GLFW_KEY_MINUS, GLFW_KEY_KP_SUBTRACT,  GLFW_KEY_LEFT,
                            GLFW_KEY_RIGHT, GLFW_KEY_UP,           GLFW_KEY_DOWN,
                            GLFW_KEY_HOME,  GLFW_KEY_LEFT_BRACKET, GLFW_KEY_RIGHT_BRACKET};
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
