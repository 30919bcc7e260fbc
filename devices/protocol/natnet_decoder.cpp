#include "devices/protocol/natnet_decoder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>

#include "devices/wire/checked_pose.h"
#include "devices/wire/wire_reader.h"

namespace carom {
namespace {

constexpr std::uint16_t kConnect = 0, kServerInfo = 1, kFrame = 7, kKeepAlive = 10;
constexpr std::size_t kName = 256;
constexpr std::size_t kVec3 = 3 * sizeof(float);
constexpr std::size_t kBody = 38;            // id, place, quaternion, error, flags
constexpr std::size_t kLabelledMarker = 26;  // id, place, size, flags, residual
constexpr std::int16_t kTracked = 1;
constexpr std::int32_t kMostNatnetSensors = 65536;
constexpr double kLongestLatency_s = 1.0;
constexpr double kLongestSession_s = 1e9;  // thirty years

glm::dvec3 readFloats(WireReader& wire) {
  const double x = wire.read<float>(), y = wire.read<float>(), z = wire.read<float>();
  return {x, y, z};
}

/// A rigid body; none where the packet ends before it does.
std::optional<Reading> readBody(WireReader& wire) {
  Reading reading;
  reading.sensor = wire.read<std::int32_t>();
  const glm::dvec3 position_m = readFloats(wire);
  const glm::dvec3 v = readFloats(wire);
  const double w = wire.read<float>();
  wire.read<float>();  // mean error of its markers
  const bool isTracked = (wire.read<std::int16_t>() & kTracked) != 0;
  if (!wire.ok()) return {};
  const auto pose = checkedPose(position_m, glm::dquat(w, v.x, v.y, v.z));
  reading.kind = pose && isTracked ? Reading::Kind::pose : Reading::Kind::lost;
  if (pose) reading.pose = *pose;
  reading.hasOrientation = true;
  return reading;
}

/// Force plates and other devices: channels of numbers.
void skipChannels(WireReader& wire) {
  const auto devices = wire.read<std::uint32_t>();
  for (std::uint32_t i = 0; i < devices && wire.ok(); ++i) {
    wire.read<std::int32_t>();  // id
    const auto channels = wire.read<std::uint32_t>();
    for (std::uint32_t k = 0; k < channels && wire.ok(); ++k)
      wire.skip(wire.read<std::uint32_t>(), sizeof(float));
  }
}

std::vector<std::uint8_t> message(std::uint16_t id, std::uint16_t payloadSize) {
  std::vector<std::uint8_t> bytes(4 + std::size_t{payloadSize});
  bytes[0] = static_cast<std::uint8_t>(id);
  bytes[2] = static_cast<std::uint8_t>(payloadSize);
  bytes[3] = static_cast<std::uint8_t>(payloadSize >> 8);
  return bytes;
}

}  // namespace

NatnetDecoder::Packet NatnetDecoder::decode(std::span<const std::uint8_t> datagram,
                                            std::vector<Reading>& readings) {
  WireReader header(datagram, std::endian::little);
  const auto id = header.read<std::uint16_t>();
  WireReader wire(header.take(header.read<std::uint16_t>()), std::endian::little);
  if (!header.ok()) return Packet::refused;
  if (id == kServerInfo) return readServer(wire) ? Packet::server : Packet::refused;
  if (id != kFrame || !server_) return Packet::other;
  const std::size_t before = readings.size();
  if (readFrame(wire, readings)) return Packet::frame;
  readings.resize(before);
  return Packet::refused;
}

/// Name (256), its version (4), NatNet's version (4), and since NatNet 3 the frequency of its clock.
bool NatnetDecoder::readServer(WireReader& wire) {
  NatnetServer server;
  const auto name = wire.take(kName);
  wire.skip(4);
  server.major = wire.read<std::uint8_t>();
  server.minor = wire.read<std::uint8_t>();
  wire.skip(2);
  if (!wire.ok()) return false;
  for (const std::uint8_t c : name) {
    if (c == 0 || server.application.size() == 40) break;
    server.application += c >= ' ' && c <= '~' ? static_cast<char>(c) : '?';
  }
  const auto ticksPerSecond = wire.read<std::uint64_t>();
  if (wire.ok()) server.ticksPerSecond = static_cast<double>(ticksPerSecond);
  server_ = std::move(server);
  return true;
}

bool NatnetDecoder::readFrame(WireReader& wire, std::vector<Reading>& readings) {
  const std::size_t first = readings.size();
  frame_ = wire.read<std::uint32_t>();
  skipMarkers(wire);
  const auto bodies = wire.read<std::uint32_t>();
  if (hasSizes()) wire.read<std::uint32_t>();
  for (std::uint32_t i = 0; i < bodies; ++i) {
    const auto body = readBody(wire);
    if (!body) return false;
    if (body->sensor >= 0 && body->sensor < kMostNatnetSensors) readings.push_back(*body);
  }
  skipAfterBodies(wire);
  Reading times;
  if (!readTimes(wire, times)) return false;
  for (std::size_t i = first; i < readings.size(); ++i) {
    readings[i].device_s = times.device_s;
    readings[i].latency_s = times.latency_s;
  }
  return true;
}

/// Marker sets (named) and markers of none. Since NatNet 4.1 each part says its size.
void NatnetDecoder::skipMarkers(WireReader& wire) const {
  if (hasSizes()) {
    for (int part = 0; part < 2; ++part) {
      wire.read<std::uint32_t>();
      wire.skip(wire.read<std::uint32_t>());
    }
    return;
  }
  const auto sets = wire.read<std::uint32_t>();
  for (std::uint32_t i = 0; i < sets && wire.ok(); ++i) {
    wire.text();
    wire.skip(wire.read<std::uint32_t>(), kVec3);
  }
  wire.skip(wire.read<std::uint32_t>(), kVec3);
}

/// Skeletons, labelled markers, force plates and devices; since NatNet 4.1 assets behind the skeletons, and
/// sizes.
void NatnetDecoder::skipAfterBodies(WireReader& wire) const {
  if (hasSizes()) {
    for (int part = 0; part < 5; ++part) {
      wire.read<std::uint32_t>();
      wire.skip(wire.read<std::uint32_t>());
    }
    return;
  }
  const auto skeletons = wire.read<std::uint32_t>();
  for (std::uint32_t i = 0; i < skeletons && wire.ok(); ++i) {
    wire.read<std::int32_t>();  // id
    wire.skip(wire.read<std::uint32_t>(), kBody);
  }
  wire.skip(wire.read<std::uint32_t>(), kLabelledMarker);
  skipChannels(wire);
  skipChannels(wire);
}

/// Time code (2 × u32), time since the start (f64), then ticks of the server's clock at the middle of the
/// exposure, when the cameras' data had come, and when this was sent. Ticks that it cannot measure are zero.
bool NatnetDecoder::readTimes(WireReader& wire, Reading& times) const {
  wire.skip(2, sizeof(std::uint32_t));
  const double sinceStart_s = wire.read<double>();
  const auto exposed = wire.read<std::uint64_t>();
  const auto received = wire.read<std::uint64_t>();
  const auto sent = wire.read<std::uint64_t>();
  if (!wire.ok() || !(std::abs(sinceStart_s) <= kLongestSession_s)) return false;
  times.device_s = sinceStart_s;
  if (sent == 0 || !(server_->ticksPerSecond >= 1.0)) return true;
  times.device_s = static_cast<double>(sent) / server_->ticksPerSecond;
  const std::uint64_t held = exposed != 0 ? exposed : received;
  if (held == 0 || held > sent) return true;
  const double latency_s = static_cast<double>(sent - held) / server_->ticksPerSecond;
  if (latency_s <= kLongestLatency_s) times.latency_s = latency_s;
  return true;
}

std::vector<std::uint8_t> natnetConnect() {
  constexpr std::string_view kGreeting = "Ping";
  std::vector<std::uint8_t> bytes =
      message(kConnect, 270);  // a name, and versions: zero, as the server likes
  std::copy(kGreeting.begin(), kGreeting.end(), bytes.begin() + 4);
  return bytes;
}

std::vector<std::uint8_t> natnetKeepAlive() { return message(kKeepAlive, 0); }

}  // namespace carom
