#pragma once
// A line of the panel on the front wall, and how wide its parts are, by the number of their letters; wider
// where these letters are.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/frame/wall_action.h"
#include "cave/hud/line_breaks.h"
#include "cave/room/wall.h"

namespace carom {

/// A button within a line.
struct HudChip {
  WallAction action;
  std::string text;
  bool isOn = false;     ///< it is the present choice
  bool atRight = false;  ///< it stands at the line's right end

  bool operator==(const HudChip&) const = default;
};

/// A line of the panel.
struct HudLine {
  std::string text;
  std::optional<glm::vec3> mark;  ///< sRGB colour of a square before it: what in the room the line refers to
  bool urgent = false;            ///< its letters are highlighted
  bool setIn = false;  ///< indented: it continues the line before it, which began with a number or a name
  WallAction row{};    ///< the whole line is a button, together with the lines after it that continue it
  std::vector<HudChip> chips{};  ///< behind its text

  bool isRow() const { return row.kind != WallAction::Kind::none; }
  bool operator==(const HudLine&) const = default;
};

/// The room of a line without a lesson, and of an entry of the legend, where the widest letters of English
/// need no more.
inline constexpr LineRoom kPanelRoom{40, 24.0}, kLegendRoom{100, 60.0};

/// What English has at its places stays as it always was. Other languages have no letters lower than this,
/// and their long entries of the legend are broken like other lines.
inline constexpr int kLeastLetter_px = 9;
bool isEnglish();
/// Returns the height below which letters do not shrink.
int leastLetter_px();
/// Returns the room of an entry of the legend.
LineRoom legendRoom();

/// Returns the room of a line of the band on a wall.
LineRoom bandRoom(const Wall& wall);
/// Returns what is left of a line that is indented.
LineRoom behindIndent(const LineRoom& room);

// In the nominal height of the letters.
inline constexpr double kChipPadding = 0.6, kChipGap = 0.5, kIndent = 1.6;
inline constexpr double kBandMargin = 1.25;  ///< where the band's text begins
/// Returns how wide a chip is, with its padding.
double widthOf(const HudChip& chip);
/// Returns where the first chip behind a line's text begins, from where the text does.
double afterText(const HudLine& line);

/// Returns whether the chip fits behind the text and the chips of a line.
bool chipFits(const HudLine& line, const HudChip& chip, const LineRoom& room);

}  // namespace carom
