// A connection to the server of a class: its files, and whatever hostile phones send.
#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <string>

#include "app/class_server/class_server.h"
#include "app/class_server/served_class.h"

namespace carom {
namespace {

using namespace test;
using namespace std::chrono_literals;

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
