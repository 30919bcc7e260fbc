#pragma once
// Letters in space, of the face of plates (cave/gl/letter_atlas.h), drawn over a picture.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "cave/gl/gl_objects.h"

namespace carom {

struct SetLetter {
  std::uint8_t code = 0;               ///< as takeLetter returns it
  glm::dvec3 foot_m{0.0};              ///< of the line, in the letter's middle
  glm::dvec3 right_m{0.0}, up_m{0.0};  ///< as long as capitals are high
  glm::vec4 colour{1.0F};              ///< sRGB, with opacity as alpha
};

/// Copies the letters to a texture of the graphics card, and smaller ones for those far away.
void uploadLetters(const GlTexture& texture);

/// The raised 2 of this face.
inline constexpr std::string_view kRaisedTwo = "²";

/// How far a letter moves the pen, over the height of capitals.
inline constexpr double kLetterAdvance = 0.83;

class LetterBatch {
 public:
  /// Create and destroy it with the drawing context current. The letters are read when first drawn.
  LetterBatch();

  /// Draws letters before the eye; call it within a GlStateGuard, after blendOver.
  void draw(std::span<const SetLetter> letters, const glm::dmat4& clipFromRoom);

 private:
  struct Corner {
    glm::vec4 clip;
    glm::vec2 on;
    glm::vec4 colour;
  };

  GlProgram program_;
  VertexStream<Corner> stream_;
  GlTexture letters_;
  bool isRead_ = false;
  std::vector<Corner> corners_;
};

}  // namespace carom
