#pragma once
// The shared memory of trackd, the tracker daemon of CAVELib: a segment of sensors, and one of a wand's
// buttons and axes. The layout is that of trackdmem.h (D. Pape, EVL, 1998), which VR Juggler and OpenCOVER
// read as well.
//
// A segment is the daemon's word: its offsets, numbers and sizes are held against the segment's size whenever
// they are read.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/base/pose.h"

namespace carom {

/// Where a segment holds its sensors.
struct TrackdSensors {
  std::size_t count = 0, offset = 0, size = 0;
  std::uint32_t seconds = 0, microseconds = 0;  ///< when the daemon last wrote; 0 if it does not say

  static constexpr std::size_t kMost = 256;
  static constexpr std::size_t kLeastSize = 40;
};

/// Reads the header of a segment of sensors. Throws std::runtime_error, which says the fault and the
/// expectation, if the sensors do not fit into the segment.
TrackdSensors readTrackdSensors(std::span<const std::uint8_t> segment);

/// One sensor as it stands in the segment.
using TrackdSensorBytes = std::array<std::uint8_t, TrackdSensors::kLeastSize>;
TrackdSensorBytes copyTrackdSensor(std::span<const std::uint8_t> segment, const TrackdSensors& sensors,
                                   std::size_t sensor);

struct TrackdSensor {
  Pose pose;
  std::uint32_t seconds = 0, microseconds = 0;  ///< when it was measured; 0 if the daemon does not say
};

/// Returns the sensor's pose, x to the right, y up, z back, by its azimuth about y, its elevation about x and
/// its roll about z, in this order; none if its numbers are no pose.
std::optional<TrackdSensor> readTrackdSensor(const TrackdSensorBytes& bytes, double unit_m);

/// The wand's buttons, 0 or 1, and its axes, in -1 … 1.
struct TrackdWand {
  std::vector<std::int32_t> buttons;
  std::vector<float> axes;

  static constexpr std::size_t kMostInputs = 64;  ///< of each kind
};

/// Reads a segment of a wand into `wand`, which keeps its memory. Two shapes occur; whichever's header fits
/// is taken: trackd's, whose header says where buttons and axes are, and that of a header as of sensors
/// followed by the numbers and the places of 32 buttons and 32 axes. Throws std::runtime_error, which says
/// the fault and the expectation.
void readTrackdWand(std::span<const std::uint8_t> segment, TrackdWand& wand);

}  // namespace carom
