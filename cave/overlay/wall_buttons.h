#pragma once
// The buttons on the front wall, for mouse, touch, wand and gamepad: the three choices, what else a game
// names, and the buttons of a lesson's band (cave/overlay/band_layout.h). They lie in the wall's plane, so
// both eyes see them at the same place. A node that draws the wall and the one that is asked where a ray
// points compute the same places.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/frame/wall_action.h"
#include "cave/record/choice.h"
#include "cave/record/frame_state.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"

namespace carom {

/// A rectangle on a wall: metres from the wall's lower left corner.
struct Tile {
  glm::dvec2 from_m{0.0}, size_m{0.0};
};

struct WallButton {
  WallAction action;
  Tile place;
};

/// Returns the places of the three choices on a wall, in their order. `atFoot`: flat, at its foot, where they
/// cover little of a game that is explained.
std::array<Tile, kChoices> tilesOn(const Wall& wall, bool atFoot);

/// What decides which tiles a game offers, besides the frame's record.
struct OfferedTiles {
  bool choices = false;   ///< the game offers the three choices
  bool keys = false;      ///< the person has a keyboard, so that the list of keys is of use
  bool isAstray = false;  ///< the table is out of sight
  bool hasTasks = false;  ///< the game has tasks
};

/// Returns what a room offers in a frame of the game.
OfferedTiles offeredIn(const RoomGeometry& room, const SeenFrame& seen, const GameOffers& game);

/// Appends the tiles on a wall in this frame: the three choices, and below them flat ones for what the keys
/// Enter, Home, F and H do, where there is something for them to do; for a picture of the best shot; for the
/// Doppler colour; and for tasks: to begin them, after the first stroke, and to go on to the next or try
/// again. Where there are several languages, below all of these the one for the next language, which stands
/// beside the choices at the foot while a lesson speaks.
void addTiles(const Wall& wall, const SeenFrame& seen, const OfferedTiles& offered,
              std::vector<WallButton>& buttons);

/// A button that a ray points to, and where the ray meets the wall.
struct PointedButton {
  WallAction action;
  glm::dvec3 onWall_m{0.0};  ///< room frame
};
/// Returns the first of the buttons on the front wall to which a ray points, or none. Room frame.
std::optional<PointedButton> buttonAt(const Wall& front, std::span<const WallButton> buttons,
                                      const glm::dvec3& from_m, const glm::dvec3& along);

/// Returns the button to which the hand of the record points, or no action.
WallAction pointedByHand(const Wall& front, std::span<const WallButton> buttons, const SeenFrame& seen);

/// Returns the middle of a place on a wall. Room frame.
glm::dvec3 middleOf(const Wall& wall, const Tile& tile);

}  // namespace carom
