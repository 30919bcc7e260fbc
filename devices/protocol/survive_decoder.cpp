#include "devices/protocol/survive_decoder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "devices/wire/checked_pose.h"
#include "devices/wire/shown_name.h"

namespace carom {
namespace {

constexpr std::size_t kLongestDevice = 32;
constexpr int kButtonUp = 2, kButtonDown = 3;  // kinds of events; others are of touches and axes
constexpr int kMostSurviveButtons = 64;
constexpr double kLatest_s = 1e11;

std::string_view takeWord(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  const std::string_view word = rest.substr(0, rest.find(' '));
  rest.remove_prefix(word.size());
  return word;
}

template <class Number>
std::optional<Number> numberOf(std::string_view word) {
  Number number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc{} || end != word.data() + word.size()) return {};
  return number;
}

/// Returns the numbers of a line, if there are as many as there are places.
template <class Number, std::size_t N>
std::optional<std::array<Number, N>> numbersOf(std::string_view rest) {
  std::array<Number, N> numbers{};
  for (Number& number : numbers) {
    const auto read = numberOf<Number>(takeWord(rest));
    if (!read) return {};
    number = *read;
  }
  if (!takeWord(rest).empty()) return {};
  return numbers;
}

}  // namespace

void SurviveDecoder::decode(std::span<const std::uint8_t> bytes, std::vector<Reading>& readings) {
  std::string_view rest(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  while (!rest.empty()) {
    const std::size_t length = std::min(rest.find('\n'), rest.size());
    const bool isTooLong = line_.size() + length > kLongestLine;
    line_ += rest.substr(0, std::min(length, kLongestLine - line_.size()));
    if (isTooLong && !std::exchange(isTooLong_, true)) judgeLongLine();
    if (length < rest.size()) {
      if (!std::exchange(isTooLong_, false)) readLine(line_, readings);
      line_.clear();
    }
    rest.remove_prefix(std::min(length + 1, rest.size()));
  }
}

void SurviveDecoder::readLine(std::string_view line, std::vector<Reading>& readings) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  const auto time_s = numberOf<double>(takeWord(line));
  const std::string_view device = takeWord(line), word = takeWord(line);
  if (!time_s || !(std::abs(*time_s) <= kLatest_s) || device.size() > kLongestDevice) return;
  Reading reading;
  reading.device_s = *time_s;
  if (word == "POSE") {
    readPose(device, line, reading, readings);
  } else if (word == "BUTTON") {
    readButton(device, line, reading, readings);
  } else if (word == "DISCONNECT" && sensorOf(device) >= 0) {
    reading.kind = Reading::Kind::lost;
    reading.sensor = sensorOf(device);
    readings.push_back(reading);
  } else if (device == "INFO" && word == "LOG") {
    lastWords_ = shownName(line.substr(std::min<std::size_t>(1, line.size())));
  }
}

void SurviveDecoder::readPose(std::string_view device, std::string_view numbers, Reading reading,
                              std::vector<Reading>& readings) {
  const auto n = numbersOf<double, 7>(numbers);
  const auto pose =
      n ? checkedPose({(*n)[0], (*n)[1], (*n)[2]}, glm::dquat((*n)[3], (*n)[4], (*n)[5], (*n)[6]))
        : std::nullopt;
  if (!pose)
    return refuse("a pose of " + shownName(device) + " cannot be read: '" + shownName(numbers) + '\'');
  if (devices_.size() < kMostDevices &&
      std::find(devices_.begin(), devices_.end(), device) == devices_.end()) {
    devices_.emplace_back(device);
  }
  reading.sensor = sensorOf(device);
  if (reading.sensor < 0) return;
  reading.pose = *pose;
  reading.hasOrientation = true;
  readings.push_back(reading);
}

void SurviveDecoder::readButton(std::string_view device, std::string_view numbers, Reading reading,
                                std::vector<Reading>& readings) {
  const auto n = numbersOf<int, 2>(numbers);
  if (!n)
    return refuse("a button of " + shownName(device) + " cannot be read: '" + shownName(numbers) + '\'');
  const auto [event, button] = *n;
  reading.sensor = sensorOf(device);
  if (reading.sensor < 0 || button < 0 || button >= kMostSurviveButtons) return;
  if (event != kButtonUp && event != kButtonDown) return;
  reading.kind = Reading::Kind::button;
  reading.index = button;
  reading.value = event == kButtonDown ? 1.0 : 0.0;
  readings.push_back(reading);
}

/// Returns −1 for a device that is no sensor.
int SurviveDecoder::sensorOf(std::string_view device) const {
  const std::vector<std::string>& sensors = names_.empty() ? devices_ : names_;
  const auto found = std::find(sensors.begin(), sensors.end(), device);
  return found == sensors.end() ? -1 : static_cast<int>(found - sensors.begin());
}

void SurviveDecoder::judgeLongLine() {
  std::string_view line = line_;
  takeWord(line);
  takeWord(line);
  if (takeWord(line) == "CONFIG") return;
  refuse("a line has over " + std::to_string(kLongestLine) + " bytes: '" + shownName(line_) + '\'');
}

void SurviveDecoder::refuse(std::string why) {
  ++refused_;
  whyRefused_ = std::move(why);
}

}  // namespace carom
