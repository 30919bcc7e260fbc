#include "devices/protocol/dtrack_decoder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include "devices/wire/checked_pose.h"

namespace carom {
namespace {

constexpr int kMostIds = 100;
constexpr int kFlysticks = 100;  // sensors from here on
constexpr int kHybrids = 200;
constexpr double kDay_s = 86400.0;
constexpr double kLongestDtrackLatency_s = 1.0;
constexpr std::size_t kMostInputs = 64;  // buttons, and axes, of a Flystick; there are none with more than 16
constexpr std::size_t kButtonsPerNumber = 32;

/// Returns whether a digit, a comma and a digit follow each other. DTRACK separates numbers by spaces alone.
bool hasDecimalComma(std::string_view line) {
  const auto isDigit = [&](std::size_t i) { return i < line.size() && line[i] >= '0' && line[i] <= '9'; };
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == ',' && isDigit(i - 1) && isDigit(i + 1)) return true;
  }
  return false;
}

/// Returns in words why a line cannot be read.
std::string faultOf(std::string_view line) {
  std::string shown(line.substr(0, 40));
  for (char& c : shown) c = c >= ' ' && c <= '~' ? c : '?';
  const std::string beginning =
      "a line of its datagrams cannot be read, '" + shown + (line.size() > 40 ? "…'" : "'");
  if (!hasDecimalComma(line)) return beginning + ", expected one as in DTRACK's manual";
  return beginning +
         ": its numbers have decimal commas, expected points: correct the sender's language settings";
}

}  // namespace

/// The rest of a line. Numbers are read the same in every locale.
class DtrackDecoder::Line {
 public:
  explicit Line(std::string_view text) : rest_(text) {}

  std::string_view word() {
    skipSpaces();
    const std::size_t length = std::min(rest_.find_first_of(" \t["), rest_.size());
    const std::string_view word = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return word;
  }

  template <class T>
  std::optional<T> number() {
    skipSpaces();
    T value{};
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc{}) return {};
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  /// Reads a bracketed list of finite numbers; those beyond `numbers` are passed over. Returns the number
  /// kept; none where there is no such list.
  std::optional<std::size_t> block(std::span<double> numbers) {
    if (!take('[')) return {};
    std::size_t count = 0;
    while (!take(']')) {
      const auto value = number<double>();
      if (!value || !std::isfinite(*value)) return {};
      if (count < numbers.size()) numbers[count++] = *value;
    }
    return count;
  }

  /// The same where all of `numbers` must be there.
  bool wholeBlock(std::span<double> numbers) { return block(numbers) == numbers.size(); }

  /// A list [id …] whose first number is below 100.
  template <std::size_t N>
  bool head(std::array<double, N>& numbers) {
    return wholeBlock(numbers) && numbers[0] >= 0.0 && numbers[0] < kMostIds &&
           numbers[0] == std::floor(numbers[0]);
  }

  /// The lists [x y z][r0 … r8]; false where they cannot be read. Fills nothing where they are no pose.
  bool pose(std::optional<Pose>& pose) {
    std::array<double, 3> place_mm{};
    std::array<double, 9> rotation{};
    if (!wholeBlock(place_mm) || !wholeBlock(rotation)) return false;
    if (const auto orientation = checkedRotation(rotation)) {
      pose =
          checkedPose(glm::dvec3(place_mm[0], place_mm[1], place_mm[2]) * kMetresPerMillimetre, *orientation);
    }
    return true;
  }

 private:
  void skipSpaces() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size())); }
  bool take(char wanted) {
    skipSpaces();
    if (rest_.empty() || rest_.front() != wanted) return false;
    rest_.remove_prefix(1);
    return true;
  }

  std::string_view rest_;
};

namespace {

Reading poseReading(int sensor, const std::optional<Pose>& pose, double quality) {
  Reading reading;
  reading.sensor = sensor;
  reading.kind = pose && quality >= 0.0 ? Reading::Kind::pose : Reading::Kind::lost;
  if (pose) reading.pose = *pose;
  reading.hasOrientation = true;
  reading.quality = std::clamp(quality, 0.0, 1.0);
  return reading;
}

Reading inputReading(Reading::Kind kind, int sensor, std::size_t index, double value) {
  Reading reading;
  reading.kind = kind;
  reading.sensor = sensor;
  reading.index = static_cast<std::int32_t>(index);
  reading.value = std::clamp(value, -1.0, 1.0);
  return reading;
}

/// 32 buttons to a number, the first in the lowest bit; DTRACK writes it signed or unsigned.
bool isPressed(std::span<const double> numbers, std::size_t button) {
  const auto bits =
      static_cast<std::uint64_t>(static_cast<std::int64_t>(numbers[button / kButtonsPerNumber]));
  return (bits >> (button % kButtonsPerNumber) & 1) != 0;
}

}  // namespace

bool DtrackDecoder::decode(std::span<const std::uint8_t> datagram, std::vector<Reading>& readings) {
  std::string_view text(reinterpret_cast<const char*>(datagram.data()), datagram.size());
  text = text.substr(0, text.find('\0'));
  frame_.reset();
  sent_s_.reset();
  latency_s_ = 0.0;
  hasTime2_ = false;
  adjusted_.reset();
  others_ = 0;
  seen_.reset();
  const std::size_t first = readings.size();
  while (!text.empty()) {
    const std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, length);
    if (length > 0 && !readLine(line, readings)) {
      ++refused_;
      whyRefused_ = faultOf(line);
    }
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  appendLost(readings);
  for (std::size_t i = first; i < readings.size(); ++i) {
    if (sent_s_) readings[i].device_s = *sent_s_;
    readings[i].latency_s = latency_s_;
  }
  return frame_ || sent_s_ || readings.size() > first;
}

void DtrackDecoder::appendLost(std::vector<Reading>& readings) const {
  if (!adjusted_ || *adjusted_ < others_) return;
  const unsigned bodies = std::min<unsigned>(*adjusted_ - others_, kMostIds);
  for (unsigned id = 0; id < bodies; ++id) {
    if (!seen_[id]) readings.push_back(poseReading(static_cast<int>(id), {}, -1.0));
  }
}

bool DtrackDecoder::readLine(std::string_view text, std::vector<Reading>& readings) {
  Line line(text);
  const std::string_view name = line.word();
  const std::size_t before = readings.size();
  bool read = true;
  if (name == "fr") {
    frame_ = line.number<std::uint32_t>();
    return frame_.has_value();
  }
  if (name == "ts") return readTime(line);
  if (name == "ts2") return readTime2(line);
  if (name == "6d") read = readBodies(line, readings);
  if (name == "6df") read = readOldFlysticks(line, readings);
  if (name == "6df2") read = readFlysticks(line, readings);
  if (name == "6dcal") read = (adjusted_ = line.number<unsigned>()).has_value();
  if (name == "6dmt" || name == "6dmt2") read = countOthers(line);  // tools
  if (name == "6di") read = readHybrids(line, readings);
  if (!read) readings.resize(before);
  return read;
}

bool DtrackDecoder::countOthers(Line& line) {
  const auto count = line.number<unsigned>();
  if (count && *count <= kMostIds) others_ += *count;
  return count.has_value();
}

/// `ts s`: seconds since midnight.
bool DtrackDecoder::readTime(Line& line) {
  const auto ofDay_s = line.number<double>();
  if (!ofDay_s || !(*ofDay_s >= 0.0 && *ofDay_s <= 2.0 * kDay_s)) return false;
  if (*ofDay_s < lastOfDay_s_ - kDay_s / 2) days_s_ += kDay_s;
  lastOfDay_s_ = *ofDay_s;
  if (!hasTime2_) sent_s_ = days_s_ + *ofDay_s;
  return true;
}

/// `ts2 s us latency_us`: when the cameras looked, and how long it took from there to the sending.
bool DtrackDecoder::readTime2(Line& line) {
  const auto whole_s = line.number<std::int64_t>(), part_us = line.number<std::int64_t>(),
             latency_us = line.number<std::int64_t>();
  if (!whole_s || !part_us || !latency_us) return false;
  constexpr std::int64_t kMost_s = 1'000'000'000'000, kMost_us = 1'000'000;
  if (*whole_s < 0 || *whole_s > kMost_s || *part_us < 0 || *part_us > kMost_us) return false;
  const double latency_s = static_cast<double>(*latency_us) * 1e-6;
  if (!(latency_s >= 0.0 && latency_s <= kLongestDtrackLatency_s)) return false;
  latency_s_ = latency_s;
  sent_s_ = static_cast<double>(*whole_s) + static_cast<double>(*part_us) * 1e-6 + latency_s;
  hasTime2_ = true;
  return true;
}

/// `6d n [id q][x y z][r0 … r8] …`: the bodies that are seen.
bool DtrackDecoder::readBodies(Line& line, std::vector<Reading>& readings) {
  const auto count = line.number<unsigned>();
  if (!count || *count > kMostIds) return false;
  for (unsigned i = 0; i < *count; ++i) {
    std::array<double, 2> head{};
    std::optional<Pose> pose;
    if (!line.head(head) || !line.pose(pose)) return false;
    readings.push_back(poseReading(static_cast<int>(head[0]), pose, head[1]));
    seen_.set(static_cast<std::size_t>(head[0]));
  }
  return true;
}

/// `6df n [id q bt][x y z][r0 … r8] …`: a stick of buttons and a hat, all bits of one number.
bool DtrackDecoder::readOldFlysticks(Line& line, std::vector<Reading>& readings) {
  const auto count = line.number<unsigned>();
  if (!count || *count > kMostIds) return false;
  others_ += *count;
  for (unsigned i = 0; i < *count; ++i) {
    std::array<double, 3> head{};
    std::optional<Pose> pose;
    if (!line.head(head) || !line.pose(pose) || !(head[2] >= 0.0 && head[2] <= 255.0)) return false;
    const int sensor = kFlysticks + static_cast<int>(head[0]);
    readings.push_back(poseReading(sensor, pose, head[1]));
    const auto bits = static_cast<unsigned>(head[2]);
    for (std::size_t button = 0; button < 4; ++button) {
      readings.push_back(inputReading(Reading::Kind::button, sensor, button, bits >> button & 1));
    }
    const auto hat = [&](unsigned minus, unsigned plus) {
      return (bits & plus ? 1.0 : 0.0) - (bits & minus ? 1.0 : 0.0);
    };
    readings.push_back(inputReading(Reading::Kind::axis, sensor, 0, hat(0x20, 0x80)));
    readings.push_back(inputReading(Reading::Kind::axis, sensor, 1, hat(0x10, 0x40)));
  }
  return true;
}

/// `6df2 known n [id q nbt njs][x y z][r0 … r8][bt … js …] …`: 32 buttons to a number, then the axes. A stick
/// that is not seen has a quality of −1, and its buttons.
bool DtrackDecoder::readFlysticks(Line& line, std::vector<Reading>& readings) {
  const auto known = line.number<unsigned>(), count = line.number<unsigned>();
  if (!known || !count || *known > kMostIds || *count > kMostIds) return false;
  others_ += *known;
  for (unsigned i = 0; i < *count; ++i) {
    std::array<double, 4> head{};
    std::optional<Pose> pose;
    std::array<double, kMostInputs / kButtonsPerNumber + kMostInputs> inputs{};
    if (!line.head(head) || !line.pose(pose)) return false;
    const auto given = line.block(inputs);
    if (!given || !(head[2] >= 0.0 && head[2] <= kMostInputs && head[3] >= 0.0 && head[3] <= kMostInputs)) {
      return false;
    }
    const auto buttons = static_cast<std::size_t>(head[2]), axes = static_cast<std::size_t>(head[3]);
    const std::size_t firstAxis = (buttons + kButtonsPerNumber - 1) / kButtonsPerNumber;
    if (*given < firstAxis + axes) return false;
    for (std::size_t k = 0; k < firstAxis; ++k) {
      if (!(std::abs(inputs[k]) < 4294967296.0)) return false;
    }
    const int sensor = kFlysticks + static_cast<int>(head[0]);
    readings.push_back(poseReading(sensor, pose, head[1]));
    for (std::size_t button = 0; button < buttons; ++button) {
      readings.push_back(inputReading(Reading::Kind::button, sensor, button, isPressed(inputs, button)));
    }
    for (std::size_t axis = 0; axis < axes; ++axis) {
      readings.push_back(inputReading(Reading::Kind::axis, sensor, axis, inputs[firstAxis + axis]));
    }
  }
  return true;
}

/// `6di n [id state drift_deg][x y z][r0 … r8] …`: bodies with an inertial sensor; of state 0 nothing is
/// known. A `6dcal` counts them, too.
bool DtrackDecoder::readHybrids(Line& line, std::vector<Reading>& readings) {
  const auto count = line.number<unsigned>();
  if (!count || *count > kMostIds) return false;
  others_ += *count;
  for (unsigned i = 0; i < *count; ++i) {
    std::array<double, 3> head{};
    std::optional<Pose> pose;
    if (!line.head(head) || !line.pose(pose)) return false;
    Reading reading = poseReading(kHybrids + static_cast<int>(head[0]), pose, head[1] > 0.0 ? 1.0 : -1.0);
    reading.quality = std::numeric_limits<double>::quiet_NaN();
    readings.push_back(reading);
  }
  return true;
}

}  // namespace carom
