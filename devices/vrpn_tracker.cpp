#include "devices/vrpn_tracker.h"

#include <array>
#include <stdexcept>
#include <vector>

#include "devices/retry.h"
#include "devices/source_url.h"
#include "devices/vrpn_decoder.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr std::uint16_t kUsualPort = 3883;
constexpr auto kPingAfter = 1s;
constexpr auto kGiveUpAfter = 5s;
constexpr auto kPause = 500ms;
constexpr std::size_t kLongestName = 100;  // VRPN's own limit

/// One connection, from its greeting to its end.
class Session {
 public:
  Session(const VrpnSource& source, DeviceSink& sink, const std::stop_token& stop)
      : source_(source),
        sink_(sink),
        stop_(stop),
        decoder_(source.sender),
        socket_(Socket::connectedTo(resolve(source.server, stop), stop)) {}

  /// Until asked to stop. Throws where the connection ends.
  void run() {
    socket_.send(vrpnGreeting(source_.sender));
    while (!stop_.stop_requested()) {
      if (waitReadable({&socket_}, kLookAtStop)) take();
      keepAlive();
      remarkOnSender();
    }
  }

 private:
  void take() {
    const auto count = socket_.receive(bytes_);
    if (!count) return;
    if (*count == 0) throw std::runtime_error("the server at " + toString(source_.server) + " hung up");
    const auto arrival = Clock::now();
    heard_ = arrival;
    readings_.clear();
    const bool wasGreeted = decoder_.greeted();
    const std::uint64_t refused = decoder_.refused();
    decode({bytes_.data(), *count});
    if (decoder_.greeted() && !wasGreeted) sink_.connected();
    for (std::uint64_t i = refused; i < decoder_.refused(); ++i) sink_.refused();
    if (!readings_.empty()) sink_.deliver(readings_, arrival);
    if (decoder_.takePings() > 0) socket_.send(vrpnPong());
  }

  void decode(std::span<const std::uint8_t> bytes) {
    try {
      decoder_.decode(bytes, readings_);
    } catch (const std::runtime_error& error) {
      throw NeedsHelp("the server at " + toString(source_.server) + ": " + error.what());
    }
  }

  void keepAlive() {
    const auto now = Clock::now();
    if (now - heard_ > kGiveUpAfter && (decoder_.senderKnown() || !decoder_.greeted())) {
      throw std::runtime_error("the server at " + toString(source_.server) + " has not answered for 5 s");
    }
    if (!decoder_.greeted() || now - heard_ < kPingAfter || now - pinged_ < kPingAfter) return;
    socket_.send(vrpnPing());
    pinged_ = now;
  }

  /// A name that the server does not have is the most usual mistake.
  void remarkOnSender() {
    if (remarked_ || decoder_.senderKnown() || Clock::now() - begun_ < kPingAfter) return;
    remarked_ = true;
    std::string names;
    for (const std::string& name : decoder_.senderNames()) names += (names.empty() ? "" : ", ") + name;
    sink_.remark("the server at " + toString(source_.server) + " has no '" + source_.sender +
                 "', it has: " + (names.empty() ? "nothing" : names));
  }

  const VrpnSource& source_;
  DeviceSink& sink_;
  const std::stop_token& stop_;
  VrpnDecoder decoder_;
  Socket socket_;
  std::array<std::uint8_t, VrpnDecoder::kMostBytes> bytes_{};
  std::vector<Reading> readings_;
  Clock::time_point begun_ = Clock::now(), heard_ = begun_, pinged_ = begun_;
  bool remarked_ = false;
};

}  // namespace

VrpnSource readVrpnSource(std::string_view text) {
  constexpr std::string_view kExample = "Head@tcp://host:3883";
  const std::size_t at = text.find('@');
  if (at == 0 || at >= kLongestName) {
    throw std::invalid_argument("source is '" + std::string(text) + "', expected one such as '" +
                                std::string(kExample) + "'");
  }
  return {std::string(text.substr(0, at)),
          readSourceUrl(text.substr(at + 1), "tcp", kUsualPort, {}, kExample).endpoint};
}

Transport vrpnTransport(const VrpnSource& source) {
  return [source](const std::stop_token& stop, DeviceSink& sink) {
    retry(stop, sink, kPause, [&] { Session(source, sink, stop).run(); });
  };
}

}  // namespace carom
