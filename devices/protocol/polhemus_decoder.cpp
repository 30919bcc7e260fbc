#include "devices/protocol/polhemus_decoder.h"

#include <algorithm>
#include <optional>

#include "devices/wire/checked_pose.h"
#include "devices/wire/wire_reader.h"

namespace carom {
namespace {

constexpr std::size_t kFastrakRecord = 32;
constexpr std::size_t kLibertyHeader = 8;
constexpr std::size_t kLibertyItems = 40;
constexpr double kMetresPerCentimetre = 0.01;

/// Position and orientation; false where the next bytes cannot be a pose.
bool readPose(WireReader& wire, Pose& pose) {
  double number[7];
  for (double& n : number) n = wire.read<float>();
  const glm::dvec3 position_m = kMetresPerCentimetre * glm::dvec3(number[0], number[1], number[2]);
  const glm::dquat orientation(number[3], number[4], number[5], number[6]);
  const std::optional<Pose> checked = checkedPose(position_m, orientation);
  if (checked) pose = *checked;
  return checked.has_value();
}

bool isLetter(std::uint8_t byte) { return (byte >= 'A' && byte <= 'Z') || (byte >= 'a' && byte <= 'z'); }

bool isMark(std::uint8_t first, std::uint8_t second) {
  return (first == 'L' && (second == 'Y' || second == 'U')) || (first == 'P' && second == 'A');
}

}  // namespace

void PolhemusDecoder::decode(std::span<const std::uint8_t> bytes, std::vector<Reading>& readings) {
  for (const std::uint8_t byte : bytes) {
    held_[heldSize_++] = byte;
    while (heldSize_ > 0) {
      Reading reading;
      const Match match = format_ == PolhemusFormat::fastrak ? matchFastrak(reading) : matchLiberty(reading);
      if (match == Match::soFar) break;
      if (match == Match::no) {
        passOver();
        continue;
      }
      if (format_ == PolhemusFormat::liberty) countFrames(reading);
      readings.push_back(reading);
      heldSize_ = 0;
      inStep_ = true;
    }
  }
}

PolhemusDecoder::Match PolhemusDecoder::matchFastrak(Reading& reading) const {
  const bool begins = held_[0] == '0' && (heldSize_ < 2 || (held_[1] >= '1' && held_[1] <= '4'));
  if (!begins) return Match::no;
  if (heldSize_ < kFastrakRecord) return Match::soFar;
  if (held_[kFastrakRecord - 1] != ' ') return Match::no;
  reading.sensor = held_[1] - '1';
  if (held_[2] != ' ') {
    reading.kind = Reading::Kind::lost;
    return isLetter(held_[2]) ? Match::whole : Match::no;
  }
  reading.hasOrientation = true;
  WireReader wire({&held_[3], 28}, std::endian::little);
  return readPose(wire, reading.pose) ? Match::whole : Match::no;
}

PolhemusDecoder::Match PolhemusDecoder::matchLiberty(Reading& reading) const {
  const auto came = [this](std::size_t index) { return heldSize_ > index; };
  if (held_[0] != 'L' && held_[0] != 'P') return Match::no;
  if (came(1) && !isMark(held_[0], held_[1])) return Match::no;
  if (came(2) && (held_[2] < 1 || held_[2] > kStations)) return Match::no;
  if (came(3) && held_[3] != 'C' && held_[3] != 'P') return Match::no;
  if (came(7) && (held_[6] != kLibertyItems || held_[7] != 0)) return Match::no;
  if (heldSize_ < kLibertyHeader + kLibertyItems) return Match::soFar;
  reading.sensor = held_[2] - 1;
  if (held_[4] != ' ' && held_[4] != 0) {
    reading.kind = Reading::Kind::lost;
    return Match::whole;
  }
  reading.hasOrientation = true;
  WireReader wire({&held_[16], 32}, std::endian::little);
  reading.quality = 1.0 / (1.0 + wire.read<std::uint32_t>());
  return readPose(wire, reading.pose) ? Match::whole : Match::no;
}

void PolhemusDecoder::countFrames(Reading& reading) {
  WireReader wire({&held_[kLibertyHeader], 8}, std::endian::little);
  reading.device_s = 1e-3 * static_cast<double>(clock_ms_.follow(wire.read<std::uint32_t>()));
  missed_ += frames_[static_cast<std::size_t>(reading.sensor)].follow(wire.read<std::uint32_t>());
}

void PolhemusDecoder::passOver() {
  if (inStep_) ++refused_;
  inStep_ = false;
  std::move(held_.begin() + 1, held_.begin() + static_cast<std::ptrdiff_t>(heldSize_), held_.begin());
  --heldSize_;
}

}  // namespace carom
