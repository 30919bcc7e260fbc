#include "devices/usb/spacemouse.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>
#include <utility>
#include <vector>

#include "devices/protocol/spacemouse_decoder.h"
#include "devices/usb/hid_transport.h"

namespace carom {
namespace {

using namespace std::chrono_literals;

// Devices send every 8 or 16 ms while the cap is off centre, and nothing at all while it is not.
constexpr auto kSpacemouseSilence = 50ms;

// Of Logitech, which sold them first; ids from spacenavd's list. (The models before 2004, c603 and c606, have
// other axes and are not among them.)
constexpr std::uint16_t kLogitech = 0x046d;
constexpr std::array<std::uint16_t, 9> kByLogitech{0xc605, 0xc621, 0xc623, 0xc625, 0xc626,
                                                   0xc627, 0xc628, 0xc629, 0xc62b};
constexpr std::uint16_t k3Dconnexion = 0x256f;

bool isMaker(std::uint16_t vendor, std::uint16_t product) {
  return vendor == k3Dconnexion || (vendor == kLogitech && std::find(kByLogitech.begin(), kByLogitech.end(),
                                                                     product) != kByLogitech.end());
}

class SpaceMouse : public HidListener {
 public:
  explicit SpaceMouse(std::optional<UsbAddress> address) : address_(std::move(address)) {}

  std::string name() const override {
    return address_ ? "SpaceMouse (" + toString(*address_) + ')' : "SpaceMouse";
  }

  bool wants(const HidEntry& entry) const override {
    if (!isSpaceMouse(entry)) return false;
    return !address_ || (entry.vendor == address_->vendor && entry.product == address_->product &&
                         (address_->serial.empty() || entry.serial == address_->serial));
  }

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
    if (now - lastCame_ <= kSpacemouseSilence) return;
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

  std::optional<UsbAddress> address_;
  SpaceMouseDecoder decoder_;
  std::vector<Reading> readings_;
  TimePoint lastCame_{};
};

}  // namespace

bool isSpaceMouse(const HidEntry& entry) {
  // generic desktop, multi-axis controller
  return isMaker(entry.vendor, entry.product) && entry.usagePage == 1 && entry.usage == 8;
}

Transport spaceMouseTransport(const std::optional<UsbAddress>& address) {
  if (address && !isMaker(address->vendor, address->product)) {
    throw std::invalid_argument(toString(*address) +
                                " is no SpaceMouse: expected one such as 046d:c626 or 256f:c635, or no "
                                "source for the first that is plugged in");
  }
  return [address](const std::stop_token& stop, DeviceSink& sink) {
    SpaceMouse mouse(address);
    listenToHid(stop, sink, mouse);
  };
}

}  // namespace carom
