#pragma once
// A class's server over real sockets, with its phones and its teacher.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include "app/class_server/class_server.h"
#include "app/web_client.h"

namespace carom::test {

using Json = nlohmann::json;

inline const ClassQuestion kQuestion{
    "twins.toml", "Twins", "Who is older?", {"Neither", "At home", "Who flew"}, 1};

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

/// Small times, so that tests need not wait for them.
class HurriedServer : public Server {
 protected:
  HurriedServer()
      : Server({20, 15, 8192, std::chrono::milliseconds(300), std::chrono::milliseconds(1000), 10.0, 20.0}) {}
};

}  // namespace carom::test
