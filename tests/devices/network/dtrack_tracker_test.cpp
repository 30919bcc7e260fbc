// The DTRACK tracker against a controller of our own, over real datagrams.

#include "devices/network/dtrack_tracker.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "devices/network_peer.h"

namespace carom {
namespace {

using test::Bytes;
using test::freePort;
using test::PeerSocket;
using test::Watched;
using State = TrackerHealth::State;

Bytes frame(unsigned number, double time_s, double x_mm = 0.0) {
  const double whole_s = std::floor(time_s);
  return test::bytesOf(
      fmt::format("fr {}\r\nts2 {:.0f} {:.0f} 4000\r\n6dcal 1\r\n6d 1 [0 1.000][{:.3f} 1700.000 0.000][1 0 0 "
                  "0 1 0 0 0 1]\r\n",
                  number, whole_s, (time_s - whole_s) * 1e6, x_mm));
}

struct Controller {
  explicit Controller(const Watched& head, std::uint16_t port, const char* address = "127.0.0.1")
      : socket(SOCK_DGRAM, 0, address), watched(head), to(port) {}

  void send(int count, const char* address = "127.0.0.1") {
    for (int i = 0; i < count; ++i) {
      // The cameras looked 4 ms before.
      socket.sendTo(frame(number, 1.8e9 + watched.now_s() - 0.004, number), to, address);
      ++number;
      std::this_thread::sleep_for(test::milliseconds(2));
    }
  }

  PeerSocket socket;
  const Watched& watched;
  std::uint16_t to;
  unsigned number = 1;
};

Transport dtrackAt(std::uint16_t port, const std::string& options = "") {
  return dtrackTransport(readDtrackSource(fmt::format("udp://127.0.0.1:{}{}", port, options)));
}

/// Datagrams are lost while nobody listens yet.
bool listens(Watched& head) {
  return head.comesTrue(
      [&] { return head.health().message.empty() && head.health().state != State::failed; });
}

TEST(DtrackTracker, DeliversFramesAtTheTimesOfTheCameras) {
  const std::uint16_t port = freePort();
  Watched head(dtrackAt(port));
  Controller controller(head, port);
  ASSERT_TRUE(head.comesTrue([&] { return controller.send(1), head.samples.size() > 0; }));
  std::vector<double> looked_s;
  for (int i = 0; i < 30; ++i) {
    looked_s.push_back(head.now_s() - 0.004);
    controller.send(1);
  }
  const long last_mm = controller.number - 1;  // x says the frame's number
  ASSERT_TRUE(
      head.comesTrue([&] { return std::lround(head.samples.back().pose.position_m.x * 1e3) == last_mm; }));
  head.samples.erase(head.samples.begin(), head.samples.end() - 30);
  // The way through the loopback takes microseconds, on a busy machine some milliseconds for all of them.
  test::expectTimes(head.samples, looked_s, 0.01);
  EXPECT_EQ(head.health().gaps, 0u);
  EXPECT_EQ(head.health().refused, 0u);
}

TEST(DtrackTracker, CountsGapsAndWhatItCannotRead) {
  const std::uint16_t port = freePort();
  Watched head(dtrackAt(port));
  Controller controller(head, port);
  ASSERT_TRUE(head.comesTrue([&] { return controller.send(1), head.samples.size() > 0; }));
  const std::uint64_t before = head.health().gaps;
  controller.number += 5;
  controller.send(1);
  EXPECT_TRUE(head.comesTrue([&] { return head.health().gaps == before + 5; }));
  controller.socket.sendTo(test::bytesOf("nonsense"), port);
  controller.socket.sendTo({}, port);
  EXPECT_TRUE(head.comesTrue([&] { return head.health().refused == 2; }));
}

// A controller, or a program in its place, that writes numbers as its language does.
TEST(DtrackTracker, SaysWhyLinesCannotBeRead) {
  const std::uint16_t port = freePort();
  Watched head(dtrackAt(port));
  Controller controller(head, port);
  ASSERT_TRUE(head.comesTrue([&] { return controller.send(1), head.samples.size() > 0; }));
  const Bytes commas =
      test::bytesOf("fr 900\r\n6dcal 1\r\n6d 1 [0 1,000][0,000 1700,000 0,000][1 0 0 0 1 0 0 0 1]\r\n");
  controller.socket.sendTo(commas, port);
  ASSERT_TRUE(head.comesTrue([&] { return !head.health().message.empty(); }));
  EXPECT_EQ(
      head.health().message,
      "a line of its datagrams cannot be read, '6d 1 [0 1,000][0,000 1700,000 0,000][1 0…': its numbers "
      "have decimal commas, expected points: correct the sender's language settings");
  EXPECT_EQ(head.health().refused, 1u);
  controller.number = 901;
  ASSERT_TRUE(head.comesTrue([&] { return controller.send(1), head.health().message.empty(); }));
  controller.socket.sendTo(test::bytesOf("fr 990\r\n6d one\r\n"), port);
  ASSERT_TRUE(head.comesTrue([&] { return !head.health().message.empty(); }));
  EXPECT_EQ(head.health().message,
            "a line of its datagrams cannot be read, '6d one', expected one as in DTRACK's manual");
}

TEST(DtrackTracker, ListensToTheConfiguredSenderAlone) {
  const std::uint16_t port = freePort();
  Watched head(dtrackAt(port, "?from=127.0.0.2"));
  Controller foreign(head, port, "127.0.0.3"), own(head, port, "127.0.0.2");
  ASSERT_TRUE(head.comesTrue([&] { return own.send(1), head.samples.size() > 0; }));
  head.poll();
  const std::size_t before = head.samples.size();
  foreign.send(20);
  own.send(1);
  ASSERT_TRUE(head.comesTrue([&] { return head.samples.size() > before; }));
  std::this_thread::sleep_for(test::milliseconds(50));
  head.poll();
  EXPECT_EQ(head.samples.size(), before + 1) << "none of the foreign ones";
  EXPECT_EQ(head.health().refused, 0u);
}

TEST(DtrackTracker, SilenceRestartAndAnotherClock) {
  const std::uint16_t port = freePort();
  Watched head(dtrackAt(port), 0.1);
  {
    Controller controller(head, port);
    ASSERT_TRUE(head.comesTrue([&] { return controller.send(1), head.health().state == State::delivering; }));
  }
  ASSERT_TRUE(head.comesTo(State::silent));
  // A controller that starts anew counts from 1 and, here, from another hour.
  PeerSocket restarted(SOCK_DGRAM);
  head.samples.clear();
  const double begun_s = head.now_s();
  double sent_s = begun_s, longestGap_s = 0.0;  // on a busy machine the controller halts, too
  for (unsigned i = 1; head.samples.size() < 100 && i < 20000; ++i) {
    longestGap_s = std::max(longestGap_s, head.now_s() - std::exchange(sent_s, head.now_s()));
    restarted.sendTo(frame(i, 1.7e9 + head.now_s()), port);
    std::this_thread::sleep_for(test::milliseconds(2));
    head.poll();
  }
  EXPECT_EQ(head.health().state, State::delivering);
  ASSERT_GE(head.samples.size(), 100u);
  EXPECT_LT(head.samples.front().time_s - begun_s, 1.0 + 4.0 * longestGap_s)
      << "believed after half a second";
  EXPECT_NEAR(head.samples.back().time_s, head.now_s(), 0.1);
}

TEST(DtrackTracker, JoinsAGroupOnAnInterface) {
  const std::uint16_t port = freePort();
  Watched head(
      dtrackTransport(readDtrackSource(fmt::format("udp://239.255.42.98:{}?interface=127.0.0.1", port))));
  Controller controller(head, port);
  in_addr loopback{htonl(INADDR_LOOPBACK)};
  setsockopt(controller.socket.descriptor(), IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof loopback);
  EXPECT_TRUE(head.comesTrue([&] { return controller.send(1, "239.255.42.98"), head.samples.size() > 0; }));
  const std::size_t before = head.samples.size();
  controller.send(3);  // to the port, but not to the group
  std::this_thread::sleep_for(test::milliseconds(50));
  head.poll();
  EXPECT_LE(head.samples.size(), before + 1);
}

TEST(DtrackTracker, APortInUseNeedsHelpUntilItIsFree) {
  auto other = std::make_unique<PeerSocket>(SOCK_DGRAM);
  const std::uint16_t port = other->port();
  Watched head(dtrackAt(port));
  ASSERT_TRUE(head.comesTo(State::failed));
  EXPECT_NE(head.health().message.find("another program"), std::string::npos) << head.health().message;
  other.reset();
  ASSERT_TRUE(listens(head));
  Controller controller(head, port);
  EXPECT_TRUE(head.comesTrue([&] { return controller.send(1), head.samples.size() > 0; }));
}

TEST(DtrackTracker, AnAddressOfAnotherMachineNeedsHelp) {
  Watched head(dtrackTransport(readDtrackSource("udp://192.0.2.1:5000")));
  ASSERT_TRUE(head.comesTo(State::failed));
  EXPECT_NE(head.health().message.find("192.0.2.1:5000"), std::string::npos) << head.health().message;
}

TEST(DtrackSource, IsReadOrExplained) {
  const DtrackSource source = readDtrackSource("udp://224.0.1.0:5001?from=10.0.0.5&interface=10.0.0.2");
  EXPECT_EQ(source.local.address, 0xE0000100u);
  EXPECT_EQ(source.local.port, 5001);
  EXPECT_TRUE(source.local.isGroup());
  EXPECT_EQ(source.from, 0x0A000005u);
  EXPECT_EQ(source.interface, 0x0A000002u);
  EXPECT_EQ(readDtrackSource("udp://0.0.0.0").local.port, 5000);
  for (const char* wrong :
       {"", "0.0.0.0:5000", "tcp://0.0.0.0:5000", "udp://", "udp://host:5000", "udp://1.2.3:5000",
        "udp://0.0.0.0:70000", "udp://0.0.0.0?from=host", "udp://0.0.0.0?form=10.0.0.5"}) {
    try {
      readDtrackSource(wrong);
      ADD_FAILURE() << wrong;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("expected"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace carom
