// The server of a class over real sockets: a lesson by phone, votes, and the teacher.
#include "app/class_server/class_server.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/class_server/served_class.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

using namespace test;
using namespace std::chrono_literals;

TEST_F(Server, LeadsThroughALesson) {
  Json told;
  std::vector<WebClient> phones;
  for (int i = 0; i < 5; ++i) phones.push_back(phone("", &told));
  EXPECT_EQ(told["state"], "idle");
  EXPECT_EQ(told["token"].get<std::string>().size(), 32U);
  WebClient leads = teacher();
  leads.say(R"({"do": "ask"})");
  for (WebClient& one : phones) {
    EXPECT_EQ(awaitState(one, "vote")["round"], 1);
    one.say(R"({"answer": 2, "confidence": 3, "round": 1})");
    EXPECT_EQ(await(one, [](const Json& now) { return now["yours"] == 2; })["confidence"], 3);
    one.say(R"({"reason": "<script>\u202eevil</script>", "round": 1})");
  }
  const Json open =
      await(leads, [](const Json& now) { return now["answered"] == 5 && now["reasons"].size() == 5; });
  EXPECT_EQ(open["reasons"][0], "<script>evil</script>");
  EXPECT_FALSE(open.contains("counts"));
  leads.say(R"({"do": "close"})");
  EXPECT_EQ(awaitState(leads, "closed")["counts"], Json::parse("[[0, 5, 0]]"));
  EXPECT_EQ(awaitState(phones[0], "closed")["counts"], Json::parse("[[0, 5, 0]]"));
  const auto votes = [&] {
    std::vector<ClassVote> all;
    for (int i = 0; i < 100 && all.empty(); ++i) {
      server_.votes().takeAll([&](ClassVote&& vote) { all.push_back(std::move(vote)); });
      std::this_thread::sleep_for(10ms);
    }
    return all;
  }();
  EXPECT_EQ(votes.size(), 5U);
  for (const char* step : {"discuss", "again", "close", "show"}) leads.say(Json({{"do", step}}).dump());
  EXPECT_EQ(awaitState(phones[0], "shown")["round"], 2);
  server_.ask(ClassStep::explain);  // at the console
  EXPECT_EQ(awaitState(phones[0], "explained")["right"], 2);
  std::vector<LessonWish> wishes;
  server_.wishes().takeAll([&](LessonWish wish) { wishes.push_back(wish); });
  EXPECT_EQ(wishes, (std::vector{LessonWish::ask, LessonWish::show, LessonWish::explain}));
}

TEST_F(Server, KeepsAPhonesAnswerOverAnotherConnection) {
  Json told;
  std::string token;
  {
    WebClient one = phone("", &told);
    token = told["token"];
    server_.ask(ClassStep::ask);
    awaitState(one, "vote");
    one.say(R"({"answer": 3, "round": 1})");
    await(one, [](const Json& now) { return now["yours"] == 3; });
  }
  phone(token, &told);
  EXPECT_EQ(told["token"], token);
  EXPECT_EQ(told["yours"], 3);
  EXPECT_EQ(told["answered"], 1);
}

TEST_F(Server, RefusesWhatIsNoVote) {
  WebClient one = phone();
  server_.ask(ClassStep::ask);
  awaitState(one, "vote");
  for (const char* wrong :
       {R"({"answer": 0, "round": 1})", R"({"answer": 9, "round": 1})", R"({"answer": "2", "round": 1})",
        R"({"answer": 2, "round": 7})", "nonsense", R"({"do": "close"})"}) {
    one.say(wrong);
    const Json told = await(one, [](const Json& now) { return now.contains("refused"); });
    EXPECT_EQ(told["answered"], 0) << wrong;
    EXPECT_EQ(told["state"], "vote") << wrong;
  }
  server_.ask(ClassStep::close);
  awaitState(one, "closed");
  one.say(R"({"answer": 2, "round": 1})");
  EXPECT_EQ(await(one, [](const Json& now) { return now.contains("refused"); })["refused"],
            texts::phone::kVoteClosed.english());
}

TEST_F(Server, HasOneTeacherAndCountsWrongPins) {
  WebClient first = teacher(), second = teacher();
  EXPECT_EQ(await(first, [](const Json& now) { return now["teacher"] == false; })["state"], "idle");
  WebClient guesser = phone("", nullptr, "127.0.0.7");
  for (int i = 0; i < 6; ++i) {
    guesser.say(Json({{"pin", i < 5 ? "00000" + std::to_string(i) : "123456"}}).dump());
    const Json told = await(guesser, [](const Json& now) { return now.contains("refused"); });
    EXPECT_EQ(told["refused"], (i < 5 ? texts::phone::kWrongPin : texts::phone::kTooManyPins).english());
  }
  second.say(R"({"do": "ask"})");
  EXPECT_EQ(awaitState(second, "vote")["teacher"], true);
}

}  // namespace
}  // namespace carom
