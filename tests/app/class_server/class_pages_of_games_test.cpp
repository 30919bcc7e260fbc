// The pages of games that a class's server has: the one that is played, whose news followers get, and those
// to take home.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "app/class_server/class_server.h"
#include "app/web_client.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

using namespace test;
using namespace std::chrono_literals;
using Steady = std::chrono::steady_clock;

std::uint16_t portOf(const ClassServer& server) {
  const std::string& address = server.invitation().address;
  return static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
}

/// A server whose news are numbered: "news 1 …", and all of them "all 1 …".
class Followed : public testing::Test {
 protected:
  void begin(std::size_t bytes, const ClassLimits& limits = {}) {
    ClassServerOptions options{"127.0.0.1", 0, "KIWI", "123456", limits};
    const auto padded = [bytes](std::string words) {
      words += ' ';
      words.resize(std::max(words.size(), bytes), '.');
      return words;
    };
    options.followed = FollowedGame{
        [this] { return hasPage_ ? std::make_shared<const std::string>("<p>played</p>") : nullptr; },
        [=, this] { return padded("news " + std::to_string(++told_)); },
        [=, this] { return padded("all " + std::to_string(told_.load())); }};
    server_ = std::make_unique<ClassServer>(options);
  }
  WebClient client(const char* from = "127.0.0.1") { return WebClient(portOf(*server_), from); }
  WebClient follower() {
    WebClient one = client();
    EXPECT_EQ(one.open(one.host(), "http://" + one.host(), "/follow/socket"), 101);
    return one;
  }
  static int numberOf(const std::string& message) { return std::atoi(message.c_str() + message.find(' ')); }

  std::atomic<int> told_ = 0;
  std::atomic<bool> hasPage_ = false;
  std::unique_ptr<ClassServer> server_;
};

TEST_F(Followed, HasAPageOnceItIsMade) {
  begin(0);
  const std::string early = client().get("/follow");
  EXPECT_EQ(early.substr(9, 3), "503");
  EXPECT_NE(early.find(texts::page::kNotYet.english()), std::string::npos);
  EXPECT_NE(early.find("Refresh: 2\r\n"), std::string::npos);
  hasPage_ = true;
  const std::string page = client().get("/follow");
  EXPECT_EQ(page.substr(9, 3), "200");
  EXPECT_NE(page.find("<p>played</p>"), std::string::npos);
  EXPECT_NE(page.find("script-src 'unsafe-inline' 'wasm-unsafe-eval'"), std::string::npos);
  EXPECT_EQ(page.find("script-src 'self'"), std::string::npos) << "one policy";
  EXPECT_NE(client().get("/").find("href=\"/follow\""), std::string::npos);
  EXPECT_EQ(client().get("/follow/socket").substr(9, 3), "426");
  WebClient strange = client();
  EXPECT_EQ(strange.open(strange.host(), "http://evil.example", "/follow/socket"), 403);
}

TEST_F(Followed, IsToldAllAndThenEveryNews) {
  ClassLimits limits;
  limits.request = 500ms;  // a follower says nothing, and is not cut off
  begin(600, limits);
  WebClient one = follower();
  std::string heard = one.hear();
  ASSERT_EQ(heard.substr(0, 4), "all ");
  std::optional<WebClient> late;
  for (int i = 1; i <= 40; ++i) {
    const std::string next = one.hear();
    ASSERT_EQ(next.substr(0, 5), "news ") << i;
    ASSERT_EQ(numberOf(next), numberOf(heard) + 1) << i;
    heard = next;
    if (i == 20) late.emplace(follower());
  }
  heard = late->hear();
  EXPECT_EQ(heard.substr(0, 4), "all ") << "who joins in the middle";
  EXPECT_GT(numberOf(heard), 20);
}

TEST_F(Followed, IsLeftOutWhileItReadsNothingAndNobodyWaits) {
  begin(300000);
  WebClient slow = follower(), quick = follower();
  std::string heard = quick.hear();
  const auto until = Steady::now() + 3s;
  int count = 0;
  for (; Steady::now() < until; ++count) {
    const std::string next = quick.hear();
    ASSERT_FALSE(next.empty());
    const bool isNext = numberOf(next) == numberOf(heard) + 1;
    ASSERT_TRUE(isNext || next.substr(0, 4) == "all ") << "a busy computer may leave out the quick one, too";
    heard = next;
  }
  EXPECT_GT(count, 10);
  const int now = numberOf(heard);
  int before = 0, read = 0;
  std::string first, next;
  do {
    next = slow.hear();
    ASSERT_FALSE(next.empty());
    if (first.empty()) first = next;
    const bool isNews = next[0] == 'n';
    EXPECT_TRUE(!isNews || numberOf(next) == before + 1) << "no news after a gap";
    before = numberOf(next);
    ++read;
  } while (before < now && read < 200);
  EXPECT_EQ(next.substr(0, 4), "all ") << "after the gap";
  EXPECT_LT(read, now - numberOf(first)) << "it was left out";
}

TEST_F(Followed, IsCutOffWhenItDoesNotReadForLong) {
  ClassLimits limits;
  limits.silence = 1500ms;
  begin(300000, limits);
  WebClient lazy = follower();
  std::this_thread::sleep_for(5s);
  EXPECT_TRUE(lazy.isClosed());
  EXPECT_FALSE(follower().hear().empty()) << "the class goes on";
}

TEST_F(Followed, SaysNothing) {
  begin(0);
  WebClient talks = follower();
  talks.say(R"({"hello": ""})");
  std::string heard;
  for (int i = 0; i < 100 && heard.substr(0, 5) != "close"; ++i) heard = talks.hear();
  EXPECT_EQ(heard, "close 1003");
}

TEST(PagesToTakeHome, AreOfferedOnTheWallsAndGivenForTheirCodes) {
  ClassServer server({"127.0.0.1", 0, "KIWI", "123456"});
  const auto get = [&](const std::string& path, const char* from = "127.0.0.1") {
    return WebClient(portOf(server), from).get(path);
  };
  EXPECT_EQ(get("/follow").substr(9, 3), "404") << "only where it was asked for";
  EXPECT_EQ(get("/").find("href=\"/follow\""), std::string::npos);
  server.offer("ABCDEFGH", "<p>Anna's</p>");
  server.offer("HGFEDCBA", "<p>Ben's</p>");
  ClassView view;
  const auto until = Steady::now() + 10s;
  while (view.address.words().find("HGFEDCBA") == std::string_view::npos && Steady::now() < until) {
    server.views().takeAll([&](const ClassView& newest) { view = newest; });
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_EQ(view.address.words(), server.invitation().address + "take/HGFEDCBA");
  EXPECT_TRUE(view.word.words().empty());
  const std::string annas = get("/take/ABCDEFGH");
  EXPECT_EQ(annas.substr(9, 3), "200");
  EXPECT_NE(annas.find("Anna's"), std::string::npos);
  EXPECT_EQ(annas.find("Ben's"), std::string::npos);
  for (int guess = 0; guess < 10; ++guess)
    EXPECT_EQ(get("/take/GUESSED" + std::to_string(guess), "127.0.0.9").substr(9, 3), "404") << guess;
  const std::string silence = get("/take/ABCDEFGH", "127.0.0.9");
  EXPECT_EQ(silence.substr(9, 3), "429");
  EXPECT_EQ(silence.find("Anna's"), std::string::npos);
  EXPECT_EQ(get("/take/ABCDEFGH").substr(9, 3), "200") << "from another address";
}

}  // namespace
}  // namespace carom
