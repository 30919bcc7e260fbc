#include "devices/protocol/qtm_frame.h"

#include <array>
#include <bit>
#include <cmath>

#include "devices/wire/checked_pose.h"
#include "devices/wire/wire_reader.h"

namespace carom {
namespace {

constexpr std::uint32_t k6d = 5, k6dResidual = 11;  // types of components
constexpr std::size_t kComponentHeader = 8;
constexpr std::uint32_t kMostComponents = 64, kMostBodiesOfFrame = 4096;
constexpr double kSecondsPerMicrosecond = 1e-6;

/// Reads one body into `reading`; false if it is seen and yet has no pose.
bool takeBody(WireReader& wire, bool hasResidual, Reading& reading) {
  glm::dvec3 place_mm;
  for (int i = 0; i < 3; ++i) place_mm[i] = static_cast<double>(wire.read<float>());
  std::array<double, 9> rotation{};
  for (double& number : rotation) number = static_cast<double>(wire.read<float>());
  if (hasResidual) wire.skip(sizeof(float));
  reading.kind = Reading::Kind::lost;
  if (std::isnan(place_mm.x) || std::isnan(place_mm.y) || std::isnan(place_mm.z)) return true;
  const auto orientation = checkedRotation(rotation);
  if (!orientation) return false;
  const auto pose = checkedPose(place_mm * kMetresPerMillimetre, *orientation);
  if (!pose) return false;
  reading.kind = Reading::Kind::pose;
  reading.pose = *pose;
  reading.hasOrientation = true;
  return true;
}

bool takeBodies(std::span<const std::uint8_t> component, bool hasResidual, double device_s, QtmFrame& frame,
                std::vector<Reading>& readings) {
  WireReader wire(component, std::endian::little);
  const std::uint32_t count = wire.read<std::uint32_t>();
  wire.skip(2, sizeof(std::uint16_t));  // cameras that dropped out, or out of sync
  const std::size_t size = (hasResidual ? 13 : 12) * sizeof(float);
  if (!wire.ok() || count > kMostBodiesOfFrame || wire.rest().size() != count * size) return false;
  for (std::uint32_t i = 0; i < count; ++i) {
    Reading reading;
    reading.device_s = device_s;
    reading.sensor = static_cast<std::int32_t>(i);
    if (takeBody(wire, hasResidual, reading)) {
      readings.push_back(reading);
    } else {
      frame.isWhole = false;
    }
  }
  return true;
}

}  // namespace

std::optional<QtmFrame> readQtmFrame(std::span<const std::uint8_t> content, std::vector<Reading>& readings) {
  WireReader wire(content, std::endian::little);
  const double device_s = static_cast<double>(wire.read<std::uint64_t>()) * kSecondsPerMicrosecond;
  QtmFrame frame;
  frame.number = wire.read<std::uint32_t>();
  const std::uint32_t components = wire.read<std::uint32_t>();
  if (!wire.ok() || components > kMostComponents) return {};
  const std::size_t before = readings.size();
  bool isRead = true, hasBodies = false;
  for (std::uint32_t i = 0; i < components && isRead; ++i) {
    const std::size_t size = wire.read<std::uint32_t>();
    const std::uint32_t type = wire.read<std::uint32_t>();
    const auto component =
        wire.take(size >= kComponentHeader ? size - kComponentHeader : wire.rest().size() + 1);
    isRead = wire.ok();
    if (!isRead || hasBodies || (type != k6d && type != k6dResidual)) continue;
    isRead = takeBodies(component, type == k6dResidual, device_s, frame, readings);
    hasBodies = true;
  }
  if (isRead) return frame;
  readings.resize(before);
  return {};
}

}  // namespace carom
