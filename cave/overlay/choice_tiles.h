#pragma once
// Draws the tiles among the buttons of the front wall (cave/overlay/wall_buttons.h): the three choices stand
// beside the panel of words, above the table, or at the wall's foot while a lesson explains; smaller ones
// below them.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/gl/glyph_bitmap.h"
#include "cave/gl/picture.h"
#include "cave/hud/panel_picture.h"
#include "cave/overlay/wall_buttons.h"
#include "cave/record/frame_state.h"
#include "cave/room/wall.h"

namespace carom {

class ChoiceTiles {
 public:
  /// Create, use and destroy it with the drawing context current.
  ChoiceTiles() = default;

  /// Sets the names of the session's languages, by their numbers.
  void setLanguages(const std::vector<std::string>& names) {
    languages_ = names;
    labels_.clear();
    painted_.clear();
  }

  /// Draws the tiles over the picture of the front wall; the one that the record's hand points to is bright.
  void draw(const Wall& wall, const SeenFrame& seen, const OfferedTiles& offered,
            const RenderTarget& picture);

 private:
  /// Name and key of a tile in a language, as large as the tile allows.
  struct Label {
    WallAction action;
    std::uint8_t language = 0;
    glm::ivec2 tile_px{0};
    GlyphBitmap name, key;
  };
  struct Painted {
    WallAction action;
    glm::ivec2 from_px{0}, size_px{0};
    std::uint8_t language = 0;
    bool operator==(const Painted&) const = default;
  };
  const Label& labelOf(const Painted& tile);
  std::pair<std::string, std::string> wordsOf(const WallAction& action) const;
  void paint();
  void paintTile(std::size_t tile, const glm::ivec2& from_px);

  std::vector<std::string> languages_;  ///< their names
  std::vector<Label> labels_;           ///< that were needed so far
  std::vector<WallButton> tiles_;
  std::vector<Painted> wanted_, painted_;  ///< in pixels of the picture
  glm::ivec2 corner_px_{0};                ///< the lower left corner of all of them
  WallAction pointed_, paintedPointed_;
  std::uint64_t keysNamed_ = 0;  ///< KeyNames::changes of the labels
  PanelPicture panel_;
};

}  // namespace carom
