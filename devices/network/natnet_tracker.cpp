#include "devices/network/natnet_tracker.h"

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "devices/network/source_url.h"
#include "devices/protocol/natnet_decoder.h"
#include "devices/tracker/retry.h"
#include "devices/wire/frame_gaps.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr std::uint16_t kNatnetCommandPort = 1510, kNatnetDataPort = 1511;
constexpr auto kAskNatnetEvery = 500ms;
constexpr auto kGiveNatnetUpAfter = 3s;

/// From the first question to where the server answers no more.
class Session {
 public:
  Session(const NatnetSource& source, DeviceSink& sink, const std::stop_token& stop)
      : source_(source),
        sink_(sink),
        stop_(stop),
        server_(resolve(source.server, stop)),
        commands_(Socket::boundTo({source.interface, 0})) {
    if (source.group) data_.emplace(Socket::boundTo(*source.group, source.interface));
  }

  /// Until asked to stop. Throws where the server is gone.
  void run() {
    Socket* const data = data_ ? &*data_ : nullptr;
    while (!stop_.stop_requested()) {
      keepAsking();
      if (!waitReadable({&commands_, data}, kLookAtStop)) continue;
      take(commands_);
      if (data) take(*data);
    }
  }

 private:
  /// A server that delivers is only told that we are there; one that does not is asked anew.
  void keepAsking() {
    const auto now = Clock::now();
    if (now - heard_ > kGiveNatnetUpAfter) {
      throw std::runtime_error("no answer from a NatNet server at " + toString(source_.server));
    }
    if (now - asked_ < kAskNatnetEvery) return;
    asked_ = now;
    const bool delivers = now - delivered_ < kAskNatnetEvery;
    if (!delivers) {
      commands_.send(natnetConnect(), server_);
    } else if (!source_.group) {
      commands_.send(natnetKeepAlive(), server_);
    }
  }

  void take(Socket& socket) {
    Ipv4 sender;
    while (!stop_.stop_requested()) {  // datagrams may come faster than they are understood
      const auto count = socket.receive(bytes_, &sender);
      if (!count) return;
      const auto arrival = Clock::now();
      if (sender.address != server_.address) continue;
      heard_ = arrival;
      understand({bytes_.data(), *count}, arrival);
    }
  }

  void understand(std::span<const std::uint8_t> datagram, Clock::time_point arrival) {
    readings_.clear();
    switch (decoder_.decode(datagram, readings_)) {
      case NatnetDecoder::Packet::server:
        meet(*decoder_.server());
        break;
      case NatnetDecoder::Packet::frame:
        delivered_ = arrival;
        sink_.missed(gaps_.follow(decoder_.frame()));
        if (!readings_.empty()) sink_.deliver(readings_, arrival);
        break;
      case NatnetDecoder::Packet::refused:
        sink_.refused();
        break;
      case NatnetDecoder::Packet::other:
        break;
    }
  }

  void meet(const NatnetServer& server) {
    if (server.major != 3 && server.major != 4) {
      throw NeedsHelp("the server at " + toString(source_.server) + " speaks NatNet " +
                      std::to_string(server.major) + '.' + std::to_string(server.minor) +
                      ", expected 3 or 4: another version of Motive is needed");
    }
    if (!met_) sink_.connected();
    met_ = true;
  }

  const NatnetSource& source_;
  DeviceSink& sink_;
  const std::stop_token& stop_;
  const Ipv4 server_;
  Socket commands_;
  std::optional<Socket> data_;
  NatnetDecoder decoder_;
  FrameGaps gaps_;
  std::vector<std::uint8_t> bytes_ = std::vector<std::uint8_t>(kMostDatagram);
  std::vector<Reading> readings_;
  bool met_ = false;
  Clock::time_point heard_ = Clock::now(), asked_{}, delivered_{};
};

}  // namespace

NatnetSource readNatnetSource(std::string_view text) {
  constexpr std::string_view kExample = "udp://192.168.1.10:1510";
  constexpr std::array<std::string_view, 2> kOptions{"group", "interface"};
  const SourceUrl url = readSourceUrl(text, "udp", kNatnetCommandPort, kOptions, kExample);
  NatnetSource source{url.endpoint, {}, url.address("interface")};
  const auto group = url.options.find("group");
  if (group == url.options.end()) return source;
  const Endpoint place = readEndpoint(group->second, kNatnetDataPort);
  source.group = Ipv4{ipv4Of(place.host).value_or(0), place.port};
  if (!source.group->isGroup()) {
    throw std::invalid_argument("group is '" + group->second +
                                "', expected a multicast address such as 239.255.42.99:1511");
  }
  return source;
}

Transport natnetTransport(const NatnetSource& source) {
  return [source](const std::stop_token& stop, DeviceSink& sink) {
    retry(stop, sink, kAskNatnetEvery, [&] { Session(source, sink, stop).run(); });
  };
}

}  // namespace carom
