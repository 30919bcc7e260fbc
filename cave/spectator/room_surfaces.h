#pragma once
// The flat parts of the room seen from outside: the ground on which it stands, and its walls with their
// pictures and names.

#include <vector>

#include "cave/display/display_walls.h"
#include "cave/gl/gl_objects.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"
#include "cave/spectator/outside_view.h"

namespace carom {

class RoomSurfaces {
 public:
  /// Created and destroyed with the drawing context current.
  explicit RoomSurfaces(const RoomGeometry& room);

  const std::vector<Wall>& walls() const { return walls_; }  ///< each screen once
  /// Returns the lowest corner, along the room's up; that of a headset's room is its origin.
  double floor_m() const { return floor_m_; }

  // These draw within a GlStateGuard.
  /// Draws the backdrop and the ground. The ground is not drawn when seen from below, where it would hide the
  /// room.
  void drawGround(const OutsideView& view) const;
  /// Draws the pictures of the walls that show their inner side; a wall that `shown` does not draw is an
  /// empty panel.
  void drawPanels(const OutsideView& view, const DisplayWalls& shown) const;
  /// Does the same for one wall.
  void drawPanel(const Wall& wall, const OutsideView& view, const DisplayWalls& shown) const;
  /// Draws each wall's name above it, before the near edge of one that lies on the floor, and at the foot of
  /// one that is seen from behind.
  void drawNames(const OutsideView& view) const;

 private:
  /// A wall's name as a picture.
  struct Name {
    GlTexture texture;
    glm::ivec2 size_px{0};
  };

  RoomGeometry room_;
  std::vector<Wall> walls_;
  double floor_m_;
  GlProgram panelProgram_, groundProgram_, backdropProgram_, wordsProgram_;
  GlVertexArray vertexArray_;
  std::vector<Name> names_;  // of each wall
};

/// Returns whether the camera sees the side of the wall that the person sees.
bool showsInside(const Wall& wall, const glm::dvec3& camera_m);

}  // namespace carom
