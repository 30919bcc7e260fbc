#pragma once
// Decodes datagrams of ART's DTRACK2 or DTRACK3 (lines of text) into readings.
//
// Sensors: body n of `6d` is sensor n, Flystick n of `6df` and `6df2` is sensor 100 + n, hybrid body n of
// `6di` is sensor 200 + n, for device numbers below 100. The room's millimetres become metres.

#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "devices/tracker/reading.h"

namespace carom {

class DtrackDecoder {
 public:
  /// Takes one datagram and appends its readings. Bodies that a `6dcal` counts and no `6d` lists are lost.
  /// Lines with other names are ignored; lines that cannot be read are ignored and counted. Returns false if
  /// the datagram holds nothing of use.
  ///
  /// Time: a `ts2` gives its stamp and latency; a `ts` starts again at midnight, so days are added.
  bool decode(std::span<const std::uint8_t> datagram, std::vector<Reading>& readings);

  /// The frame's number, if the last datagram gave one.
  std::optional<std::uint32_t> frame() const { return frame_; }
  std::uint64_t refused() const { return refused_; }  ///< lines that could not be read, so far
  /// Returns why the last refused line could not be read, for people; empty if none was.
  const std::string& whyRefused() const { return whyRefused_; }

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
  std::string whyRefused_;

  // Contents of this datagram.
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
