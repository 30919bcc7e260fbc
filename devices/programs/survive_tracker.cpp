#include "devices/programs/survive_tracker.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <stdexcept>

#include "devices/network/source_url.h"
#include "devices/programs/child_program.h"
#include "devices/protocol/survive_decoder.h"
#include "devices/tracker/retry.h"
#include "devices/wire/shown_name.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kSurvivePause = 2000ms;
constexpr auto kPosesWithin = 5s;
constexpr auto kFaultShown = 10s;
constexpr std::size_t kMostBytes = 65536;  // read at once

/// The program and its arguments: poses and buttons alone, none of what they are computed from.
const std::vector<std::string> kCommand{
    "survive-cli", "--record-stdout", "--record-rawlight", "0", "--record-imu", "0", "--record-angle", "0"};

/// What comes of the lines, wherever they come from.
class Lines {
 public:
  Lines(const std::vector<std::string>& names, DeviceSink& sink)
      : names_(names), sink_(sink), decoder_(names) {
    sink.connected();
  }

  void take(std::span<const std::uint8_t> bytes) {
    const auto arrival = Clock::now();
    readings_.clear();
    const std::uint64_t refused = decoder_.refused();
    decoder_.decode(bytes, readings_);
    for (std::uint64_t i = refused; i < decoder_.refused(); ++i) sink_.refused();
    if (!readings_.empty()) sink_.deliver(readings_, arrival);
    if (decoder_.refused() > refused) {
      fault_ = decoder_.whyRefused();
      faultAt_ = arrival;
    }
    if (decoder_.devices().size() > named_) {
      named_ = decoder_.devices().size();
      sink_.named("devices: " + list());
    }
  }

  /// Tells the latest fault, as long as somebody may want to read it, if it has changed.
  void remark() {
    if (Clock::now() - faultAt_ > kFaultShown) fault_.clear();
    std::string remark = fault_;
    if (remark.empty() && Clock::now() - begun_ > kPosesWithin) remark = missing();
    if (remark == remark_) return;
    remark_ = remark;
    sink_.remark(remark);
  }

 private:
  std::string list() const {
    std::string words;
    for (const std::string& device : decoder_.devices())
      words += (words.empty() ? "" : ", ") + shownName(device);
    return words;
  }

  /// Returns which devices are wanted and have sent no pose; empty if there are none.
  std::string missing() const {
    const auto& devices = decoder_.devices();
    if (devices.empty()) {
      return "no device has sent a pose yet" +
             (decoder_.lastWords().empty() ? "" : "; survive-cli last said '" + decoder_.lastWords() + '\'');
    }
    for (const std::string& name : names_) {
      if (std::find(devices.begin(), devices.end(), name) == devices.end()) {
        return "no '" + shownName(name) + "' has sent a pose; these have: " + list();
      }
    }
    return {};
  }

  const std::vector<std::string>& names_;
  DeviceSink& sink_;
  SurviveDecoder decoder_;
  std::vector<Reading> readings_;
  std::size_t named_ = 0;
  std::string fault_, remark_;
  Clock::time_point faultAt_{};
  const Clock::time_point begun_ = Clock::now();
};

void readProgram(const std::vector<std::string>& names, DeviceSink& sink, const std::stop_token& stop) {
  ChildProgram program(kCommand);
  Lines lines(names, sink);
  std::vector<std::uint8_t> bytes(kMostBytes);
  while (!stop.stop_requested()) {
    if (program.waitReadable(kLookAtStop)) {
      const auto count = program.receive(bytes);
      if (count == 0) throw std::runtime_error(kCommand[0] + ' ' + program.howItEnded());
      if (count) lines.take({bytes.data(), *count});
    }
    lines.remark();
  }
}

void readServer(const Endpoint& server, const std::vector<std::string>& names, DeviceSink& sink,
                const std::stop_token& stop) {
  Socket socket = Socket::connectedTo(resolve(server, stop), stop);
  Lines lines(names, sink);
  std::vector<std::uint8_t> bytes(kMostBytes);
  while (!stop.stop_requested()) {
    if (waitReadable({&socket}, kLookAtStop)) {
      const auto count = socket.receive(bytes);
      if (count == 0) throw std::runtime_error("the server at " + toString(server) + " hung up");
      if (count) lines.take({bytes.data(), *count});
    }
    lines.remark();
  }
}

}  // namespace

Endpoint readSurviveServer(std::string_view text) {
  constexpr std::string_view kExample = "tcp://192.168.1.10:7001";
  const Endpoint server = readSourceUrl(text, "tcp", 0, {}, kExample).endpoint;
  if (server.port == 0) {
    throw std::invalid_argument("source is '" + std::string(text) + "', expected it with a port, such as '" +
                                std::string(kExample) + '\'');
  }
  return server;
}

Transport surviveTransport(const std::optional<Endpoint>& server, const std::vector<std::string>& names) {
  return [server, names](const std::stop_token& stop, DeviceSink& sink) {
    retry(stop, sink, kSurvivePause,
          [&] { server ? readServer(*server, names, sink, stop) : readProgram(names, sink, stop); });
  };
}

}  // namespace carom
