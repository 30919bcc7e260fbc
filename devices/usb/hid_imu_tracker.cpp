#include "devices/usb/hid_imu_tracker.h"

#include <array>
#include <chrono>
#include <glm/mat3x3.hpp>
#include <optional>
#include <stdexcept>
#include <vector>

#include "devices/filter/orientation_filter.h"
#include "devices/protocol/rift_decoder.h"
#include "devices/usb/hid_transport.h"

namespace carom {
namespace {

using namespace std::chrono_literals;

constexpr std::uint16_t kOculus = 0x2833;
// Feature report 8: the headset sends for this number of milliseconds (10 000) and then sleeps until told
// again.
constexpr std::array<std::uint8_t, 5> kKeepAlive{8, 0, 0, 0x10, 0x27};
constexpr auto kBetweenKeepAlives = 3s;  // two may be lost
constexpr double kUsualStep_s = 1e-3;
constexpr double kLongestStep_s = 0.5;  // a longer gap is an interruption, not a turn

class Headset : public HidListener {
 public:
  Headset(UsbAddress address, const glm::dvec3& standing_m, const RoomAxes& axes)
      : address_(std::move(address)),
        standing_m_(standing_m),
        trackerFromLevel_(glm::quat_cast(glm::dmat3(axes.right, axes.up, -axes.forward))) {
    samples_.reserve(4);
    readings_.reserve(8);
  }

  std::string name() const override {
    return std::string(headsetName(address_.vendor, address_.product)) + " (" + toString(address_) + ')';
  }

  bool wants(const HidEntry& entry) const override {
    return entry.vendor == address_.vendor && entry.product == address_.product &&
           (address_.serial.empty() || entry.serial == address_.serial);
  }

  void connected(HidDevice& device) override {
    decoder_ = {};
    missed_ = 0;
    lastSample_s_.reset();
    keepAlive(device, std::chrono::steady_clock::now());
  }

  void report(std::span<const std::uint8_t> report, TimePoint arrival, DeviceSink& sink) override {
    samples_.clear();
    readings_.clear();
    if (!decoder_.decode(report, samples_)) sink.refused();
    for (const ImuSample& sample : samples_) add(sample);
    if (!readings_.empty()) sink.deliver(readings_, arrival);
    if (decoder_.missed() > missed_) sink.missed(decoder_.missed() - missed_);
    missed_ = decoder_.missed();
  }

  void tick(HidDevice& device, TimePoint now, DeviceSink&) override {
    if (now - lastKeepAlive_ >= kBetweenKeepAlives) keepAlive(device, now);
  }

  void disconnected(TimePoint, DeviceSink&) override {}

 private:
  void keepAlive(HidDevice& device, TimePoint now) {
    device.sendFeature(kKeepAlive);
    lastKeepAlive_ = now;
  }

  void add(const ImuSample& sample) {
    const double step_s = lastSample_s_ ? sample.device_s - *lastSample_s_ : kUsualStep_s;
    lastSample_s_ = sample.device_s;
    if (step_s > 0.0 && step_s <= kLongestStep_s) {
      filter_.update(step_s, sample.rate_rad_s, sample.acceleration_m_s2);
    }
    Reading reading;
    reading.hasOrientation = true;
    reading.device_s = sample.device_s;
    reading.pose.position_m = standing_m_;
    reading.pose.orientation =
        glm::normalize(trackerFromLevel_ * filter_.orientation() * glm::conjugate(trackerFromLevel_));
    readings_.push_back(reading);
    reading.kind = Reading::Kind::velocity;
    reading.angularVelocity_rad_s =
        trackerFromLevel_ * (filter_.orientation() * (sample.rate_rad_s - filter_.bias_rad_s()));
    readings_.push_back(reading);
  }

  UsbAddress address_;
  glm::dvec3 standing_m_;
  glm::dquat trackerFromLevel_;  // from right, up, back to the tracker's axes
  RiftDecoder decoder_;
  OrientationFilter filter_;
  std::vector<ImuSample> samples_;
  std::vector<Reading> readings_;
  std::optional<double> lastSample_s_;
  std::uint64_t missed_ = 0;
  TimePoint lastKeepAlive_{};
};

}  // namespace

const char* headsetName(std::uint16_t vendor, std::uint16_t product) {
  if (vendor != kOculus) return nullptr;
  if (product == 0x0001) return "Oculus Rift DK1";
  return product == 0x0021 || product == 0x2021 ? "Oculus Rift DK2" : nullptr;
}

Transport hidImuTransport(const UsbAddress& address, const glm::dvec3& standing_m, const RoomAxes& axes) {
  if (headsetName(address.vendor, address.product) == nullptr) {
    throw std::invalid_argument(
        toString(address) +
        " is no headset that is known: expected 2833:0001 (Oculus Rift DK1), 2833:0021 or "
        "2833:2021 (DK2)");
  }
  return [=](const std::stop_token& stop, DeviceSink& sink) {
    Headset headset(address, standing_m, axes);
    listenToHid(stop, sink, headset);
  };
}

}  // namespace carom
