// The server of a class over real sockets: its pages, a lesson by phone, and whatever hostile phones do.
#include "app/classroom/class_server.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/web_client.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

using namespace test;
using namespace std::chrono_literals;
using Json = nlohmann::json;

const ClassQuestion kQuestion{"twins.toml", "Twins", "Who is older?", {"Neither", "At home", "Who flew"}, 1};

class Server : public testing::Test {
 protected:
  explicit Server(const ClassLimits& limits = {}) : server_({"127.0.0.1", 0, "KIWI", "123456", limits}) {
    const std::string& address = server_.invitation().address;
    port_ = static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
    server_.tell({kQuestion, LessonPhase::asks});
  }

  WebClient client(const char* from = "127.0.0.1") { return WebClient(port_, from); }
  /// A phone that has joined; `told` is what it was told first.
  WebClient phone(const std::string& token = "", Json* told = nullptr, const char* from = "127.0.0.1") {
    WebClient one(port_, from);
    EXPECT_EQ(one.open(), 101);
    one.say(Json({{"hello", token}}).dump());
    const std::string first = one.hear();
    EXPECT_FALSE(first.empty());
    if (told) *told = Json::parse(first, nullptr, false);
    return one;
  }
  WebClient teacher() {
    WebClient one(port_);
    EXPECT_EQ(one.open(), 101);
    one.say(R"({"pin": "123456"})");
    EXPECT_EQ(Json::parse(one.hear())["teacher"], true);
    return one;
  }
  /// Returns the first message for which this holds, or null.
  static Json await(WebClient& one, const std::function<bool(const Json&)>& isIt) {
    for (int i = 0; i < 200; ++i) {
      const Json told = Json::parse(one.hear(), nullptr, false);
      if (!told.is_object()) return {};
      if (isIt(told)) return told;
    }
    return {};
  }
  static Json awaitState(WebClient& one, const std::string& state) {
    return await(one, [&](const Json& told) { return told.value("state", "") == state; });
  }
  /// Proves that the class goes on: another phone joins.
  void expectAlive() {
    Json told;
    phone("", &told);
    EXPECT_TRUE(told.contains("token"));
  }

  ClassServer server_;
  std::uint16_t port_ = 0;
};

TEST_F(Server, HasThreeFilesAndNoOther) {
  EXPECT_EQ(server_.invitation().address, "http://" + client().host() + "/");
  std::size_t bytes = 0;
  for (const char* path : {"/", "/teacher", "/class.css", "/class.js"}) {
    const std::string answer = client().get(path);
    EXPECT_EQ(answer.substr(0, 15), "HTTP/1.1 200 OK") << path;
    for (const char* line :
         {"Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; "
          "connect-src 'self'; img-src 'self' data:; frame-ancestors 'none'; base-uri 'none'\r\n",
          "X-Content-Type-Options: nosniff\r\n", "Cache-Control: no-store\r\n"})
      EXPECT_NE(answer.find(line), std::string::npos) << path << ": " << line;
    if (path != std::string("/teacher")) bytes += answer.size();
  }
  EXPECT_LE(bytes, 60000U);
  for (const char* path :
       {"/../../etc/passwd", "/etc/passwd", "//", "/index.html", "/%2e%2e/x", "/class.js/", "*"})
    EXPECT_EQ(client().get(path).substr(9, 3), "404") << path;
  EXPECT_EQ(client().get("/socket").substr(9, 3), "426");
  WebClient posts = client();
  posts.send("POST / HTTP/1.1\r\nHost: " + posts.host() + "\r\n\r\n");
  EXPECT_EQ(posts.rest().substr(9, 3), "405");
}

TEST_F(Server, AnswersToItsOwnNameAndPagesAlone) {
  EXPECT_EQ(client().get("/", "evil.example:80").substr(9, 3), "421");
  EXPECT_EQ(client().get("/", "").substr(9, 3), "421");
  EXPECT_EQ(client().open("evil.example"), 421);
  EXPECT_EQ(client().open(client().host(), "http://evil.example"), 403);
  EXPECT_EQ(client().open(client().host(), "https://" + client().host()), 403);
  EXPECT_EQ(client().open(client().host(), "null"), 403);
  EXPECT_EQ(client().open(client().host(), "http://" + client().host()), 101);
}

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

TEST_F(Server, EndsAPhoneThatSendsAMegabyte) {
  WebClient one = phone();
  one.frame(0x81, std::string(1 << 20, 'a'));
  EXPECT_TRUE(one.isClosed());
  WebClient parts = phone();  // in pieces, each allowed
  parts.frame(0x01, std::string(900, 'a'));
  for (int i = 0; i < 3; ++i) parts.frame(0x00, std::string(900, 'a'));
  EXPECT_TRUE(parts.isClosed());
  WebClient lies = phone();  // a length that no memory has
  lies.frame(0x81, "a", std::size_t{1} << 62U);
  EXPECT_TRUE(lies.isClosed());
  expectAlive();
}

TEST_F(Server, EndsAPhoneThatFloods) {
  WebClient one = phone();
  server_.ask(ClassStep::ask);
  for (int i = 0; i < 1000; ++i) one.say(R"({"answer": 1, "round": 1})");
  EXPECT_TRUE(one.isClosed());
  expectAlive();
}

TEST_F(Server, EndsBinaryAndBrokenText) {
  WebClient binary = phone();
  binary.frame(0x82, "abc");
  std::string heard;
  while ((heard = binary.hear()).starts_with("{")) {
  }
  EXPECT_EQ(heard, "close 1003");
  WebClient broken = phone();
  broken.say("{\"hello\": \"\xc3\x28\"}");
  while ((heard = broken.hear()).starts_with("{")) {
  }
  EXPECT_EQ(heard, "close 1007");
  WebClient reserved = phone();
  reserved.frame(0xf1, "abc");
  EXPECT_TRUE(reserved.isClosed());
  expectAlive();
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

TEST_F(Server, LetsOneAddressKeepNobodyOut) {
  rlimit files{};
  getrlimit(RLIMIT_NOFILE, &files);
  files.rlim_cur = std::min<rlim_t>(files.rlim_max, 4096);
  setrlimit(RLIMIT_NOFILE, &files);
  std::vector<WebClient> phones, hostile;
  for (int i = 0; i < 20; ++i) phones.push_back(phone("", nullptr, "127.0.0.2"));
  for (int i = 0; i < 500; ++i) hostile.push_back(client("127.0.0.3"));
  Json told;
  WebClient late = phone("", &told, "127.0.0.4");
  EXPECT_EQ(told["phones"], 21);
  server_.ask(ClassStep::ask);
  for (WebClient& one : phones) EXPECT_EQ(awaitState(one, "vote")["round"], 1);
}

TEST_F(Server, SaysWhatIsWrongWithItsPort) {
  const auto words = [&](const std::string& address, std::uint16_t port) -> std::string {
    try {
      ClassServer other({address, port, "KIWI", "123456"});
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(words("127.0.0.1", port_), "class: port " + std::to_string(port_) +
                                           " of 127.0.0.1 is taken by another program, expected a free one: "
                                           "--class-port");
  EXPECT_NE(words("192.0.2.77", 0).find("expected an address of this computer"), std::string::npos);
  EXPECT_NE(words("kiwi", 0).find("'kiwi' is no address"), std::string::npos);
}

/// Small times, so that tests need not wait for them.
class HurriedServer : public Server {
 protected:
  HurriedServer() : Server({20, 15, 8192, 300ms, 1000ms, 10.0, 20.0}) {}
};

TEST_F(HurriedServer, EndsWhoDoesNotSayWhoTheyAre) {
  WebClient silent = client(), half = client(), unnamed = client();
  half.send("GET / HTTP/1.1\r\nHo");
  EXPECT_EQ(unnamed.open(), 101);
  for (WebClient* one : {&silent, &half, &unnamed}) EXPECT_TRUE(one->isClosed());
  WebClient large = client();
  large.send("GET / HTTP/1.1\r\nX: " + std::string(100000, 'x'));
  EXPECT_TRUE(large.isClosed());
}

TEST_F(HurriedServer, KeepsASilentPhoneThatAnswersPingsAndNoOther) {
  WebClient half = phone(), deaf = phone();
  half.send(std::string("\x81\xfe", 2));  // the beginning of a frame, and nothing more
  EXPECT_TRUE(half.isClosed());
  EXPECT_TRUE(deaf.isClosed());
  WebClient silent = phone();
  const auto until = std::chrono::steady_clock::now() + 3s;
  while (std::chrono::steady_clock::now() < until) {
    const std::string heard = silent.hear(100ms);  // answers pings
    EXPECT_TRUE(heard.empty() || heard.starts_with("{")) << heard;
  }
  server_.ask(ClassStep::ask);
  EXPECT_EQ(awaitState(silent, "vote")["round"], 1);
}

TEST_F(HurriedServer, DropsTheNamelessFirstWhenItIsFull) {
  std::vector<WebClient> hostile, phones;
  for (int i = 0; i < 8; ++i) phones.push_back(phone("", nullptr, "127.0.0.2"));
  for (int i = 0; i < 15; ++i) hostile.push_back(client("127.0.0.3"));
  Json told;
  WebClient late = phone("", &told, "127.0.0.4");
  EXPECT_EQ(told["phones"], 9);
}

/// Bytes of anything, as requests and as frames: whatever comes, the class goes on.
TEST_F(HurriedServer, SurvivesAnyBytes) {
  std::mt19937 random(8);
  const auto any = [&](int most) { return std::uniform_int_distribution(0, most)(random); };
  for (int i = 0; i < 60; ++i) {
    std::string bytes(static_cast<std::size_t>(any(400)), ' ');
    for (char& byte : bytes) byte = static_cast<char>(any(255));
    WebClient one = client("127.0.0.9");
    if (i % 2 == 0) {
      one.send(bytes);
    } else if (one.open() == 101) {
      one.say(R"({"hello": ""})");
      one.send(bytes);
    }
  }
  expectAlive();
}

}  // namespace
}  // namespace carom
