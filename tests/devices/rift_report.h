#pragma once
// Reports of a Rift's inertial sensor, packed bit by bit as its firmware does.

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace carom::test {

struct RiftSample {
  glm::dvec3 acceleration_m_s2{0.0};
  glm::dvec3 rate_rad_s{0.0};
};

/// Three numbers of 21 bits, highest first, and a spare bit.
inline void packVector(const glm::dvec3& vector, std::uint8_t* bytes) {
  int place = 0;  // of the next bit
  for (int i = 0; i < 3; ++i) {
    const auto number = static_cast<std::uint32_t>(std::lround(vector[i] / 1e-4)) & 0x1fffffU;
    for (int bit = 20; bit >= 0; --bit, ++place) {
      if ((number >> bit & 1U) != 0)
        bytes[place / 8] = static_cast<std::uint8_t>(bytes[place / 8] | 0x80U >> place % 8);
    }
  }
}

inline void packSamples(const std::vector<RiftSample>& samples, std::uint8_t* bytes) {
  for (const RiftSample& sample : samples) {
    packVector(sample.acceleration_m_s2, bytes);
    packVector(sample.rate_rad_s, bytes + 8);
    bytes += 16;
  }
}

inline std::vector<std::uint8_t> dk1Report(std::uint16_t time_ms, const std::vector<RiftSample>& samples) {
  std::vector<std::uint8_t> report(62);
  report[0] = 1;
  report[1] = static_cast<std::uint8_t>(samples.size());
  report[2] = static_cast<std::uint8_t>(time_ms);
  report[3] = static_cast<std::uint8_t>(time_ms >> 8);
  packSamples(samples, &report[8]);
  return report;
}

inline std::vector<std::uint8_t> dk2Report(std::uint32_t time_us, const std::vector<RiftSample>& samples) {
  std::vector<std::uint8_t> report(64);
  report[0] = 11;
  report[3] = static_cast<std::uint8_t>(samples.size());
  for (int i = 0; i < 4; ++i)
    report[static_cast<std::size_t>(8 + i)] = static_cast<std::uint8_t>(time_us >> 8 * i);
  packSamples(samples, &report[12]);
  return report;
}

}  // namespace carom::test
