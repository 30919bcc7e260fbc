#pragma once
// One record of what a device sent. Decoders make it from bytes, and it passes from the device's thread to
// the frame.

#include <cstdint>
#include <limits>
#include <type_traits>

#include <glm/vec3.hpp>

#include "engine/base/pose.h"

namespace carom {

/// One item that a device sent. `kind` says which members hold.
struct Reading {
  enum class Kind : std::uint8_t {
    pose,      ///< sensor, pose, hasOrientation, times, quality
    velocity,  ///< sensor, velocity_m_s, angularVelocity_rad_s
    lost,      ///< the device reports that it does not see this sensor
    button,    ///< sensor, index, value 0 or 1
    axis,      ///< sensor, index, value in -1 … 1
    battery,   ///< sensor, value in 0 … 1
  };
  Kind kind = Kind::pose;
  bool hasOrientation = false;
  std::int32_t sensor = 0;                ///< body, stick or station; counts from 0
  std::int32_t index = 0;                 ///< of the button or axis; counts from 0
  Pose pose;                              ///< trackerFromSensor, metres; a unit quaternion
  glm::dvec3 velocity_m_s{0.0};           ///< in the tracker's axes
  glm::dvec3 angularVelocity_rad_s{0.0};  ///< in the tracker's axes
  double value = 0.0;
  /// Time on the device's own clock, in seconds since a moment of its choosing; NaN if it sends none.
  double device_s = std::numeric_limits<double>::quiet_NaN();
  double latency_s = 0.0;  ///< age of the pose when the device sent it, if it reports that
  double quality =
      std::numeric_limits<double>::quiet_NaN();  ///< 0 … 1 if the device reports it, otherwise NaN
};
static_assert(std::is_trivially_copyable_v<Reading>);

}  // namespace carom
