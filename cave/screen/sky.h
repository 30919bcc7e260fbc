#pragma once
// Pictures by direction: what somebody sees all around, laid into one picture by a rule, as planetariums and
// films of 360° want it. Each is the picture of a screen so far away that it makes no difference where in the
// room the eyes are.

#include <array>
#include <cstdint>
#include <string_view>

#include <glm/vec3.hpp>

namespace carom {

enum class SkyKind : std::uint8_t {
  /// A circle: the angle from the axis is in proportion to the distance from the middle; the front is at the
  /// bottom, and its left at the left.
  fisheye,
  /// Longitude across, from 180° to the left of the front to 180° to the right; latitude upwards.
  equirectangular,
  /// Six squares of 90° in one row: right, left, up, down, back, front. The lower edge of up and the upper
  /// edge of down are those at the front.
  cubemap
};
inline constexpr std::array<std::string_view, 3> kSkyKinds{"fisheye", "equirectangular", "cubemap"};

/// Room frame.
struct Sky {
  SkyKind kind = SkyKind::fisheye;
  double fov_rad = 3.141592653589793;  ///< of a fisheye: the angle across its circle
  glm::dvec3 axis{0.0, 1.0, 0.0};      ///< unit vector: the middle of a fisheye's circle, the others' up
  glm::dvec3 front{0.0, 0.0, -1.0};    ///< unit vector at a right angle to the axis
  glm::dvec3 middle_m{0.0};            ///< about where the eyes are
};

/// How far away the screen is: at three metres from the middle, eyes see a place of it within a hundredth of
/// a pixel of 8192 across.
inline constexpr double kSky_m = 1e6;

}  // namespace carom
