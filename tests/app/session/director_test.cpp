// How rank 0's director has commands take effect, whoever gives them.
#include "app/session/director.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "app/operator/wall_commands.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

/// Shows what the settings say; gives a hand's command where one is set.
class Shows : public FrameSource {
 public:
  void next(const FrameTimes& times, const FrameInput& input, OperatorSettings& settings,
            Decision& decision) override {
    given.assign(input.commands.begin(), input.commands.end());
    FrameRecord& record = decision.frame.record = {};
    record.number = times.number;
    record.display_s = static_cast<double>(times.number);
    record.lesson = settings.lesson;
    putInto(record, settings);
    decision.showsShot = shotUntil > times.number;
    if (byCaption) decision.commands.push_back(*std::exchange(byCaption, std::nullopt));
    if (byHand) decision.handCommands.push_back({*std::exchange(byHand, std::nullopt), 1});
  }

  Commands given;
  std::optional<Command> byCaption, byHand;  ///< the hand is the second viewer's
  std::uint64_t shotUntil = 0;
};

class DirectorTest : public testing::Test {
 protected:
  void decide(FrameLeader& leader, const WindowInput& input) {
    testing::internal::CaptureStderr();
    leader.decide(pacer_.next(), input, decision_);
    said_ = testing::internal::GetCapturedStderr();
  }
  const FrameRecord& frame(const WindowInput& input = {}) {
    decide(leader_, input);
    return decision_.frame.record;
  }
  /// The game that a frame of this leader asks for.
  NextGame next(FrameLeader& leader, const WindowInput& input = {}) {
    decide(leader, input);
    return leader.takeNextGame();
  }
  static WindowInput pressing(int key) { return {{{key, true}, {key, false}}, false}; }
  std::vector<std::string> inputs() const {
    std::vector<std::string> all;
    for (const Note& input : decision_.inputs) all.push_back(input.what + ": " + input.value);
    return all;
  }

  using Words = std::vector<std::string>;
  Shows source_;
  FramePacer pacer_;
  FrameLeader leader_{source_, KeysOf::session, {}, nullptr};
  Decision decision_;
  std::string said_;
};

TEST_F(DirectorTest, AKeyHoldsInTheFrameThatItIsToldOf) {
  EXPECT_EQ(frame().switches.colour, 0);
  EXPECT_EQ(inputs(), Words{});
  EXPECT_EQ(frame(pressing(GLFW_KEY_4)).switches.colour, 1);
  EXPECT_EQ(inputs(), Words{"colour: on"});
  EXPECT_EQ(said_, "colour: on\n");
  EXPECT_EQ(source_.given, (Commands{SetSwitch{&Switches::colour, false, true}}));
  EXPECT_EQ(frame().switches.colour, 1) << "it stays so";
  EXPECT_EQ(inputs(), Words{}) << "it is told once";
  EXPECT_TRUE(source_.given.empty());
}

TEST_F(DirectorTest, TheConsolesCommandsComeBeforeTheKeys) {
  leader_.inbox().emplace_back(SetView{&TimeViews::paths, true});
  EXPECT_EQ(frame(pressing(GLFW_KEY_P)).views.paths, 0) << "the key turns off what the click has turned on";
  EXPECT_EQ(inputs(), (Words{"paths: on", "paths: off"}));
  EXPECT_EQ(frame().views.paths, 0);
}

TEST_F(DirectorTest, WhatChangesNothingIsNotTold) {
  leader_.inbox().emplace_back(SetLightSpeed{leader_.settings().lightSpeed_m_s});
  leader_.inbox().emplace_back(ChooseInLesson{1});
  frame();
  EXPECT_EQ(inputs(), Words{});
  EXPECT_EQ(said_, "");
}

TEST_F(DirectorTest, AHandsButtonHoldsFromTheNextFrameOn) {
  OperatorSettings asking;
  asking.lesson.phase = LessonPhase::asks;
  asking.lessonAnswers = 2;
  leader_.begin(asking);
  source_.byHand = ChooseInLesson{2};
  EXPECT_EQ(frame().lesson.phase, LessonPhase::asks);
  EXPECT_EQ(frame().lesson, (LessonState{LessonPhase::shows, 2}));
  EXPECT_EQ(inputs(), Words{"lesson: shows, answered 2"});
  EXPECT_EQ(decision_.inputs.front().viewer, 1U);
  EXPECT_EQ(frame().lesson, (LessonState{LessonPhase::shows, 2}));
  EXPECT_EQ(inputs(), Words{});
}

TEST_F(DirectorTest, TheNextVisitorBeginsWithTheFirstGame) {
  OperatorSettings settings;
  settings.playing = "first.toml";
  FrameLeader leader(source_, KeysOf::session, settings, nullptr);
  leader.inbox().emplace_back(PlayScenario{"second.toml"});
  NextGame game = next(leader);
  EXPECT_EQ(game.file, "second.toml");
  EXPECT_FALSE(game.isForNextVisitor);
  game = next(leader, pressing(GLFW_KEY_F8));
  EXPECT_EQ(game.file, "first.toml");
  EXPECT_TRUE(game.isForNextVisitor);
}

// A frame a second. After 60 s without anybody, games attract people: the key at 100 s is that of somebody
// new. The patience counts from the latest sign of life, and a room that nobody has entered since is not
// welcomed again.
TEST_F(DirectorTest, InAStudyNobodyLeavesTheirLesson) {
  const std::string own = "lesson.toml";
  leader_.allowOnly([&](const std::string& file) { return file == own; });
  for (const int key : {GLFW_KEY_F5, GLFW_KEY_F6, GLFW_KEY_F7, GLFW_KEY_F8}) {
    EXPECT_EQ(next(leader_, pressing(key)).file, "") << key;
    EXPECT_NE(said_.find("is locked while people take part"), std::string::npos) << said_;
    EXPECT_EQ(source_.given, Commands{TellPerson{texts::message::kNoSuchKey}}) << "who presses it is told";
  }
  leader_.inbox().emplace_back(PlayScenario{"another.toml"});  // at the console
  EXPECT_EQ(next(leader_).file, "");
  source_.byHand = PlayScenario{"another.toml"};
  EXPECT_EQ(next(leader_).file, "");
  EXPECT_EQ(next(leader_).file, "") << "the hand's button holds from the next frame on";
  leader_.inbox().emplace_back(PlayScenario{own, true});  // of the study
  EXPECT_EQ(next(leader_).file, own);
}

TEST_F(DirectorTest, AnAbandonedSessionWelcomesTheNextVisitorOnce) {
  OperatorSettings settings;
  settings.playing = "first.toml";
  FrameLeader leader(source_, KeysOf::session, settings, nullptr, 60.0);
  std::vector<int> welcomed;
  for (int frame = 0; frame < 600; ++frame) {
    const bool presses = frame == 100;
    if (frame >= 130 && frame < 140)
      decision_.heads[0].pose.position_m.x = 0.01 * (frame - 129);                         // a step of 10 cm
    if (frame >= 300) decision_.heads[0].pose.position_m.y = frame % 2 == 0 ? 0.01 : 0.0;  // noise
    const WindowInput input = presses ? pressing(GLFW_KEY_4) : WindowInput{};
    if (next(leader, input).isForNextVisitor) welcomed.push_back(frame);
  }
  EXPECT_EQ(welcomed, (std::vector<int>{100, 195})) << "60 s after the head had moved by more than 5 cm";
}

// Commands of the source itself, as captions give them, are no sign of life; the key that welcomes the next
// visitor is none either.
TEST_F(DirectorTest, ACaptionIsNoSignOfLife) {
  OperatorSettings settings;
  settings.playing = "first.toml";
  FrameLeader leader(source_, KeysOf::session, settings, nullptr, 60.0);
  std::vector<int> welcomed;
  for (int frame = 0; frame < 400; ++frame) {
    if (frame % 40 == 20) source_.byCaption = SetView{&TimeViews::boardNow, frame % 80 == 20};
    const WindowInput input = frame == 100 ? pressing(GLFW_KEY_F8) : WindowInput{};
    if (next(leader, input).isForNextVisitor) welcomed.push_back(frame);
  }
  EXPECT_EQ(welcomed, (std::vector<int>{100}));
}

// A frame a second: the walls are still lit in the first frame and black in the next.
TEST_F(DirectorTest, TheWallsGoDarkBeforeAnotherGame) {
  EXPECT_EQ(frame(pressing(GLFW_KEY_Y)).last, 0u) << "nothing is played that could begin again";
  leader_.inbox().emplace_back(PlayScenario{"another.toml"});
  EXPECT_EQ(frame().last, 0u);
  EXPECT_EQ(decision_.frame.record.fade, 0.0);
  EXPECT_EQ(inputs(), Words{"scenario: another.toml"});
  EXPECT_EQ(frame().last, 1u);
  EXPECT_EQ(decision_.frame.record.fade, 1.0);
  EXPECT_EQ(leader_.takeNextGame().file, "another.toml");
  EXPECT_EQ(leader_.takeNextGame().file, "");
  EXPECT_EQ(frame().last, 0u);
  EXPECT_EQ(decision_.frame.record.fade, 0.0);
}

// The first game of the playlist lasts 5 s. Its best shot takes 3 s more, which somebody who chooses a game
// cuts short.
TEST_F(DirectorTest, TheBestShotEndsAGameOfThePlaylist) {
  Playlist playlist;
  playlist.games.resize(2);
  playlist.games[0].scenario = "first.toml";
  playlist.games[0].for_s = 5.0;
  playlist.games[1].scenario = "second.toml";
  OperatorSettings settings;
  settings.playing = "first.toml";
  settings.playlist = std::make_shared<const Playlist>(playlist);
  for (const bool choosesAnother : {false, true}) {
    SCOPED_TRACE(choosesAnother);
    FramePacer pacer;
    FrameLeader leader(source_, KeysOf::session, settings, nullptr);
    source_.shotUntil = 0;
    std::uint64_t frames = 0;
    for (decision_ = {}; !decision_.frame.record.last && frames < 20; ++frames) {
      if (frames == 6) {
        EXPECT_EQ(source_.shotUntil, 0u);
        source_.shotUntil = 9;
      }
      if (frames == 7 && choosesAnother) leader.inbox().emplace_back(PlayScenario{"third.toml"});
      leader.decide(pacer.next(), {}, decision_);
      EXPECT_EQ(!source_.given.empty(), frames == 6 || (frames == 7 && choosesAnother)) << frames;
    }
    EXPECT_EQ(frames, choosesAnother ? 9u : 11u);
    EXPECT_EQ(leader.takeNextGame().file, choosesAnother ? "third.toml" : "second.toml");
  }
}

// After 60 s without anybody a game is to attract people. Somebody comes while the walls go dark for it.
TEST_F(DirectorTest, WhoComesWhileTheWallsGoDarkIsWelcomed) {
  OperatorSettings settings;
  settings.playing = "first.toml";
  for (const bool comes : {false, true}) {
    SCOPED_TRACE(comes);
    FramePacer pacer;
    FrameLeader leader(source_, KeysOf::session, settings, nullptr, 60.0);
    int frame = 0;
    for (decision_ = {}; !decision_.frame.record.last && frame < 100; ++frame)
      leader.decide(pacer.next(), comes && frame == 61 ? pressing(GLFW_KEY_4) : WindowInput{}, decision_);
    EXPECT_EQ(frame, 62);
    const NextGame next = leader.takeNextGame();
    EXPECT_EQ(next.attracts, !comes);
    EXPECT_EQ(next.isForNextVisitor, comes);
  }
}

TEST_F(DirectorTest, TheListOfKeysIsShownAndSaid) {
  frame(pressing(GLFW_KEY_H));
  EXPECT_TRUE(leader_.settings().keysShown);
  EXPECT_EQ(said_.find("keys: on\nKeys: 1 light delay (retardation)"), 0u) << said_;
  frame(pressing(GLFW_KEY_F1));
  EXPECT_FALSE(leader_.settings().keysShown);
}

TEST(FollowingDirector, DecidesNothing) {
  Director follower;
  Decision decision;
  decision.frame.record.number = 7;
  follower.decide({}, {{{GLFW_KEY_4, true}}, false}, decision);
  EXPECT_EQ(decision.frame.record.number, 7u);
  EXPECT_TRUE(decision.inputs.empty());
  EXPECT_EQ(follower.settings(), OperatorSettings{});
}

TEST_F(DirectorTest, F9GoesThroughTheLanguagesOfTheFirstViewerAndAHandThroughItsOwn) {
  EXPECT_EQ(frame(pressing(GLFW_KEY_F9)).viewers[0].language, 0);
  EXPECT_EQ(inputs(), Words{std::string("refused: ") + texts::message::kOneLanguage.english()});
  OperatorSettings settings;
  settings.languages = std::make_shared<const SessionLanguages>(SessionLanguages{{"fr", "ja"}, {}, true});
  leader_.begin(settings);
  EXPECT_EQ(frame().languagesOnTile, 2);
  EXPECT_EQ(frame(pressing(GLFW_KEY_F9)).viewers[0].language, 1);
  EXPECT_EQ(inputs(), Words{"language: ja"});
  EXPECT_EQ(decision_.inputs.at(0).viewer, 0U);
  EXPECT_EQ(frame().viewers[0].language, 1) << "it stays so";
  EXPECT_EQ(frame(pressing(GLFW_KEY_F9)).viewers[0].language, 0) << "after the last one comes the first";
  source_.byHand = *commandOf(WallAction{WallAction::Kind::language, 1}, leader_.settings(), 1);
  frame();
  const FrameRecord& record = frame();
  EXPECT_EQ(record.viewers[0].language, 0);
  EXPECT_EQ(record.viewers[1].language, 1);
  EXPECT_EQ(decision_.inputs.at(0).viewer, 1U);
  leader_.inbox().emplace_back(SetLanguage{2, 1});  // of the console, for anyone
  EXPECT_EQ(frame().viewers[2].language, 1);
  EXPECT_EQ(decision_.inputs.at(0).viewer, 2U);
}

}  // namespace
}  // namespace carom
