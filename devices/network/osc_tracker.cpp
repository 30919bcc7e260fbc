#include "devices/network/osc_tracker.h"

#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "devices/network/source_url.h"
#include "devices/osc/osc_decoder.h"
#include "devices/tracker/retry.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr std::uint16_t kOscPort = 9000;
constexpr auto kOscPause = 1000ms;
constexpr auto kFitsWithin = 3s;  // a sender whose messages fit has sent one by then

/// Returns the addresses that the mapping expects, for people.
std::string wantedBy(const OscMapping& mapping) {
  std::string words;
  for (const auto* pattern : {&mapping.pose, &mapping.buttons, &mapping.axes}) {
    if (*pattern) words += (words.empty() ? "'" : " or '") + (*pattern)->text() + '\'';
  }
  return words;
}

/// From the first datagram to where the socket fails.
class Listener {
 public:
  Listener(const OscSource& source, const OscMapping& mapping, DeviceSink& sink)
      : source_(source),
        sink_(sink),
        wanted_(wantedBy(mapping)),
        decoder_(mapping),
        socket_(Socket::boundTo(source.local, source.interface)) {
    sink.connected();
  }

  void run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      if (waitReadable({&socket_}, kLookAtStop)) take();
    }
  }

 private:
  void take() {
    Ipv4 sender;
    const auto count = socket_.receive(bytes_, &sender);
    const auto arrival = Clock::now();
    if (!count || (source_.from != 0 && sender.address != source_.from)) return;
    if (!heard_) heard_ = arrival;
    readings_.clear();
    const bool isRead = decoder_.decode({bytes_.data(), *count}, readings_);
    if (!isRead) sink_.refused();
    if (!readings_.empty()) {
      fits_ = true;
      sink_.deliver(readings_, arrival);
    }
    remark(isRead, arrival);
  }

  void remark(bool isRead, Clock::time_point now) {
    std::string remark = remark_;
    if (!isRead) {
      remark = decoder_.whyRefused();
    } else if (!readings_.empty()) {
      remark.clear();
    } else if (!fits_ && now - *heard_ > kFitsWithin && !decoder_.otherAddresses().empty()) {
      remark = "nothing has come for " + wanted_ + "; what has come is for ";
      for (const std::string& other : decoder_.otherAddresses()) {
        remark += (&other == &decoder_.otherAddresses().front() ? "" : ", ") + other;
      }
    }
    if (remark == remark_) return;
    remark_ = remark;
    sink_.remark(remark);
  }

  const OscSource& source_;
  DeviceSink& sink_;
  const std::string wanted_;
  OscDecoder decoder_;
  Socket socket_;
  std::vector<std::uint8_t> bytes_ = std::vector<std::uint8_t>(kMostDatagram);
  std::vector<Reading> readings_;
  std::string remark_;
  std::optional<Clock::time_point> heard_;
  bool fits_ = false;
};

}  // namespace

OscSource readOscSource(std::string_view text) {
  constexpr std::array<std::string_view, 2> kOptions{"from", "interface"};
  const SourceUrl url = readSourceUrl(text, "udp", kOscPort, kOptions, "udp://0.0.0.0:9000");
  return {url.local(), url.address("interface"), url.address("from")};
}

Transport oscTransport(const OscSource& source, const OscMapping& mapping) {
  return [source, mapping](const std::stop_token& stop, DeviceSink& sink) {
    retry(stop, sink, kOscPause, [&] { Listener(source, mapping, sink).run(stop); });
  };
}

}  // namespace carom
