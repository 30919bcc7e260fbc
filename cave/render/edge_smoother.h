#pragma once
// Smooth edges without multisampling, for renderers in software, where four samples a pixel cost two and a
// half times the time of a frame: edges are found in the finished picture and drawn again, each pixel mixed
// with its neighbour as far as the edge covers it (shaders/edge_frag.glsl). What holds no edge is not
// touched.

#include <glm/vec2.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/gl/picture.h"

namespace carom {

/// Create, use and destroy it with the drawing context current.
class EdgeSmoother {
 public:
  /// Where a picture has the tones between which edges are sought.
  enum class Tones { inAlpha, luminance };
  explicit EdgeSmoother(Tones tones = Tones::inAlpha);

  /// Smooths the picture's columns from `left_px` on, `size_px` large. They are a copy of the first columns
  /// and rows of the texture `drawn`.
  /// The viewport is the
  /// first `size_px` when this is called and stays that. Nothing from beyond these columns and rows gets into the picture; one of fewer than ten stays as it
  /// is.
  void smooth(unsigned drawn, const glm::ivec2& size_px, const RenderTarget& picture, int left_px);

 private:
  GlProgram program_;
  GlVertexArray vertexArray_;
  int sizeAt_ = -1, leftAt_ = -1;  // places of the uniforms
  glm::ivec2 size_px_{0};
  int left_px_ = 0;  // as the program has them
};

}  // namespace carom
