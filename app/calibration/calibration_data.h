#pragma once
// The data of a calibration: the points to be touched and sighted, and those that were.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/calibration/corner_names.h"
#include "app/calibration/tip_fit.h"
#include "app/rig/rig.h"
#include "devices/calibration/rests.h"

namespace carom {

/// What shall be done, in this order: the tip, the corners, the mark, the left eye, the right eye.
struct CalibrationPlan {
  SensorChoice tool;                 ///< the sensor that touches
  std::vector<NamedCorner> corners;  ///< in the order of touching
  bool pivot = false;                ///< the tip is found by turning the tool about it
  bool sight = false;                ///< the eyes are found: a mark is touched after the corners
  std::vector<NamedCorner> targets;  ///< of each eye, in the order of looking
};

/// A corner, and the sensor while the corner was touched or looked at.
struct HeldAt {
  NamedCorner corner;
  Rest rest;
};

struct CalibrationData {
  std::optional<TipFit> tip;
  std::vector<HeldAt> touched;
  std::optional<Rest> mark;
  std::array<std::vector<HeldAt>, 2> sighted;  ///< left eye, right eye
  double noise_m = 0.0;                        ///< of a coordinate of the tool, from sample to sample
};

/// The names of the recordings in a folder.
inline constexpr const char* kPivotFile = "pivot.csv";
inline constexpr const char* kCornersFile = "corners.csv";
inline constexpr std::array<const char*, 2> kSightFiles{"sight-left.csv", "sight-right.csv"};

/// Returns the limits within which a tool is at rest, with so much noise of the tracker.
RestLimits toolLimits(double noise_m);
/// Returns those within which a head is: people stand less still than a hand on a wall.
RestLimits headLimits();

/// Returns the tip of the tool: its sensor's own place, if it was not turned.
glm::dvec3 tipOf(const CalibrationData& data);

/// Reads the recordings of a calibration, whose points are the rests, in the order of the
/// plan. Throws InputError if a file cannot be read, InputErrors if its rests are not as many as the points.
CalibrationData readCalibration(const std::filesystem::path& folder, const CalibrationPlan& plan);

/// Guides a person through the plan, with words on standard output. Points that were skipped are not in the
/// result; after an early end the rest is not. Taken points are written to `folder`, if one is given. Throws
/// std::runtime_error if it cannot be written.
CalibrationData takeCalibration(const Rig& rig, const CalibrationPlan& plan,
                                const std::optional<std::filesystem::path>& folder);

}  // namespace carom
