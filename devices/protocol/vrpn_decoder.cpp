#include "devices/protocol/vrpn_decoder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "devices/wire/checked_pose.h"
#include "devices/wire/shown_name.h"
#include "devices/wire/wire_reader.h"

namespace carom {
namespace {

constexpr std::size_t kCookie = 24;
constexpr std::size_t kVrpnHeader = 24;
constexpr std::size_t kMostRecord = 65536;  // VRPN's own buffers hold 64000
constexpr std::string_view kMagic = "vrpn: ver. 07.";
constexpr std::string_view kOurCookie = "vrpn: ver. 07.38  0";
constexpr std::size_t kLongestVrpnName = 100;          // VRPN's own limit
constexpr std::string_view kControl = "VRPN Control";  // the connection itself, no device
constexpr std::int32_t kSenderDescription = -1;
constexpr std::int32_t kTypeDescription = -2;
constexpr int kMostVrpnSensors = 65536;
constexpr int kMostButtons = 256;
constexpr int kMostChannels = 128;

constexpr std::size_t padded(std::size_t length) { return (length + 7) / 8 * 8; }

glm::dvec3 readDoubles(WireReader& wire) {
  const double x = wire.read<double>(), y = wire.read<double>(), z = wire.read<double>();
  return {x, y, z};
}

glm::dquat readQuat(WireReader& wire) {
  const glm::dvec3 v = readDoubles(wire);
  return {wire.read<double>(), v.x, v.y, v.z};
}

/// A constant rate of turning that turns by `turn` in `interval_s`.
glm::dvec3 rateOf(const glm::dquat& turn, double interval_s) {
  const glm::dquat shorter = turn.w < 0.0 ? -turn : turn;
  const glm::dvec3 axis(shorter.x, shorter.y, shorter.z);
  const double sine = glm::length(axis);
  if (!(sine > 0.0)) return glm::dvec3(0.0);
  return axis / sine * (2.0 * std::atan2(sine, shorter.w) / interval_s);
}

bool takePose(WireReader& wire, Reading& reading) {
  reading.sensor = wire.read<std::int32_t>();
  wire.read<std::int32_t>();  // padding
  const glm::dvec3 position_m = readDoubles(wire);
  const auto pose = checkedPose(position_m, readQuat(wire));
  if (!wire.ok() || !pose || reading.sensor < 0 || reading.sensor >= kMostVrpnSensors) return false;
  reading.kind = Reading::Kind::pose;
  reading.pose = *pose;
  reading.hasOrientation = true;
  return true;
}

bool takeVelocity(WireReader& wire, Reading& reading) {
  constexpr double kFastest_m_s = 1e4;
  reading.sensor = wire.read<std::int32_t>();
  wire.read<std::int32_t>();
  reading.velocity_m_s = readDoubles(wire);
  const auto turn = checkedPose(glm::dvec3(0.0), readQuat(wire));
  const double interval_s = wire.read<double>();
  if (!wire.ok() || reading.sensor < 0 || reading.sensor >= kMostVrpnSensors) return false;
  if (!turn || !(glm::length(reading.velocity_m_s) <= kFastest_m_s)) return false;
  if (!(interval_s >= 1e-6 && interval_s <= 1e6)) return false;
  reading.kind = Reading::Kind::velocity;
  reading.angularVelocity_rad_s = rateOf(turn->orientation, interval_s);
  return true;
}

bool takeButton(WireReader& wire, std::int32_t index, Reading& reading) {
  const bool isPressed = wire.read<std::int32_t>() != 0;
  if (!wire.ok() || index < 0 || index >= kMostButtons) return false;
  reading.kind = Reading::Kind::button;
  reading.index = index;
  reading.value = isPressed ? 1.0 : 0.0;
  return true;
}

bool takeButtons(WireReader& wire, Reading reading, std::vector<Reading>& readings) {
  const auto count = wire.read<std::int32_t>();
  if (count < 0 || count > kMostButtons) return false;
  for (std::int32_t i = 0; i < count; ++i) {
    if (!takeButton(wire, i, reading)) return false;
    readings.push_back(reading);
  }
  return true;
}

bool takeChannels(WireReader& wire, Reading reading, std::vector<Reading>& readings) {
  const double count = wire.read<double>();
  if (!(count >= 0.0 && count <= kMostChannels)) return false;
  reading.kind = Reading::Kind::axis;
  for (reading.index = 0; reading.index < count; ++reading.index) {
    const double value = wire.read<double>();
    if (!wire.ok()) return false;
    if (!std::isfinite(value)) continue;
    reading.value = std::clamp(value, -1.0, 1.0);
    readings.push_back(reading);
  }
  return true;
}

void appendVrpn(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

/// Appends a record of our own. Its time stays zero: servers do not read it.
void appendRecord(std::vector<std::uint8_t>& bytes, std::int32_t sender, std::int32_t type,
                  std::span<const std::uint8_t> payload) {
  appendVrpn(bytes, static_cast<std::uint32_t>(kVrpnHeader + payload.size()));
  appendVrpn(bytes, 0);
  appendVrpn(bytes, 0);
  appendVrpn(bytes, static_cast<std::uint32_t>(sender));
  appendVrpn(bytes, static_cast<std::uint32_t>(type));
  appendVrpn(bytes, 0);
  for (const std::uint8_t byte : payload) bytes.push_back(byte);
  bytes.resize(padded(bytes.size()));
}

void appendName(std::vector<std::uint8_t>& bytes, std::int32_t id, std::int32_t what, std::string_view name) {
  std::vector<std::uint8_t> payload;
  appendVrpn(payload, static_cast<std::uint32_t>(name.size() + 1));
  for (const char c : name) payload.push_back(static_cast<std::uint8_t>(c));
  payload.push_back(0);
  appendRecord(bytes, id, what, payload);
}

constexpr std::int32_t kOurSender = 0, kOurPing = 0, kOurPong = 1, kOurForceField = 2;

}  // namespace

struct VrpnDecoder::Header {
  double time_s = 0.0;
  std::int32_t sender = 0;
  std::int32_t type = 0;
};

void VrpnDecoder::decode(std::span<const std::uint8_t> bytes, std::vector<Reading>& readings) {
  if (bytes.size() > kMostBytes) throw std::invalid_argument("VrpnDecoder: more than 8 KiB at a time");
  held_.insert(held_.end(), bytes.begin(), bytes.end());
  while (takeRecord(readings)) {
  }
  held_.erase(held_.begin(), held_.begin() + static_cast<std::ptrdiff_t>(std::exchange(used_, 0)));
}

/// Takes one record from the buffer; returns false if it is not complete yet.
bool VrpnDecoder::takeRecord(std::vector<Reading>& readings) {
  const auto held = std::span<const std::uint8_t>(held_).subspan(used_);
  if (!greeted_) {
    if (held.size() < kCookie) return false;
    greet({reinterpret_cast<const char*>(held.data()), kCookie});
    used_ += kCookie;
    return true;
  }
  if (held.size() < kVrpnHeader) return false;
  WireReader wire(held, std::endian::big);
  const std::size_t length = wire.read<std::uint32_t>();
  if (length < kVrpnHeader || length > kMostRecord) {
    throw std::runtime_error("it sent a record of " + std::to_string(length) +
                             " bytes, expected 24 to 65536: this is no VRPN, or bytes were lost");
  }
  if (held.size() < padded(length)) return false;
  spoke_ = true;
  Header header;
  header.time_s = wire.read<std::uint32_t>();
  header.time_s += wire.read<std::uint32_t>() * 1e-6;
  header.sender = wire.read<std::int32_t>();
  header.type = wire.read<std::int32_t>();
  if (!understand(header, held.subspan(kVrpnHeader, length - kVrpnHeader), readings)) ++refused_;
  used_ += padded(length);
  return true;
}

/// Versions that agree up to their last point understand each other.
void VrpnDecoder::greet(std::string_view cookie) {
  if (!cookie.starts_with(kMagic)) {
    throw std::runtime_error("it begins with '" + shownName(cookie) + "', expected '" + std::string(kMagic) +
                             "…' of a VRPN server");
  }
  greeted_ = true;
}

VrpnDecoder::Type VrpnDecoder::typeOf(std::string_view name) {
  if (name == "vrpn_Tracker Pos_Quat") return Type::pose;
  if (name == "vrpn_Tracker Velocity") return Type::velocity;
  if (name == "vrpn_Button Change") return Type::buttonChange;
  if (name == "vrpn_Button States") return Type::buttonStates;
  if (name == "vrpn_Analog Channel") return Type::analog;
  if (name == "vrpn_Base ping_message") return Type::ping;
  return Type::unknown;
}

/// The server gives a name to an id, which stands in the place of the sender.
void VrpnDecoder::describe(const Header& header, std::span<const std::uint8_t> payload) {
  WireReader wire(payload, std::endian::big);
  wire.read<std::int32_t>();  // its length; the zero behind the name says the same
  const std::string_view name = wire.text();
  const auto id = static_cast<std::size_t>(header.sender);
  if (!wire.ok() || header.sender < 0 || id >= kMostIds) {
    ++refused_;
  } else if (header.type == kTypeDescription) {
    types_[id] = typeOf(name);
  } else {
    senders_[id] = name == sender_;
    if (!namesCount_) return;
    if (senders_[id]) senderNamed_ = true;
    if (name == kControl || named_.size() == kMostNamed) return;
    named_.push_back({header.sender, std::string(name.substr(0, kLongestVrpnName))});
  }
}

/// False where a record of a kind that we know makes no sense.
bool VrpnDecoder::understand(const Header& header, std::span<const std::uint8_t> payload,
                             std::vector<Reading>& readings) {
  if (header.type == kSenderDescription || header.type == kTypeDescription) {
    describe(header, payload);
    return true;
  }
  const auto isId = [](std::int32_t id) { return id >= 0 && static_cast<std::size_t>(id) < kMostIds; };
  if (!isId(header.type) || !isId(header.sender)) return true;  // logs and the like
  for (NamedSender& named : named_) named.heard = named.heard || named.id == header.sender;
  if (!senders_[static_cast<std::size_t>(header.sender)]) return true;
  senderHeard_ = true;
  WireReader wire(payload, std::endian::big);
  Reading reading;
  reading.device_s = header.time_s;
  bool understood = true;
  switch (types_[static_cast<std::size_t>(header.type)]) {
    case Type::unknown:
      return true;
    case Type::ping:
      ++pings_;
      return true;
    case Type::buttonStates:
      return takeButtons(wire, reading, readings);
    case Type::analog:
      return takeChannels(wire, reading, readings);
    case Type::pose:
      understood = takePose(wire, reading);
      break;
    case Type::velocity:
      understood = takeVelocity(wire, reading);
      break;
    case Type::buttonChange:
      understood = takeButton(wire, wire.read<std::int32_t>(), reading);
      break;
  }
  if (understood) readings.push_back(reading);
  return understood;
}

std::vector<std::uint8_t> vrpnGreeting() {
  std::vector<std::uint8_t> bytes(kCookie);
  std::copy(kOurCookie.begin(), kOurCookie.end(), bytes.begin());
  return bytes;
}

std::vector<std::uint8_t> vrpnDescription(std::string_view sender) {
  std::vector<std::uint8_t> bytes;
  appendName(bytes, kOurSender, kSenderDescription, sender);
  appendName(bytes, kOurPing, kTypeDescription, "vrpn_Base ping_message");
  appendName(bytes, kOurPong, kTypeDescription, "vrpn_Base pong_message");
  return bytes;
}

std::vector<std::uint8_t> vrpnPing() {
  std::vector<std::uint8_t> bytes;
  appendRecord(bytes, kOurSender, kOurPing, {});
  return bytes;
}

std::vector<std::uint8_t> vrpnPings(std::span<const VrpnDecoder::NamedSender> senders) {
  std::vector<std::uint8_t> bytes;
  std::int32_t id = kOurSender;
  for (const VrpnDecoder::NamedSender& sender : senders) {
    appendName(bytes, ++id, kSenderDescription, sender.name);
    appendRecord(bytes, id, kOurPing, {});
  }
  return bytes;
}

std::vector<std::uint8_t> vrpnPong() {
  std::vector<std::uint8_t> bytes;
  appendRecord(bytes, kOurSender, kOurPong, {});
  return bytes;
}

std::vector<std::uint8_t> vrpnForceDescription() {
  std::vector<std::uint8_t> bytes;
  appendName(bytes, kOurForceField, kTypeDescription, "vrpn_ForceDevice Force_Field");
  return bytes;
}

std::vector<std::uint8_t> vrpnForceField(const VrpnForceField& field) {
  std::vector<std::uint8_t> payload, bytes;
  const auto put = [&payload](double value) {
    appendVrpn(payload, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  };
  for (int i = 0; i < 3; ++i) put(field.origin_m[i]);
  for (int i = 0; i < 3; ++i) put(field.force_n[i]);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) put(field.jacobian_n_m[column][row]);
  }
  put(field.radius_m);
  appendRecord(bytes, kOurSender, kOurForceField, payload);
  return bytes;
}

}  // namespace carom
