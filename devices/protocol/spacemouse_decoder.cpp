#include "devices/protocol/spacemouse_decoder.h"

#include <algorithm>

#include "devices/wire/wire_reader.h"

namespace carom {
namespace {

constexpr double kFullDeflection = 350.0;  // the descriptors' logical maximum
constexpr std::size_t kMostButtonBytes = 6;
constexpr std::size_t kTriple = 6;  // bytes of three axes

Reading axis(std::size_t index, double value) {
  Reading reading;
  reading.kind = Reading::Kind::axis;
  reading.index = static_cast<std::int32_t>(index);
  reading.value = value;
  return reading;
}

}  // namespace

bool SpaceMouseDecoder::decode(std::span<const std::uint8_t> report, std::vector<Reading>& readings) {
  if (report.empty()) return false;
  const std::span<const std::uint8_t> body = report.subspan(1);
  switch (report[0]) {
    case 1:
      if (body.size() < kTriple) return false;
      setAxes(body, 0, readings);
      if (body.size() >= 2 * kTriple) setAxes(body.subspan(kTriple), 3, readings);
      return true;
    case 2:
      if (body.size() < kTriple) return false;
      setAxes(body, 3, readings);
      return true;
    case 3: {
      if (body.empty()) return false;
      std::uint64_t pressed = 0;
      for (std::size_t i = 0; i < std::min(body.size(), kMostButtonBytes); ++i) {
        pressed |= std::uint64_t{body[i]} << (8 * i);
      }
      setButtons(pressed, readings);
      return true;
    }
    default:
      return true;
  }
}

/// The device's axes are right, toward the user and down; ours are right, up and back.
void SpaceMouseDecoder::setAxes(std::span<const std::uint8_t> raw, std::size_t first,
                                std::vector<Reading>& readings) {
  WireReader wire(raw, std::endian::little);
  double device[3];
  for (double& d : device) d = std::clamp(wire.read<std::int16_t>() / kFullDeflection, -1.0, 1.0);
  const double ours[3] = {device[0], -device[2], device[1]};
  for (std::size_t i = 0; i < 3; ++i) {
    axes_[first + i] = ours[i];
    readings.push_back(axis(first + i, ours[i]));
  }
}

void SpaceMouseDecoder::setButtons(std::uint64_t pressed, std::vector<Reading>& readings) {
  const std::uint64_t changed = pressed ^ pressed_;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(8 * kMostButtonBytes); ++i) {
    if ((changed >> i & 1) == 0) continue;
    Reading button;
    button.kind = Reading::Kind::button;
    button.index = i;
    button.value = (pressed >> i & 1) != 0 ? 1.0 : 0.0;
    readings.push_back(button);
  }
  pressed_ = pressed;
}

void SpaceMouseDecoder::centre(std::vector<Reading>& readings) {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (axes_[i] != 0.0) readings.push_back(axis(i, 0.0));
    axes_[i] = 0.0;
  }
}

void SpaceMouseDecoder::release(std::vector<Reading>& readings) {
  centre(readings);
  setButtons(0, readings);
}

}  // namespace carom
