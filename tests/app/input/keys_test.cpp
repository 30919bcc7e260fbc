// What a session's keys change.
#include "app/input/keys.h"
#include "cave/texts/texts.h"
#include "engine/base/limits.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace carom {
namespace {

constexpr std::array kPlaces{KeysOf::session, KeysOf::replay, KeysOf::patterns, KeysOf::dryRun};

WindowInput pressing(int key) { return {{{key, true}, {key, false}}, false}; }

/// Returns what the key asks for.
Commands commandsOf(int key, const OperatorSettings& settings, KeysOf place = KeysOf::session) {
  return carom::commandsOf(pressing(key), place, 10.0, settings);
}

/// Returns how many things were changed.
int press(int key, OperatorSettings& settings, KeysOf place = KeysOf::session) {
  int changed = 0;
  for (const Command& command : commandsOf(key, settings, place)) changed += apply(command, settings);
  return changed;
}

TEST(Keys, TGoesThroughThePatternsAndBackToTheSession) {
  OperatorSettings settings;
  std::set<Shown> seen;
  do {
    press(GLFW_KEY_T, settings);
    seen.insert(settings.walls.shown);
  } while (settings.walls.shown != Shown::session && seen.size() < 9);
  EXPECT_TRUE(seen.contains(Shown::calibrationPattern) && seen.contains(Shown::alignmentPattern));
  EXPECT_EQ(settings, OperatorSettings{});
}

TEST(Keys, WithoutASessionTNeverGoesToOne) {
  OperatorSettings settings;
  settings.walls.shown = Shown::calibrationPattern;
  for (int i = 0; i < 9; ++i) {
    press(GLFW_KEY_T, settings, KeysOf::patterns);
    EXPECT_NE(settings.walls.shown, Shown::session);
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
      OperatorSettings settings;
      press(key, settings, place);
      press(key, settings, place);
      EXPECT_EQ(settings, OperatorSettings{}) << key;
    }
  }
}

TEST(Keys, TheKeyForAThingChangesThatThingAlone) {
  std::vector<std::string> things{"walls", "eyes", "shown", "latency", "tracker cross"};
  for (const NamedSwitch& s : kNamedSwitches) {
    things.emplace_back(s.name);
    things.emplace_back(std::string("beside: ") + s.name);
  }
  for (const NamedView& view : kNamedViews) things.emplace_back(view.name);
  for (const std::string& thing : things) {
    const KeyLine line = keyFor(KeysOf::session, thing);
    ASSERT_TRUE(line.keys.size() == 1u || line.keys == "F11") << thing << ": " << line.keys;
    // GLFW's numbers of letters, digits and signs are theirs.
    const Commands commands = commandsOf(line.keys == "F11" ? kKeyF11 : line.keys.front(), {});
    ASSERT_EQ(commands.size(), 1u) << thing;
    EXPECT_EQ(nameOf(commands.front()), thing);
  }
  EXPECT_EQ(keyFor(KeysOf::replay, "playback").keys, "Space");
  EXPECT_TRUE(keyFor(KeysOf::replay, "light speed").keys.empty());
  EXPECT_TRUE(keyFor(KeysOf::session, "no such thing").does.empty());
}

TEST(Keys, EveryGIsAWishToSetOut) {
  EXPECT_EQ(commandsOf(GLFW_KEY_G, {}), Commands{StartTour{}});
  EXPECT_EQ(commandsOf(GLFW_KEY_G, {}, KeysOf::replay), Commands{})
      << "a recorded person goes where they went";
}

TEST(Keys, YPlaysTheGameThatIsPlayed) {
  OperatorSettings settings;
  EXPECT_EQ(press(GLFW_KEY_Y, settings), 0) << "none is";
  settings.playing = "game.toml";
  EXPECT_EQ(commandsOf(GLFW_KEY_Y, settings), Commands{PlayScenario{"game.toml"}});
}

TEST(Keys, KeysOfOneFrameGoOnFromEachOther) {
  const WindowInput twice{
      {{GLFW_KEY_RIGHT, true}, {GLFW_KEY_1, true}, {GLFW_KEY_RIGHT, true}, {GLFW_KEY_1, true}}, false};
  const SetSwitch off{&Switches::retardation, false, false}, on{&Switches::retardation, false, true};
  EXPECT_EQ(carom::commandsOf(twice, KeysOf::replay, 10.0, {}), (Commands{Seek{11.0}, off, Seek{12.0}, on}));
}

TEST(Keys, PlusAndMinusSetTheEyesAMillimetreFurtherAndCloser) {
  for (const auto& [further, closer] :
       {std::pair{GLFW_KEY_EQUAL, GLFW_KEY_MINUS}, std::pair{GLFW_KEY_KP_ADD, GLFW_KEY_KP_SUBTRACT}}) {
    OperatorSettings settings;
    double& apart_m = settings.eyeSeparation_m;
    press(further, settings);
    EXPECT_DOUBLE_EQ(apart_m, 0.065);
    for (int i = 0; i < 40; ++i) press(further, settings);
    EXPECT_DOUBLE_EQ(apart_m, 0.080);
    press(closer, settings);
    EXPECT_DOUBLE_EQ(apart_m, 0.079);
    for (int i = 0; i < 100; ++i) press(closer, settings);
    EXPECT_EQ(apart_m, 0.0);
    press(further, settings);
    EXPECT_DOUBLE_EQ(apart_m, 0.001);
  }
}

TEST(Keys, BracketsChangeTheSpeedOfLightWithinItsBounds) {
  OperatorSettings settings;
  press(GLFW_KEY_RIGHT_BRACKET, settings);
  EXPECT_GT(settings.lightSpeed_m_s, OperatorSettings{}.lightSpeed_m_s);
  press(GLFW_KEY_LEFT_BRACKET, settings);
  EXPECT_NEAR(settings.lightSpeed_m_s, OperatorSettings{}.lightSpeed_m_s, 1e-12);
  for (int i = 0; i < 200; ++i) press(GLFW_KEY_LEFT_BRACKET, settings);
  EXPECT_EQ(settings.lightSpeed_m_s, kLeastLightSpeed_m_s);
  for (int i = 0; i < 200; ++i) press(GLFW_KEY_RIGHT_BRACKET, settings);
  EXPECT_EQ(settings.lightSpeed_m_s, kMostLightSpeed_m_s);
}

TEST(Keys, ArrowsGoThroughARecordingAndMeanNothingInASession) {
  OperatorSettings settings;
  EXPECT_EQ(commandsOf(GLFW_KEY_RIGHT, settings, KeysOf::replay), Commands{Seek{11.0}});
  EXPECT_EQ(commandsOf(GLFW_KEY_LEFT, settings, KeysOf::replay), Commands{Seek{9.0}});
  EXPECT_EQ(commandsOf(GLFW_KEY_HOME, settings, KeysOf::replay), Commands{Seek{0.0}});
  press(GLFW_KEY_UP, settings, KeysOf::replay);
  press(GLFW_KEY_R, settings, KeysOf::replay);
  press(GLFW_KEY_SPACE, settings, KeysOf::replay);
  EXPECT_EQ(settings.playback, (Playback{true, -2.0}));
  for (int i = 0; i < 20; ++i) press(GLFW_KEY_DOWN, settings, KeysOf::replay);
  EXPECT_EQ(settings.playback.rate, -1.0 / 16.0);

  for (const int key : {GLFW_KEY_RIGHT, GLFW_KEY_LEFT, GLFW_KEY_UP, GLFW_KEY_R})
    EXPECT_EQ(commandsOf(key, {}), Commands{TellPerson{texts::message::kNoSuchKey}});
  EXPECT_EQ(commandsOf(GLFW_KEY_SPACE, {}), Commands{}) << "it brakes";
}

TEST(Keys, AKeyThatDoesNothingSaysSoUnlessItSteersOrIsTheDesktops) {
  EXPECT_EQ(commandsOf(GLFW_KEY_DOWN, {}), Commands{TellPerson{texts::message::kNoSuchKey}});
  EXPECT_EQ(commandsOf(GLFW_KEY_F9, {}), Commands{TellPerson{texts::message::kOneLanguage}});
  for (const int key :
       {GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_S, GLFW_KEY_D, GLFW_KEY_Q, GLFW_KEY_ESCAPE, GLFW_KEY_F12,
        GLFW_KEY_LEFT_SHIFT, GLFW_KEY_TAB, GLFW_KEY_LEFT_SUPER, GLFW_KEY_PRINT_SCREEN})
    EXPECT_EQ(commandsOf(key, {}), Commands{}) << key;
  EXPECT_EQ(commandsOf(GLFW_KEY_F2, {}), Commands{TellPerson{texts::message::kNoVelocities}});
}

TEST(Keys, F10ShowsTheConsoleAndHidesIt) {
  OperatorSettings settings;
  EXPECT_EQ(commandsOf(GLFW_KEY_F10, settings), Commands{TellPerson{texts::message::kNoConsole}});
  settings.console = ConsoleState::waits;
  EXPECT_EQ(press(GLFW_KEY_F10, settings), 1);
  EXPECT_EQ(settings.console, ConsoleState::shown);
  EXPECT_EQ(press(GLFW_KEY_F10, settings, KeysOf::replay), 1);
  EXPECT_EQ(settings.console, ConsoleState::waits);
}

TEST(Keys, WhileALessonAsksDigitsAnswerAndDoNothingElse) {
  for (const int digit : {0, 1, 2, 3, 4, 9}) {
    OperatorSettings settings;
    settings.lesson.phase = LessonPhase::asks;
    settings.lessonAnswers = 3;
    const OperatorSettings asking = settings;
    const int changed = press(GLFW_KEY_0 + digit, settings);
    EXPECT_EQ(settings.switches, asking.switches) << digit;
    EXPECT_EQ(settings.views, asking.views) << digit;
    const bool answers = digit >= 1 && digit <= 3;
    EXPECT_EQ(settings.lesson,
              answers ? (LessonState{LessonPhase::shows, static_cast<std::uint8_t>(digit)}) : asking.lesson);
    EXPECT_EQ(changed, answers ? 1 : 0);
  }
}

TEST(Keys, OnceItIsAnsweredDigitsAreSwitchesAgainAndEnterGoesOn) {
  OperatorSettings settings;
  settings.lesson.phase = LessonPhase::asks;
  settings.lessonAnswers = 3;
  press(GLFW_KEY_KP_2, settings);
  EXPECT_EQ(settings.lesson, (LessonState{LessonPhase::shows, 2}));
  press(GLFW_KEY_1, settings);
  EXPECT_EQ(settings.switches.retardation, 0);
  EXPECT_EQ(settings.lesson.answer, 2);
  press(GLFW_KEY_ENTER, settings);
  EXPECT_EQ(settings.lesson.phase, LessonPhase::explains);
  press(GLFW_KEY_KP_ENTER, settings);
  EXPECT_EQ(settings.lesson.phase, LessonPhase::shows);
}

TEST(Keys, InARecordingTheLessonIsAsItWas) {
  OperatorSettings settings;
  settings.lesson.phase = LessonPhase::asks;
  settings.lessonAnswers = 3;
  press(GLFW_KEY_2, settings, KeysOf::replay);
  press(GLFW_KEY_ENTER, settings, KeysOf::replay);
  EXPECT_EQ(settings.lesson.phase, LessonPhase::asks);
  EXPECT_EQ(settings.switches.contraction, 0) << "digits are switches";
}

TEST(Keys, EveryCommandIsSaidInWords) {
  std::set<std::string> said;
  for (const KeysOf place : kPlaces) {
    for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key) {
      OperatorSettings settings;
      settings.playing = "game.toml";
      for (const Command& command : commandsOf(key, settings, place)) {
        apply(command, settings);
        said.insert(toString(command, settings));
      }
    }
  }
  for (const char* words :
       {"retardation: off", "beside: colour: on", "board-now: on", "walls: black", "eyes: swapped",
        "shown: test patterns", "tracker cross: on", "latency: on", "keys: on", "eye separation: 65.0 mm",
        "light speed: 1.5 m/s", "lesson: none", "tour: asked for", "scenario: game.toml", "playback: paused",
        "playback rate: 2", "playback: from 11.00 s"}) {
    EXPECT_TRUE(said.contains(words)) << words;
  }
}

// A dry run has all keys of a session. Those that walk are no mistake there, and are listed.
TEST(Keys, InADryRunTheArrowsWalkAndTheOthersAreThoseOfASession) {
  const OperatorSettings settings;
  const Commands noSuchKey{TellPerson{texts::message::kNoSuchKey}};
  for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key) {
    const bool isArrow = key >= GLFW_KEY_RIGHT && key <= GLFW_KEY_UP;
    EXPECT_EQ(commandsOf(key, settings, KeysOf::dryRun),
              isArrow ? Commands{} : commandsOf(key, settings, KeysOf::session))
        << key;
    if (!isArrow) continue;
    EXPECT_EQ(commandsOf(key, settings, KeysOf::session), noSuchKey);
  }
  EXPECT_EQ(keyMap(KeysOf::dryRun).size(), keyMap(KeysOf::session).size() + 3);
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
