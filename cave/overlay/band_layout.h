#pragma once
// Where the lines and buttons of a lesson's band lie on the front wall. Computed from the numbers of letters
// and lines alone, not from the letters' shapes, so that a node without the wall's picture finds the same
// places.
//
//   +--------------------------------------------------+
//   | Question:  Two twins part and meet again ...     |
//   | [1   Neither                                   ] |   a row is a button
//   | [2   The one who stayed at home                ] |
//   | Choose an answer.  [Skip Enter]       [Leave F7] |   chips are buttons
//   +--------------------------------------------------+

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/hud/hud_text.h"
#include "cave/overlay/wall_buttons.h"
#include "cave/room/wall.h"

namespace carom {

/// A part of the band, in pixels from its lower left corner.
struct BandPart {
  glm::ivec2 from_px{0}, size_px{0};
};

/// The band on a picture.
struct BandLayout {
  int height_px = 1;  ///< nominal height of the letters
  glm::ivec2 size_px{0};
  std::vector<BandPart> lines;  ///< of each line
  struct Button {
    WallAction action;
    BandPart part;
    std::size_t line = 0, chip = 0;  ///< of a row the first line; `chip` is the number of a chip in its line
    bool isRow = false;
  };
  std::vector<Button> buttons;
};
/// Fills `layout`, whose memory is reused.
void layOut(const Wall& wall, const glm::ivec2& picture_px, std::span<const HudLine> lines,
            BandLayout& layout);

/// Returns where the lower left corner of a band so high lies on the picture: its lower edge at the height of
/// the eyes, or lower if it would reach beyond the wall.
glm::ivec2 bandCorner_px(const Wall& wall, const glm::dvec2& pxPerM, int high_px);

/// Appends the band's buttons, and below them in order the band itself, which does nothing.
void addBand(const Wall& wall, std::span<const HudLine> lines, std::vector<WallButton>& buttons);

/// Returns whether the band shows the lesson's longest text on this wall in letters of their full height.
bool bandHolds(const LessonWords& words, const LessonPlan& plan, const Wall& wall);

}  // namespace carom
