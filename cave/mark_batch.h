#pragma once
// Small flat things drawn among the bodies: lines, plates with digits, glows. Made anew for each eye, in
// double, where the eye sees them; drawn over all walls of that eye.

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
  glm::vec2 on{0.0F};    ///< on a plate: places from the left, 0 … 1 over its height; on a glow −1 … 1
  glm::vec2 what{0.0F};  ///< style (shaders/mark_frag.glsl) and a plate's digits
};

/// Digits of a plate: up to five places.
struct PlateText {
  float digits = 0.0F;  ///< a place every 4 bits, the last lowest: 0 to 9, 10 a minus sign, 11 nothing
  int places = 0;
  bool tenths = false;  ///< a point stands before the last place
};
PlateText wholeNumber(unsigned long number);  ///< its last five digits
/// As clocks show it: whole tenths that have gone by; −999.9 to 9999.9, then it begins again.
PlateText tenthsOf(double time_s);

class MarkBatch {
 public:
  void clear() { corners_.clear(); }
  std::span<const MarkCorner> corners() const { return corners_; }

  /// A line from point to point, everywhere so wide as seen: half its width as an angle. Points from the eye.
  void addLine(std::span<const glm::dvec3> drawn_m, const glm::vec4& colour, double halfWidth_rad);

  /// Strip: two borders, point by point.
  void addStrip(std::span<const glm::dvec3> left_m, std::span<const glm::dvec3> right_m,
                const glm::vec4& colour);

  /// A plate with digits in `colour`, framed in `frame`: rows of points from the left, lower border, then
  /// upper.
  void addPlate(std::span<const glm::dvec3> lower_m, std::span<const glm::dvec3> upper_m,
                const PlateText& text, const glm::vec4& colour);

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

  void upload(const MarkBatch& batch);
  /// What was uploaded last; within a PlainState that tests depth and blends.
  void draw(const glm::mat4& clipFromDrawn) const;

 private:
  unsigned program_ = 0, vertexArray_ = 0, buffer_ = 0;
  int count_ = 0;
};

}  // namespace carom
