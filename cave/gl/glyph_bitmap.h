#pragma once
// Text as a bitmap: FreeType draws the letters, raqm places them (shaping and kerning by HarfBuzz).

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace carom {

/// The coverage of each pixel of a text's bounding box, 0 to 255; rows from the bottom.
struct GlyphBitmap {
  glm::ivec2 size_px{0};
  std::vector<std::uint8_t> alpha;
  int below_px = 0;  ///< from the foot of the line (the same for all texts of that height) up to the box
};

/// DejaVu Sans, of the package fonts-dejavu-core: Latin, Greek and Cyrillic letters, signs of physics.
inline constexpr const char* kLettersFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

/// A font of the chain in which each letter is looked for.
struct LetterFont {
  const char* file;
  const char* package;  ///< that brings it
};

/// Returns the fonts of the chain, in the order in which a letter is looked for. Those behind the first may
/// be missing on a computer.
std::span<const LetterFont> letterFonts();

/// Returns a line of UTF-8 text, from left to right, each letter of the first font that has it; a letter that
/// no font has is a box. Capitals are about 0.72 of `height_px` high. Returns an empty bitmap if the text
/// covers no pixel. Throws std::runtime_error if the first font is not installed.
GlyphBitmap ink(std::string_view text, int height_px);

/// Returns how wide a line is in the height in which letters are measured (kMeasured_px): the way of the pen.
/// Throws as `ink` does.
inline constexpr int kMeasured_px = 100;
int widthOf_px(std::string_view text);

/// Returns how far a letter moves the pen, in that height, where none stands beside it. Each letter is
/// measured once. The letters of a line add up to its width but for their kerning.
int advanceOf_px(char32_t letter);

/// Returns the place in the chain of the first installed font that has a letter; none.
std::optional<std::size_t> fontOf(char32_t letter);

/// Returns the file of the last font in the chain that the letters of a text need, for what can use one
/// alone.
const char* fontFileOf(std::string_view text);

/// Returns the package of the first font of the chain that is not installed; empty if all are.
std::string missingFontPackage();

/// Returns the letters of a text that no installed font has, each once.
std::u32string lettersWithoutFont(std::string_view text);

}  // namespace carom
