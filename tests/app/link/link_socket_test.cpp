// The sockets of a link: where they listen, who calls, and why a call fails.
#include "app/link/link_socket.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include "app/link/quick_line.h"

namespace carom::test {
namespace {

const LinkAddress kAnyPort{true, "127.0.0.1", 0};

std::optional<Called> awaitCaller(const LinkSocket& listening) {
  std::optional<Called> called;
  comes([&] {
    called = nextCaller(listening);
    return called.has_value();
  });
  return called;
}

TEST(LinkSocket, ACallReachesTheOneWhoListens) {
  for (const char* host : {"127.0.0.1", ""}) {
    SCOPED_TRACE(host);
    const LinkSocket listening = listenAt({true, host, 0});
    ASSERT_GT(portOf(listening), 0);
    EXPECT_FALSE(nextCaller(listening)) << "it does not wait for a call";
    std::string why;
    const LinkSocket calling = callTo({false, "127.0.0.1", portOf(listening)}, 0, why);
    ASSERT_TRUE(calling) << why;
    const auto called = awaitCaller(listening);
    ASSERT_TRUE(called);
    EXPECT_TRUE(called->from.ends_with("127.0.0.1")) << called->from;
    EXPECT_TRUE(comes([&] { return isAnswered(calling, why).value_or(false); })) << why;
    for (const int socket : {*calling, *called->socket, *listening}) {
      EXPECT_TRUE(fcntl(socket, F_GETFL) & O_NONBLOCK);
      EXPECT_TRUE(fcntl(socket, F_GETFD) & FD_CLOEXEC);
    }
    for (const int socket : {*calling, *called->socket}) {
      int atOnce = 0;
      socklen_t size = sizeof atOnce;
      ASSERT_EQ(getsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &atOnce, &size), 0);
      EXPECT_NE(atOnce, 0) << "small messages do not wait for more";
    }
  }
}

TEST(LinkSocket, APortThatIsTakenOrNotListenedToIsNamed) {
  LinkSocket listening = listenAt(kAnyPort);
  const LinkAddress there{true, "127.0.0.1", portOf(listening)};
  try {
    listenAt(there);
    FAIL() << "it listens twice";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()),
              "link: " + there.text() + ": another program has that port, expected a free one");
  }
  listening.reset();
  std::string why;
  const LinkSocket calling = callTo({false, "127.0.0.1", there.port}, 0, why);
  if (calling) {
    std::optional<bool> answered;
    ASSERT_TRUE(comes([&] {
      answered = isAnswered(calling, why);
      return answered.has_value();
    }));
    EXPECT_EQ(answered, false);
  }
  EXPECT_EQ(why, "Connection refused");
}

TEST(LinkSocket, IsClosedOnceByTheLastWhoHasIt) {
  const auto isOpen = [](int number) { return fcntl(number, F_GETFD) != -1; };
  LinkSocket first = listenAt(kAnyPort);
  const int number = *first;
  {
    LinkSocket second = std::move(first);
    EXPECT_FALSE(first);  // NOLINT(bugprone-use-after-move): it has none any more
    EXPECT_EQ(*second, number);
    LinkSocket third = listenAt(kAnyPort);
    const int other = *third;
    third = std::move(second);
    EXPECT_EQ(*third, number);
    EXPECT_FALSE(isOpen(other));
    EXPECT_TRUE(isOpen(number));
  }
  EXPECT_FALSE(isOpen(number));
}

}  // namespace
}  // namespace carom::test
