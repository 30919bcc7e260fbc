#include "devices/protocol/trackd_segment.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "devices/wire/checked_pose.h"
#include "devices/wire/wire_reader.h"

namespace carom {
namespace {

constexpr std::size_t kSensorsHeader = 28, kWandHeader = 32, kLargestSensor = 4096;
constexpr double kLargestAngle_deg = 36000.0;

/// Whether `count` items of `size` bytes from `offset` on are within the segment and behind its header.
bool fits(std::span<const std::uint8_t> segment, std::size_t header, std::uint64_t offset,
          std::uint64_t count, std::uint64_t size) {
  return offset >= header && offset <= segment.size() && count * size <= segment.size() - offset;
}

[[noreturn]] void refuse(const std::string& why, const std::string& expected) {
  throw std::runtime_error(why + ", expected " + expected);
}

void checkSize(std::span<const std::uint8_t> segment, std::size_t header) {
  if (segment.size() >= header) return;
  refuse("it has " + std::to_string(segment.size()) + " bytes", std::to_string(header) + " at least");
}

/// Where a segment holds a wand.
struct WandPlaces {
  std::uint64_t buttons = 0, buttonOffset = 0, axes = 0, axisOffset = 0;

  bool fit(std::span<const std::uint8_t> segment, std::size_t header) const {
    return buttons <= TrackdWand::kMostInputs && axes <= TrackdWand::kMostInputs && buttons + axes > 0 &&
           fits(segment, header, buttonOffset, buttons, 4) && fits(segment, header, axisOffset, axes, 4);
  }
};

/// trackd's own: version, offsets of buttons and axes, their numbers, a time, a command.
WandPlaces placesOfTrackd(std::span<const std::uint8_t> segment) {
  WireReader wire(segment, std::endian::native);
  wire.skip(4);
  WandPlaces places;
  places.buttonOffset = wire.read<std::uint32_t>();
  places.axisOffset = wire.read<std::uint32_t>();
  places.buttons = wire.read<std::uint32_t>();
  places.axes = wire.read<std::uint32_t>();
  return places;
}

/// The other one: a header as of sensors, a number of wands, then the numbers of buttons and axes, 32 places
/// for buttons, and 32 for axes.
WandPlaces placesBehindASensorsHeader(std::span<const std::uint8_t> segment) {
  constexpr std::size_t kNumbers = 32, kPlaces = 32;
  WireReader wire(segment, std::endian::native);
  wire.skip(kNumbers);
  WandPlaces places;
  places.buttons = wire.read<std::uint32_t>();
  places.axes = wire.read<std::uint32_t>();
  places.buttonOffset = kNumbers + 8;
  places.axisOffset = places.buttonOffset + kPlaces * 4;
  if (places.buttons > kPlaces || places.axes > kPlaces) return {};
  return places;
}

}  // namespace

TrackdSensors readTrackdSensors(std::span<const std::uint8_t> segment) {
  checkSize(segment, kSensorsHeader);
  WireReader wire(segment, std::endian::native);
  wire.skip(4);  // the daemon's version
  TrackdSensors sensors;
  sensors.count = wire.read<std::uint32_t>();
  sensors.offset = wire.read<std::uint32_t>();
  sensors.size = wire.read<std::uint32_t>();
  sensors.seconds = wire.read<std::uint32_t>();
  sensors.microseconds = wire.read<std::uint32_t>();
  if (sensors.count > TrackdSensors::kMost) {
    refuse("it has " + std::to_string(sensors.count) + " sensors",
           std::to_string(TrackdSensors::kMost) + " at most");
  }
  if (sensors.size < TrackdSensors::kLeastSize || sensors.size > kLargestSensor) {
    refuse("its sensors have " + std::to_string(sensors.size) + " bytes", "from 40 to 4096");
  }
  if (!fits(segment, kSensorsHeader, sensors.offset, sensors.count, sensors.size)) {
    refuse(std::to_string(sensors.count) + " sensors of " + std::to_string(sensors.size) +
               " bytes from byte " + std::to_string(sensors.offset) + " on",
           "them within its " + std::to_string(segment.size()) + " bytes, from byte 28 on");
  }
  return sensors;
}

TrackdSensorBytes copyTrackdSensor(std::span<const std::uint8_t> segment, const TrackdSensors& sensors,
                                   std::size_t sensor) {
  TrackdSensorBytes bytes;
  const auto from = segment.subspan(sensors.offset + sensor * sensors.size, bytes.size());
  std::copy(from.begin(), from.end(), bytes.begin());
  return bytes;
}

std::optional<TrackdSensor> readTrackdSensor(const TrackdSensorBytes& bytes, double unit_m) {
  WireReader wire(bytes, std::endian::native);
  glm::dvec3 place, angles_deg;  // azimuth, elevation, roll
  for (int i = 0; i < 3; ++i) place[i] = static_cast<double>(wire.read<float>());
  for (int i = 0; i < 3; ++i) angles_deg[i] = static_cast<double>(wire.read<float>());
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(angles_deg[i]) <= kLargestAngle_deg)) return {};
  }
  const glm::dvec3 angles = glm::radians(angles_deg);
  const auto pose = checkedPose(place * unit_m, glm::angleAxis(angles[0], glm::dvec3(0, 1, 0)) *
                                                    glm::angleAxis(angles[1], glm::dvec3(1, 0, 0)) *
                                                    glm::angleAxis(angles[2], glm::dvec3(0, 0, 1)));
  if (!pose) return {};
  TrackdSensor sensor{*pose};
  sensor.seconds = wire.read<std::uint32_t>();
  sensor.microseconds = wire.read<std::uint32_t>();
  return sensor;
}

void readTrackdWand(std::span<const std::uint8_t> segment, TrackdWand& wand) {
  checkSize(segment, kWandHeader);
  WandPlaces places = placesOfTrackd(segment);
  if (!places.fit(segment, kWandHeader)) places = placesBehindASensorsHeader(segment);
  if (!places.fit(segment, kWandHeader)) {
    refuse("its buttons and axes are not within its " + std::to_string(segment.size()) + " bytes",
           "the layout of a wand");
  }
  WireReader buttons(segment.subspan(places.buttonOffset), std::endian::native);
  WireReader axes(segment.subspan(places.axisOffset), std::endian::native);
  wand.buttons.resize(places.buttons);
  for (std::int32_t& button : wand.buttons) button = buttons.read<std::int32_t>() != 0 ? 1 : 0;
  wand.axes.resize(places.axes);
  for (float& axis : wand.axes) {
    axis = axes.read<float>();
    axis = std::isfinite(axis) ? std::clamp(axis, -1.0f, 1.0f) : 0.0f;
  }
}

}  // namespace carom
