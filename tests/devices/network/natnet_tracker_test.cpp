// The NatNet tracker against a server of our own, over real datagrams.

#include "devices/network/natnet_tracker.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "devices/natnet_sender.h"
#include "devices/network_peer.h"

namespace carom {
namespace {

using test::Bytes;
using test::NatnetSender;
using test::PeerSocket;
using test::Watched;
using State = TrackerHealth::State;

constexpr double kLatency_s = 0.008;
const NatnetSender::Body kHead{4, 0.5f, 1.75f, -0.25f, 0.0f, 0.0f, 0.0f, 1.0f};

/// Answers questions on a thread of its own, and sends frames to who asked, or to a group, when told to.
class MotiveServer {
 public:
  MotiveServer(int major, int minor, std::uint16_t port = 0)
      : socket_(SOCK_DGRAM, port),
        sender_(major, minor),
        thread_([this](const std::stop_token& stop) { answer(stop); }) {}

  std::uint16_t port() const { return socket_.port(); }
  int keptAlive() const { return keptAlive_; }
  bool isAsked() const { return client_ != 0; }
  std::uint16_t client() const { return client_; }  ///< its port
  const PeerSocket& socket() const { return socket_; }

  void sendFrame(double now_s) {
    if (client_ != 0) socket_.sendTo(frame(now_s), client_);
  }
  Bytes frame(double now_s) { return sender_.frame(number_++, {kHead}, 100.0 + now_s, kLatency_s); }
  void skipFrames(std::uint32_t count) { number_ += count; }

 private:
  void answer(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      if (!socket_.isReadable(20)) continue;
      std::uint16_t from = 0;
      const auto question = socket_.receive(&from);
      if (!question || question->size() < 4) continue;
      if ((*question)[0] == 10) ++keptAlive_;
      if ((*question)[0] != 0) continue;
      socket_.sendTo(sender_.serverInfo(), from);
      client_ = from;
    }
  }

  PeerSocket socket_;
  NatnetSender sender_;
  std::uint32_t number_ = 1000;
  std::atomic<std::uint16_t> client_{0};
  std::atomic<int> keptAlive_{0};
  std::jthread thread_;
};

Transport natnetAt(std::uint16_t port, const std::string& options = "") {
  return natnetTransport(readNatnetSource(fmt::format("udp://127.0.0.1:{}{}", port, options)));
}

bool delivers(Watched& head, MotiveServer& server) {
  head.samples.clear();
  return head.comesTrue([&] { return server.sendFrame(head.now_s()), head.samples.size() >= 5; });
}

// A server that plays one packet again and again.
TEST(NatnetTracker, DeliversThoughTheServersClockStands) {
  MotiveServer server(3, 1);
  Watched head(natnetAt(server.port()));
  ASSERT_TRUE(head.comesTrue([&] {
    server.sendFrame(0.0);
    std::this_thread::sleep_for(test::milliseconds(2));
    return !head.health().message.empty();
  }));
  EXPECT_EQ(head.health().state, State::delivering);
  EXPECT_NE(head.health().message.find("the same time again and again"), std::string::npos)
      << head.health().message;
  head.samples.clear();
  for (int i = 0; i < 40; ++i) {
    server.sendFrame(0.0);
    std::this_thread::sleep_for(test::milliseconds(2));
  }
  EXPECT_TRUE(head.comesTrue([&] { return head.samples.size() >= 40; })) << head.samples.size();
}

TEST(NatnetTracker, AsksTheVersionThenDelivers) {
  for (const auto& [major, minor] : {std::pair{3, 1}, {4, 1}}) {
    MotiveServer server(major, minor);
    Watched head(natnetAt(server.port()));
    ASSERT_TRUE(delivers(head, server));
    EXPECT_EQ(head.health().state, State::delivering);
    EXPECT_EQ(head.samples[0].sensor, 4);
    EXPECT_EQ(head.samples[0].pose.position_m, glm::dvec3(0.5, 1.75, -0.25));
    // Of the middle of the exposure; the way through the loopback is short.
    EXPECT_NEAR(head.samples.back().time_s, head.now_s() - kLatency_s, 0.05);
    EXPECT_LT(head.samples.back().time_s, head.now_s() - kLatency_s);
  }
}

TEST(NatnetTracker, TellsTheServerThatItIsStillThere) {
  MotiveServer server(3, 0);
  Watched head(natnetAt(server.port()));
  EXPECT_TRUE(head.comesTrue([&] { return server.sendFrame(head.now_s()), server.keptAlive() >= 2; }));
}

TEST(NatnetTracker, CountsGaps) {
  MotiveServer server(4, 0);
  Watched head(natnetAt(server.port()));
  ASSERT_TRUE(delivers(head, server));
  const std::uint64_t before = head.health().gaps;
  server.skipFrames(7);
  server.sendFrame(head.now_s());
  EXPECT_TRUE(head.comesTrue([&] { return head.health().gaps == before + 7; }));
}

TEST(NatnetTracker, ComesBackAfterTheServerStartedAnewInAnotherVersion) {
  auto server = std::make_unique<MotiveServer>(3, 0);
  const std::uint16_t port = server->port();
  Watched head(natnetAt(port), 0.1);
  ASSERT_TRUE(delivers(head, *server));
  server.reset();
  ASSERT_TRUE(head.comesTo(State::silent));
  ASSERT_TRUE(head.comesTo(State::connecting)) << "after three seconds without an answer";
  EXPECT_NE(head.health().message.find("no answer"), std::string::npos) << head.health().message;
  server = std::make_unique<MotiveServer>(4, 1, port);
  ASSERT_TRUE(delivers(head, *server));
  EXPECT_EQ(head.health().reconnections, 1u);
}

// Motive in edit mode: it answers, and sends no frames.
TEST(NatnetTracker, AServerWithoutFramesIsSilentNotGone) {
  MotiveServer server(4, 1);
  Watched head(natnetAt(server.port()), 0.1);
  ASSERT_TRUE(delivers(head, server));
  ASSERT_TRUE(head.comesTo(State::silent));
  std::this_thread::sleep_for(std::chrono::milliseconds(3500));  // longer than one that is gone is waited for
  EXPECT_EQ(head.health().state, State::silent) << head.health().message;
  ASSERT_TRUE(delivers(head, server));
  EXPECT_EQ(head.health().reconnections, 0u);
}

TEST(NatnetTracker, ListensToItsServerAlone) {
  MotiveServer server(3, 0);
  Watched head(natnetAt(server.port()));
  ASSERT_TRUE(delivers(head, server));
  std::this_thread::sleep_for(test::milliseconds(50));
  head.poll();
  const std::size_t before = head.samples.size();
  // From another address to the very port at which the tracker listens.
  const PeerSocket foreign(SOCK_DGRAM, 0, "127.0.0.9");
  for (int i = 0; i < 20; ++i) foreign.sendTo(server.frame(head.now_s()), server.client());
  std::this_thread::sleep_for(test::milliseconds(50));
  head.poll();
  EXPECT_EQ(head.samples.size(), before);
}

TEST(NatnetTracker, JoinsAGroup) {
  MotiveServer server(3, 1);
  const std::uint16_t port = PeerSocket(SOCK_DGRAM).port();
  Watched head(natnetAt(server.port(), fmt::format("?group=239.255.42.97:{}&interface=127.0.0.1", port)));
  in_addr loopback{htonl(INADDR_LOOPBACK)};
  setsockopt(server.socket().descriptor(), IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof loopback);
  EXPECT_TRUE(head.comesTrue([&] {
    if (server.isAsked()) server.socket().sendTo(server.frame(head.now_s()), port, "239.255.42.97");
    return head.samples.size() >= 5;
  }));
  EXPECT_EQ(server.keptAlive(), 0) << "who sends to a group need not know who listens";
}

TEST(NatnetTracker, AnOldServerNeedsHelp) {
  MotiveServer server(2, 9);
  Watched head(natnetAt(server.port()));
  ASSERT_TRUE(head.comesTo(State::failed));
  EXPECT_NE(head.health().message.find("NatNet 2.9"), std::string::npos) << head.health().message;
}

TEST(NatnetSource, IsReadOrExplained) {
  const NatnetSource source = readNatnetSource("udp://motive.local?group=239.255.42.99&interface=10.0.0.2");
  EXPECT_EQ(source.server.host, "motive.local");
  EXPECT_EQ(source.server.port, 1510);
  EXPECT_EQ(source.group->port, 1511);
  EXPECT_EQ(source.interface, 0x0A000002u);
  EXPECT_FALSE(readNatnetSource("udp://10.0.0.1:1600").group);
  for (const char* wrong : {"", "10.0.0.1", "udp://", "udp://h?group=10.0.0.1", "udp://h?group=x",
                            "udp://h?group=", "udp://h?group=239.255.42.99:0", "udp://h?from=10.0.0.1"}) {
    try {
      readNatnetSource(wrong);
      ADD_FAILURE() << wrong;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("expected"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace carom
