// A study as the frames see it: lessons that it wants, what an arm leaves out, and orders of the console.
#include "app/class_server/study_desk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>

#include "app/study/study_code.h"
#include "app/temporary_folder.h"
#include "app/web_client.h"

namespace carom {
namespace {

using test::TemporaryFolder;

/// A study with one participant, who is about to begin the lessons, and its desk.
class Desk : public testing::Test {
 protected:
  Desk() {
    const auto session = folder_ / "day.db";
    SQLite::Database(session.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
        .exec(
            "CREATE TABLE session(key TEXT PRIMARY KEY, value); CREATE TABLE game(first_frame INTEGER); "
            "INSERT INTO game VALUES(42)");
    plan_ = allocate(study_).front();
    const ParticipantRow row{code_,
                             "a",
                             1,
                             plan_.orderRow,
                             "ABC",
                             "take-part",
                             "1234",
                             "2026-11-23",
                             static_cast<int>(StudyStep::wellBefore),
                             0,
                             ""};
    StudyTables(session, study_, false).write(row);
    desk_ = std::make_unique<StudyDesk>(study_, StudyDeskOptions{session,
                                                                 {{code_, 1}},
                                                                 false,
                                                                 "waiting.toml",
                                                                 {"127.0.0.1", 0, "KIWI", "123456"},
                                                                 study_.arms[0].rig});
    settings_.switches.aberration = 1;
    settings_.switches.contraction = 1;
    settings_.views.paths = 1;
  }

  /// Sends a form as a tablet does, and returns the address of the page that follows.
  std::string post(const std::string& form) {
    const std::string address = desk_->address();
    const std::size_t port = address.rfind(':') + 1;
    test::WebClient tablet(static_cast<std::uint16_t>(std::stoi(address.substr(port))));
    tablet.send("POST /study HTTP/1.1\r\nHost: " + tablet.host() +
                "\r\nContent-Length: " + std::to_string(form.size()) + "\r\n\r\n" + form);
    const std::string answer = tablet.rest(), named = "Location: ";
    const std::size_t begin = answer.find(named);
    EXPECT_NE(begin, std::string::npos) << answer;
    if (begin == std::string::npos) return {};
    return answer.substr(begin + named.size(), answer.find('\r', begin) - begin - named.size());
  }
  /// Goes on from a page.
  void goOn(const std::string& fields = "step=4") { post("token=" + token_ + "&item=0&go=next&" + fields); }
  void enterRoom() {
    const std::string address = post("go=code&code=" + code_);
    token_ = address.substr(address.find('=') + 1);
    goOn("step=3&unwell-before=1");
  }
  Commands commands() {
    Commands commands;
    desk_->command(settings_, 7.0, commands);
    return commands;
  }
  /// Returns the file that is to be played by a command that is the only one; empty if there is none.
  std::string wanted() {
    const Commands all = commands();
    EXPECT_LE(all.size(), 1U);
    const auto* play = all.empty() ? nullptr : std::get_if<PlayScenario>(&all.front());
    return play ? play->file : "";
  }
  std::string lesson(std::size_t place) const {
    return study_.lessons.at(plan_.lessons.at(place)).scenario.string();
  }

  const TemporaryFolder folder_;
  const std::string code_ = newCodes(1)[0];
  const Study study_ = readStudy(folder_.file(
      "study.toml",
      "title = \"T\"\nseed = 5\nparticipants = 4\nlessons = [\"light-clock\", \"twins\"]\n[[arm]]\nname = "
      "\"a\"\nrig = \"desk\"\nhead = \"still\"\nswitches_off = [\"aberration\"]\nviews_off = [\"paths\"]\n"));
  Participant plan_;
  OperatorSettings settings_;
  std::string token_;
  std::unique_ptr<StudyDesk> desk_;
};

TEST_F(Desk, BetweenLessonsTheWallsAreBlack) {
  EXPECT_EQ(wanted(), "");
  ASSERT_EQ(desk_->standings().size(), 1U);
  EXPECT_EQ(desk_->standings()[0].words, "rating");
  EXPECT_FALSE(desk_->play(lesson(0))) << "a lesson that no participant is in";
  EXPECT_FALSE(desk_->allows(lesson(0)) || desk_->isStill());
  desk_->applyTo(settings_);
  EXPECT_EQ(settings_.walls.blank, 1);
  EXPECT_EQ(settings_.switches.aberration, 1);
}

TEST_F(Desk, ALessonIsWantedOnceAndLacksWhatItsArmLeavesOut) {
  enterRoom();
  EXPECT_EQ(wanted(), lesson(0));
  EXPECT_EQ(wanted(), "") << "it is asked for once";
  EXPECT_TRUE(desk_->allows(lesson(0)));
  EXPECT_FALSE(desk_->allows(lesson(1)));
  ASSERT_TRUE(desk_->play(lesson(0)));
  desk_->begun();
  SQLite::Database session((folder_ / "day.db").string());
  const auto begun = participationsIn(session);
  ASSERT_EQ(begun.size(), 1U);
  EXPECT_EQ(begun[0].code + begun[0].lesson, code_ + study_.lessons[plan_.lessons[0]].name);
  EXPECT_EQ(begun[0].firstFrame, 42);
  EXPECT_TRUE(desk_->isStill());
  const Commands off = commands();
  EXPECT_EQ(off.size(), 2U) << "an effect and a view that the operator has switched on";
  OperatorSettings put = settings_;
  for (const Command& command : off) apply(command, put);
  desk_->applyTo(settings_);
  for (const OperatorSettings* settings : {&put, &settings_}) {
    EXPECT_EQ(settings->switches.aberration, 0);
    EXPECT_EQ(settings->switches.contraction, 1);
    EXPECT_EQ(settings->views.paths, 0);
    EXPECT_EQ(settings->walls.blank, 0);
  }
  EXPECT_EQ(wanted(), "") << "all of it is off";
}

TEST_F(Desk, TheNextLessonFollowsOneThatHasExplainedItself) {
  enterRoom();
  wanted();
  ASSERT_TRUE(desk_->play(lesson(0)));
  desk_->applyTo(settings_);
  goOn();
  EXPECT_EQ(wanted(), "") << "it has not explained itself";
  settings_.lesson.phase = LessonPhase::explains;
  EXPECT_EQ(wanted(), "");
  goOn();
  EXPECT_EQ(wanted(), lesson(1));
  ASSERT_TRUE(desk_->play(lesson(1)));
  settings_.lesson.phase = LessonPhase::asks;
  EXPECT_EQ(wanted(), "");
  settings_.lesson.phase = LessonPhase::explains;
  EXPECT_EQ(wanted(), "");
  goOn();
  EXPECT_EQ(wanted(), "waiting.toml") << "the room waits during the test";
  EXPECT_FALSE(desk_->play("waiting.toml"));
  EXPECT_FALSE(desk_->isStill());
}

TEST_F(Desk, OrdersOfTheConsoleAreCarriedOutWithAFrame) {
  desk_->order(StopInRoom{});
  EXPECT_EQ(desk_->said(), "");
  commands();
  EXPECT_EQ(desk_->said(), "Nobody is in a lesson.");
  enterRoom();
  desk_->order(StopInRoom{});
  EXPECT_EQ(wanted(), lesson(0));
  EXPECT_EQ(desk_->said(), code_ + " has stopped.");
  EXPECT_EQ(wanted(), "waiting.toml");
  EXPECT_TRUE(desk_->standings().empty());
}

}  // namespace
}  // namespace carom
