#pragma once
// A wall as one eye sees it: a texture that the drawing context fills and every window and capture reads.

#include <cstdint>
#include <span>

#include <glm/vec2.hpp>

namespace carom {

/// An 8-bit RGBA texture, sRGB encoded, rows from the bottom up, with a framebuffer to draw into it. Made and
/// destroyed with the drawing context current (Graphics::makeCurrent); the texture is shared with every
/// window.
class RenderTarget {
 public:
  explicit RenderTarget(const glm::ivec2& size_px);
  ~RenderTarget();
  RenderTarget(const RenderTarget&) = delete;
  RenderTarget& operator=(const RenderTarget&) = delete;

  void clear();  ///< to black
  /// Holds these pixels from now on: RGB, rows from the bottom up, as many as the picture has.
  void fill(std::span<const std::uint8_t> rgb);

  unsigned texture() const { return texture_; }
  unsigned framebuffer() const { return framebuffer_; }  ///< of the drawing context
  const glm::ivec2& size_px() const { return size_px_; }

 private:
  glm::ivec2 size_px_;
  unsigned texture_ = 0;
  unsigned framebuffer_ = 0;
};

}  // namespace carom
