#pragma once
// The other end of a tracker's network connection, for tests: plain sockets on 127.0.0.x, blocking with a
// limit.

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "devices/tracker/device_tracker.h"

namespace carom::test {

using Bytes = std::vector<std::uint8_t>;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

inline Bytes bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

/// A socket of any kind, bound to a free port (or a given one) of a loopback address.
class PeerSocket {
 public:
  PeerSocket(int type, std::uint16_t port = 0, const char* address = "127.0.0.1")
      : descriptor_(socket(AF_INET, type | SOCK_CLOEXEC, 0)) {
    const int yes = 1;
    setsockopt(descriptor_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in local = addressOf(address, port);
    // The port of a listener that just closed may stay taken for a moment.
    for (int i = 0; i < 100; ++i) {
      if (bind(descriptor_, reinterpret_cast<sockaddr*>(&local), sizeof local) == 0) break;
      std::this_thread::sleep_for(milliseconds(10));
    }
    socklen_t size = sizeof local;
    getsockname(descriptor_, reinterpret_cast<sockaddr*>(&local), &size);
    port_ = ntohs(local.sin_port);
  }
  /// A client of a listening socket.
  static PeerSocket acceptedBy(const PeerSocket& listener) {
    return PeerSocket(Adopted{accept(listener.descriptor_, nullptr, nullptr)});
  }
  PeerSocket(PeerSocket&& other) noexcept : descriptor_(other.descriptor_), port_(other.port_) {
    other.descriptor_ = -1;
  }
  ~PeerSocket() {
    if (descriptor_ >= 0) close(descriptor_);
  }

  std::uint16_t port() const { return port_; }
  int descriptor() const { return descriptor_; }

  void send(const Bytes& bytes) const { ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL); }
  void sendTo(const Bytes& bytes, std::uint16_t port, const char* address = "127.0.0.1") const {
    const sockaddr_in to = addressOf(address, port);
    sendto(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL, reinterpret_cast<const sockaddr*>(&to),
           sizeof to);
  }

  /// What came within a minute; none at the end of a connection. Fills in the sender's port.
  std::optional<Bytes> receive(std::uint16_t* from = nullptr) const {
    if (!isReadable(60000)) return {};
    Bytes bytes(65536);
    sockaddr_in sender{};
    socklen_t size = sizeof sender;
    const ssize_t count =
        recvfrom(descriptor_, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr*>(&sender), &size);
    if (from) *from = ntohs(sender.sin_port);
    if (count <= 0) return {};
    bytes.resize(static_cast<std::size_t>(count));
    return bytes;
  }
  bool isReadable(int longest_ms) const {
    pollfd waiting{descriptor_, POLLIN, 0};
    return poll(&waiting, 1, longest_ms) > 0;
  }

 private:
  struct Adopted {
    int descriptor;
  };
  explicit PeerSocket(Adopted adopted) : descriptor_(adopted.descriptor) {}

  static sockaddr_in addressOf(const char* address, std::uint16_t port) {
    sockaddr_in result{};
    result.sin_family = AF_INET;
    result.sin_port = htons(port);
    inet_pton(AF_INET, address, &result.sin_addr);
    return result;
  }

  int descriptor_;
  std::uint16_t port_ = 0;
};

/// A datagram port that was free a moment ago.
inline std::uint16_t freePort() { return PeerSocket(SOCK_DGRAM).port(); }

/// A tracker and what it has delivered so far.
struct Watched {
  explicit Watched(Transport transport, double silence_s = 0.25)
      : tracker(std::move(transport), start, silence_s) {}

  double now_s() const { return std::chrono::duration<double>(Clock::now() - start).count(); }
  TrackerHealth health() const { return tracker.health(now_s()); }

  void poll() {
    tracker.poll(now_s(), samples);
    tracker.takeInputs(inputs);
  }
  /// Polls until `condition` holds; the limit only ends a test that has failed.
  template <class Condition>
  bool comesTrue(const Condition& condition) {
    for (int i = 0; i < 60000; ++i) {
      poll();
      if (condition()) return true;
      std::this_thread::sleep_for(milliseconds(1));
    }
    return false;
  }
  bool comesTo(TrackerHealth::State state) {
    return comesTrue([&] { return health().state == state; });
  }

  Clock::time_point start = Clock::now();
  DeviceTracker tracker;
  std::vector<TrackerSample> samples;
  std::vector<Reading> inputs;
};

/// Whether times of samples are those at which they were sent, on the sender's clock; to the delay of a busy
/// machine.
inline void expectTimes(const std::vector<TrackerSample>& samples, const std::vector<double>& sent_s,
                        double tolerance_s) {
  ASSERT_EQ(samples.size(), sent_s.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_NEAR(samples[i].time_s, sent_s[i], tolerance_s) << "sample " << i;
  }
}

}  // namespace carom::test
