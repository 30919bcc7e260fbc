// The QTM tracker against a server of our own, over real connections.

#include "devices/network/qtm_tracker.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <atomic>
#include <mutex>
#include <stdexcept>

#include "devices/network_peer.h"
#include "devices/qtm_sender.h"
#include "resident_bytes.h"

namespace carom {
namespace {

using test::Bytes;
using test::PeerSocket;
using test::QtmSender;
using test::Watched;
using State = TrackerHealth::State;

/// Greets one client after another and answers its commands, on a thread of its own.
class QtmProgram {
 public:
  explicit QtmProgram(std::vector<std::string> names, std::uint16_t port = 0)
      : names_(std::move(names)), listener_(SOCK_STREAM, port) {
    ::listen(listener_.descriptor(), 1);
    thread_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
  }

  std::uint16_t port() const { return listener_.port(); }
  int asked() const { return asked_; }  ///< how often frames were asked for
  bool streams() const { return streams_; }
  void refuseVersion() { refuses_ = true; }
  void name(std::vector<std::string> names) {
    const std::lock_guard lock(mutex_);
    names_ = std::move(names);
  }

  /// Sends bytes to the client, if there is one.
  void send(const Bytes& bytes) {
    const std::lock_guard lock(mutex_);
    if (client_) client_->send(bytes);
  }
  void sendFrame(double now_s) {
    if (streams_)
      send(QtmSender::frame(number_++, 100.0 + now_s,
                            {QtmSender::turned(1000, 0, 0, 0), QtmSender::turned(2000, 0, 0, 0)}));
  }
  void skipFrames(std::uint32_t count) { number_ += count; }
  void hangUp() {
    streams_ = false;
    const std::lock_guard lock(mutex_);
    client_.reset();
  }

 private:
  void serve(const std::stop_token& stop) {
    std::string commands;
    while (!stop.stop_requested()) {
      if (listener_.isReadable(5)) {
        hangUp();
        const std::lock_guard lock(mutex_);
        client_.emplace(PeerSocket::acceptedBy(listener_));
        client_->send(QtmSender::text(1, "QTM RT Interface connected"));
        commands.clear();
      }
      const std::lock_guard lock(mutex_);
      if (!client_ || !client_->isReadable(0)) continue;
      const auto bytes = client_->receive();
      if (!bytes) {
        client_.reset();
        continue;
      }
      commands.append(bytes->begin(), bytes->end());
      answer(commands);
    }
  }
  void answer(std::string& commands) {
    if (commands.find("Version 1.19") != std::string::npos) {
      client_->send(refuses_ ? QtmSender::text(0, "Version NOT supported")
                             : QtmSender::text(1, "Version set to 1.19"));
    }
    if (commands.find("GetParameters 6D") != std::string::npos)
      client_->send(QtmSender::text(2, QtmSender::xml(names_)));
    if (commands.find("StreamFrames AllFrames 6DRes") == std::string::npos) {
      if (commands.find("Version") != std::string::npos) commands.clear();
      return;
    }
    commands.clear();
    streams_ = true;
    ++asked_;
  }

  std::mutex mutex_;
  std::vector<std::string> names_;
  PeerSocket listener_;
  std::optional<PeerSocket> client_;
  std::atomic<bool> streams_{false}, refuses_{false};
  std::atomic<int> asked_{0};
  std::uint32_t number_ = 100;
  std::jthread thread_;
};

Transport qtmAt(std::uint16_t port, const std::vector<std::string>& names = {}) {
  return qtmTransport(readQtmServer(fmt::format("tcp://127.0.0.1:{}", port)), names);
}

bool delivers(Watched& head, QtmProgram& server) {
  head.samples.clear();
  return head.comesTrue([&] { return server.sendFrame(head.now_s()), head.samples.size() >= 6; });
}

TEST(QtmTracker, DeliversBodiesInQtmsOrder) {
  QtmProgram server({"Head", "Wand"});
  Watched head(qtmAt(server.port()));
  ASSERT_TRUE(delivers(head, server));
  EXPECT_EQ(head.health().state, State::delivering);
  EXPECT_EQ(head.health().names, "QTM's bodies: Head, Wand");
  EXPECT_EQ(head.health().message, "");
  for (const TrackerSample& sample : head.samples)
    EXPECT_EQ(sample.pose.position_m.x, sample.sensor == 0 ? 1.0 : 2.0);
  EXPECT_NEAR(head.samples.back().time_s, head.now_s(), 0.05);
  EXPECT_EQ(head.health().refused, 0u);
}

TEST(QtmTracker, DeliversBodiesByTheirNames) {
  QtmProgram server({"Head", "Wand"});
  Watched head(qtmAt(server.port(), {"Wand", "Hat"}));
  ASSERT_TRUE(delivers(head, server));
  for (const TrackerSample& sample : head.samples) {
    EXPECT_EQ(sample.sensor, 0);
    EXPECT_EQ(sample.pose.position_m.x, 2.0);
  }
  EXPECT_NE(head.health().message.find("has no body 'Hat', it has: Head, Wand"), std::string::npos)
      << head.health().message;
}

// A measurement that is started anew, with other bodies.
TEST(QtmTracker, AsksAgainWhileNoFramesCome) {
  QtmProgram server({"Wand"});
  Watched head(qtmAt(server.port(), {"Head"}));
  ASSERT_TRUE(head.comesTrue([&] { return server.asked() >= 1; }));
  server.name({"Wand", "Head"});
  ASSERT_TRUE(head.comesTrue([&] { return server.asked() >= 2; }));
  ASSERT_TRUE(delivers(head, server));
  EXPECT_EQ(head.samples[0].pose.position_m.x, 2.0);
  EXPECT_EQ(head.health().message, "");
}

TEST(QtmTracker, CountsGaps) {
  QtmProgram server({"Head"});
  Watched head(qtmAt(server.port()));
  ASSERT_TRUE(delivers(head, server));
  const std::uint64_t before = head.health().gaps;
  server.skipFrames(7);
  server.sendFrame(head.now_s());
  EXPECT_TRUE(head.comesTrue([&] { return head.health().gaps == before + 7; }));
}

TEST(QtmTracker, ComesBack) {
  auto server = std::make_unique<QtmProgram>(std::vector<std::string>{"Head"});
  const std::uint16_t port = server->port();
  Watched head(qtmAt(port));
  ASSERT_TRUE(delivers(head, *server));
  server->send(QtmSender::event(12));
  ASSERT_TRUE(head.comesTo(State::connecting));
  EXPECT_NE(head.health().message.find("it shuts down"), std::string::npos) << head.health().message;
  server.reset();
  server = std::make_unique<QtmProgram>(std::vector<std::string>{"Head"}, port);
  ASSERT_TRUE(delivers(head, *server));
  EXPECT_GE(head.health().reconnections, 1u);
  server->hangUp();
  ASSERT_TRUE(delivers(head, *server));
}

TEST(QtmTracker, AnOldServerNeedsHelp) {
  QtmProgram server({"Head"});
  server.refuseVersion();
  Watched head(qtmAt(server.port()));
  ASSERT_TRUE(head.comesTo(State::failed));
  EXPECT_NE(head.health().message.find("says 'Version NOT supported', expected one that speaks version 1.19"),
            std::string::npos)
      << head.health().message;
}

TEST(QtmTracker, SaysWhatQtmSays) {
  QtmProgram server({"Head"});
  Watched head(qtmAt(server.port()));
  ASSERT_TRUE(delivers(head, server));
  server.send(QtmSender::text(0, "The license has expired"));
  ASSERT_TRUE(head.comesTrue([&] { return !head.health().message.empty(); }));
  EXPECT_NE(head.health().message.find("says 'The license has expired'"), std::string::npos)
      << head.health().message;
}

// Packets whose sizes cannot be, in the midst of good frames: the connection is made anew, and nothing is
// kept for them.
TEST(QtmTracker, SurvivesSizesThatCannotBe) {
  for (const std::uint32_t size : {4U, 0xfffffff0U}) {
    QtmProgram server({"Head"});
    Watched head(qtmAt(server.port()));
    ASSERT_TRUE(delivers(head, server));
    const std::size_t before = test::residentBytes();
    Bytes bad;
    QtmSender::put(bad, size);
    bad.resize(8);
    bad.resize(100'000);
    server.send(bad);
    ASSERT_TRUE(head.comesTo(State::connecting));
    EXPECT_NE(head.health().message.find(fmt::format("a packet says that it has {} bytes", size)),
              std::string::npos)
        << head.health().message;
    ASSERT_TRUE(delivers(head, server));
    EXPECT_LT(test::residentBytes(), before + (16U << 20U));
  }
}

TEST(QtmTracker, AnotherProgramAtThePortIsNamed) {
  const PeerSocket listener(SOCK_STREAM);
  ::listen(listener.descriptor(), 1);
  Watched head(qtmAt(listener.port()));
  const PeerSocket client = PeerSocket::acceptedBy(listener);
  client.send(QtmSender::text(1, "HTTP/1.1 400"));
  ASSERT_TRUE(head.comesTrue([&] { return head.health().message.find("greets") != std::string::npos; }));
  EXPECT_NE(
      head.health().message.find("it greets with 'HTTP/1.1 400', expected 'QTM RT Interface connected'"),
      std::string::npos)
      << head.health().message;
}

TEST(QtmServer, IsReadOrExplained) {
  EXPECT_EQ(readQtmServer("tcp://qtm.local").port, 22223);
  for (const char* wrong : {"", "udp://h:22223", "tcp://", "tcp://h?from=1"}) {
    EXPECT_THROW(readQtmServer(wrong), std::invalid_argument) << wrong;
  }
}

}  // namespace
}  // namespace carom
