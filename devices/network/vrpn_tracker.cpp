#include "devices/network/vrpn_tracker.h"

#include <array>
#include <optional>
#include <stdexcept>
#include <vector>

#include "devices/network/source_url.h"
#include "devices/protocol/vrpn_decoder.h"
#include "devices/tracker/retry.h"
#include "devices/wire/shown_name.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr std::uint16_t kVrpnPort = 3883;
constexpr auto kPingAfter = 1s;
constexpr auto kNamesWithin = 1s;   // a server that has met its client names all of its senders at once
constexpr auto kAnswerWithin = 3s;  // VRPN's own clients wait as long for a device before they complain
constexpr auto kGiveVrpnUpAfter = 5s;
constexpr auto kVrpnPause = 500ms;
constexpr std::size_t kLongestName = 100;  // VRPN's own limit

/// One connection, from its greeting to its end.
class VrpnSession {
 public:
  VrpnSession(const VrpnSource& source, DeviceSink& sink, const std::stop_token& stop)
      : source_(source),
        sink_(sink),
        stop_(stop),
        decoder_(source.sender),
        socket_(Socket::connectedTo(resolve(source.server, stop), stop)) {}

  /// Until asked to stop. Throws where the connection ends.
  void run() {
    socket_.send(vrpnGreeting());
    while (!stop_.stop_requested()) {
      if (waitReadable({&socket_}, kLookAtStop)) take();
      describe();
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
    if (decoder_.greeted() && !wasGreeted) {
      greeted_ = arrival;
      sink_.connected();
    }
    if (decoder_.senderHeard() && remarked_) {
      remarked_ = false;
      sink_.remark({});
    }
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

  /// Names the sender that we will ping, and pings it. A server names to its clients what they name to it, so
  /// its own names are waited for, unless it says nothing before its client does.
  void describe() {
    if (described_ || !decoder_.greeted()) return;
    if (!decoder_.senderNamed() && Clock::now() - greeted_ < kNamesWithin) return;
    if (decoder_.spoke()) decoder_.ignoreNames();
    std::vector<std::uint8_t> bytes = vrpnDescription(source_.sender);
    for (const std::uint8_t byte : vrpnPing()) bytes.push_back(byte);
    socket_.send(bytes);
    described_ = pinged_ = Clock::now();
  }

  void keepAlive() {
    const auto now = Clock::now();
    const bool isOurs = decoder_.senderNamed() || decoder_.senderHeard();
    if (now - heard_ > kGiveVrpnUpAfter && (isOurs || !decoder_.spoke())) {
      throw std::runtime_error("the server at " + toString(source_.server) +
                               (decoder_.spoke() || !decoder_.greeted()
                                    ? " has not answered for 5 s"
                                    : " greeted and has said nothing for 5 s"));
    }
    if (!described_ || now - heard_ < kPingAfter || now - pinged_ < kPingAfter) return;
    socket_.send(vrpnPing());
    pinged_ = now;
  }

  /// Returns the names of the server's other senders that have answered, or those that have not.
  std::string namesOf(bool answered) const {
    constexpr int kMostListed = 16;
    std::string names;
    int listed = 0;
    for (const auto& sender : decoder_.namedSenders()) {
      if (sender.name == source_.sender || sender.heard != answered) continue;
      if (++listed > kMostListed) return names + ", and more";
      names += (names.empty() ? "" : ", ") + shownName(sender.name);
    }
    return names;
  }

  /// A name that the server does not have is the most usual mistake. A server names what its earlier clients
  /// asked for as well as its devices: these alone answer a ping.
  void remarkOnSender() {
    if (remarked_ || !described_ || !decoder_.spoke() || decoder_.senderHeard()) return;
    if (decoder_.senderNamed() && Clock::now() - *described_ < kAnswerWithin) return;
    if (!probed_) {
      socket_.send(vrpnPings(decoder_.namedSenders()));
      probed_ = Clock::now();
    }
    if (Clock::now() - *probed_ < kNamesWithin) return;
    remarked_ = true;
    const std::string server = "the server at " + toString(source_.server);
    std::string names = namesOf(true);
    if (names.empty()) names = "nothing that answers";
    const std::string others = namesOf(false);
    if (!others.empty()) names += "; it names without an answer: " + others;
    sink_.remark(decoder_.senderNamed() ? server + " names a '" + source_.sender +
                                              "', but no such device answers; beside it there is: " + names
                                        : server + " has no '" + source_.sender + "', it has: " + names);
  }

  const VrpnSource& source_;
  DeviceSink& sink_;
  const std::stop_token& stop_;
  VrpnDecoder decoder_;
  Socket socket_;
  std::array<std::uint8_t, VrpnDecoder::kMostBytes> bytes_{};
  std::vector<Reading> readings_;
  Clock::time_point heard_ = Clock::now(), greeted_ = heard_, pinged_ = heard_;
  std::optional<Clock::time_point> described_, probed_;
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
          readSourceUrl(text.substr(at + 1), "tcp", kVrpnPort, {}, kExample).endpoint};
}

Transport vrpnTransport(const VrpnSource& source) {
  return [source](const std::stop_token& stop, DeviceSink& sink) {
    retry(stop, sink, kVrpnPause, [&] { VrpnSession(source, sink, stop).run(); });
  };
}

}  // namespace carom
