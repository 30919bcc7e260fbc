// What commands do to the operator's settings, and their words.
#include "app/operator/command.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>
#include <vector>

#include "app/temporary_folder.h"
#include "places.h"

namespace carom {
namespace {

struct Case {
  Command command;
  const char* words;
};

/// Commands that each change one thing of the settings as they begin.
std::vector<Case> changes() {
  std::vector<Case> cases{{ShowOnWalls{Shown::alignmentPattern}, "shown: seam pattern"},
                          {ShowKeys{true}, "keys: on"},
                          {SetEyeSeparation{0.0615}, "eye separation: 61.5 mm"},
                          {SetLightSpeed{299792458.0}, "light speed: 3e+08 m/s"},
                          {Pause{true}, "playback: paused"},
                          {KeepTaskBest{2, 0.125}, "best of task: 3: 0.125 J"},
                          {SetRate{-0.25}, "playback rate: -0.25"},
                          {SetWalls{&WallControls::blank, true}, "walls: black"},
                          {SetWalls{&WallControls::eyesSwapped, true}, "eyes: swapped"},
                          {SetWalls{&WallControls::trackerCross, true}, "tracker cross: on"},
                          {SetWalls{&WallControls::latency, true}, "latency: on"}};
  for (const NamedSwitch& s : kNamedSwitches) cases.push_back({SetSwitch{s.value, true, true}, nullptr});
  for (const NamedView& view : kNamedViews) cases.push_back({SetView{view.value, true}, nullptr});
  cases.push_back({SetSwitch{&Switches::retardation, false, false}, "retardation: off"});
  cases.push_back({SetSwitch{&Switches::searchlight, false, true}, "searchlight: on"});
  cases.push_back({SetSwitch{&Switches::contraction, true, true}, "beside: contraction: on"});
  cases.push_back({SetView{&TimeViews::myNow, true}, "my-now: on"});
  return cases;
}

TEST(Command, ChangesOneThingOnceAndSaysWhat) {
  for (const Case& given : changes()) {
    OperatorSettings settings;
    SCOPED_TRACE(toString(given.command, settings));
    EXPECT_TRUE(apply(given.command, settings));
    EXPECT_NE(settings, OperatorSettings{});
    const OperatorSettings once = settings;
    EXPECT_FALSE(apply(given.command, settings)) << "it is so already";
    EXPECT_EQ(settings, once);
    if (given.words) {
      EXPECT_EQ(toString(given.command, settings), given.words);
    }
  }
}

TEST(Command, OfATaskTheLeastEnergyIsKept) {
  OperatorSettings settings;
  settings.playing = "tasks.toml";
  EXPECT_TRUE(apply(KeepTaskBest{1, 0.3}, settings));
  EXPECT_FALSE(apply(KeepTaskBest{1, 0.4}, settings));
  EXPECT_TRUE(apply(KeepTaskBest{1, 0.2}, settings));
  settings.playing = "others.toml";
  EXPECT_TRUE(apply(KeepTaskBest{1, 0.4}, settings)) << "tasks of another scenario are other tasks";
  using Best = decltype(settings.bestOfTask_j);
  EXPECT_EQ(settings.bestOfTask_j, (Best{{{"tasks.toml", 1}, 0.2}, {{"others.toml", 1}, 0.4}}));
}

TEST(Command, SwitchesOfTheHalvesAreApart) {
  OperatorSettings settings;
  apply(SetSwitch{&Switches::aberration, false, false}, settings);
  EXPECT_EQ(settings.switches.aberration, 0);
  EXPECT_EQ(settings.views.beside, kNoSwitches);
  apply(SetSwitch{&Switches::aberration, true, true}, settings);
  EXPECT_EQ(settings.switches.aberration, 0);
  EXPECT_EQ(settings.views.beside.aberration, 1);
}

TEST(Command, EachViewerReadsALanguageOfTheSession) {
  OperatorSettings settings;
  EXPECT_FALSE(apply(SetLanguage{0, 0}, settings)) << "there is English alone";
  const SessionLanguages languages{{"fr", "/words/mine.po"}, {}, true};
  settings.languages = std::make_shared<const SessionLanguages>(languages);
  EXPECT_FALSE(apply(SetLanguage{0, 0}, settings)) << "it is so already";
  EXPECT_FALSE(apply(SetLanguage{0, 2}, settings)) << "there is no such language";
  EXPECT_FALSE(apply(SetLanguage{kMostViewers, 1}, settings)) << "there is no such viewer";
  EXPECT_TRUE(apply(SetLanguage{1, 1}, settings));
  EXPECT_EQ(settings.languageOf, (std::array<std::uint8_t, kMostViewers>{0, 1, 0, 0}));
  EXPECT_EQ(toString(SetLanguage{1, 1}, settings), "language: /words/mine.po");
  FrameRecord record;
  putInto(record, settings);
  EXPECT_EQ(record.viewers[0].language, 0);
  EXPECT_EQ(record.viewers[1].language, 1);
  EXPECT_EQ(record.languagesOnTile, 2);
  OperatorSettings taken;
  takeFrom(record, taken);
  EXPECT_EQ(taken.languageOf, settings.languageOf);
}

TEST(Command, OrdersOfOneMomentLeaveTheSettings) {
  for (const Command& order :
       {Command(StartTour{}), Command(PlayScenario{"game.toml"}), Command(Seek{3.0})}) {
    OperatorSettings settings;
    EXPECT_TRUE(apply(order, settings)) << toString(order, settings);
    EXPECT_EQ(settings, OperatorSettings{}) << toString(order, settings);
  }
  OperatorSettings settings;
  EXPECT_FALSE(apply(PlayScenario{""}, settings)) << "nothing is played that could begin again";
}

TEST(Command, AnAnswerOfOneButtonComesBeforeGoingOn) {
  EXPECT_EQ(lessonCommand(2, true), Command(ChooseInLesson{2}));
  EXPECT_EQ(lessonCommand(0, true), Command(AdvanceLesson{}));
  EXPECT_FALSE(lessonCommand(0, false));
}

TEST(Command, ALessonIsAnsweredOnceAndToldAsItThenIs) {
  OperatorSettings settings;
  settings.lesson.phase = LessonPhase::asks;
  settings.lessonAnswers = 3;
  EXPECT_FALSE(apply(ChooseInLesson{4}, settings)) << "there is no such answer";
  EXPECT_TRUE(apply(ChooseInLesson{2}, settings));
  EXPECT_EQ(toString(ChooseInLesson{2}, settings), "lesson: shows, answered 2");
  EXPECT_FALSE(apply(ChooseInLesson{1}, settings)) << "it has been answered";
  EXPECT_TRUE(apply(AdvanceLesson{}, settings));
  EXPECT_EQ(toString(AdvanceLesson{}, settings), "lesson: explains, answered 2");
}

TEST(Command, TheLastOrderOfAFrameCounts) {
  const Commands commands{Seek{1.0}, Pause{true}, Seek{2.0}, StartTour{}};
  ASSERT_TRUE(lastOf<Seek>(commands));
  EXPECT_EQ(lastOf<Seek>(commands)->session_s, 2.0);
  EXPECT_TRUE(lastOf<StartTour>(commands));
  EXPECT_FALSE(lastOf<SetRate>(commands));
}

// Files know a view by its place: a new one comes after these.
TEST(NamedViews, KeepTheirPlaces) {
  const std::vector<std::string_view> known{"board-now", "my-now", "paths",     "events", "clocks",
                                            "split",     "frozen", "ruler",     "angles", "strain",
                                            "heat",      "news",   "spacetime", "speeds"};
  ASSERT_GE(kNamedViews.size(), known.size());
  for (std::size_t i = 0; i < known.size(); ++i) EXPECT_EQ(kNamedViews[i].name, known[i]);
}

TEST(NamedViews, HaveWordsAndAFlagOfTheirOwn) {
  for (std::size_t i = 0; i < kNamedViews.size(); ++i) {
    EXPECT_STRNE(kNamedViews[i].words.english(), "") << kNamedViews[i].name;
    EXPECT_STRNE(kNamedViews[i].tip.english(), "") << kNamedViews[i].name;
    TimeViews views;
    views.*kNamedViews[i].value = 1;
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_EQ(views.*kNamedViews[j].value, 0)
          << kNamedViews[i].name << " has the flag of " << kNamedViews[j].name;
  }
}

// The page of players is written by hand beside the rows.
TEST(NamedViews, AreAllOnThePageWithTheirKeys) {
  const std::string page = test::contentOf(CAROM_TESTS_DIR "/../app/doc/playing.md");
  for (const NamedView& view : kNamedViews) {
    const std::string key = view.key == kKeyF11 ? "F11" : std::string(1, static_cast<char>(view.key));
    EXPECT_NE(page.find(fmt::format("\n| {} | `{}` |", key, view.name)), std::string::npos) << view.name;
  }
}

TEST(NamedSwitches, AreAllOnThePageWithTheirKeys) {
  const std::string page = test::contentOf(CAROM_TESTS_DIR "/../app/doc/playing.md");
  for (const NamedSwitch& effect : kNamedSwitches)
    EXPECT_NE(page.find(fmt::format("\n| {} | {}", effect.key, effect.name)), std::string::npos)
        << effect.name;
}

}  // namespace
}  // namespace carom
