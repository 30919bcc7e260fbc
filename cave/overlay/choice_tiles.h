#pragma once
// Three large choices on the front wall, for a mouse, a wand or a key: they stand beside the panel of words, above
// the table, or at the wall's foot while a lesson explains. They lie in the wall's plane, so both eyes see them at
// the same place.

#include <array>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/frame/choice.h"
#include "cave/frame/frame_state.h"
#include "cave/gl/glyph_bitmap.h"
#include "cave/gl/picture.h"
#include "cave/overlay/panel_picture.h"
#include "cave/room/wall.h"

namespace carom {

/// A rectangle on a wall: metres from the wall's lower left corner.
struct Tile {
  glm::dvec2 from_m{0.0}, size_m{0.0};
};

/// Returns the tiles on a wall, in the order of the choices. `atFoot`: flat, at its foot, where they cover
/// little of a game that is explained.
std::array<Tile, kChoices> tilesOn(const Wall& wall, bool atFoot);

/// A choice that a ray points to, and where the ray meets the wall.
struct PointedChoice {
  Choice choice = Choice::play;
  glm::dvec3 onWall_m{0.0};  ///< room frame
};
/// Returns the choice on the front wall to which a ray points, or none. Room frame.
std::optional<PointedChoice> choiceAt(const Wall& front, bool atFoot, const glm::dvec3& from_m,
                                      const glm::dvec3& along);

class ChoiceTiles {
 public:
  /// Create, use and destroy it with the drawing context current.
  ChoiceTiles() = default;

  /// Draws the tiles over the picture of the front wall; the one that the record's hand points to is bright.
  void draw(const Wall& wall, const FrameRecord& record, const RenderTarget& picture);

 private:
  void write(const glm::ivec2& tile_px);
  void paint(const glm::ivec2& tile_px, int gap_px, std::optional<Choice> pointed);

  std::array<GlyphBitmap, kChoices> names_, keys_;
  glm::ivec2 tile_px_{0};  ///< the size for which they were written
  std::optional<Choice> pointed_;
  PanelPicture panel_;
};

}  // namespace carom
