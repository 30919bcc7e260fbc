#pragma once
// What a class that answers by phone sees on the front wall, on the left above the tiles of its foot: a QR
// code, the address and the word of the room, how many have answered, and once a vote is closed, how, as
// pairs of bars. While the lesson plays it is small.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/gl/glyph_bitmap.h"
#include "cave/gl/picture.h"
#include "cave/hud/panel_picture.h"
#include "cave/overlay/qr_code.h"
#include "cave/record/class_view.h"
#include "cave/room/wall.h"
#include "cave/texts/language.h"

namespace carom {

class ClassBoard {
 public:
  /// Create, use and destroy it with the drawing context current.
  ClassBoard() = default;

  /// Draws it over the picture of the front wall; nothing if no class takes part.
  void draw(const Wall& wall, const ClassView& view, const RenderTarget& picture);

 private:
  struct Line {
    std::string text;
    GlyphBitmap ink;
  };
  void layOut(double scale);
  void paint();
  void paintCode();
  void paintBars(int top_px);
  bool showsBars() const;
  bool hasBoth() const;
  int barRows() const;
  int begin_px() const;

  PanelPicture panel_;
  ClassView view_;  ///< as it is painted
  const texts::Language* language_ = nullptr;
  glm::ivec2 picture_px_{0};  ///< size of the picture that it is painted for
  QrCode code_;
  ShortText<120> coded_;  ///< what the code says
  std::vector<Line> lines_;
  int letter_px_ = 1, module_px_ = 1;
  glm::ivec2 size_px_{0};
};

/// Returns the lines of words beside the code.
std::vector<std::string> classLines(const ClassView& view);

/// Returns the size of a module of the code, in pixels, on a picture of this height: at least 1/400 of it.
int moduleOf_px(int picture_px, int modules, bool isSmall);

}  // namespace carom
