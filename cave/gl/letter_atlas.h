#pragma once
// The letters of plates, all equally wide, in one picture: a face for numbers and short words that stand in
// the scene. Longer texts are panels (cave/gl/glyph_bitmap.h).

#include <cstdint>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace carom {

/// Cells of the picture, in columns and rows; a letter's code is its cell, counted along the rows.
inline constexpr int kLetterColumns = 16, kLetterRows = 7;  ///< of the letters that there always are
inline constexpr int kMostLetterRows = 16;
inline constexpr glm::ivec2 kLetterCell_px{58, 96};
inline constexpr int kCapital_px = 58;  ///< the height of a capital: 0.729 of the em

/// DejaVu Sans Mono, of the package fonts-dejavu-core.
inline constexpr const char* kPlateLettersFile = "/usr/share/fonts/truetype/dejavu/DejaVuSansMono-Bold.ttf";

/// Sets the letters beyond those that there always are: those of the names and words on plates in the
/// languages of a session. Those that exceed the picture (more than 151) are as if unknown. Call it before
/// anything is drawn, on a thread of its own.
void setPlateLetters(std::u32string_view letters);

/// The coverage of each pixel by ink, 0 to 255; rows from the bottom, row 0 of the cells lowest.
struct LetterAtlas {
  int rows = kLetterRows;
  glm::ivec2 size_px{kLetterColumns * kLetterCell_px.x, kLetterRows* kLetterCell_px.y};
  std::vector<std::uint8_t> ink;
};

/// Returns the picture, which is made at the first call, and anew when letters were set. Throws
/// std::runtime_error if the font is not installed.
const LetterAtlas& letterAtlas();

/// Takes the first letter from a text in UTF-8 and returns its code: ASCII, some letters of physics, and
/// those that were set. Returns that of '?' for any other.
std::uint8_t takeLetter(std::string_view& text);

}  // namespace carom
