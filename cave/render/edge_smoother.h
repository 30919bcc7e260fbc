#pragma once
// Smooth edges without multisampling, for renderers in software, where four samples a pixel cost two and a
// half times the time of a frame. As the processor has drawn the picture, it also smooths it
// (cave/render/edge_pixels.h): a shader would do for every pixel what few pixels need.

#include "cave/gl/picture.h"
#include "cave/render/draw_target.h"
#include "cave/render/edge_pixels.h"

namespace carom {

/// Use it with the drawing context current.
class EdgeSmoother {
 public:
  explicit EdgeSmoother(EdgePixels::Tones tones = EdgePixels::Tones::inAlpha) : pixels_(tones) {}

  /// Puts the drawn pixels into columns of a picture, from `left_px` on, with smooth edges. Afterwards the
  /// depth test is off and no framebuffer is bound.
  void copy(const DrawTarget& drawn, RenderTarget& picture, int left_px);

 private:
  EdgePixels pixels_;
};

}  // namespace carom
