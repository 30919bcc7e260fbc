#pragma once
// Small flat things drawn among the bodies: lines, plates with digits, glows. Made anew for each eye, in
// double, where the eye sees them; drawn over all walls of that eye.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace carom {

/// A corner of a triangle. Colours are sRGB, and how much it covers.
struct MarkCorner {
  glm::vec3 drawn_m{0.0F};  ///< from the eye, in the frame in which walls draw
  glm::vec4 colour{1.0F};
  glm::vec2 on{0.0F};  ///< on a plate: places from its left border, 0 … 1 over its height; on a glow −1 … 1
  glm::vec3 what{0.0F};   ///< style (shaders/mark_frag.glsl) and a plate's digits, the last six in z
  glm::vec4 plate{0.0F};  ///< a plate's middle, from the eye, and half its diagonal (m)
};

/// Digits of a plate: up to twelve places.
struct PlateText {
  /// A place every 4 bits, the last lowest: 0 to 9, 10 a minus sign, 11 nothing, 12 a degree sign, 13 an m.
  std::uint64_t digits = 0;
  int places = 0;
  bool tenths = false;  ///< a point stands before the last digit
  bool unit = false;    ///< which the sign of a unit follows
};
PlateText wholeNumber(std::uint64_t number);  ///< its last twelve digits
/// As all clocks show it: whole tenths that have gone by; six years of them, either way.
PlateText tenthsOf(double time_s);
PlateText degreesOf(double angle_deg);  ///< to the nearest tenth; 0 to 999.9
PlateText metresOf(double length_m);    ///< the same

/// What a plate looks like, so that one knows from afar what it tells.
enum class PlateShape {
  box,    ///< a number: digits in its colour on black
  clock,  ///< round corners, a thick border in its colour
  flag,   ///< black digits on its colour
};
/// A plate's width, in places of a digit.
double placesAcross(const PlateText& text, PlateShape shape);

class MarkBuffer {
 public:
  void clear() { corners_.clear(); }
  std::span<const MarkCorner> corners() const { return corners_; }

  /// A line from point to point, everywhere so wide as seen: half its width as an angle. Points from the eye.
  void addLine(std::span<const glm::dvec3> drawn_m, const glm::vec4& colour, double halfWidth_rad);

  /// Strip: two borders, point by point.
  void addStrip(std::span<const glm::dvec3> left_m, std::span<const glm::dvec3> right_m,
                const glm::vec4& colour);

  /// A plate with digits: rows of points from the left, lower border, then upper; as wide as placesAcross
  /// says of its height.
  void addPlate(std::span<const glm::dvec3> lower_m, std::span<const glm::dvec3> upper_m,
                const PlateText& text, PlateShape shape, const glm::vec4& colour);

  /// A soft round light around a point.
  void addGlow(const glm::dvec3& drawn_m, double radius_m, const glm::vec4& colour);

 private:
  std::vector<MarkCorner> corners_;
};

/// Draws batches. Made and destroyed with the drawing context current.
class MarkDrawer {
 public:
  MarkDrawer();
  ~MarkDrawer();
  MarkDrawer(const MarkDrawer&) = delete;
  MarkDrawer& operator=(const MarkDrawer&) = delete;

  void upload(const MarkBuffer& batch);
  /// What was uploaded last, plates over all else; within a GlStateGuard that tests depth and blends. `cutAt`:
  /// 1 if the picture goes on beyond its right border with another, −1 if beyond its left, 0: neither. Plates
  /// that such a border would cut are left out.
  void draw(const glm::mat4& clipFromDrawn, float cutAt = 0.0F) const;

 private:
  unsigned program_ = 0, vertexArray_ = 0, buffer_ = 0;
  int count_ = 0;
};

}  // namespace carom
