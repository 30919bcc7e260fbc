#pragma once
// Decodes the lines that libsurvive's survive-cli writes with --record-stdout: time, device, word and
// numbers, such as "12.345678 T20 POSE x y z qw qx qy qz" (metres, z up) or "12.345678 WM0 BUTTON 3 0".
// Trackers are called T20, T21, …, wands WM0, WM1.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "devices/tracker/reading.h"

namespace carom {

class SurviveDecoder {
 public:
  /// The device names[i] is sensor i; without names, the devices in the order in which they come.
  explicit SurviveDecoder(std::vector<std::string> names) : names_(std::move(names)) {}

  /// Takes bytes as they come and appends the readings of complete lines. Lines with other words are passed
  /// by, those that are too long, or are poses or buttons and cannot be read, are passed by and counted.
  /// Device times are seconds since the program started.
  void decode(std::span<const std::uint8_t> bytes, std::vector<Reading>& readings);

  std::uint64_t refused() const { return refused_; }
  /// Returns why the last line that was refused could not be read, for people; empty if none was.
  const std::string& whyRefused() const { return whyRefused_; }
  /// Returns the devices that have sent poses, in the order in which they came, at most kMostDevices.
  const std::vector<std::string>& devices() const { return devices_; }
  /// Returns what the program last told people.
  const std::string& lastWords() const { return lastWords_; }

  static constexpr std::size_t kMostDevices = 64;
  static constexpr std::size_t kLongestLine = 4096;  ///< but for those with a device's configuration

 private:
  void readLine(std::string_view line, std::vector<Reading>& readings);
  void readPose(std::string_view device, std::string_view numbers, Reading reading,
                std::vector<Reading>& readings);
  void readButton(std::string_view device, std::string_view numbers, Reading reading,
                  std::vector<Reading>& readings);
  int sensorOf(std::string_view device) const;
  void judgeLongLine();
  void refuse(std::string why);

  std::vector<std::string> names_;
  std::vector<std::string> devices_;
  std::string line_;  // as far as it has come
  bool isTooLong_ = false;
  std::uint64_t refused_ = 0;
  std::string whyRefused_, lastWords_;
};

}  // namespace carom
