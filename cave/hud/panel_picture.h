#pragma once
// A panel in the plane of a wall, drawn over the wall's picture: painted on the processor, kept as a texture,
// and drawn pixel on pixel.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/gl/glyph_bitmap.h"
#include "cave/gl/picture.h"

namespace carom {

class PanelPicture {
 public:
  using Rgba = std::array<std::uint8_t, 4>;  ///< sRGB and opacity

  /// The ground of what a hand points to, and the letters on it.
  static constexpr Rgba kPointed{245, 190, 60, 245};
  static constexpr glm::vec3 kOnPointed{15.0F, 15.0F, 15.0F};

  /// Create and destroy it with the drawing context current.
  PanelPicture();

  /// Begins a panel of this size, of one colour.
  void begin(const glm::ivec2& size_px, const Rgba& ground);
  /// Fills a rectangle, given by its lower left corner.
  void fill(const glm::ivec2& from_px, const glm::ivec2& size_px, const Rgba& colour);
  /// Writes a line of text whose foot begins here. `colour`: sRGB, 0 to 255.
  void write(const glm::ivec2& foot_px, const GlyphBitmap& ink, const glm::vec3& colour);
  /// Uploads the painted pixels for drawing.
  void upload();

  const glm::ivec2& size_px() const { return size_px_; }

  /// Draws the panel over a picture, with its lower left corner here. `stretch` is the width of its pixels in
  /// pixels of the picture.
  void draw(const RenderTarget& picture, const glm::ivec2& from_px, double stretch) const;

 private:
  glm::ivec2 size_px_{0};
  std::vector<std::uint8_t> rgba_;
  GlProgram program_;
  GlVertexArray vertexArray_;
  GlTexture texture_;
};

}  // namespace carom
