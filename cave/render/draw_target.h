#pragma once
// The buffers into which a wall is drawn, with depth and if asked for with several samples a pixel, before it
// is copied into its picture.

#include <cstdint>
#include <span>

#include <glm/vec2.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/gl/picture.h"

namespace carom {

class DrawTarget {
 public:
  /// `samples`: samples a pixel (1: no multisampling).
  explicit DrawTarget(int samples);

  /// Forgets which viewport is set, as others have drawn since.
  void forgetViewport() { viewport_px_ = glm::ivec2(0); }

  /// Makes what follows draw into a black picture of this size, with the depth test on. The buffers grow to
  /// the largest picture and keep that size: making them anew for every size would cost more than the
  /// drawing.
  void begin(const glm::ivec2& size_px);
  /// Does the same, but begins with the colours and depths of another picture. Both have one sample a pixel.
  void beginWith(const DrawTarget& other);
  /// Copies the picture, which was begun last, into columns of another, from `left_px` on. Afterwards the
  /// depth test is off and no framebuffer is bound; the viewport is still that of this picture.
  void copyTo(const RenderTarget& picture, int left_px) const;

  /// Does the same, but copies into memory (cave/gl/picture.h: `RenderTarget::fill`). With one sample a
  /// pixel.
  void read(std::span<std::uint32_t> pixels) const;

  unsigned framebuffer() const { return framebuffer_; }
  const glm::ivec2& size_px() const { return size_px_; }

 private:
  void bind(const glm::ivec2& size_px);
  void grow(const glm::ivec2& size_px);

  int samples_;
  glm::ivec2 buffer_px_{0}, size_px_{0};
  glm::ivec2 viewport_px_{0};  // as it is set; 0: not known
  GlFramebuffer framebuffer_;
  GlTexture texture_;      // of colours, with one sample a pixel
  GlRenderbuffer colour_;  // with several
  GlRenderbuffer depth_;
};

}  // namespace carom
