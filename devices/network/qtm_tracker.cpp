#include "devices/network/qtm_tracker.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <stdexcept>

#include "devices/network/source_url.h"
#include "devices/protocol/qtm_bodies.h"
#include "devices/protocol/qtm_frame.h"
#include "devices/protocol/qtm_packets.h"
#include "devices/tracker/retry.h"
#include "devices/wire/frame_gaps.h"
#include "devices/wire/shown_name.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;
using Type = QtmPacket::Type;
using namespace std::chrono_literals;

constexpr std::uint16_t kQtmPort = 22223;
constexpr std::size_t kMostBytes = 65536;  // read at once
constexpr auto kQtmPause = 1000ms;
constexpr auto kAskQtmEvery = 2s;
constexpr auto kGiveQtmUpAfter = 6s;
constexpr std::uint8_t kShutsDown = 12;  // an event
constexpr std::size_t kMostShown = 32;
constexpr std::string_view kGreeting = "QTM RT Interface connected";

/// Which of QTM's bodies is which sensor.
class Bodies {
 public:
  explicit Bodies(const std::vector<std::string>& wanted) : wanted_(wanted) {}

  void take(std::vector<std::string> names) {
    names_ = std::move(names);
    isKnown_ = true;
  }

  /// Gives the readings of bodies the numbers of their sensors, and leaves out those that are none.
  void number(std::vector<Reading>& readings) const {
    if (wanted_.empty()) return;
    std::erase_if(readings, [&](Reading& reading) {
      const auto body = static_cast<std::size_t>(reading.sensor);
      const auto found =
          body < names_.size() ? std::find(wanted_.begin(), wanted_.end(), names_[body]) : wanted_.end();
      reading.sensor = static_cast<std::int32_t>(found - wanted_.begin());
      return found == wanted_.end();
    });
  }

  /// Returns what QTM's bodies are called, for people.
  std::string list() const {
    std::string words;
    for (std::size_t i = 0; i < names_.size() && i < kMostShown; ++i)
      words += (i > 0 ? ", " : "") + shownName(names_[i]);
    if (names_.size() > kMostShown) words += ", and more";
    return words.empty() ? "none" : words;
  }

  /// Returns which names of the rig are none of QTM's bodies, for people; empty if all are.
  std::string missing() const {
    std::string words;
    for (const std::string& name : wanted_) {
      if (isKnown_ && std::find(names_.begin(), names_.end(), name) == names_.end()) {
        words += (words.empty() ? "'" : ", '") + shownName(name) + '\'';
      }
    }
    return words;
  }

 private:
  const std::vector<std::string>& wanted_;
  std::vector<std::string> names_;
  bool isKnown_ = false;
};

/// One connection, from its greeting to its end.
class QtmSession {
 public:
  QtmSession(const Endpoint& server, const std::vector<std::string>& names, DeviceSink& sink,
             const std::stop_token& stop)
      : server_(server),
        sink_(sink),
        stop_(stop),
        bodies_(names),
        socket_(Socket::connectedTo(resolve(server, stop), stop)) {}

  /// Until asked to stop. Throws where the connection ends.
  void run() {
    while (!stop_.stop_requested()) {
      if (waitReadable({&socket_}, kLookAtStop)) take();
      keepAsking();
    }
  }

 private:
  std::string name() const { return "QTM at " + toString(server_); }

  void take() {
    const auto count = socket_.receive(bytes_);
    if (!count) return;
    if (*count == 0) throw std::runtime_error(name() + " hung up");
    const auto arrival = heard_ = Clock::now();
    packets_.add({bytes_.data(), *count});
    try {
      while (const auto packet = packets_.next()) understand(*packet, arrival);
    } catch (const NeedsHelp&) {
      throw;
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(name() + ": " + error.what());
    }
  }

  void understand(const QtmPacket& packet, Clock::time_point arrival) {
    if (!greeted_ && packet.type != Type::command && packet.type != Type::event) {
      throw std::runtime_error("it begins without a greeting, expected '" + std::string(kGreeting) + '\'');
    }
    switch (packet.type) {
      case Type::command:
        return applyAnswer(packet.text());
      case Type::error:
        return complain(packet.text());
      case Type::xml:
        return learn(packet.text());
      case Type::data:
        return readFrame(packet.content, arrival);
      case Type::event:
        if (!packet.content.empty() && packet.content.front() == kShutsDown)
          throw std::runtime_error("it shuts down");
        return;
      case Type::noMoreData:
        return;
    }
  }

  /// Takes QTM's answers to a new client and to its version.
  void applyAnswer(std::string_view answer) {
    if (!greeted_) {
      if (!answer.starts_with(kGreeting)) {
        throw std::runtime_error("it greets with '" + shownName(answer) + "', expected '" +
                                 std::string(kGreeting) + '\'');
      }
      greeted_ = true;
      socket_.send(qtmCommand("Version 1.19"));
    } else if (answer.starts_with("Version set") && !agreed_) {
      agreed_ = true;
      sink_.connected();
      ask();
    }
  }

  void complain(std::string_view words) {
    if (!agreed_) {
      throw NeedsHelp(name() + " says '" + shownName(words) +
                      "', expected one that speaks version 1.19 of its protocol: update QTM");
    }
    remark(name() + " says '" + shownName(words) + '\'');
  }

  void learn(std::string_view xml) {
    auto names = readQtmBodies(xml);
    if (!names) return sink_.refused();
    bodies_.take(std::move(*names));
    sink_.named("QTM's bodies: " + bodies_.list());
    const std::string missing = bodies_.missing();
    remark(missing.empty() ? "" : name() + " has no body " + missing + ", it has: " + bodies_.list());
  }

  void readFrame(std::span<const std::uint8_t> content, Clock::time_point arrival) {
    readings_.clear();
    const auto frame = readQtmFrame(content, readings_);
    if (!frame || !frame->isWhole) sink_.refused();
    if (!frame) return;
    delivered_ = arrival;
    sink_.missed(gaps_.follow(frame->number));
    bodies_.number(readings_);
    if (!readings_.empty()) sink_.deliver(readings_, arrival);
  }

  /// Asks for names and frames, and again while no frames come.
  void keepAsking() {
    const auto now = Clock::now();
    if (now - heard_ > kGiveQtmUpAfter) throw std::runtime_error(name() + " has not answered for 6 s");
    const bool delivers = now - delivered_ < kAskQtmEvery;
    if (agreed_ && !delivers && now - asked_ > kAskQtmEvery) ask();
  }
  void ask() {
    asked_ = Clock::now();
    socket_.send(qtmCommand("GetParameters 6D"));
    socket_.send(qtmCommand("StreamFrames AllFrames 6DRes"));
  }

  void remark(const std::string& what) {
    if (what == remark_) return;
    remark_ = what;
    sink_.remark(what);
  }

  const Endpoint& server_;
  DeviceSink& sink_;
  const std::stop_token& stop_;
  Bodies bodies_;
  Socket socket_;
  QtmPackets packets_;
  FrameGaps gaps_;
  std::vector<std::uint8_t> bytes_ = std::vector<std::uint8_t>(kMostBytes);
  std::vector<Reading> readings_;
  std::string remark_;
  Clock::time_point heard_ = Clock::now(), asked_{}, delivered_{};
  bool greeted_ = false, agreed_ = false;
};

}  // namespace

Endpoint readQtmServer(std::string_view text) {
  return readSourceUrl(text, "tcp", kQtmPort, {}, "tcp://192.168.1.10:22223").endpoint;
}

Transport qtmTransport(const Endpoint& server, const std::vector<std::string>& names) {
  return [server, names](const std::stop_token& stop, DeviceSink& sink) {
    retry(stop, sink, kQtmPause, [&] { QtmSession(server, names, sink, stop).run(); });
  };
}

}  // namespace carom
