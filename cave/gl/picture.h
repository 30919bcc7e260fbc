#pragma once
// A wall as one eye sees it: a texture that the drawing context fills and every window and capture reads.

#include <cstdint>
#include <span>

#include <glm/vec2.hpp>

#include "cave/gl/gl_objects.h"

namespace carom {

/// Gives the 2D texture that is bound room for a picture with 8 bits a colour, in the order of windows, which
/// it is copied into: blue, green, red, alpha.
void allocatePicture(const glm::ivec2& size_px);

/// A texture of 8 bits a colour and alpha, sRGB encoded, rows from the bottom up, with a framebuffer to draw
/// into it. Create and destroy it with the drawing context current (Graphics::makeCurrent); every window
/// shares the texture.
class RenderTarget {
 public:
  explicit RenderTarget(const glm::ivec2& size_px);

  /// Fills it with black, or `width_px` columns from `left_px` on, unless all of it is black still; leaves no
  /// framebuffer bound.
  void clear();
  void clear(int left_px, int width_px);
  /// Sets the pixels of `width_px` columns from `left_px` on: numbers of four bytes, alpha in the highest,
  /// then red, green, blue; rows from the bottom up.
  void fill(std::span<const std::uint32_t> pixels, int left_px, int width_px);
  /// Sets its pixels: RGB, rows from the bottom up, as many as the picture has.
  void fill(std::span<const std::uint8_t> rgb);

  unsigned texture() const { return texture_; }
  /// Returns its framebuffer in the drawing context, for drawing: it may not be black any more.
  unsigned framebuffer() const {
    isBlack_ = false;
    return framebuffer_;
  }
  const glm::ivec2& size_px() const { return size_px_; }

 private:
  glm::ivec2 size_px_;
  GlTexture texture_;
  GlRenderbuffer depth_;  // keeps Mesa 22.3's llvmpipe from a fast path that mistakes colours
  GlFramebuffer framebuffer_;
  mutable bool isBlack_ = false;  // not drawn into since it was cleared
};

}  // namespace carom
