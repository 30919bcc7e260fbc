#include "devices/spacemouse.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

#include "devices/hid_transport.h"
#include "devices/spacemouse_decoder.h"

namespace carom {
namespace {

using namespace std::chrono_literals;

// Devices send every 8 or 16 ms while the cap is off centre, and nothing at all while it is not.
constexpr auto kSilence = 50ms;

// Of Logitech, which sold them first; ids from spacenavd's list. (The models before 2004, c603 and c606, have
// other axes and are not among them.)
constexpr std::uint16_t kLogitech = 0x046d;
constexpr std::array<std::uint16_t, 9> kByLogitech{0xc605, 0xc621, 0xc623, 0xc625, 0xc626,
                                                   0xc627, 0xc628, 0xc629, 0xc62b};
constexpr std::uint16_t k3Dconnexion = 0x256f;

class SpaceMouse : public HidListener {
 public:
  std::string name() const override { return "SpaceMouse"; }

  bool wants(const HidEntry& entry) const override { return isSpaceMouse(entry); }

  void connected(HidDevice&) override {
    decoder_ = {};
    readings_.reserve(64);
  }

  void report(std::span<const std::uint8_t> report, TimePoint arrival, DeviceSink& sink) override {
    lastCame_ = arrival;
    if (!decoder_.decode(report, readings_)) sink.refused();
    deliver(arrival, sink);
  }

  void tick(HidDevice&, TimePoint now, DeviceSink& sink) override {
    if (now - lastCame_ <= kSilence) return;
    decoder_.centre(readings_);
    deliver(now, sink);
  }

  void disconnected(TimePoint now, DeviceSink& sink) override {
    decoder_.release(readings_);
    deliver(now, sink);
  }

 private:
  void deliver(TimePoint when, DeviceSink& sink) {
    if (!readings_.empty()) sink.deliver(readings_, when);
    readings_.clear();
  }

  SpaceMouseDecoder decoder_;
  std::vector<Reading> readings_;
  TimePoint lastCame_{};
};

}  // namespace

bool isSpaceMouse(const HidEntry& entry) {
  const bool maker = entry.vendor == k3Dconnexion ||
                     (entry.vendor == kLogitech &&
                      std::find(kByLogitech.begin(), kByLogitech.end(), entry.product) != kByLogitech.end());
  return maker && entry.usagePage == 1 && entry.usage == 8;  // generic desktop, multi-axis controller
}

Transport spaceMouseTransport() {
  return [](const std::stop_token& stop, DeviceSink& sink) {
    SpaceMouse mouse;
    listenToHid(stop, sink, mouse);
  };
}

}  // namespace carom
