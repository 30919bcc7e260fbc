#pragma once
// Decodes the input reports of an Oculus Rift DK1 or DK2 into samples of its gyroscope and accelerometer.
// Sources: OpenHMD's drv_oculus_rift/packet.c; the layout was found by O. Kreylos and others.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "devices/wire/unwrapped_counter.h"

namespace carom {

/// One sample of an inertial sensor, in the sensor's axes: right, up and back of the wearer.
struct ImuSample {
  double device_s = 0.0;              ///< on the device's clock
  glm::dvec3 rate_rad_s{0.0};         ///< how fast it turns
  glm::dvec3 acceleration_m_s2{0.0};  ///< as felt: at rest 9.81 upwards
};

class RiftDecoder {
 public:
  /// Takes one report, which begins with its number: 1 (DK1, at least 62 bytes, up to 3 samples) or 11 (DK2,
  /// 64 bytes, up to 2). Appends its samples, oldest first; they are a millisecond apart, and the last one
  /// has the report's time. Returns false if the report is too short; ignores reports with other numbers.
  bool decode(std::span<const std::uint8_t> report, std::vector<ImuSample>& samples);

  /// Returns how many samples the device has counted and not sent.
  std::uint64_t missed() const { return missed_; }

 private:
  void append(std::span<const std::uint8_t> packed, int count, double last_s,
              std::vector<ImuSample>& samples);

  UnwrappedCounter<std::uint16_t> clock_ms_;  // DK1
  UnwrappedCounter<std::uint32_t> clock_us_;  // DK2
  std::uint64_t missed_ = 0;
};

}  // namespace carom
