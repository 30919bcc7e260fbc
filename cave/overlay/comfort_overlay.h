#pragma once
// What makes driving bearable: while the room moves, the edges of sight darken and a frame that rests in the
// room stays visible; and a game that begins comes out of black.
//
// The clear cone around the direction of sight is the narrower the faster the room moves on the board. A
// person feels no motion; what moves at the edge of their sight is what makes them ill (Fernandes, Feiner
// 2016).

#include <vector>

#include <glm/vec3.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/gl/line_batch.h"
#include "cave/gl/picture.h"
#include "cave/record/frame_state.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"

namespace carom {

/// Returns how much of the edges of sight is darkened: 0 at rest, 1 from kFullBeta on. Nothing unless the
/// record asks for it.
double shadeOf(const SeenFrame& seen);

/// Returns the direction in which the person looks: that of the tracked head or, where none is known or there
/// is a single wall, to the middle of the front wall.
glm::dvec3 sightOf(const RoomGeometry& room, const SeenFrame& seen);

class ComfortOverlay {
 public:
  static constexpr double kFullBeta = 0.6;
  static constexpr double kClearAtRest_rad = 0.9, kClearFast_rad = 0.35;  ///< half the clear cone's angle
  static constexpr double kSoft_rad = 0.3;                                ///< from there on to the darkest
  static constexpr double kDarkest = 0.9;

  /// Create and destroy it with the drawing context current.
  ComfortOverlay();

  /// Draws the dark edges and the resting frame over the picture of a wall for an eye in the room; costs
  /// nothing if there is nothing to draw.
  void draw(const RoomGeometry& room, const Wall& wall, const glm::dvec3& eyeInRoom_m, const SeenFrame& seen,
            const RenderTarget& picture);

  /// Blackens the whole picture as far as the record says.
  void fade(const Wall& wall, const SeenFrame& seen, const RenderTarget& picture) const;

 private:
  void shade(const Wall& wall, const glm::dvec3& eyeInRoom_m, const glm::dvec3& sight, double shade,
             double black, const RenderTarget& picture) const;
  void drawFrame(const RoomGeometry& room, const Wall& wall, const glm::dvec3& eyeInRoom_m, double shade,
                 const RenderTarget& picture);

  GlProgram program_;
  GlVertexArray vertexArray_;
  LineBatch ribbons_;
  std::vector<Ribbon> lines_;
};

}  // namespace carom
