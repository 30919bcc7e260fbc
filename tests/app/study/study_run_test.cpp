// A participant's way through a study, by the pages alone: from the code to the last test, with all that
// people do on the way.
#include "app/study/study_run.h"

#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "app/journal/session_games.h"
#include "app/study/slips.h"
#include "app/study/study_code.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::TemporaryFolder;

/// A session file with as many tables as a study asks for, a study of it, and its pages.
class StudyVisit {
 public:
  explicit StudyVisit(const std::string& more = "reasons = true\n", bool isAmended = false)
      : study_(folder_.file("study.toml",
                            "title = \"T\"\nseed = 5\nparticipants = 4\nlessons = "
                            "[\"light-clock\", \"twins\"]\n" +
                                more + "[[arm]]\nname = \"a\"\nrig = \"desk\"\n")),
        session_(folder_ / "day.db") {
    if (!std::filesystem::exists(session_)) {
      SQLite::Database made(session_.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
      made.exec(
          "CREATE TABLE session(key TEXT PRIMARY KEY, value); CREATE TABLE game(first_frame INTEGER); "
          "INSERT INTO game VALUES(0)");
    }
    codes_ = newCodes(4);
    open(isAmended);
  }

  void open(bool isAmended = false) {
    run_.reset();
    tables_.reset();
    const Study study = readStudy(study_);
    tables_ = std::make_unique<StudyTables>(session_, study, isAmended);
    StudyRun::Setup setup{
        study, {}, "# Consent\n", [this] { return std::to_string(++tokens_); }, [this] { return day_; }};
    for (std::size_t i = 0; i < codes_.size(); ++i) setup.slips[codes_[i]] = i + 1;
    run_ = std::make_unique<StudyRun>(std::move(setup), *tables_);
  }

  /// Sends a form on the page that was last seen: its hidden fields and these.
  const std::string& send(const std::string& fields) {
    static const std::regex hidden("type=\"hidden\" name=\"(\\w+)\" value=\"([^\"]*)\"");
    std::string form = fields;
    for (std::sregex_iterator it(page_.begin(), page_.end(), hidden), end; it != end; ++it)
      form += "&" + (*it)[1].str() + "=" + (*it)[2].str();
    return goTo(run_->take(form, now_s_ += 10.0));
  }
  /// Asks for the page of an address, as a browser does.
  const std::string& goTo(const std::string& address) {
    address_ = address;
    const std::size_t query = address.find('?');
    return page_ = run_->page(query == std::string::npos ? "" : address.substr(query + 1));
  }
  const std::string& enter(const std::string& code) {
    goTo("/study");
    return send("go=code&code=" + code);
  }
  bool says(const std::string& words) const { return page_.find(words) != std::string::npos; }

  void answerForm(std::size_t form, bool isRight) {
    for (const Item* item : run_->study().bank.ofForm(form)) {
      ASSERT_TRUE(says("Question ")) << page_;
      std::string answer;
      for (const ItemAnswer& one : item->answers) {
        if (one.isRight == isRight) answer = one.id;
      }
      send("go=next&confidence=3&answer=" + answer);
    }
    ASSERT_TRUE(says("Hand in"));
    send("go=next");
  }
  /// From the code to the lessons.
  void beginWith(const std::string& code) {
    enter(code);
    send("go=next&part=yes&paths=yes");
    send("go=next&age_band=18-24&relativity=read&language=Deutsch");
    answerForm(plan(code).forms[0], false);
    send("go=next&unwell-before=1");
  }
  Participant plan(const std::string& code) const {
    const auto number = std::find(codes_.begin(), codes_.end(), code) - codes_.begin();
    return allocate(run_->study())[static_cast<std::size_t>(number)];
  }
  std::vector<ResponseRow> responses(const std::string& code, const std::string& phase) {
    std::vector<ResponseRow> rows = responsesOf(tables_->database(), code);
    std::erase_if(rows, [&](const ResponseRow& row) { return row.phase != phase; });
    return rows;
  }
  ParticipantRow row(const std::string& code) {
    for (const ParticipantRow& one : participantsIn(tables_->database())) {
      if (one.code == code) return one;
    }
    return {};
  }

  TemporaryFolder folder_;
  std::filesystem::path study_, session_;
  std::vector<std::string> codes_;
  std::unique_ptr<StudyTables> tables_;
  std::unique_ptr<StudyRun> run_;
  std::string page_, address_, day_ = "2026-11-23";
  int tokens_ = 100;
  double now_s_ = 0.0;
};

TEST(StudyRun, LeadsFromTheCodeToTheLastTest) {
  StudyVisit run;
  const std::string code = run.codes_[2];
  const Participant plan = run.plan(code);
  run.enter(code);
  ASSERT_TRUE(run.says("Before you begin"));
  EXPECT_TRUE(run.row(code).code.empty()) << "somebody who has not agreed is stored";
  run.send("go=next&paths=yes");
  EXPECT_TRUE(run.says("tick the first box"));
  run.send("go=next&part=yes&paths=yes");
  ASSERT_TRUE(run.says("About you"));
  EXPECT_FALSE(run.says("gender"));
  run.send("go=next&age_band=18-24&physics_years=99&language=%D0%A0%D1%83%D1%81%D1%81%D0%BA%D0%B8%D0%B9");
  run.answerForm(plan.forms[0], false);
  EXPECT_FALSE(run.run_->takeWish()) << "a lesson begins before the rating";
  run.send("go=next");
  EXPECT_TRUE(run.says("choose a number"));
  run.send("go=next&unwell-before=2");
  for (std::size_t lesson = 0; lesson < 2; ++lesson) {
    ASSERT_TRUE(run.says("Lesson " + std::to_string(lesson + 1) + " of 2"));
    const auto wish = run.run_->takeWish();
    ASSERT_TRUE(wish);
    EXPECT_EQ(wish->code, code);
    EXPECT_EQ(wish->lesson, plan.lessons[lesson]);
    EXPECT_EQ(wish->position, lesson + 1);
    EXPECT_FALSE(run.run_->takeWish());
    run.run_->lessonBegins(*wish);
    EXPECT_TRUE(run.run_->lessonExplains(*wish));
    run.send("go=next");
  }
  ASSERT_TRUE(run.run_->takeWish()->code.empty()) << "the room waits during the test";
  run.answerForm(plan.forms[1], true);
  run.send("go=next&unwell-after=0&hard=3&there=8");
  ASSERT_TRUE(run.says("For today this was all"));

  const ParticipantRow row = run.row(code);
  EXPECT_EQ(row.consent, "take-part paths");
  EXPECT_EQ(row.arm, "a");
  EXPECT_EQ(row.startedUtc, "2026-11-23");
  EXPECT_EQ(row.orderRow, plan.orderRow);
  EXPECT_EQ(row.forms, std::string(kForms[plan.forms[0]]) + kForms[plan.forms[1]] + kForms[plan.forms[2]]);
  const auto pre = run.responses(code, "pre"), post = run.responses(code, "post");
  ASSERT_EQ(pre.size(), 18U);
  ASSERT_EQ(post.size(), 18U);
  for (const ResponseRow& answer : pre) {
    EXPECT_EQ(answer.form, kForms[plan.forms[0]]);
    EXPECT_DOUBLE_EQ(answer.seconds, 10.0);
    EXPECT_EQ(answer.confidence, 3);
    EXPECT_FALSE(run.run_->study().bank.find(answer.item, plan.forms[0])->answer(answer.answer)->isRight);
  }
  for (const ResponseRow& answer : post)
    EXPECT_TRUE(run.run_->study().bank.find(answer.item, plan.forms[1])->answer(answer.answer)->isRight);
  const auto background = run.responses(code, "background");
  const auto answered = [&](const std::string& item) {
    for (const ResponseRow& one : background) {
      if (one.item == item) return one.answer;
    }
    return std::string("none");
  };
  EXPECT_EQ(answered("age_band"), "18-24");
  EXPECT_EQ(answered("physics_years"), "") << "a band that there is not";
  EXPECT_EQ(answered("language"), "\xD0\xA0\xD1\x83\xD1\x81\xD1\x81\xD0\xBA\xD0\xB8\xD0\xB9");
  EXPECT_EQ(run.responses(code, "rating").size(), 4U);
  EXPECT_EQ(participationsIn(run.tables_->database()).size(), 2U);

  run.enter(code);
  EXPECT_TRUE(run.says("This code was used. Its last test comes 7 days after")) << run.page_;
  run.day_ = "2026-11-30";
  run.enter(code);
  run.answerForm(plan.forms[2], true);
  EXPECT_TRUE(run.says("This was the last test"));
  EXPECT_EQ(run.responses(code, "delayed").size(), 18U);
  run.enter(code);
  EXPECT_TRUE(run.says("its last test is handed in"));
}

TEST(StudyRun, RefusesCodesThatCannotBeUsed) {
  StudyVisit run;
  std::string mistyped = run.codes_[0];
  mistyped[1] = mistyped[1] == 'A' ? 'B' : 'A';
  run.enter(mistyped);
  EXPECT_TRUE(run.says("a letter of it is mistyped"));
  std::string unknown = newCodes(1)[0];
  run.enter(unknown);
  EXPECT_TRUE(run.says("This code is none of this study"));
  run.tables_->database().exec("INSERT INTO session VALUES('study_withdrawn', '" +
                               withdrawnMark(run.codes_[1]) + "')");
  run.open();  // nobody's data are deleted while a session runs
  run.enter(run.codes_[1]);
  EXPECT_TRUE(run.says("were deleted"));
  run.enter(run.codes_[0]);
  run.send("go=next&part=yes");
  run.send("go=stop-now");
  EXPECT_TRUE(run.says("About you")) << "stopped without having been asked";
  run.send("go=stop");
  ASSERT_TRUE(run.says("Do you want to stop?"));
  EXPECT_TRUE(run.says("is kept, but left out of the analysis; with the code of your slip")) << run.page_;
  run.send("go=stay");
  ASSERT_TRUE(run.says("About you"));
  EXPECT_EQ(run.row(run.codes_[0]).excluded, "");
  run.send("go=stop");
  run.send("go=stop-now");
  EXPECT_TRUE(run.says("You have stopped. What you answered so far is kept, but left out of the analysis."));
  EXPECT_EQ(run.row(run.codes_[0]).excluded, "stopped");
  run.enter(run.codes_[0]);
  EXPECT_TRUE(run.says("its participant stopped"));
}

TEST(StudyRun, WhoClosesThePageGoesOnWhereTheyWereAlsoAfterARestart) {
  StudyVisit run;
  const std::string code = run.codes_[0];
  run.enter(code);
  run.send("go=next&part=yes");
  run.send("go=next");
  const Item first = *run.run_->study().bank.ofForm(run.plan(code).forms[0])[0];
  run.send("go=next&confidence=4&reason=Because&answer=" + first.answers[1].id);
  const std::string old = run.page_;
  run.enter(code);
  EXPECT_TRUE(run.says("Question 2 of 18"));
  run.page_ = old;  // the page that was left open has lost its place
  run.send("go=next&confidence=1&answer=dont-know");
  EXPECT_TRUE(run.says("The code of your slip"));
  run.open();  // the program was ended
  run.enter(code);
  ASSERT_TRUE(run.says("Question 1 of 18"));
  EXPECT_TRUE(run.says("value=\"" + first.answers[1].id + "\" checked"));
  EXPECT_TRUE(run.says(">Because</textarea>"));
}

TEST(StudyRun, WhoGoesBackChangesAnswersAndEachChangeIsStored) {
  StudyVisit run;
  const std::string code = run.codes_[0];
  run.enter(code);
  run.send("go=next&part=yes");
  run.send("go=next");
  const Item* first = run.run_->study().bank.ofForm(run.plan(code).forms[0])[0];
  run.send("go=next&confidence=1&answer=" + first->answers[0].id);
  run.send("go=back");
  run.send("go=next&confidence=2&answer=" + first->answers[1].id);
  run.send("go=back");
  run.send("go=next&answer=nonsense&confidence=9");
  const auto rows = run.responses(code, "pre");
  ASSERT_GE(rows.size(), 1U);
  EXPECT_EQ(rows[0].item, first->id);
  EXPECT_EQ(rows[0].answer, first->answers[1].id);
  EXPECT_EQ(rows[0].confidence, 2);
  EXPECT_EQ(rows[0].changes, 1);
  EXPECT_DOUBLE_EQ(rows[0].seconds, 30.0);
  SQLite::Statement changes(run.tables_->database(), "SELECT count(*) FROM response_change WHERE item = ?");
  changes.bind(1, first->id);
  ASSERT_TRUE(changes.executeStep());
  EXPECT_EQ(changes.getColumn(0).getInt(), 2);
}

TEST(StudyRun, ItemsWithoutAnAnswerHaveARowOnceTheTestIsHandedIn) {
  StudyVisit run;
  const std::string code = run.codes_[0];
  run.enter(code);
  run.send("go=next&part=yes");
  run.send("go=next");
  for (int item = 0; item < 18; ++item) run.send("go=next");
  ASSERT_TRUE(run.says("18 of the questions have no answer yet"));
  run.send("go=back");
  EXPECT_TRUE(run.says("Question 18 of 18"));
  run.send("go=next");
  run.send("go=next");
  EXPECT_TRUE(run.says("How are you?"));
  EXPECT_EQ(run.responses(code, "pre").size(), 18U);
}

TEST(StudyRun, WhoFeelsUnwellIsOfferedToStopAndOneIsInTheRoomAtATime) {
  StudyVisit run;
  run.beginWith(run.codes_[0]);
  ASSERT_TRUE(run.run_->takeWish());
  const std::string first = run.page_;
  run.beginWith(run.codes_[1]);
  EXPECT_TRUE(run.says("The room is not ready for you yet"));
  EXPECT_FALSE(run.run_->takeWish());
  run.send("go=next");
  EXPECT_TRUE(run.says("The room is not ready for you yet"));
  const std::string second = run.page_;
  run.page_ = first;
  run.now_s_ += 600.0;
  run.send("go=next");
  ASSERT_TRUE(run.says("How unwell do you feel now?"));
  run.send("go=rate");
  ASSERT_TRUE(run.says("choose a number"));
  run.send("go=rate&unwell-during=8");
  ASSERT_TRUE(run.says("Do you want to stop?"));
  run.send("go=next");
  ASSERT_TRUE(run.says("Do you want to stop?")) << "a page of before does not pass over the offer";
  run.send("go=stop-now");
  EXPECT_TRUE(run.says("You have stopped"));
  EXPECT_TRUE(run.run_->takeWish()->code.empty());
  run.page_ = second;
  run.send("go=next");
  EXPECT_TRUE(run.says("Lesson 1 of 2"));
  EXPECT_EQ(run.run_->takeWish()->code, run.codes_[1]);
}

/// Returns what is said to an order.
std::string said(StudyVisit& run, const StudyOrder& order) {
  return run.run_->order(order, run.now_s_).value();
}

/// Returns how the owner of a code stands; none if they are not on their way. The newest standings are kept.
class Standings {
 public:
  const StudyStanding* of(StudyVisit& run, const std::string& code) {
    if (auto all = run.run_->takeStandings()) newest_ = *std::move(all);
    const auto found = std::find_if(newest_.begin(), newest_.end(),
                                    [&](const StudyStanding& one) { return one.code == code; });
    return found == newest_.end() ? nullptr : &*found;
  }

 private:
  std::vector<StudyStanding> newest_;
};

TEST(StudyRun, ACodeThatIsTypedAtTheConsoleOpensTheNextPageThatAsks) {
  StudyVisit run;
  const std::string code = run.codes_[1];
  run.goTo("/study");
  run.send("go=called&code=");
  EXPECT_TRUE(run.says("No code has been typed at the console")) << run.page_;
  EXPECT_EQ(said(run, CallCode{"AAAAAB"}), "This is no code: a letter of it is mistyped.");
  EXPECT_EQ(said(run, CallCode{newCodes(1)[0]}),
            "This code is none of this study. Please look at the slip again.");
  run.send("go=called&code=");
  EXPECT_TRUE(run.says("No code has been typed at the console")) << "a refused code lets in";
  std::string typed = code;
  std::transform(typed.begin(), typed.end(), typed.begin(), [](unsigned char c) { return std::tolower(c); });
  EXPECT_EQ(said(run, CallCode{" " + typed}), code + ": ready. On the tablet: \"My code was typed for me\".")
      << "not the arm";
  run.send("go=called&code=");
  ASSERT_TRUE(run.says("Before you begin")) << run.page_;
  run.send("go=next&part=yes");
  EXPECT_EQ(run.row(code).code, code);
  run.goTo("/study");
  run.send("go=called&code=");
  EXPECT_TRUE(run.says("No code has been typed at the console")) << "one order lets two people in";
  run.send("go=stop");
  StudyVisit open("open = true\n");
  EXPECT_EQ(said(open, CallCode{open.codes_[0]}).substr(6),
            " (a): ready. On the tablet: \"My code was typed for me\".");
}

TEST(StudyRun, WhoIsInALessonIsAskedEveryTenMinutesHowTheyFeel) {
  StudyVisit run;
  const std::string code = run.codes_[0];
  Standings standings;
  EXPECT_EQ(said(run, RateUnwell{3}), "Nobody is in a lesson.");
  EXPECT_EQ(said(run, StopInRoom{}), "Nobody is in a lesson.");
  run.beginWith(code);
  const std::string lesson = run.page_;
  ASSERT_TRUE(standings.of(run, code));
  EXPECT_EQ(standings.of(run, code)->words, "lesson 1 of 2");
  EXPECT_TRUE(standings.of(run, code)->isInRoom);
  EXPECT_FALSE(run.run_->takeStandings()) << "nothing has changed";
  const double begun_s = run.now_s_;
  int asked = 0;
  for (run.now_s_ = begun_s; run.now_s_ < begun_s + 599.0; run.now_s_ += 0.5)
    asked += run.run_->asksUnwell(run.now_s_);
  EXPECT_EQ(asked, 0);
  for (; run.now_s_ < begun_s + 661.0; run.now_s_ += 0.5) asked += run.run_->asksUnwell(run.now_s_);
  EXPECT_EQ(asked, 3) << "at 600 s, and reminded at 630 and 660";
  EXPECT_TRUE(standings.of(run, code)->isAsked);
  EXPECT_EQ(standings.of(run, code)->words, "lesson 1 of 2, asked how they feel");
  run.send("go=next");
  ASSERT_TRUE(run.says("How unwell do you feel now?")) << "the lesson's page goes on past the question";
  run.send("go=rate&unwell-during=6");
  ASSERT_TRUE(run.says("Lesson 1 of 2")) << run.page_;
  EXPECT_FALSE(standings.of(run, code)->isAsked);
  EXPECT_FALSE(run.run_->asksUnwell(run.now_s_ + 599.0));
  EXPECT_TRUE(run.run_->asksUnwell(run.now_s_ + 601.0)) << "ten minutes after the answer again";
  run.now_s_ += 601.0;
  EXPECT_EQ(said(run, RateUnwell{7}), code + " feels unwell: offer to stop.");  // who wears a headset says it
  EXPECT_TRUE(standings.of(run, code)->isUnwell);
  run.send("go=next");
  ASSERT_TRUE(run.says("Do you want to stop?"));
  run.send("go=stay");
  ASSERT_TRUE(run.says("Lesson 1 of 2"));
  EXPECT_FALSE(standings.of(run, code)->isUnwell);
  EXPECT_EQ(said(run, RateUnwell{2}), code + ": 2 is kept.");
  const auto ratings = run.responses(code, "rating");
  ASSERT_EQ(ratings.size(), 3U) << "the newest is written with the next page";
  EXPECT_EQ(ratings[1].item + " " + ratings[1].answer, "unwell-during-1 6");
  EXPECT_EQ(ratings[2].item + " " + ratings[2].answer, "unwell-during-2 7");
  EXPECT_EQ(said(run, StopInRoom{}), code + " has stopped.");
  EXPECT_TRUE(run.run_->takeWish()->code.empty()) << "the room waits for the next one";
  EXPECT_EQ(standings.of(run, code), nullptr);
  EXPECT_FALSE(run.run_->asksUnwell(run.now_s_ + 700.0));
  run.send("go=next");
  EXPECT_TRUE(run.says("You have stopped"));
  EXPECT_EQ(run.row(code).excluded, "stopped");
  EXPECT_EQ(run.responses(code, "rating").back().answer, "2");
}

TEST(StudyRun, WhoIsUnderAgeNeedsTheConsentOfAGuardian) {
  StudyVisit run;
  const std::string code = run.codes_[0];
  Standings standings;
  run.enter(code);
  run.send("go=next&part=yes");
  EXPECT_EQ(run.row(code).code, code);
  run.send("go=next&age_band=under-18");
  ASSERT_TRUE(run.says("Before you begin")) << run.page_;
  EXPECT_TRUE(
      run.says("the consent of a parent or guardian on paper is needed. Please speak to the person who"));
  ASSERT_TRUE(standings.of(run, code));
  EXPECT_EQ(standings.of(run, code)->words,
            "consent, under 18 without the consent of a guardian: speak with them");
  EXPECT_EQ(run.row(code).code, "") << "what is stored of a minor without that consent";
  run.send("go=next&part=yes");
  run.send("go=next&age_band=under-18");
  ASSERT_TRUE(run.says("Before you begin")) << "the second time";
  run.send("go=next&part=yes&guardian=yes");
  run.send("go=next&age_band=under-18");
  EXPECT_TRUE(run.says("Question 1 of 18")) << run.page_;
  EXPECT_TRUE(run.row(code).allows("guardian"));
  EXPECT_EQ(standings.of(run, code)->words, "test before");
  run.enter(run.codes_[1]);
  run.send("go=next&part=yes");
  run.send("go=next&age_band=18-24");
  EXPECT_TRUE(run.says("Question 1 of 18"));
}

TEST(StudyRun, BeforeALessonHasExplainedItselfThePageAsksOnce) {
  StudyVisit run;
  run.beginWith(run.codes_[0]);
  const RoomWish first = run.run_->takeWish().value();
  run.send("go=anyway");
  ASSERT_TRUE(run.says("Lesson 1 of 2")) << "gone on without having been asked";
  run.send("go=next");
  ASSERT_TRUE(run.says("The lesson has not explained itself yet"));
  run.send("go=next");
  ASSERT_TRUE(run.says("The lesson has not explained itself yet")) << "a form of before that is sent twice";
  run.send("go=stay");
  ASSERT_TRUE(run.says("Lesson 1 of 2"));
  EXPECT_FALSE(run.run_->takeWish());
  run.send("go=next");
  run.send("go=anyway");
  ASSERT_TRUE(run.says("Lesson 2 of 2"));
  const RoomWish second = run.run_->takeWish().value();
  EXPECT_TRUE(run.run_->lessonExplains(first)) << "which is over";
  run.send("go=next");
  ASSERT_TRUE(run.says("The lesson has not explained itself yet")) << "the first lesson's explanation";
  EXPECT_TRUE(run.run_->lessonExplains(second));
  run.send("go=next");
  EXPECT_TRUE(run.says("Question 1 of 18")) << run.page_;
}

TEST(StudyRun, APageThatIsAskedForAgainIsTheSameAndItsAddressEndsWithTheVisit) {
  StudyVisit run;
  const std::string code = run.codes_[0];
  run.enter(run.codes_[0].substr(1));
  const std::string refused = run.page_;
  EXPECT_TRUE(run.says("a letter of it is mistyped"));
  EXPECT_EQ(run.goTo(run.address_), refused);
  run.enter(code);
  const std::string address = run.address_;
  run.send("go=next&part=yes");
  run.send("go=next");
  const Item first = *run.run_->study().bank.ofForm(run.plan(code).forms[0])[0];
  run.now_s_ += 5.0;
  run.goTo(address);  // which takes nothing from the time
  run.send("go=next&confidence=1&answer=" + first.answers[0].id);
  EXPECT_DOUBLE_EQ(run.responses(code, "pre").at(0).seconds, 15.0);
  EXPECT_EQ(run.address_, address);
  const std::string second = run.page_;
  EXPECT_EQ(run.goTo(address), second);
  run.send("go=stop");
  run.send("go=stop-now");
  EXPECT_NE(run.address_, address);
  EXPECT_TRUE(run.says("You have stopped"));
  run.goTo(run.address_);
  EXPECT_TRUE(run.says("You have stopped"));
  run.goTo(address);
  EXPECT_TRUE(run.says("The code of your slip"))
      << "the address of somebody who has stopped still shows their page";
}

TEST(StudyRun, WhatTheConsoleKeptLastIsWrittenWhenTheSessionEnds) {
  StudyVisit run;
  const std::string code = run.codes_[0];
  run.beginWith(code);
  said(run, RateUnwell{5});
  run.run_.reset();
  EXPECT_EQ(run.responses(code, "rating").back().answer, "5");
}

TEST(StudyRun, AStudyThatWasChangedAfterTheFirstParticipantIsRefusedUnlessAmended) {
  StudyVisit run;
  const std::string before = run.run_->study().sha256;
  run.enter(run.codes_[0]);
  run.send("go=next&part=yes");
  std::ofstream(run.study_, std::ios::app) << "# another one\n";
  EXPECT_THROW(run.open(), std::runtime_error);
  run.open(true);
  EXPECT_EQ(sessionValue(run.tables_->database(), "study_sha256_before"), before);
  EXPECT_EQ(sessionValue(run.tables_->database(), "study_sha256"), run.run_->study().sha256);
  EXPECT_NE(before, run.run_->study().sha256);
}

TEST(StudyRun, AFullDiskIsToldAndTheAnswersAreWrittenLater) {
  StudyVisit run;
  const std::string code = run.codes_[0];
  run.enter(code);
  run.send("go=next&part=yes");
  const int pages = run.tables_->database().execAndGet("PRAGMA page_count").getInt();
  run.tables_->database().exec("PRAGMA max_page_count = " + std::to_string(pages));
  run.send("go=next&language=" + std::string(40, 'x'));
  for (int item = 0; item < 18; ++item)
    run.send("go=next&answer=dont-know&confidence=1&reason=" + std::string(200, 'y'));
  EXPECT_TRUE(run.says("cannot be stored at the moment; they are kept")) << run.page_;
  EXPECT_LT(run.responses(code, "pre").size(), 18U);
  run.tables_->database().exec("PRAGMA max_page_count = 1000000");
  run.send("go=next");
  EXPECT_FALSE(run.says("cannot be stored"));
  EXPECT_EQ(run.responses(code, "pre").size(), 18U);
  EXPECT_EQ(run.responses(code, "pre")[17].reason, std::string(200, 'y'));
}

TEST(StudyRun, HostileFormsChangeNothing) {
  StudyVisit run;
  run.enter(run.codes_[0]);
  const std::string page = run.page_;
  for (const std::string& form :
       {std::string("token=%"), std::string("&&&===&"), std::string(9000, 'a'),
        std::string("token=101&step=-1"), std::string("token=101&step=99999999999999999999&go=next"),
        std::string("code=%00%ff%zz&go=code"), std::string("token=101&step=5&go=next&answer=c"),
        std::string("\xff\xfe=\x01")}) {
    run.run_->take(form, 1.0);
    run.run_->page(form);
    EXPECT_TRUE(run.row(run.codes_[0]).code.empty()) << form;
  }
  run.page_ = page;
  run.send("go=next&part=yes");
  EXPECT_TRUE(run.says("About you"));
}

TEST(FormFields, TakesWhatBrowsersSend) {
  const FormFields fields("a=1+2&b=%C3%A4%26&c=&d&a=3&e=%0a%");
  EXPECT_EQ(fields["a"], "1 2");
  EXPECT_EQ(fields["b"], "\xC3\xA4&");
  EXPECT_TRUE(fields.has("c"));
  EXPECT_FALSE(fields.has("d"));
  EXPECT_EQ(fields["e"], "\n%");
  EXPECT_EQ(FormFields("f=%00%1b%7f")["f"], "???");
  EXPECT_EQ(FormFields("n=7")["x"], "");
  EXPECT_EQ(FormFields("n=7").number("n", 10, -1), 7);
  for (const char* wrong : {"n=11", "n=-1", "n=7x", "n=", "n=7.0", "m=7"})
    EXPECT_EQ(FormFields(wrong).number("n", 10, -1), -1) << wrong;
}

TEST(Slips, AreReadWithTheirFaults) {
  const TemporaryFolder folder;
  const std::vector<std::string> codes = newCodes(2);
  const auto read = [&](const std::string& text) { return readSlips(folder.file("slips.csv", text), 2); };
  const auto slips = read("number,code\n1," + codes[0] + "\n2," + codes[1] + "\n");
  EXPECT_EQ(slips.at(codes[0]), 1U);
  EXPECT_EQ(slips.at(codes[1]), 2U);
  for (const std::string& wrong :
       {std::string("code,number\n"), "number,code\n3," + codes[0] + "\n",
        std::string("number,code\n1,AAAAAB\n"), "number,code\n1," + codes[0] + "\n2," + codes[0] + "\n",
        std::string("number,code\n"), "number,code\n1.5," + codes[0] + "\n", std::string("number,code\n1\n")})
    EXPECT_THROW(read(wrong), InputErrors) << wrong;
}

}  // namespace
}  // namespace carom
