#include "devices/network/dtrack_tracker.h"

#include <array>
#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "devices/network/dtrack_controller.h"
#include "devices/network/source_url.h"
#include "devices/protocol/dtrack_decoder.h"
#include "devices/tracker/retry.h"
#include "devices/tracker/stoppable_wait.h"
#include "devices/wire/frame_gaps.h"

namespace carom {
namespace {

constexpr std::uint16_t kDtrackPort = 5000;
constexpr std::chrono::milliseconds kDtrackPause{1000};
constexpr std::chrono::seconds kStartEvery{5};
constexpr std::uint16_t kDtrackCommandPort = 50105;

/// Starts the measurement, again and again while it fails and nothing comes, and stops it when this object
/// goes. In a thread of its own: a controller that wakes its cameras up, or does not answer, takes its time.
class Starter {
 public:
  Starter(const DtrackSource& source, DeviceSink& sink) {
    if (!source.start || !source.controller) return;
    thread_ = std::jthread([this, controller = *source.controller, &sink](const std::stop_token& stop) {
      run(controller, sink, stop);
    });
  }

  void delivers() { delivers_ = true; }

 private:
  void run(const Endpoint& endpoint, DeviceSink& sink, const std::stop_token& stop) {
    DtrackController controller(endpoint);
    bool started = false;
    for (bool first = true; !stop.stop_requested(); first = false, waitUnlessStopped(stop, kStartEvery)) {
      if (started || (delivers_.exchange(false) && !first)) continue;
      try {
        controller.start(stop);
        started = true;
        sink.remark({});
      } catch (const std::exception& error) {
        if (!stop.stop_requested()) sink.remark(error.what());
      }
    }
  }

  std::atomic<bool> delivers_ = false;
  std::jthread thread_;  // last: it uses the rest
};

void listen(const DtrackSource& source, DeviceSink& sink, const std::stop_token& stop) {
  Socket socket = Socket::boundTo(source.local, source.interface);
  sink.connected();
  Starter starter(source, sink);
  DtrackDecoder decoder;
  FrameGaps gaps;
  std::vector<std::uint8_t> bytes(kMostDatagram);
  std::vector<Reading> readings;
  bool remarked = false;  // on lines that cannot be read
  while (!stop.stop_requested()) {
    if (!waitReadable({&socket}, kLookAtStop)) continue;
    Ipv4 sender;
    const auto count = socket.receive(bytes, &sender);
    const auto arrival = std::chrono::steady_clock::now();
    if (!count || (source.from != 0 && sender.address != source.from)) continue;
    starter.delivers();
    readings.clear();
    const std::uint64_t refused = decoder.refused();
    const bool understood = decoder.decode({bytes.data(), *count}, readings);
    const bool isRefused = decoder.refused() != refused;
    if (!understood || isRefused) sink.refused();
    if (isRefused != remarked && (isRefused || !readings.empty())) {
      remarked = isRefused;
      sink.remark(isRefused ? decoder.whyRefused() : "");
    }
    if (decoder.frame()) sink.missed(gaps.follow(*decoder.frame()));
    if (!readings.empty()) sink.deliver(readings, arrival);
  }
}

}  // namespace

DtrackSource readDtrackSource(std::string_view text) {
  constexpr std::string_view kExample = "udp://0.0.0.0:5000";
  constexpr std::array<std::string_view, 3> kOptions{"from", "interface", "controller"};
  const SourceUrl url = readSourceUrl(text, "udp", kDtrackPort, kOptions, kExample);
  DtrackSource source{url.local(), url.address("interface"), url.address("from")};
  const auto controller = url.options.find("controller");
  if (controller != url.options.end())
    source.controller = readEndpoint(controller->second, kDtrackCommandPort);
  return source;
}

Transport dtrackTransport(const DtrackSource& source) {
  return [source](const std::stop_token& stop, DeviceSink& sink) {
    retry(stop, sink, kDtrackPause, [&] { listen(source, sink, stop); });
  };
}

}  // namespace carom
