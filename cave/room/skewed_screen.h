#pragma once
// A flat screen that is no rectangle: four measured corners, the rectangle around them for which pictures are
// drawn, and the homography that brings each place of the picture to its place on the screen.

#include <array>
#include <string>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace carom {

/// Corners in this order: lower left, lower right, upper left, upper right, as seen from inside the room.
struct SkewedScreen {
  std::array<glm::dvec3, 4> corners_m{};  ///< as measured, in the room
  std::array<glm::dvec2, 4> inPicture{};  ///< the same corners in the picture, 0 to 1 from its lower left
  double offPlane_m = 0.0;                ///< distance of every corner from the plane that fits them best

  bool operator==(const SkewedScreen&) const = default;
};

/// Corners farther off their plane than this are those of a bent screen.
inline constexpr double kMostOffPlane_m = 0.02;

/// The rectangle around a skewed screen, in its plane.
struct AroundScreen {
  glm::dvec3 lowerLeft_m{0.0}, lowerRight_m{0.0}, upperLeft_m{0.0};
  SkewedScreen screen;
  std::string fault;  ///< if there is one, nothing else holds: the fault and the expectation
};

/// Returns the smallest rectangle around the corners whose horizontal edges run along the mean of the
/// screen's lower and upper edge.
AroundScreen around(const std::array<glm::dvec3, 4>& corners_m);

/// Returns the homography from the window (0 to 1 from its lower left, as (u, v, 1)) to the picture, as
/// homogeneous coordinates with a positive third: the window's corners go to the screen's.
glm::dmat3 pictureFromWindow(const SkewedScreen& screen);

/// What a homography costs.
struct SkewCost {
  double inset_m = 0.0;   ///< largest distance between a corner of the screen and that of the rectangle
  double inset_px = 0.0;  ///< the same in pixels of the picture
  double lost = 0.0;      ///< share of the picture that falls beside the screen
  /// Pixels of the picture, across, that a pixel of the projector shows, where it is least and most; the
  /// projector has as many pixels as the picture.
  double least = 1.0, most = 1.0;
};

/// `size_m` and `pixels` are the rectangle's.
SkewCost costOf(const SkewedScreen& screen, const glm::dvec2& size_m, const glm::ivec2& pixels);

}  // namespace carom
