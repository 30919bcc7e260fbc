#pragma once
// Small flat marks drawn among the bodies: lines, plates with letters, glows. They are computed anew for each
// eye, in double, at the places where the eye sees them, and drawn over all walls of that eye.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/texts/format.h"

namespace carom {

/// A corner of a triangle. Colours are sRGB, with opacity as alpha.
struct MarkCorner {
  glm::vec3 drawn_m{0.0F};  ///< from the eye, in the frame in which walls are drawn
  glm::vec4 colour{1.0F};
  glm::vec2 on{0.0F};  ///< on a plate: places from its left border, 0 … 1 over its height; else −1 … 1
  float style = 0.0F;  ///< shaders/mark_frag.glsl
  glm::vec4 text{0.0F};   ///< a plate's letters, three in each, the first highest
  glm::vec4 plate{0.0F};  ///< a plate's middle, from the eye, and half its diagonal (m)
};

/// What a plate says: up to twelve letters (cave/gl/letter_atlas.h).
struct PlateText {
  std::array<std::uint8_t, 12> letters{};
  int places = 0;
  bool operator==(const PlateText&) const = default;
};
PlateText plateText(std::string_view words);  ///< UTF-8; cut after twelve letters
PlateText wholeNumber(std::uint64_t number);  ///< the last twelve digits of `number`
/// Returns a time as all clocks show it: rounded down to tenths, from minus to plus six years.
PlateText tenthsOf(double time_s);
PlateText hundredthsOf(double time_s);  ///< rounded to hundredths; minus to plus 999.99
/// Returns a number in words, such as "γ {:.2f}", from 0 to 9999.
PlateText measured(const texts::Text& words, double value);
/// Returns numbers or names in words, such as "{} of {}", cut after twelve letters.
template <typename... Values>
PlateText written(const texts::Text& words, const Values&... values) {
  std::array<char, 64> text{};
  return plateText(texts::formatTo(text, words, values...));
}

/// The look of a plate, by which a person tells from afar what it shows.
enum class PlateShape {
  box,    ///< letters in its colour on black
  clock,  ///< round corners, a thick border in its colour
  flag,   ///< black letters on its colour
};
/// Returns the width of a plate, in places of a letter.
double placesAcross(const PlateText& text, PlateShape shape);

class MarkBuffer {
 public:
  void clear() {
    corners_.clear();
    plates_.clear();
  }
  std::span<const MarkCorner> corners() const { return corners_; }
  /// Corners that follow one another.
  struct Run {
    int first = 0, count = 0;
  };
  /// Returns which of them are of plates, in their order.
  std::span<const Run> plates() const { return plates_; }

  /// Adds a line through these points, given from the eye. It looks equally wide everywhere: `halfWidth_rad`
  /// is half its width as an angle. Where its last point is its first, it is closed without a seam.
  void addLine(std::span<const glm::dvec3> drawn_m, const glm::vec4& colour, double halfWidth_rad);

  /// Adds a strip between two borders, given point by point.
  void addStrip(std::span<const glm::dvec3> left_m, std::span<const glm::dvec3> right_m,
                const glm::vec4& colour);

  /// Adds a plate. Its lower and upper borders are rows of points from the left; its width is its
  /// height times placesAcross.
  void addPlate(std::span<const glm::dvec3> lower_m, std::span<const glm::dvec3> upper_m,
                const PlateText& text, PlateShape shape, const glm::vec4& colour);

  /// Adds a soft round glow around a point.
  void addGlow(const glm::dvec3& drawn_m, double radius_m, const glm::vec4& colour);
  /// Adds a round disc that faces the eye.
  void addDisc(const glm::dvec3& drawn_m, double radius_m, const glm::vec4& colour);

 private:
  void addRound(const glm::dvec3& drawn_m, double radius_m, const glm::vec4& colour, float style);
  std::vector<MarkCorner> corners_;
  std::vector<Run> plates_;
};

/// Draws mark buffers. Create and destroy it with the drawing context current.
class MarkDrawer {
 public:
  MarkDrawer();

  void upload(const MarkBuffer& batch);
  /// Draws the last upload, plates over everything else. Call it within a GlStateGuard, with depth
  /// test and blending on. `cutAt`: 1 if another picture continues beyond the right border, −1 if beyond the
  /// left one, 0 if neither. Plates that such a border would cut are left out.
  void draw(const glm::mat4& clipFromDrawn, float cutAt = 0.0F) const;

 private:
  GlProgram program_;
  GlTexture letters_;
  VertexStream<MarkCorner> stream_;
  int clipAt_, cutAt_;  // places of uniforms
  struct Runs {
    std::vector<int> firsts, counts;
    void add(int first, int end);
    void draw() const;
  } flat_, plates_;
};

}  // namespace carom
