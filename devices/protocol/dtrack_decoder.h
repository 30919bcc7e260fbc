#pragma once
// From a datagram of ART's DTRACK2 or DTRACK3 (lines of text) to readings.
//
// Sensors: body n of `6d` is sensor n, Flystick n of `6df` and `6df2` is sensor 100 + n, hybrid body n of
// `6di` is sensor 200 + n; numbers of the device below 100. A room's millimetres become metres.

#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "devices/tracker/reading.h"

namespace carom {

class DtrackDecoder {
 public:
  /// Takes one datagram and appends what it says; bodies that a `6dcal` counts and no `6d` lists are lost.
  /// Lines of other names are passed over, and so are those that cannot be read, which are counted. False
  /// where it says nothing to us at all.
  ///
  /// Time: of a `ts2`, its stamp and latency; of a `ts`, which begins again at midnight, days are added.
  bool decode(std::span<const std::uint8_t> datagram, std::vector<Reading>& readings);

  /// The frame's number, where the last datagram gave one.
  std::optional<std::uint32_t> frame() const { return frame_; }
  std::uint64_t refused() const { return refused_; }  ///< lines that could not be read, so far

 private:
  class Line;
  bool readLine(std::string_view text, std::vector<Reading>& readings);
  bool readBodies(Line& line, std::vector<Reading>& readings);
  bool readFlysticks(Line& line, std::vector<Reading>& readings);
  bool readOldFlysticks(Line& line, std::vector<Reading>& readings);
  bool readHybrids(Line& line, std::vector<Reading>& readings);
  bool readTime(Line& line);
  bool readTime2(Line& line);
  bool countOthers(Line& line);
  void appendLost(std::vector<Reading>& readings) const;

  std::optional<std::uint32_t> frame_;
  std::uint64_t refused_ = 0;

  // Of this datagram.
  std::optional<double> sent_s_;
  double latency_s_ = 0.0;
  bool hasTime2_ = false;
  std::optional<unsigned> adjusted_;  // bodies, sticks, tools and hybrid bodies
  unsigned others_ = 0;               // sticks, tools and hybrid bodies
  std::bitset<100> seen_;

  double lastOfDay_s_ = 0.0;
  double days_s_ = 0.0;
};

}  // namespace carom
