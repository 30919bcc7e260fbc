// A study as the room and the console see it: lessons that are wanted, who is how far, and the orders of the
// person who leads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>

#include "app/study/study_code.h"
#include "app/study/study_run.h"
#include "app/study/study_visit.h"

namespace carom {
namespace {

using test::StudyVisit;

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

TEST(StudyRun, WhatTheConsoleKeptLastIsWrittenWhenTheSessionEnds) {
  StudyVisit run;
  const std::string code = run.codes_[0];
  run.beginWith(code);
  said(run, RateUnwell{5});
  run.run_.reset();
  EXPECT_EQ(run.responses(code, "rating").back().answer, "5");
}

}  // namespace
}  // namespace carom
