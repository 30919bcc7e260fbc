// The OSC tracker against a sender of our own, over real datagrams.

#include "devices/network/osc_tracker.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "devices/network_peer.h"
#include "devices/osc_sender.h"

namespace carom {
namespace {

using test::Bytes;
using test::freePort;
using test::OscSender;
using test::PeerSocket;
using test::Watched;
using State = TrackerHealth::State;

OscMapping mapping() {
  OscMapping mapping;
  mapping.pose = OscPattern("/head/{sensor}", false);
  mapping.values = readOscValues("x y z qx qy qz qw");
  mapping.buttons = OscPattern("/wand/{sensor}/button/{n}", true);
  return mapping;
}

Transport oscAt(std::uint16_t port, const std::string& options = "") {
  return oscTransport(readOscSource(fmt::format("udp://127.0.0.1:{}{}", port, options)), mapping());
}

Bytes pose(float x_m, double time_s = 0.0) {
  return OscSender::bundle({OscSender::message("/head/4", {x_m, 1.75f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f})},
                           time_s);
}

TEST(OscTracker, DeliversPosesAtTheTimesOfTheBundles) {
  const std::uint16_t port = freePort();
  Watched head(oscAt(port));
  const PeerSocket sender(SOCK_DGRAM);
  ASSERT_TRUE(head.comesTrue(
      [&] { return sender.sendTo(pose(-1.0f, 3.9e9 + head.now_s()), port), !head.samples.empty(); }));
  std::vector<double> sent_s;
  for (int i = 0; i < 30; ++i) {
    sent_s.push_back(head.now_s());
    sender.sendTo(pose(static_cast<float>(i), 3.9e9 + sent_s.back()), port);
    std::this_thread::sleep_for(test::milliseconds(2));
  }
  ASSERT_TRUE(head.comesTrue([&] { return head.samples.back().pose.position_m.x == 29.0; }));
  EXPECT_EQ(head.samples.back().sensor, 4);
  head.samples.erase(head.samples.begin(), head.samples.end() - 30);
  test::expectTimes(head.samples, sent_s, 0.01);
  EXPECT_EQ(head.health().state, State::delivering);
  EXPECT_EQ(head.health().refused, 0u);
}

TEST(OscTracker, DeliversButtons) {
  const std::uint16_t port = freePort();
  Watched wand(oscAt(port));
  const PeerSocket sender(SOCK_DGRAM);
  ASSERT_TRUE(wand.comesTrue([&] {
    sender.sendTo(OscSender::message("/wand/100/button/1", {1.0f}), port);
    return !wand.inputs.empty();
  }));
  EXPECT_EQ(wand.inputs[0].sensor, 100);
  EXPECT_EQ(wand.inputs[0].index, 1);
  EXPECT_EQ(wand.inputs[0].value, 1.0);
}

TEST(OscTracker, SaysWhatItCannotReadAndKeepsWhatItCan) {
  const std::uint16_t port = freePort();
  Watched head(oscAt(port));
  const PeerSocket sender(SOCK_DGRAM);
  ASSERT_TRUE(head.comesTrue([&] { return sender.sendTo(pose(0.0f), port), !head.samples.empty(); }));
  sender.sendTo(OscSender::nested(1000, pose(0.0f)), port);
  ASSERT_TRUE(head.comesTrue([&] { return !head.health().message.empty(); }));
  EXPECT_EQ(head.health().message, "bundles are in one another more than 8 deep");
  EXPECT_EQ(head.health().refused, 1u);
  const std::size_t before = head.samples.size();
  ASSERT_TRUE(head.comesTrue([&] { return sender.sendTo(pose(1.0f), port), head.samples.size() > before; }));
  EXPECT_TRUE(head.comesTrue([&] { return head.health().message.empty(); }));
}

TEST(OscTracker, NamesTheAddressesThatComeIfNoneFits) {
  const std::uint16_t port = freePort();
  Watched head(oscAt(port));
  const PeerSocket sender(SOCK_DGRAM);
  ASSERT_TRUE(head.comesTrue([&] {
    sender.sendTo(OscSender::message("/rigidbody/1", {1.0f}), port);
    return !head.health().message.empty() && head.now_s() > 1.0;
  }));
  EXPECT_EQ(head.health().message,
            "nothing has come for '/head/{sensor}' or '/wand/{sensor}/button/{n}'; what has come is for "
            "'/rigidbody/1'");
  EXPECT_EQ(head.health().state, State::connecting);
  ASSERT_TRUE(head.comesTrue([&] { return sender.sendTo(pose(0.0f), port), !head.samples.empty(); }));
  EXPECT_TRUE(head.comesTrue([&] { return head.health().message.empty(); }));
}

TEST(OscTracker, ListensToTheConfiguredSenderAlone) {
  const std::uint16_t port = freePort();
  Watched head(oscAt(port, "?from=127.0.0.3"));
  const PeerSocket right(SOCK_DGRAM, 0, "127.0.0.3"), wrong(SOCK_DGRAM, 0, "127.0.0.4");
  ASSERT_TRUE(head.comesTrue([&] {
    wrong.sendTo(pose(7.0f), port);
    right.sendTo(pose(3.0f), port);
    return head.samples.size() >= 5;
  }));
  for (const TrackerSample& sample : head.samples) EXPECT_EQ(sample.pose.position_m.x, 3.0);
}

TEST(OscTracker, APortThatIsTakenNeedsHelp) {
  const PeerSocket other(SOCK_DGRAM);
  Watched head(oscAt(other.port()));
  ASSERT_TRUE(head.comesTo(State::failed));
  EXPECT_NE(head.health().message.find("another program listens there"), std::string::npos)
      << head.health().message;
}

TEST(OscSource, IsReadOrExplained) {
  const OscSource source = readOscSource("udp://0.0.0.0?from=10.0.0.2");
  EXPECT_EQ(source.local.port, 9000);
  EXPECT_EQ(source.from, 0x0A000002u);
  EXPECT_TRUE(readOscSource("udp://239.1.1.1:9001?interface=10.0.0.1").local.isGroup());
  for (const char* wrong :
       {"", "udp://name:9000", "tcp://0.0.0.0:9000", "udp://0.0.0.0:0", "udp://0.0.0.0?group=1"}) {
    EXPECT_THROW(readOscSource(wrong), std::invalid_argument) << wrong;
  }
}

}  // namespace
}  // namespace carom
