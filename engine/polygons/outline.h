#pragma once
// The outline of a puck with corners: a simple polygon in the puck's rest frame, in the board's axes.
// Theory: app/doc/physics.md, Polygons.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace carom {

constexpr std::size_t kLeastCorners = 3;
constexpr std::size_t kMostCorners = 256;

/// Returns by how much b is to the left of a, seen from above: |a| |b| sin of the angle from a to b.
inline double cross2(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// The fault of the corners of an outline.
struct OutlineFault {
  std::size_t corner = 0;  ///< the first corner, counted from 0, that is wrong
  std::string what;        ///< and the expectation
};

/// Returns why these corners are no outline: too few or too many, no numbers, two in one place, sides that
/// cross or touch, no area, clockwise. None if nothing is wrong.
std::optional<OutlineFault> faultOf(std::span<const glm::dvec2> corners);

/// Returns whether the line from a to b and the one from c to d, which have no end in common, cross or touch.
bool sidesMeet(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d);

/// Returns whether an outline is convex at a corner: a point nearest to it is outside. At a dent it is
/// inside.
bool turnsLeft(std::span<const glm::dvec2> corners, std::size_t corner);

/// Returns whether a side is nearer to a point than another, by the squares of the distances and by how far
/// the point is in front of their lines. Two sides are equally near at their corner: that is the nearer one
/// which the point lies on the outside of, or else more in front of.
bool isNearer(double distance2, double front, double least2, double frontOfLeast);

/// What a plate of even density with such an outline is. The corners are measured from the puck's centre.
struct OutlineMoments {
  double area = 0.0;
  glm::dvec2 centre{0.0};  ///< its centre of mass
  double inertia = 0.0;    ///< I/(m R²) about the puck's centre, R the farthest corner
};
OutlineMoments momentsOf(std::span<const glm::dvec2> corners);

/// An outline, prepared for contacts. Side k runs from corner k to the next one, with the body on its left.
class Outline {
 public:
  struct Side {
    glm::dvec2 from, along, normal;  ///< unit vectors; the normal points out of the body
    double offset = 0.0;             ///< normal · x on the side
    double length = 0.0;
  };

  /// Takes corners without a fault (`faultOf`).
  explicit Outline(std::span<const glm::dvec2> corners);

  std::span<const glm::dvec2> corners() const { return corners_; }
  std::span<const Side> sides() const { return sides_; }
  double radius() const { return radius_; }  ///< of the farthest corner from the centre
  bool isConvex() const { return convex_; }

  /// How deep a point lies outside the outline, and at which side.
  struct Clearance {
    double outside = 0.0;  ///< below 0 inside; never more than the distance
    std::size_t side = 0;  ///< the nearest one inside and at the outline
  };
  Clearance clearanceOf(const glm::dvec2& point) const;
  /// Returns the side by which a way, straight and from outside, comes in, of several the last; none if it
  /// does not.
  std::optional<std::size_t> entranceOf(const glm::dvec2& from, const glm::dvec2& to) const;

 private:
  std::vector<glm::dvec2> corners_;
  std::vector<Side> sides_;
  double radius_ = 0.0;
  bool convex_ = true;
};

}  // namespace carom
