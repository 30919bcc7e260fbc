#pragma once
// A line of the panel on the front wall, and how wide its parts are, by the number of their letters.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/frame/wall_action.h"
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

inline constexpr std::size_t kLineLetters = 40;  ///< without a lesson; longer words are not divided

/// Returns how many letters a line of the band has on a wall.
std::size_t bandLetters(const Wall& wall);

// In the nominal height of the letters.
inline constexpr double kChipPadding = 0.6, kChipGap = 0.5;
/// Returns how wide a chip is, with its padding.
double widthOf(const HudChip& chip);
/// Returns where the first chip behind a line's text begins, from where the text does.
double afterText(const HudLine& line);

/// Returns whether the chip fits behind the text and the chips of a line with room for so many letters.
bool chipFits(const HudLine& line, const HudChip& chip, std::size_t letters);

}  // namespace carom
