#pragma once
// A board that stands in the room, for rooms without a front wall: what else is drawn over the front wall's
// picture is written on it, and it is drawn over the pictures of both eyes, each from where that eye is.

#include <optional>

#include <glm/vec3.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/gl/picture.h"
#include "cave/room/wall.h"

namespace carom {

class StandingBoard {
 public:
  /// Create and destroy it with the drawing context current.
  explicit StandingBoard(const Wall& place);

  const Wall& place() const { return place_; }
  /// Returns the writing on it; `wiped`: after it was wiped clean.
  const RenderTarget& written() const { return written_; }
  const RenderTarget& wiped() const;

  /// Draws the board over the picture of a wall for an eye in the room.
  void draw(const Wall& wall, const glm::dvec3& eyeInRoom_m, const RenderTarget& picture) const;

 private:
  Wall place_;
  RenderTarget written_;
  GlProgram program_;
  GlVertexArray vertexArray_;
};

}  // namespace carom
