// The server of a class, whose connections share what there is: no address keeps others out.
#include "app/class_server/class_host.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/class_server/served_class.h"

namespace carom {
namespace {

using namespace test;

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

TEST_F(HurriedServer, DropsTheNamelessFirstWhenItIsFull) {
  std::vector<WebClient> hostile, phones;
  for (int i = 0; i < 8; ++i) phones.push_back(phone("", nullptr, "127.0.0.2"));
  for (int i = 0; i < 15; ++i) hostile.push_back(client("127.0.0.3"));
  Json told;
  WebClient late = phone("", &told, "127.0.0.4");
  EXPECT_EQ(told["phones"], 9);
}

TEST(Allowance, IsABurstAndThenTheRate) {
  ClassLimits limits;
  limits.burst = 5.0;
  limits.messages_1_s = 2.0;
  const double begin_s = secondsOf(SteadyClock::now()) + 1000.0;
  Allowance allowance(limits);
  int allowed = 0;
  for (int i = 0; i < 8; ++i) allowed += allowance.take(begin_s) ? 1 : 0;
  EXPECT_EQ(allowed, 5) << "the burst, at once";
  EXPECT_FALSE(allowance.take(begin_s + 1.0)) << "what was refused counts as well";
  EXPECT_TRUE(allowance.take(begin_s + 3.0));
  EXPECT_TRUE(allowance.take(begin_s + 3.0));
  EXPECT_FALSE(allowance.take(begin_s + 3.0));
  allowed = 0;
  for (int i = 0; i < 400; ++i) allowed += allowance.take(begin_s + 1000.0 + 0.5 * i) ? 1 : 0;
  EXPECT_EQ(allowed, 400) << "at its rate it may send for ever";
}

}  // namespace
}  // namespace carom
