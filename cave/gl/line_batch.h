#pragma once
// Straight lines in space with a thickness, smooth at their edges, drawn over a picture.

#include <array>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace carom {

struct Ribbon {
  glm::dvec3 from_m{0.0}, to_m{0.0};
  double halfWidth_m = 0.0;  ///< across the line of sight; never less than a pixel wide on the picture
  glm::vec4 colour{1.0F};    ///< sRGB, and how much it covers
};

class LineBatch {
 public:
  /// Made and destroyed with the drawing context current.
  LineBatch();
  ~LineBatch();
  LineBatch(const LineBatch&) = delete;
  LineBatch& operator=(const LineBatch&) = delete;

  /// Draws them in their order, into a picture of this size. Within a GlStateGuard, after blendOver; the depth
  /// is theirs where the depth test is on. What is behind the eye is left out.
  void draw(std::span<const Ribbon> ribbons, const glm::dmat4& clipFromRoom, const glm::ivec2& size_px);

 private:
  struct Corner {
    glm::vec4 clip;
    glm::vec2 across_px;  ///< from the middle; half the width there
    glm::vec4 colour;
  };
  void add(const Ribbon& ribbon, const glm::dmat4& clipFromRoom, const glm::dvec2& half_px);

  unsigned program_ = 0, vertexArray_ = 0, buffer_ = 0;
  std::vector<Corner> corners_;
};

}  // namespace carom
