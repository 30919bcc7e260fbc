// One connection of a line, whose time is that of the test: its messages, its pings, and when it ends.
#include "app/link/line_connection.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include "app/link/quick_line.h"
#include "app/link/sample_messages.h"

namespace carom::test {
namespace {

TEST(LineConnection, ANewerPresentTakesThePlaceOfOneThatWasNotSent) {
  const LinkKey its = key();
  TlsEnd listens(true, its), calls(false, its);
  int pair[2];
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, pair), 0);
  const auto now = LinkClock::now();
  LineConnection sends(1, listens, pair[0], "a test", now), takes(2, calls, pair[1], "a test", now);
  std::vector<LinkMessage> taken;
  const auto readBoth = [&] {
    sends.read(now, [](const LinkMessage&) {});
    takes.read(now, [&](LinkMessage& message) { taken.push_back(std::move(message)); });
  };
  ASSERT_TRUE(comes([&] {
    readBoth();
    return sends.isProven() && takes.isProven();
  }));
  for (std::uint32_t i = 1; i <= 5; ++i) {
    LinkPresent present = samplePresent();
    present.present.number = i;
    std::vector<std::uint8_t> bytes = bytesOf(present);
    sends.setPresent(bytes);
    sends.add(bytesOf(sampleStroke(i)), quick());
  }
  sends.write(quick());
  ASSERT_TRUE(comes([&] {
    readBoth();
    return taken.size() >= 6;
  }));
  EXPECT_EQ(taken.size(), 6U) << "five strokes and a present";
  for (std::uint32_t i = 0; i < 5; ++i) EXPECT_EQ(std::get<LinkStroke>(taken[i]).told.number, i + 1);
  EXPECT_EQ(std::get<LinkPresent>(taken[5]).present.number, 5U);
}

/// Both ends of a line that have proven their key.
struct Ends {
  Ends() {
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, pair), 0);
    called.emplace(1, listens, pair[0], "a test", now);
    caller.emplace(2, calls, pair[1], "a test", now);
  }
  void prove() {
    ASSERT_TRUE(comes([&] {
      readBoth();
      return called->isProven() && caller->isProven();
    }));
  }
  void readBoth() {
    for (LineConnection* one : {&*called, &*caller})
      one->read(now, [&](const LinkMessage& message) { taken.push_back(message); });
  }
  /// Brings what waits at one end to the other.
  void carry(LineConnection& from, LineConnection& to) {
    from.write(limits);
    to.read(now, [&](const LinkMessage& message) { taken.push_back(message); });
  }

  int pair[2] = {-1, -1};
  LinkLimits limits = quick();
  TlsEnd listens{true, key()}, calls{false, key()};
  LinkClock::time_point now = LinkClock::now();
  std::optional<LineConnection> called, caller;
  std::vector<LinkMessage> taken;
};

TEST(LineConnection, PingsMeasureTheWayThereAndBack) {
  Ends ends;
  ends.prove();
  constexpr std::size_t kRounds = 12;
  std::size_t rounds = 0;
  for (int turn = 0; turn < 15 && rounds < kRounds; ++turn) {
    ends.now += std::chrono::milliseconds(50);
    ends.caller->look(ends.now, ends.limits, true);
    const bool isSent = ends.caller->wantsToWrite();
    EXPECT_EQ(isSent, turn < 10 || turn % 2 == 1) << "turn " << turn << ": ten come fast, then 10 a second";
    ends.limits.pings_1_s = 10.0;
    ends.carry(*ends.caller, *ends.called);
    ends.now += std::chrono::milliseconds(turn);  // on the way back
    ends.carry(*ends.called, *ends.caller);
    ends.now -= std::chrono::milliseconds(turn);
    rounds += isSent ? 1 : 0;
    ASSERT_EQ(ends.caller->roundTrip().count, rounds);
    if (isSent) {
      EXPECT_NEAR(ends.caller->roundTrip().most_s, 1e-3 * turn, 1e-9);
    }
  }
  EXPECT_EQ(ends.caller->roundTrip().least_s, 0.0);
  EXPECT_TRUE(ends.taken.empty()) << "pings are for the connection alone";
  ends.called->add(bytesOf(LinkPong{{4000, 0}}), ends.limits);
  ends.carry(*ends.called, *ends.caller);
  EXPECT_EQ(ends.caller->ended(), "it answered a ping that was not sent");
}

TEST(LineConnection, EndsWhenItsTimeIsOver) {
  using std::chrono::milliseconds;
  const auto endedAfter = [](milliseconds passed, bool isProven, bool calls, const auto& before) {
    Ends ends;
    if (isProven) ends.prove();
    LineConnection& one = calls ? *ends.caller : *ends.called;
    before(ends, one);
    one.look(ends.now + passed, ends.limits, calls);
    return one.ended();
  };
  const auto nothing = [](Ends&, LineConnection&) {};
  const LinkLimits limits = quick();
  const milliseconds little(1), first = 2 * limits.silence + limits.handshake;
  EXPECT_EQ(endedAfter(limits.handshake, false, false, nothing), "");
  EXPECT_EQ(endedAfter(limits.handshake + little, false, false, nothing),
            "it has not proven the key in time");
  EXPECT_EQ(endedAfter(limits.listening, true, false, nothing), "");
  EXPECT_EQ(endedAfter(limits.listening + little, true, false, nothing), "nothing has come for too long");
  EXPECT_EQ(endedAfter(first, true, true, nothing), "") << "the first answer may take longer";
  EXPECT_EQ(endedAfter(first + little, true, true, nothing), "nothing has come for too long");
  const auto half = [](Ends& ends, LineConnection&) {
    const auto bytes = bytesOf(sampleStroke(1));
    ends.called->add(std::span(bytes).first(bytes.size() / 2), ends.limits);
    ends.carry(*ends.called, *ends.caller);
  };
  EXPECT_EQ(endedAfter(limits.silence + little, true, true, half), "it stopped in the middle of a message");
  const auto long_ = [](Ends& ends, LineConnection&) { ends.limits.listening = milliseconds(60000); };
  EXPECT_EQ(endedAfter(limits.unknown + little, true, false, long_), "it has the key, and has not joined");
  const auto letIn = [&](Ends& ends, LineConnection& one) {
    long_(ends, one);
    auto bytes = bytesOf(samplePresent());
    one.setPresent(bytes);
  };
  EXPECT_EQ(endedAfter(limits.unknown + little, true, false, letIn), "");
}

TEST(LineConnection, SendsItsLastWordsAndThenCloses) {
  Ends ends;
  ends.prove();
  ends.called->add(bytesOf(LinkBye{"the room closes"}), ends.limits);
  ends.called->closeAfter();
  ends.called->write(ends.limits);
  ends.called->add(bytesOf(LinkDigest{1, 1}), ends.limits);
  ends.called->write(ends.limits);
  ASSERT_TRUE(comes([&] {
    ends.readBoth();
    return ends.caller->isOver();
  }));
  EXPECT_EQ(ends.caller->ended(), "the line was closed");
  ASSERT_EQ(ends.taken.size(), 1U);
  EXPECT_EQ(std::get<LinkBye>(ends.taken[0]).reason, "the room closes");
}

TEST(LineConnection, MoreThanMayWaitEndsIt) {
  Ends ends;
  ends.limits.waitingBytes = 100;
  ends.called->add(std::vector<std::uint8_t>(60), ends.limits);
  ends.called->add(std::vector<std::uint8_t>(40), ends.limits);
  EXPECT_FALSE(ends.called->isOver());
  ends.called->add(std::vector<std::uint8_t>(1), ends.limits);
  EXPECT_EQ(ends.called->ended(), "it takes nothing any more");
}

}  // namespace
}  // namespace carom::test
