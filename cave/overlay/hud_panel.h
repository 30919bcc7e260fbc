#pragma once
// Text in the room: a panel of short lines in the plane of the front wall, at its left, as high as the wall
// and the eyes allow. The table is below the eyes, so up there the panel covers nothing of the game. Since it
// lies in the wall's plane, it is the same for both eyes and needs no effort to fuse.
//
// While a lesson speaks, the panel is a band across the whole wall with larger letters, for a group to read,
// and has the lesson's texts alone, with buttons among them (cave/overlay/band_layout.h). It stands above the
// eyes, as far as the wall reaches up there.

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/gl/glyph_bitmap.h"
#include "cave/gl/picture.h"
#include "cave/hud/hud_text.h"
#include "cave/hud/panel_picture.h"
#include "cave/overlay/band_layout.h"
#include "cave/record/frame_state.h"
#include "cave/room/wall.h"

namespace carom {

class HudPanel {
 public:
  /// Create and destroy it with the drawing context current.
  HudPanel() = default;

  /// Sets the panel's lines; without lines there is no panel. Only lines that have changed are rendered anew,
  /// when they are next drawn.
  void set(const std::vector<HudLine>& lines);

  /// Sets the wall on which the panel is drawn, and the viewers in the order of the records to follow.
  void setWall(const Wall& wall, std::span<const RoomViewer> viewers) { text_.setWall(wall, viewers); }

  /// Sets the game's lesson, and whether it has the button that leaves it.
  void setLesson(const LessonWords& words, const LessonPlan& plan, bool mayLeave = true) {
    text_.setLesson(words, plan, mayLeave);
  }

  /// Updates the panel from the frame.
  void follow(const SeenFrame& seen);

  /// Draws the panel over the picture of the front wall. The button that the hand of this record points to is
  /// bright.
  void draw(const Wall& wall, const SeenFrame& seen, const RenderTarget& picture);
  /// Draws it without a hand.
  void draw(const Wall& wall, const RenderTarget& picture);

 private:
  struct Written {
    HudLine line;
    GlyphBitmap ink;
    std::vector<GlyphBitmap> chips;
  };
  static int endOf_px(const Written& written, int height_px);
  void draw(const Wall& wall, const WallAction& pointed, const RenderTarget& picture);
  void write(const glm::ivec2& picture_px, const Wall& wall);
  void writePanel(const glm::ivec2& picture_px, const Wall& wall);
  void writeBand();
  void inkLines(int height_px);
  void paintPanel();
  void paintBand();

  std::vector<Written> lines_;
  HudText text_;
  BandLayout layout_;
  std::vector<WallButton> buttons_;  ///< of the band, on the wall
  WallAction pointed_;               ///< as it was painted
  bool band_ = false;                ///< a lesson speaks
  bool written_ = false;
  int height_px_ = 0;         ///< of the rendered letters
  glm::ivec2 picture_px_{0};  ///< size of the picture for which they were rendered
  PanelPicture panel_;
};

}  // namespace carom
