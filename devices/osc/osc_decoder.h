#pragma once
// Decodes datagrams of Open Sound Control 1.0 into readings.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "devices/osc/osc_mapping.h"
#include "devices/tracker/reading.h"

namespace carom {

class WireReader;

class OscDecoder {
 public:
  explicit OscDecoder(OscMapping mapping) : mapping_(std::move(mapping)) {}

  /// Takes one datagram, a message or a bundle, and appends its readings. Readings before a fault are
  /// kept. Returns false if a part of it cannot be read; `whyRefused` then says why.
  ///
  /// Time: the time tag of the innermost bundle, seconds since 1900; a message outside of a bundle, or in one
  /// whose tag says "at once", has none.
  bool decode(std::span<const std::uint8_t> datagram, std::vector<Reading>& readings);

  /// Returns why the last part that was refused could not be read, for people; empty if none was.
  const std::string& whyRefused() const { return whyRefused_; }
  /// Returns the first addresses that were none of a pose, a button or an axis, at most kMostOthers.
  const std::vector<std::string>& otherAddresses() const { return others_; }

  static constexpr std::size_t kMostOthers = 8;

 private:
  bool readElement(std::span<const std::uint8_t> element, double device_s, int depth,
                   std::vector<Reading>& readings);
  bool readBundle(WireReader& wire, int depth, std::vector<Reading>& readings);
  bool readMessage(WireReader& wire, double device_s, std::vector<Reading>& readings);
  bool takeArguments(WireReader& wire, std::string_view types);
  bool addPose(std::string_view address, Reading reading, std::vector<Reading>& readings);
  bool addInput(std::string_view address, Reading reading, std::vector<Reading>& readings);
  void noteOther(std::string_view address);
  bool refuse(std::string_view address, const std::string& why);

  OscMapping mapping_;
  std::vector<double> arguments_;  // of the present message; NaN for one that is no number
  std::string whyRefused_;
  std::vector<std::string> others_;
};

}  // namespace carom
