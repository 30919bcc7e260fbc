#pragma once
// Decodes the bytes of a Polhemus tracker into readings. Records may arrive joined or split.
// Sources: Polhemus FASTRAK manual (URM95PH002) and LIBERTY manual (URM03PH156), output records in binary;
// VRPN's serial drivers of both.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "devices/tracker/reading.h"
#include "devices/wire/frame_gaps.h"
#include "devices/wire/unwrapped_counter.h"

namespace carom {

/// The two formats of a record. The lowest byte of a number comes first.
enum class PolhemusFormat {
  /// After "O…,2,11,0": '0', station '1' … '4', status, 3 floats of position, 4 of orientation, ' '. No
  /// clock.
  fastrak,
  /// PATRIOT and LIBERTY, after "O*,8,9,11,3,7": two letters, station 1 … 16, command 'C' or 'P', error,
  /// reserved, 16-bit size 40; then 32-bit time (ms), frame count and distortion, 3 floats, 4 floats.
  liberty,
};

/// Decodes a stream of records (lengths in centimetres, quaternions scalar first). Whatever the bytes are,
/// the readings are finite, with unit quaternions. Bytes that fit no record are skipped up to the next mark
/// whose record makes sense.
class PolhemusDecoder {
 public:
  explicit PolhemusDecoder(PolhemusFormat format) : format_(format) {}

  /// Takes the next bytes of the stream; appends a reading for each record that they complete: a pose, or
  /// `lost` if the device flags the station's record as faulty. The sensor is station − 1. `quality` is 1 /
  /// (1 + distortion level) if the device reports one.
  void decode(std::span<const std::uint8_t> bytes, std::vector<Reading>& readings);

  /// Returns how often bytes had to be skipped.
  std::uint64_t refused() const { return refused_; }
  /// Returns how many records the device has counted that never arrived.
  std::uint64_t missed() const { return missed_; }

  static constexpr int kStations = 16;

 private:
  enum class Match { no, soFar, whole };
  Match matchFastrak(Reading& reading) const;
  Match matchLiberty(Reading& reading) const;
  void countFrames(Reading& reading);
  void passOver();

  PolhemusFormat format_;
  std::array<std::uint8_t, 48> held_{};  // the beginning of the next record
  std::size_t heldSize_ = 0;
  bool inStep_ = true;
  UnwrappedCounter<std::uint32_t> clock_ms_;
  std::array<FrameGaps, kStations> frames_{};
  std::uint64_t refused_ = 0;
  std::uint64_t missed_ = 0;
};

}  // namespace carom
