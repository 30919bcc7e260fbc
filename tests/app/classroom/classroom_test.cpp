// A class without sockets: tokens, votes, the teacher, and how it follows the lesson on the wall.
#include "app/classroom/classroom.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <string>

#include <nlohmann/json.hpp>

#include "app/classroom/class_of_phones.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

using namespace test;

TEST_F(Class, CountsOneVoteAPhoneAndTheLastAnswer) {
  const auto all = phones(5);
  take(ClassStep::ask);
  now_s_ = 107.5;
  for (const auto id : all) answer(id, 1);
  answer(all[0], 3);
  const auto again = phone("token-1");  // another tab of the same phone
  EXPECT_EQ(told(again)["yours"], 3);
  EXPECT_EQ(answer(again, 2)["answered"], 5);
  room_.receive(all[1], PhoneReason{"I guess", 1}, now_s_);
  EXPECT_TRUE(room_.takeVotes().empty()) << "nothing counts before the vote is closed";
  take(ClassStep::close);
  const std::vector<ClassVote> votes = room_.takeVotes();
  ASSERT_EQ(votes.size(), 5U);
  EXPECT_EQ(votes[0], (ClassVote{1, "Twins", "Who is older?", "token-1", "At home", 2, 7.5, ""}));
  EXPECT_EQ(votes[1], (ClassVote{1, "Twins", "Who is older?", "token-2", "Neither", 2, 7.5, "I guess"}));
  EXPECT_EQ(told(all[0])["counts"], Json::parse("[[4, 1, 0]]"));
}

TEST_F(Class, RefusesVotesThatAreNone) {
  const auto id = phone();
  EXPECT_EQ(answer(id, 1)["refused"], texts::phone::kVoteClosed.english()) << "not asked yet";
  take(ClassStep::ask);
  EXPECT_EQ(answer(id, 4)["refused"], texts::phone::kNoMessage.english()) << "the question has three answers";
  EXPECT_EQ(answer(id, 1, 2)["refused"], texts::phone::kVoteClosed.english()) << "of the second vote";
  room_.receive(id, PhoneReason{"why", 1}, now_s_);
  EXPECT_EQ(told(id)["refused"], texts::phone::kAnswerFirst.english());
  EXPECT_EQ(told(id)["answered"], 0);
  EXPECT_FALSE(told(id).contains("refused")) << "is told once";
  take(ClassStep::close);
  EXPECT_EQ(answer(id, 1)["refused"], texts::phone::kVoteClosed.english()) << "after the close";
  EXPECT_TRUE(room_.takeVotes().empty());
  const Classroom::Id nobody = ++ids_;
  room_.connect(nobody, "10.0.0.99");
  EXPECT_EQ(answer(nobody, 1), Json({{"refused", texts::phone::kHelloFirst.english()}}));
  room_.receive(id, TeacherStep{ClassStep::show}, now_s_);
  EXPECT_EQ(told(id)["refused"], texts::phone::kTeacherOnly.english());
}

TEST_F(Class, GivesTokensThatNobodyCanInvent) {
  const auto id = phone("00112233445566778899aabbccddeeff");
  EXPECT_EQ(told(id)["token"], "token-1");
  room_.leave(id);
  EXPECT_EQ(told(phone("token-1"))["token"], "token-1") << "a phone comes back";
  EXPECT_EQ(told(phone())["phones"], 2);
}

TEST_F(Class, HasOneTeacherAndGuardsThePin) {
  const auto first = teacher();
  EXPECT_EQ(told(first)["teacher"], true);
  EXPECT_EQ(told(first)["steps"], Json::parse(R"(["ask", "show", "next"])"));
  const auto second = teacher();
  EXPECT_EQ(told(second)["teacher"], true);
  EXPECT_EQ(told(first)["teacher"], false) << "somebody has taken over";
  EXPECT_FALSE(told(first).contains("steps"));
  room_.receive(first, TeacherStep{ClassStep::ask}, now_s_);
  EXPECT_EQ(told(first)["refused"], texts::phone::kTeacherOnly.english());
  EXPECT_EQ(told(first)["state"], "idle");
  const auto guesses = [&](Classroom::Id id, const std::string& pin) {
    room_.receive(id, TeacherPin{pin}, now_s_);
    return told(id).value("refused", "");
  };
  const auto guesser = phone();
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(guesses(guesser, std::to_string(i)), texts::phone::kWrongPin.english());
  EXPECT_EQ(guesses(guesser, "123456"), texts::phone::kTooManyPins.english());
  EXPECT_TRUE(room_.isTeacher(second));
  now_s_ += 30.0;
  EXPECT_EQ(guesses(first, "123456"), "") << "another address has tries of its own";
  EXPECT_EQ(guesses(guesser, "123456"), texts::phone::kTooManyPins.english()) << "half a minute later";
  now_s_ += 30.5;
  EXPECT_EQ(guesses(guesser, "123456"), "") << "a minute later";
  EXPECT_TRUE(room_.isTeacher(guesser));
  room_.leave(guesser);
  EXPECT_FALSE(room_.isTeacher(guesser));
}

TEST_F(Class, WishesForTheLesson) {
  for (const ClassStep step : {ClassStep::ask, ClassStep::close, ClassStep::show, ClassStep::explain})
    take(step);
  EXPECT_EQ(room_.takeWishes(), (std::vector{LessonWish::ask, LessonWish::show, LessonWish::explain}));
  take(ClassStep::next);
  EXPECT_EQ(room_.takeWishes(), std::vector{LessonWish::next});
  take(ClassStep::ask);  // before the lesson has come
  EXPECT_TRUE(room_.takeWishes().empty());
  EXPECT_EQ(room_.view().phase, ClassPhase::idle);
  ClassQuestion other = kQuestion;
  other.file = "cause.toml";
  other.lesson = "Cause";
  room_.follow({other, LessonPhase::asks}, now_s_);
  EXPECT_EQ(room_.view().phase, ClassPhase::vote) << "it was asked as soon as it came";
  EXPECT_EQ(told(phone())["lesson"], "Cause");
}

TEST_F(Class, FollowsKeysOnTheWall) {
  const auto all = phones(5);
  take(ClassStep::ask);
  for (const auto id : all) answer(id, 1);
  room_.follow({{}, LessonPhase::shows}, now_s_);
  EXPECT_EQ(room_.takeVotes().size(), 5U) << "what was answered counts";
  EXPECT_EQ(told(all[0])["state"], "shown");
  room_.follow({{}, LessonPhase::explains}, now_s_);
  EXPECT_EQ(told(all[0])["state"], "explained");
  room_.follow({kQuestion, LessonPhase::asks}, now_s_);
  EXPECT_EQ(told(all[0])["state"], "idle") << "asked anew";
  EXPECT_EQ(told(all[0])["answered"], 0);
  room_.follow({ClassQuestion{"play.toml", {}, {}, {}, 0}, LessonPhase::none}, now_s_);
  EXPECT_STREQ(room_.take(ClassStep::ask, now_s_), texts::phone::kNoQuestion);
  EXPECT_EQ(told(all[0])["answers"], Json::array());
}

TEST_F(Class, KeepsAVoteWhenTheLessonBeginsAgainForIt) {
  const auto id = phone();
  room_.follow({{}, LessonPhase::explains}, now_s_);
  room_.follow({kQuestion, LessonPhase::asks}, now_s_);
  take(ClassStep::ask);
  answer(id, 1);
  room_.follow({kQuestion, LessonPhase::asks}, now_s_);
  EXPECT_EQ(told(id)["state"], "vote");
  EXPECT_EQ(told(id)["yours"], 1);
}

TEST_F(Class, GoesOnWhereASessionBrokeOff) {
  Classroom room({"", "KIWI", "123456"}, [] { return std::string("new"); });
  ClassLeft left{"vote", 2, {"a", "b"}, {}};
  for (const char* token : {"a", "b", "c", "d", "e"})
    left.votes.push_back({1, "Twins", kQuestion.question, token, "Neither", 1, 3.0, ""});
  room.resume(left);
  room.follow({kQuestion, LessonPhase::asks}, 50.0);
  room.connect(1, "10.0.0.1");
  room.receive(1, PhoneHello{"b"}, 50.0);
  Json told = Json::parse(room.messageFor(1));
  EXPECT_EQ(told["token"], "b");
  EXPECT_EQ(told["state"], "vote");
  EXPECT_EQ(told["round"], 2);
  EXPECT_EQ(told["first"], 1);
  EXPECT_EQ(told["yours"], nullptr);
  room.receive(1, PhoneAnswer{2, 0, 2}, 53.0);
  EXPECT_FALSE(room.take(ClassStep::close, 60.0));
  const auto votes = room.takeVotes();
  ASSERT_EQ(votes.size(), 1U) << "those of the first vote stand in the file already";
  EXPECT_EQ(votes[0], (ClassVote{2, "Twins", kQuestion.question, "b", "At home", 0, 3.0, ""}));
  EXPECT_EQ(Json::parse(room.messageFor(1))["counts"], Json::parse("[[5, 0, 0], []]"));
}

TEST_F(Class, RemembersALimitedNumberOfPhones) {
  for (std::size_t i = 0; i < 3 * Classroom::kMostPhones; ++i) room_.leave(phone());
  EXPECT_EQ(told(phone())["phones"], 1);
  for (std::size_t i = 1; i < Classroom::kMostPhones; ++i) phone();
  EXPECT_EQ(told(phone())["refused"], texts::phone::kFull.english());
}

/// A class of any size does any steps: what each is told is compared with a count by hand.
TEST_F(Class, CountsAsASlowReferenceDoes) {
  std::mt19937 random(37);
  const auto any = [&](int most) { return std::uniform_int_distribution(0, most)(random); };
  const auto all = phones(12);
  for (int lesson = 0; lesson < 50; ++lesson) {
    std::array<std::map<std::size_t, int>, 2> given;
    take(ClassStep::ask);
    for (int round = 1; round <= 2; ++round) {
      for (int i = any(40); i > 0; --i) {
        const auto who = static_cast<std::size_t>(any(11));
        given[round - 1][who] = 1 + any(2);
        answer(all[who], given[round - 1][who], round);
      }
      take(ClassStep::close);
      EXPECT_EQ(room_.takeVotes().size(), given[round - 1].size()) << "lesson " << lesson;
      if (round == 1) take(ClassStep::discuss);
      if (round == 1) take(ClassStep::again);
    }
    Json expected = Json::array();
    for (const auto& votes : given) {
      Json counts = Json::array();
      if (votes.size() >= 5) counts = {0, 0, 0};
      for (const auto& [who, choice] : votes) {
        if (votes.size() >= 5) counts[choice - 1] = counts[choice - 1].get<int>() + 1;
      }
      expected.push_back(counts);
    }
    const Json found = told(all[0]);
    if (expected == Json::parse("[[], []]")) {
      EXPECT_FALSE(found.contains("counts")) << "lesson " << lesson;
    } else {
      EXPECT_EQ(found["counts"], expected) << "lesson " << lesson;
    }
    take(ClassStep::next);
    room_.follow({kQuestion, LessonPhase::asks}, now_s_);
  }
}

}  // namespace
}  // namespace carom
