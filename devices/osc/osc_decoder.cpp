#include "devices/osc/osc_decoder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "devices/wire/checked_pose.h"
#include "devices/wire/wire_reader.h"

namespace carom {
namespace {

constexpr int kDeepest = 8;  // of bundles in bundles; senders use one
constexpr std::size_t kMostArguments = 64;
constexpr std::size_t kMostShown = 64;  // characters of an address
constexpr std::string_view kBundle = "#bundle";
constexpr std::uint64_t kAtOnce = 1;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Reads a text and the zeros that fill it to a multiple of four bytes.
std::string_view takeText(WireReader& wire) {
  const std::string_view text = wire.text();
  const std::size_t size = text.size() + 1;
  if (wire.ok()) wire.skip((4 - size % 4) % 4);
  return text;
}

/// A time tag: 32 bits of seconds since 1900 and 32 of a fraction, as in NTP.
double timeOf(std::uint64_t tag) {
  if (tag <= kAtOnce) return kNone;
  return static_cast<double>(tag >> 32U) + std::ldexp(static_cast<double>(tag & 0xffffffffU), -32);
}

/// Reads the argument of a type. NaN if it is no number; `known` says whether there is such a type.
double takeArgument(WireReader& wire, char type, bool& known) {
  known = true;
  switch (type) {
    case 'i':
      return wire.read<std::int32_t>();
    case 'f':
      return static_cast<double>(wire.read<float>());
    case 'd':
      return wire.read<double>();
    case 'h':
      return static_cast<double>(wire.read<std::int64_t>());
    case 'T':
      return 1.0;
    case 'F':
      return 0.0;
    case 's':
    case 'S':
      takeText(wire);
      return kNone;
    case 'b': {
      const std::size_t size = wire.read<std::uint32_t>();
      wire.skip(size);
      wire.skip((4 - size % 4) % 4);
      return kNone;
    }
    case 't':
      wire.skip(8);
      return kNone;
    case 'c':
    case 'r':
    case 'm':
      wire.skip(4);
      return kNone;
    case 'N':
    case 'I':
      return kNone;
    default:
      known = false;
      return kNone;
  }
}

std::string shown(std::string_view address) {
  std::string text(address.substr(0, kMostShown));
  for (char& c : text) c = c >= ' ' && c <= '~' ? c : '?';
  return '\'' + text + (address.size() > kMostShown ? "…'" : "'");
}

}  // namespace

bool OscDecoder::decode(std::span<const std::uint8_t> datagram, std::vector<Reading>& readings) {
  return readElement(datagram, kNone, 0, readings);
}

bool OscDecoder::readElement(std::span<const std::uint8_t> element, double device_s, int depth,
                             std::vector<Reading>& readings) {
  WireReader wire(element, std::endian::big);
  if (!element.empty() && element.front() == '#') return readBundle(wire, depth, readings);
  return readMessage(wire, device_s, readings);
}

bool OscDecoder::readBundle(WireReader& wire, int depth, std::vector<Reading>& readings) {
  if (takeText(wire) != kBundle) return refuse({}, "a datagram begins with '#' and is no bundle of OSC");
  if (depth == kDeepest) return refuse({}, "bundles are in one another more than 8 deep");
  const double device_s = timeOf(wire.read<std::uint64_t>());
  bool isRead = true;
  while (wire.ok() && !wire.rest().empty()) {
    const auto element = wire.take(wire.read<std::uint32_t>());
    if (!element.empty()) isRead = readElement(element, device_s, depth + 1, readings) && isRead;
  }
  return wire.ok() ? isRead : refuse({}, "a bundle of OSC ends before its last part");
}

bool OscDecoder::readMessage(WireReader& wire, double device_s, std::vector<Reading>& readings) {
  const std::string_view address = takeText(wire);
  if (!wire.ok() || !address.starts_with('/')) {
    return refuse({}, "a datagram is no message of OSC, expected an address such as '/head/0'");
  }
  const bool isPose = mapping_.pose && mapping_.pose->match(address);
  const bool isInput = (mapping_.buttons && mapping_.buttons->match(address)) ||
                       (mapping_.axes && mapping_.axes->match(address));
  if (!isPose && !isInput) {
    noteOther(address);
    return true;
  }
  const std::string_view types = takeText(wire);
  if (!wire.ok() || !types.starts_with(','))
    return refuse(address, "came without the types of its arguments");
  if (!takeArguments(wire, types.substr(1)))
    return refuse(address, "came with arguments that cannot be read");
  Reading reading;
  reading.device_s = device_s;
  return isPose ? addPose(address, reading, readings) : addInput(address, reading, readings);
}

bool OscDecoder::takeArguments(WireReader& wire, std::string_view types) {
  arguments_.clear();
  if (types.size() > kMostArguments) return false;
  for (const char type : types) {
    bool known = false;
    arguments_.push_back(takeArgument(wire, type, known));
    if (!known) return false;
  }
  return wire.ok();
}

bool OscDecoder::addPose(std::string_view address, Reading reading, std::vector<Reading>& readings) {
  if (arguments_.size() != mapping_.values.size()) {
    return refuse(address, "came with " + std::to_string(arguments_.size()) + " arguments, expected " +
                               std::to_string(mapping_.values.size()) + ", those that 'values' names");
  }
  std::array<double, 8> parts{0, 0, 0, 0, 0, 0, 1, 0};
  for (std::size_t i = 0; i < arguments_.size(); ++i) {
    const OscValue value = mapping_.values[i];
    parts.at(static_cast<std::size_t>(value)) = arguments_[i];
    if (value == OscValue::qw) reading.hasOrientation = true;
  }
  const auto pose = checkedPose(glm::dvec3(parts[0], parts[1], parts[2]) * mapping_.unit_m,
                                glm::dquat(parts[6], parts[3], parts[4], parts[5]));
  if (!pose) return refuse(address, "came with numbers that are no pose");
  reading.pose = *pose;
  reading.sensor = mapping_.pose->match(address)->sensor;
  readings.push_back(reading);
  return true;
}

bool OscDecoder::addInput(std::string_view address, Reading reading, std::vector<Reading>& readings) {
  if (arguments_.empty() || !std::isfinite(arguments_.front())) {
    return refuse(address, "came without a number, expected one");
  }
  const auto button = mapping_.buttons ? mapping_.buttons->match(address) : std::nullopt;
  const auto numbers = button ? button : mapping_.axes->match(address);
  constexpr double kPressed = 0.5;
  reading.kind = button ? Reading::Kind::button : Reading::Kind::axis;
  reading.sensor = numbers->sensor;
  reading.index = numbers->index;
  reading.value =
      button ? (arguments_.front() >= kPressed ? 1.0 : 0.0) : std::clamp(arguments_.front(), -1.0, 1.0);
  readings.push_back(reading);
  return true;
}

void OscDecoder::noteOther(std::string_view address) {
  if (others_.size() == kMostOthers) return;
  const std::string text = shown(address);
  if (std::find(others_.begin(), others_.end(), text) == others_.end()) others_.push_back(text);
}

bool OscDecoder::refuse(std::string_view address, const std::string& why) {
  whyRefused_ = address.empty() ? why : shown(address) + ' ' + why;
  return false;
}

}  // namespace carom
