#include "devices/protocol/rift_decoder.h"

#include <algorithm>

#include "devices/wire/wire_reader.h"

namespace carom {
namespace {

constexpr double kUnit = 1e-4;       // m/s² and rad/s in a step of the sensors' numbers
constexpr double kSpacing_s = 1e-3;  // between samples of one report

/// Three signed numbers of 21 bits, highest bit first, in 64 bits; the last bit is not used.
glm::dvec3 unpack(std::uint64_t bits) {
  const auto number = [bits](int shift) {  // into the highest bits, then down again with the sign
    return static_cast<double>(static_cast<std::int64_t>(bits << shift) >> 43);
  };
  return kUnit * glm::dvec3(number(0), number(21), number(42));
}

}  // namespace

bool RiftDecoder::decode(std::span<const std::uint8_t> report, std::vector<ImuSample>& samples) {
  if (report.empty()) return false;
  if (report[0] == 1) {
    if (report.size() < 62) return false;
    const int made = report[1];
    const int count = std::min(made, 3);
    missed_ += static_cast<std::uint64_t>(made - count);
    const auto time_ms =
        clock_ms_.follow(WireReader(report.subspan(2), std::endian::little).read<std::uint16_t>());
    append(report.subspan(8), count, 1e-3 * static_cast<double>(time_ms), samples);
  } else if (report[0] == 11) {
    if (report.size() < 64) return false;
    const int made = report[3];
    const int count = std::min(made, 2);
    missed_ += static_cast<std::uint64_t>(made - count);
    const auto time_us =
        clock_us_.follow(WireReader(report.subspan(8), std::endian::little).read<std::uint32_t>());
    append(report.subspan(12), count, 1e-6 * static_cast<double>(time_us), samples);
  }
  return true;
}

void RiftDecoder::append(std::span<const std::uint8_t> packed, int count, double last_s,
                         std::vector<ImuSample>& samples) {
  WireReader wire(packed, std::endian::big);
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 acceleration_m_s2 = unpack(wire.read<std::uint64_t>());
    const glm::dvec3 rate_rad_s = unpack(wire.read<std::uint64_t>());
    samples.push_back({last_s - (count - 1 - i) * kSpacing_s, rate_rad_s, acceleration_m_s2});
  }
}

}  // namespace carom
