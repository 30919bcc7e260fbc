// A participant's way through a study, by the pages alone: from the code to the last test, with all that
// people do on the way.
#include "app/study/study_run.h"

#include <gtest/gtest.h>

#include <string>

#include "app/study/study_code.h"
#include "app/study/study_visit.h"

namespace carom {
namespace {

using test::StudyVisit;

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

}  // namespace
}  // namespace carom
