#pragma once
// A still picture to draw test patterns on. Rows count from the bottom.

#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/pictures/image.h"
#include "cave/room/wall.h"

namespace carom {

/// Lengths and places in the pattern, as fractions of the picture's width and height or in metres.
struct CalibrationPatternLayout {
  static constexpr double kLine_m = 0.1;  ///< between strong grid lines, from the lower left corner
  static constexpr double kFineLine_m =
      0.01;  ///< between weak grid lines, which need pixels that are small enough
  static constexpr double kFinest_px = 4.0;  ///< weak lines closer together than this are left out
  static constexpr double kCircle = 0.4;     ///< radius, as a fraction of the wall's shorter side
  static constexpr double kEyeBar = 0.06;    ///< distance of one eye's bar from its own side of the picture
  static constexpr double kEyeBarWidth = 0.04;          ///< width of that bar
  static constexpr glm::dvec2 kEyeBarRows{0.25, 0.75};  ///< lower and upper end of that bar
};

/// Returns the words that give a point of the room.
std::string cornerWords(const glm::dvec3& corner_m);

class PatternCanvas {
 public:
  using Colour = std::array<std::uint8_t, 3>;
  static constexpr Colour kBlack{0, 0, 0}, kWhite{255, 255, 255};

  explicit PatternCanvas(const glm::ivec2& size_px);
  /// Draws on a picture that is there.
  explicit PatternCanvas(Image image) : image_(std::move(image)) {}

  const glm::ivec2& size_px() const { return image_.size_px; }
  Image take() { return std::move(image_); }

  /// Fills from `from` up to, but not including, `to`; parts outside the picture are left out.
  void fill(glm::ivec2 from, glm::ivec2 to, const Colour& colour);
  /// Fills a box given by two corners, as fractions of the picture's size.
  void fillShare(const glm::dvec2& from, const glm::dvec2& to, const Colour& colour);
  void dot(int x, int y, const Colour& colour);
  /// Draws a white frame along the outermost pixels.
  void frame();
  /// Draws the bar that only this eye has.
  void eyeBar(Eye eye);
  /// Writes white text on black, smaller if it would be wider than `widest` of the picture's width. `anchor`,
  /// a fraction of the picture's size, is where the text's left (0), middle (0.5) or right (1) end lies, at
  /// half its height.
  void write(const std::string& text, double height_px, const glm::dvec2& anchor, double end,
             double widest = 0.7);

 private:
  /// Blends white in, with an opacity of `alpha`/255.
  void whiten(const glm::ivec2& place, int alpha);
  std::uint8_t* at(int x, int y);

  Image image_;
};

}  // namespace carom
