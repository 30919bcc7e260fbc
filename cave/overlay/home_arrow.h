#pragma once
// Which way the table is, on the front wall, while no wall shows it.

#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/gl/line_batch.h"
#include "cave/gl/picture.h"
#include "cave/hud/panel_picture.h"
#include "cave/record/frame_state.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"
#include "cave/texts/language.h"

namespace carom {

/// Where the table's middle is seen: the direction from the eyes in the room, and its distance then.
struct SeenTable {
  glm::dvec3 towards{0.0};
  double distance_m = 0.0;
};

/// Returns where the point between the eyes sees the middle of the table, which rests on the board at its
/// origin: its light left it at the board time t − |r|/c, and the room has its own directions.
SeenTable seenTable(const SeenFrame& seen);

/// Returns which way to turn to have the table in sight, in the front wall's plane: a unit vector to the
/// right and up. None while one of the walls shows the table's middle, while a scripted flight or a lesson
/// places the room, or if the room has no front wall.
std::optional<glm::dvec2> wayHome(const RoomGeometry& room, const SeenFrame& seen);

class HomeArrow {
 public:
  /// Create and destroy it with the drawing context current.
  HomeArrow() = default;

  /// Draws the arrow over the picture of the front wall, if one is needed.
  void draw(const RoomGeometry& room, const Wall& front, const glm::dvec3& eyeInRoom_m, const SeenFrame& seen,
            const RenderTarget& picture);

 private:
  LineBatch ribbons_;
  std::vector<Ribbon> lines_;
  PanelPicture words_;
  int height_px_ = 0;                          ///< of the letters that were written
  long distance_m_ = -1;                       ///< that was written
  const texts::Language* language_ = nullptr;  ///< in which it was
};

}  // namespace carom
