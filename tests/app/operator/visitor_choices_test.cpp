// The shipped games that keys lead to, and the captions of a game.
#include "app/operator/visitor_choices.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include "app/operator/wall_commands.h"
#include "app/scenario/scenario.h"
#include "cave/record/effects.h"
#include "cave/texts/texts.h"
#include "places.h"

namespace carom {
namespace {

TEST(VisitorChoices, LeadsThroughEveryShippedLessonAndBack) {
  std::set<std::string> lessons, visited;
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/scenarios")) {
    if (readScenario(entry.path()).lesson) lessons.insert(entry.path().stem().string());
  }
  std::string file = fileOfGame(kWelcome);
  for (std::size_t i = 0; i < kLessons.size(); ++i) {
    file = lessonAfter(file);
    visited.insert(std::filesystem::path(file).stem().string());
  }
  EXPECT_EQ(visited, lessons);
  EXPECT_EQ(lessonAfter(file), fileOfGame(kLessons.front()));
}

// Where nobody can walk, the lesson that asks people to is left out, and no other.
TEST(VisitorChoices, LeavesOutTheLessonOfWalkersWhereNobodyCanWalk) {
  OperatorSettings settings;
  settings.canWalk = false;
  std::set<std::string> visited;
  for (std::size_t i = 0; i + 1 < kLessons.size(); ++i) {
    settings.lastLesson = std::get<PlayScenario>(commandOf(Choice::lessons, settings)).file;
    visited.insert(std::filesystem::path(settings.lastLesson).stem().string());
  }
  EXPECT_EQ(visited.size(), kLessons.size() - 1);
  EXPECT_FALSE(visited.contains(std::string(kLessonOfWalkers)));
  EXPECT_EQ(lessonAfter(settings.lastLesson, false), fileOfGame(kLessons.front()));
}

TEST(VisitorChoices, LessonsGoOnAfterTheOneSeenLast) {
  OperatorSettings settings;
  settings.playing = fileOfGame(kWelcome);
  EXPECT_EQ(commandOf(Choice::lessons, settings), Command(PlayScenario{fileOfGame(kLessons[0]), true}));
  settings.lastLesson = fileOfGame(kLessons[2]);
  EXPECT_EQ(commandOf(Choice::lessons, settings), Command(PlayScenario{fileOfGame(kLessons[3]), true}));
  settings.lastLesson = fileOfGame(kLessons.back());
  EXPECT_EQ(commandOf(Choice::lessons, settings), Command(PlayScenario{fileOfGame(kLessons[0]), true}));
  EXPECT_EQ(commandOf(Choice::play, settings), Command(PlayScenario{fileOfGame(kWelcome), true}));
  EXPECT_EQ(commandOf(Choice::showMe, settings), Command(PlayScenario{fileOfGame(kShowMe), true}));
}

TEST(WallCommands, TheButtonOfSpacetimeTurnsItsViewOnAndOff) {
  OperatorSettings settings;
  const WallAction button{WallAction::Kind::spacetime};
  EXPECT_EQ(commandOf(button, settings), Command(SetView{&TimeViews::spacetime, true}));
  settings.views.spacetime = 1;
  EXPECT_EQ(commandOf(button, settings), Command(SetView{&TimeViews::spacetime, false}));
  for (const char* lesson : {"two-cushions", "cause", "twins", "train-in-tunnel"})
    EXPECT_TRUE(readScenario(fileOfGame(lesson)).lesson->plan.offersSpacetime) << lesson;
}

TEST(WallCommands, TheButtonOfAnEffectTurnsItOffAndOn) {
  OperatorSettings settings;
  for (const NamedSwitch& effect : kNamedSwitches) {
    const WallAction button{WallAction::Kind::effect, numberOf(effect.value)};
    for (const bool on : {false, true}) {
      settings.switches.*effect.value = on ? 0 : 1;
      EXPECT_EQ(commandOf(button, settings), Command(SetSwitch{effect.value, false, on})) << effect.name;
    }
  }
  EXPECT_EQ(readScenario(fileOfGame("rolling-wheel")).lesson->plan.effects,
            (std::vector<std::uint8_t>{numberOf(&Switches::retardation), numberOf(&Switches::contraction)}));
}

TEST(VisitorChoices, TheFirstMinuteOffersTheChoices) {
  EXPECT_TRUE(readScenario(fileOfGame(kWelcome)).choices);
  EXPECT_TRUE(readScenario(fileOfGame(kShowMe)).choices);
  for (const std::string_view lesson : kLessons)
    EXPECT_TRUE(readScenario(fileOfGame(lesson)).choices) << lesson;
  EXPECT_FALSE(readScenario(fileOfGame("three-pucks")).choices);
}

TEST(VisitorChoices, TheWelcomeGoesOnByItselfAndSaysHowToStrike) {
  const Scenario welcome = readScenario(fileOfGame(kWelcome));
  EXPECT_FALSE(welcome.lesson);
  ASSERT_FALSE(welcome.captions.empty());
  EXPECT_EQ(welcome.captions.front().from_s, 0.0);
  EXPECT_NE(welcome.captions.front().text.find("drag back"), std::string::npos);
  for (const Caption& caption : welcome.captions) {
    for (const char* key : {"H lists", "W A S D", "mouse", "Home:"})
      EXPECT_EQ(caption.handText.find(key), std::string::npos) << "a wand has no keys: " << caption.handText;
    EXPECT_FALSE(caption.handText.empty());
  }
  // Some move from before the beginning on, others are struck as it begins.
  std::size_t moving = welcome.billiard.strokes.size();
  for (const Puck& puck : welcome.billiard.pucks) moving += glm::length(puck.beta) > 0.1 ? 1U : 0U;
  for (const Stroke& stroke : welcome.billiard.strokes) EXPECT_EQ(stroke.at_s, 0.0);
  EXPECT_GT(moving, welcome.billiard.pucks.size() / 2);
}

TEST(VisitorChoices, ShowMeLastsAboutAMinute) {
  const Scenario show = readScenario(fileOfGame(kShowMe));
  ASSERT_GE(show.captions.size(), 5U);
  const Caption& last = show.captions.back();
  EXPECT_GE(last.from_s, 55.0);
  EXPECT_LE(last.from_s, 70.0);
  EXPECT_TRUE(show.tourAtOnce);
}

TEST(VisitorChoices, TheNextLanguageComesAfterTheLastOneAgain) {
  OperatorSettings settings;
  EXPECT_EQ(nextLanguage(settings, 0), Command(TellPerson{texts::message::kOneLanguage}));
  settings.languages = std::make_shared<const SessionLanguages>(SessionLanguages{{"fr"}, {}});
  EXPECT_EQ(nextLanguage(settings, 0), Command(TellPerson{texts::message::kOneLanguage}));
  settings.languages = std::make_shared<const SessionLanguages>(SessionLanguages{{"fr", "en", "ja"}, {1}});
  settings.languageOf = {1, 2};
  EXPECT_EQ(nextLanguage(settings, 0), Command(SetLanguage{0, 2}));
  EXPECT_EQ(nextLanguage(settings, 1), Command(SetLanguage{1, 0}));
}

}  // namespace
}  // namespace carom
