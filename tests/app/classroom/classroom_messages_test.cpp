// What a class is told, and who sees what when: the messages to phones and to the teacher, the view of the
// walls.
#include <gtest/gtest.h>

#include <string>

#include <nlohmann/json.hpp>

#include "app/classroom/class_of_phones.h"
#include "app/classroom/classroom.h"

namespace carom {
namespace {

using namespace test;

TEST_F(Class, TellsAPhoneHowThingsStand) {
  const auto id = phone();
  EXPECT_EQ(told(id), Json::parse(R"({"token": "token-1", "state": "idle", "round": 0, "lesson": "Twins",
    "question": "Who is older?", "answers": ["Neither", "At home", "Who flew"], "answered": 0, "phones": 1,
    "yours": null})"));
  take(ClassStep::ask);
  const Json after = answer(id, 2);
  EXPECT_EQ(after["state"], "vote");
  EXPECT_EQ(after["round"], 1);
  EXPECT_EQ(after["yours"], 2);
  EXPECT_EQ(after["answered"], 1);
}

TEST_F(Class, TellsItsWordToPagesThatMayHaveAnother) {
  EXPECT_FALSE(told(phone()).contains("word"));
  EXPECT_EQ(told(phone("of a session before"))["word"], "KIWI");
  const auto leads = teacher();
  EXPECT_EQ(told(leads)["word"], "KIWI");
  // The teacher's page asks now and then whether the class is there: it does not become a phone.
  room_.receive(leads, PhoneHello{""}, now_s_);
  EXPECT_EQ(told(leads)["phones"], 2);
  EXPECT_EQ(told(leads)["token"], "");
  EXPECT_TRUE(room_.isTeacher(leads));
}

TEST_F(Class, TellsTheTeacherTheReasonsOfBothVotes) {
  const auto all = phones(2);
  const auto leads = teacher();
  take(ClassStep::ask);
  answer(all[0], 1);
  room_.receive(all[0], PhoneReason{"first", 1}, now_s_);
  take(ClassStep::close);
  take(ClassStep::discuss);
  take(ClassStep::again);
  EXPECT_EQ(told(leads)["reasons"], Json::parse(R"(["first"])"));
  answer(all[1], 2, 2);
  room_.receive(all[1], PhoneReason{"second", 2}, now_s_);
  EXPECT_EQ(told(leads)["reasons"], Json::parse(R"(["second", "first"])"));
  EXPECT_FALSE(told(all[0]).contains("reasons"));
}

TEST_F(Class, ShowsNoDistributionBeforeTheVoteIsClosedNorOfFewerThanFive) {
  const auto all = phones(5);
  const auto leads = teacher();
  const auto isSeen = [&] {
    bool seen = room_.view().counts != ClassView{}.counts;
    for (const auto id : {all[0], leads}) seen = seen || told(id).contains("counts");
    return seen;
  };
  take(ClassStep::ask);
  for (int i = 0; i < 4; ++i) answer(all[i], 1);
  EXPECT_FALSE(isSeen());
  take(ClassStep::close);
  EXPECT_FALSE(isSeen()) << "four answers";
  EXPECT_FALSE(told(leads)["hint"].get<std::string>().empty());
  take(ClassStep::discuss);
  take(ClassStep::again);
  for (const auto id : all) answer(id, 2, 2);
  EXPECT_FALSE(isSeen()) << "the vote is open";
  take(ClassStep::close);
  EXPECT_TRUE(isSeen());
  EXPECT_EQ(told(all[0])["counts"], Json::parse("[[], [0, 5, 0]]"));
  EXPECT_EQ(told(all[0])["first"], 1);
  EXPECT_FALSE(told(all[0]).contains("right"));
  take(ClassStep::show);
  EXPECT_FALSE(told(all[0]).contains("right"));
  EXPECT_EQ(room_.view().right, 0);
  take(ClassStep::explain);
  EXPECT_EQ(told(all[0])["right"], 2);
  EXPECT_EQ(room_.view().right, 2);
}

TEST_F(Class, HidesTheFirstVoteWhileTheSecondIsOpen) {
  const auto all = phones(6);
  take(ClassStep::ask);
  for (const auto id : all) answer(id, 3);
  take(ClassStep::close);
  EXPECT_TRUE(told(all[0]).contains("counts"));
  take(ClassStep::discuss);
  EXPECT_TRUE(told(all[0]).contains("counts"));
  take(ClassStep::again);
  EXPECT_FALSE(told(all[0]).contains("counts"));
  EXPECT_EQ(told(all[0])["first"], 3);
  EXPECT_EQ(told(all[0])["yours"], nullptr);
}

}  // namespace
}  // namespace carom
