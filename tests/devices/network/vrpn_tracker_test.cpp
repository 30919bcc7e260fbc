// The VRPN tracker against a server of our own, over a real connection.

#include "devices/network/vrpn_tracker.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "devices/network_peer.h"
#include "devices/vrpn_sender.h"
#include "devices/vrpn_server.h"

namespace carom {
namespace {

using test::Bytes;
using test::PeerSocket;
using test::VrpnSender;
using Server = test::VrpnServer;
using test::Watched;
using State = TrackerHealth::State;

constexpr double kNeverSilent_s = std::numeric_limits<double>::infinity();
constexpr double kServerAhead_s = 1.8e9;  // the server counts from 1970

Transport transportTo(const Server& server) { return vrpnTransport(readVrpnSource(server.source())); }

/// Sends `count` poses, 2 ms apart, by the server's clock.
void sendPoses(const PeerSocket& client, const Watched& head, int count) {
  for (int i = 0; i < count; ++i) {
    client.send(VrpnSender::pose(0, 0.001 * i, 0.1, kServerAhead_s + head.now_s()));
    std::this_thread::sleep_for(test::milliseconds(2));
  }
}

/// Sends poses until the tracker knows the server's clock: where the first packets came all at once, as on a
/// busy machine, some of them have no time of their own and are dropped.
void sendUntilKnown(const PeerSocket& client, Watched& head) {
  for (std::size_t before = head.samples.size(), sent = 0; sent < 5000; sent += 20) {
    sendPoses(client, head, 20);
    head.poll();
    if (head.samples.size() == before + 20) return head.samples.clear();
    std::this_thread::sleep_for(test::milliseconds(20));
    head.poll();
    before = head.samples.size();
  }
}

TEST(VrpnTracker, DeliversWhatTheServerSends) {
  Server server;
  Watched head(transportTo(server));
  const PeerSocket client = server.meet();
  sendUntilKnown(client, head);
  sendPoses(client, head, 20);
  client.send(VrpnSender::button(2, true, kServerAhead_s + head.now_s()));
  ASSERT_TRUE(head.comesTrue([&] { return head.samples.size() == 20 && head.inputs.size() == 1; }));
  EXPECT_EQ(head.health().state, State::delivering);
  EXPECT_TRUE(head.health().message.empty());
  EXPECT_EQ(head.samples[7].pose.position_m, glm::dvec3(0.001 * 7, 1.7, -0.25));
  EXPECT_EQ(head.inputs[0].index, 2);
}

TEST(VrpnTracker, KeepsTheServersSpacingThroughABurst) {
  Server server;
  Watched head(transportTo(server));
  const PeerSocket client = server.meet();
  sendUntilKnown(client, head);
  Bytes burst;  // 30 ms of records in one piece, as after a stall
  const double from_s = head.now_s();
  for (int i = 0; i < 10; ++i) {
    VrpnSender::add(burst, VrpnSender::pose(0, 0.0, 0.0, kServerAhead_s + from_s + 0.003 * i));
  }
  std::this_thread::sleep_for(test::milliseconds(30));
  // In two portions, cut inside a record.
  client.send(Bytes(burst.begin(), burst.begin() + 500));
  std::this_thread::sleep_for(test::milliseconds(1));
  client.send(Bytes(burst.begin() + 500, burst.end()));
  ASSERT_TRUE(head.comesTrue([&] { return head.samples.size() == 10; }));
  // Device times are kept to the microsecond of the protocol; a fit that gets better may move one by the
  // delay of this machine, of which the earliest of twenty packets is within 0.5 ms.
  for (std::size_t i = 1; i < 10; ++i) {
    EXPECT_NEAR(head.samples[i].time_s - head.samples[i - 1].time_s, 0.003, 0.0005);
  }
}

TEST(VrpnTracker, ComesBackAfterTheServerDiedAndStartedAnew) {
  auto server = std::make_unique<Server>();
  const std::uint16_t port = server->port();
  Watched head(transportTo(*server));
  {
    const PeerSocket client = server->meet();
    sendPoses(client, head, 10);
    ASSERT_TRUE(head.comesTo(State::delivering));
    server.reset();
  }  // the connection is cut
  ASSERT_TRUE(head.comesTo(State::connecting));
  EXPECT_NE(head.health().message.find("127.0.0.1"), std::string::npos) << head.health().message;
  server = std::make_unique<Server>("Head", port);
  const PeerSocket client = server->meet();
  head.samples.clear();
  sendUntilKnown(client, head);
  sendPoses(client, head, 10);
  ASSERT_TRUE(head.comesTrue([&] { return head.samples.size() >= 10; }));
  EXPECT_EQ(head.health().reconnections, 1u);
  EXPECT_EQ(head.health().state, State::delivering);
}

TEST(VrpnTracker, SilenceIsJudgedByTime) {
  Server server;
  Watched head(transportTo(server), 0.1);
  const PeerSocket client = server.meet();
  sendPoses(client, head, 3);
  ASSERT_TRUE(head.comesTo(State::delivering));
  ASSERT_TRUE(head.comesTo(State::silent));
  sendPoses(client, head, 1);
  EXPECT_TRUE(head.comesTo(State::delivering));
  EXPECT_EQ(head.health().reconnections, 0u);
}

TEST(VrpnTracker, PingsWhenNothingComesAndAnswersPings) {
  Server server;
  Watched head(transportTo(server));
  const PeerSocket client = server.greet();
  client.send(VrpnSender::names("Head"));
  const auto described = client.receive();
  ASSERT_TRUE(described && described->size() > 24u);
  const auto ping = client.receive();  // after a second of silence
  ASSERT_TRUE(ping);
  EXPECT_EQ(ping->size(), 24u);
  EXPECT_EQ((*ping)[19], 0) << "the type that the greeting named vrpn_Base ping_message";
  client.send(VrpnSender::ping(1.0));
  const auto pong = client.receive();
  ASSERT_TRUE(pong);
  EXPECT_EQ((*pong)[19], 1) << "… and vrpn_Base pong_message";
}

/// Lets the server answer its client until the tracker has a message.
bool saysSomething(Server& server, const PeerSocket& client, Watched& head) {
  return head.comesTrue([&] {
    if (client.isReadable(0)) server.hear(client);
    return !head.health().message.empty();
  });
}

// A server names back what is named to it, and to every later client: no name is a proof of a device.
TEST(VrpnTracker, SaysWhichSendersThereAre) {
  Server server("Tracker0");
  {
    Watched head(transportTo(server));
    const PeerSocket client = server.meet();
    EXPECT_EQ(server.wanted(), "Head");
    ASSERT_TRUE(saysSomething(server, client, head));
    EXPECT_EQ(head.health().message, "the server at 127.0.0.1:" + std::to_string(server.port()) +
                                         " has no 'Head', it has: Tracker0");
    EXPECT_EQ(head.health().state, State::connecting);
    EXPECT_TRUE(head.health().connected);
  }
  Watched head(transportTo(server));
  const PeerSocket client = server.meet();  // which names a Head now
  ASSERT_TRUE(saysSomething(server, client, head));
  EXPECT_EQ(head.health().message,
            "the server at 127.0.0.1:" + std::to_string(server.port()) +
                " names a 'Head', but no such device answers; beside it there is: Tracker0");
  Watched box(vrpnTransport(readVrpnSource(server.source("Buttons9"))), kNeverSilent_s);
  const PeerSocket another = server.meet();
  ASSERT_TRUE(saysSomething(server, another, box));
  EXPECT_EQ(box.health().message,
            "the server at 127.0.0.1:" + std::to_string(server.port()) +
                " has no 'Buttons9', it has: Tracker0; it names without an answer: Head");
  EXPECT_EQ(box.health().state, State::connecting) << "also of a device that sends only while it is used";
}

// A box of buttons is silent by nature.
TEST(VrpnTracker, AButtonBoxIsUntouchedAndThenDelivers) {
  Server server("Buttons0");
  for (const double silence_s : {kNeverSilent_s, 0.05}) {
    Watched box(vrpnTransport(readVrpnSource(server.source("Buttons0"))), silence_s);
    const PeerSocket client = server.meet();
    const State first = silence_s == kNeverSilent_s ? State::untouched : State::connecting;
    ASSERT_TRUE(box.comesTrue([&] { return box.health().connected; }));
    EXPECT_EQ(box.health().state, first);
    client.send(VrpnSender::button(2, true, kServerAhead_s + box.now_s()));
    ASSERT_TRUE(box.comesTo(State::delivering));
    std::this_thread::sleep_for(test::milliseconds(200));
    EXPECT_EQ(box.health().state, State::delivering) << "it has sent no pose, so it may say nothing";
  }
}

// One that answers pings is there, and so is one that speaks under a name that came late.
TEST(VrpnTracker, TakesBackARemarkWhenTheDeviceSpeaks) {
  Server server("Tracker0");
  Watched head(transportTo(server));
  const PeerSocket client = server.meet();
  ASSERT_TRUE(head.comesTrue([&] { return !head.health().message.empty(); }));
  for (int i = 0; i < 20; ++i) {  // the name that was named back is sender 2
    client.send(VrpnSender::pose(0, 0.1, 0.0, kServerAhead_s + head.now_s(), 2));
    std::this_thread::sleep_for(test::milliseconds(2));
  }
  ASSERT_TRUE(head.comesTo(State::delivering));
  EXPECT_TRUE(head.comesTrue([&] { return head.health().message.empty(); })) << head.health().message;
}

TEST(VrpnTracker, AQuietDeviceThatAnswersIsNotRemarkedOn) {
  Server server;
  Watched head(transportTo(server));
  const PeerSocket client = server.meet();
  const auto until = head.now_s() + 3.5;  // longer than it waits for an answer
  while (head.now_s() < until) {
    if (client.isReadable(100)) server.hear(client);
  }
  EXPECT_EQ(head.health().message, "");
  EXPECT_EQ(head.health().state, State::connecting) << "no pose has come";
}

TEST(VrpnTracker, GivesUpAServerThatGreetsAndSaysNoMore) {
  Server silent, halting;
  Watched a(transportTo(silent)), b(transportTo(halting));
  const PeerSocket client = silent.greet(), other = halting.greet();
  other.send(Bytes(12, 0));  // half a header
  for (const auto& [head, server] : {std::pair{&a, &silent}, {&b, &halting}}) {
    ASSERT_TRUE(
        head->comesTrue([&] { return head->health().message.find("said nothing") != std::string::npos; }));
    EXPECT_EQ(head->health().state, State::connecting);
    EXPECT_TRUE(server->isCalled(60000)) << "it is called again";
  }
}

TEST(VrpnTracker, AnotherProtocolNeedsHelp) {
  Server server;
  Watched head(transportTo(server));
  const PeerSocket client = server.meet("06.00");
  ASSERT_TRUE(head.comesTo(State::failed));
  EXPECT_NE(head.health().message.find("ver. 06.00"), std::string::npos) << head.health().message;
}

TEST(VrpnTracker, HangsUpWhereBytesWereLost) {
  Server server;
  Watched head(transportTo(server));
  {
    const PeerSocket client = server.meet();
    client.send(Bytes(64, 0xff));
    ASSERT_TRUE(head.comesTo(State::failed));
  }
  const PeerSocket client = server.meet();  // and calls again
  sendPoses(client, head, 3);
  EXPECT_TRUE(head.comesTo(State::delivering));
}

TEST(VrpnTracker, EndsAtOnceWhateverItWaitsFor) {
  Server server;
  const auto timed = [](const std::string& source) {
    auto tracker = std::make_unique<DeviceTracker>(vrpnTransport(readVrpnSource(source)), test::Clock::now());
    std::this_thread::sleep_for(test::milliseconds(50));
    const auto before = test::Clock::now();
    tracker.reset();
    return std::chrono::duration<double>(test::Clock::now() - before).count();
  };
  // At once, not when the network gives up, after some minutes; the rest is for machines that do other
  // things.
  constexpr double kAtOnce_s = 15.0;
  EXPECT_LT(timed("Head@tcp://127.0.0.1:" + std::to_string(server.port())), kAtOnce_s)
      << "connected, never greeted";
  EXPECT_LT(timed("Head@tcp://127.0.0.1:1"), kAtOnce_s) << "refused";
  EXPECT_LT(timed("Head@tcp://192.0.2.1:3883"), kAtOnce_s) << "an address that nobody has";
  EXPECT_LT(timed("Head@tcp://no-such-machine.invalid"), kAtOnce_s) << "a name that nobody has";
}

TEST(VrpnSource, IsReadOrExplained) {
  const VrpnSource source = readVrpnSource("Head@tcp://tracker.local:3884");
  EXPECT_EQ(source.sender, "Head");
  EXPECT_EQ(source.server.host, "tracker.local");
  EXPECT_EQ(source.server.port, 3884);
  EXPECT_EQ(readVrpnSource("A B@tcp://h").server.port, 3883);
  for (const char* wrong :
       {"", "Head", "@tcp://h", "Head@h", "Head@udp://h", "Head@tcp://", "Head@tcp://h:", "Head@tcp://h:0",
        "Head@tcp://h:65536", "Head@tcp://h:12x", "Head@tcp://a b", "Head@tcp://h?x=1"}) {
    try {
      readVrpnSource(wrong);
      ADD_FAILURE() << wrong;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("expected"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace carom
