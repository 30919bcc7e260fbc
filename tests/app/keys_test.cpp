// What a session's keys change.
#include "app/keys.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace carom {
namespace {

WindowInput pressing(int key) { return {{{key, true}, {key, false}}, false}; }

TEST(Keys, TGoesThroughThePatternsAndBackToTheSession) {
  WallControls controls;
  for (const Shown shown : {Shown::testPattern, Shown::seamPattern, Shown::session, Shown::testPattern}) {
    steerWalls(pressing(GLFW_KEY_T), controls);
    EXPECT_EQ(controls, (WallControls{shown, 0, 0}));
  }
}

TEST(Keys, WithoutASessionTGoesBetweenThePatterns) {
  WallControls controls{Shown::testPattern, 0, 0};
  steerWalls(pressing(GLFW_KEY_T), controls, false);
  EXPECT_EQ(controls.shown, Shown::seamPattern);
  steerWalls(pressing(GLFW_KEY_T), controls, false);
  EXPECT_EQ(controls.shown, Shown::testPattern);
}

TEST(Keys, BMakesWallsBlackAndXSwapsEyes) {
  WallControls controls;
  steerWalls(pressing(GLFW_KEY_B), controls);
  EXPECT_EQ(controls, (WallControls{Shown::session, 1, 0}));
  steerWalls(pressing(GLFW_KEY_X), controls);
  EXPECT_EQ(controls, (WallControls{Shown::session, 1, 1}));
  steerWalls(pressing(GLFW_KEY_B), controls);
  steerWalls(pressing(GLFW_KEY_X), controls);
  EXPECT_EQ(controls, WallControls{});
}

TEST(Keys, PlusAndMinusSetTheEyesAMillimetreFurtherAndCloser) {
  for (const auto& [further, closer] :
       {std::pair{GLFW_KEY_EQUAL, GLFW_KEY_MINUS}, std::pair{GLFW_KEY_KP_ADD, GLFW_KEY_KP_SUBTRACT}}) {
    double apart_m = 0.064;
    setEyesApart(pressing(further), apart_m);
    EXPECT_DOUBLE_EQ(apart_m, 0.065);
    for (int i = 0; i < 40; ++i) setEyesApart(pressing(further), apart_m);
    EXPECT_DOUBLE_EQ(apart_m, 0.080);
    setEyesApart(pressing(closer), apart_m);
    EXPECT_DOUBLE_EQ(apart_m, 0.079);
    for (int i = 0; i < 100; ++i) setEyesApart(pressing(closer), apart_m);
    EXPECT_EQ(apart_m, 0.0);
    setEyesApart(pressing(further), apart_m);
    EXPECT_DOUBLE_EQ(apart_m, 0.001);
  }
}

TEST(Keys, OtherKeysChangeNothing) {
  for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key) {
    WallControls controls;
    double apart_m = 0.0635;
    steerWalls(pressing(key), controls);
    setEyesApart(pressing(key), apart_m);
    const bool steers = key == GLFW_KEY_T || key == GLFW_KEY_B || key == GLFW_KEY_X;
    const bool parts = key == GLFW_KEY_EQUAL || key == GLFW_KEY_MINUS || key == GLFW_KEY_KP_ADD ||
                       key == GLFW_KEY_KP_SUBTRACT;
    EXPECT_EQ(controls != WallControls{}, steers) << key;
    EXPECT_EQ(apart_m != 0.0635, parts) << key;
  }
}

}  // namespace
}  // namespace carom
