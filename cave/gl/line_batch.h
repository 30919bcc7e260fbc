#pragma once
// Thick straight lines in space, with smooth edges, drawn over a picture.

#include <array>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "cave/gl/gl_objects.h"

namespace carom {

struct Ribbon {
  glm::dvec3 from_m{0.0}, to_m{0.0};
  double halfWidth_m = 0.0;  ///< across the line of sight; on the picture, a line is at least a pixel wide
  glm::vec4 colour{1.0F};    ///< sRGB, with opacity as alpha
};

class LineBatch {
 public:
  /// Create and destroy it with the drawing context current.
  LineBatch();

  /// Draws the ribbons in their order, into a picture of this size. Call it within a GlStateGuard, after
  /// blendOver. If the depth test is on, their own depth applies. Parts behind the eye are left out.
  void draw(std::span<const Ribbon> ribbons, const glm::dmat4& clipFromRoom, const glm::ivec2& size_px);

 private:
  struct Corner {
    glm::vec4 clip;
    glm::vec2 across_px;  ///< from the middle of the line; half its width there
    glm::vec4 colour;
  };
  void add(const Ribbon& ribbon, const glm::dmat4& clipFromRoom, const glm::dvec2& half_px);

  GlProgram program_;
  VertexStream<Corner> stream_;
  std::vector<Corner> corners_;
};

}  // namespace carom
