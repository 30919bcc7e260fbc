#include "cave/gl/letter_atlas.h"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>

#include <ft2build.h>
#include FT_FREETYPE_H

#include "engine/base/code_points.h"

namespace carom {
namespace {

constexpr int kFirst = 32, kAscii = 95;  // the letters of ASCII that can be seen, and the blank
/// What follows them.
constexpr std::array<char32_t, 10> kMore{U'°', U'β', U'γ', U'τ', U'Δ', U'²', U'×', U'±', U'≈', U'−'};
static_assert(kAscii + kMore.size() <= kLetterColumns * kLetterRows);

constexpr unsigned kEm_px = 80;                                 // an advance is 0.602 of it
constexpr int kCapital_px = 58;                                 // 0.729 of it
constexpr int kFoot_px = (kLetterCell_px.y - kCapital_px) / 2;  // capitals and digits stand in the middle

void drawLetter(FT_Face face, char32_t letter, int cell, LetterAtlas& atlas) {
  if (FT_Load_Char(face, letter, FT_LOAD_RENDER | FT_LOAD_NO_HINTING) != 0) return;
  const FT_Bitmap& bitmap = face->glyph->bitmap;
  const int advance_px = static_cast<int>(face->glyph->advance.x >> 6);
  const glm::ivec2 corner(cell % kLetterColumns * kLetterCell_px.x, cell / kLetterColumns * kLetterCell_px.y);
  const glm::ivec2 at(face->glyph->bitmap_left + (kLetterCell_px.x - advance_px) / 2,
                      kFoot_px + face->glyph->bitmap_top - static_cast<int>(bitmap.rows));
  for (int y = 0; y < static_cast<int>(bitmap.rows); ++y) {
    for (int x = 0; x < static_cast<int>(bitmap.width); ++x) {
      const glm::ivec2 to(at.x + x, at.y + y);
      if (to.x < 0 || to.y < 0 || to.x >= kLetterCell_px.x || to.y >= kLetterCell_px.y) continue;
      const int row = static_cast<int>(bitmap.rows) - 1 - y;
      atlas.ink[static_cast<std::size_t>((corner.y + to.y) * atlas.size_px.x + corner.x + to.x)] =
          bitmap.buffer[row * bitmap.pitch + x];
    }
  }
}

LetterAtlas makeAtlas() {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  if (FT_Init_FreeType(&library) != 0) throw std::runtime_error("FreeType does not start");
  const std::unique_ptr<FT_LibraryRec_, decltype(&FT_Done_FreeType)> owner(library, FT_Done_FreeType);
  if (FT_New_Face(library, kPlateLettersFile, 0, &face) != 0)
    throw std::runtime_error(std::string("the font ") + kPlateLettersFile +
                             " cannot be read; expected the package fonts-dejavu-core");
  const std::unique_ptr<FT_FaceRec_, decltype(&FT_Done_Face)> font(face, FT_Done_Face);
  FT_Set_Pixel_Sizes(face, 0, kEm_px);
  LetterAtlas atlas;
  atlas.ink.resize(static_cast<std::size_t>(atlas.size_px.x * atlas.size_px.y));
  for (int i = 0; i < kAscii; ++i) drawLetter(face, static_cast<char32_t>(kFirst + i), i, atlas);
  for (std::size_t i = 0; i < kMore.size(); ++i)
    drawLetter(face, kMore[i], kAscii + static_cast<int>(i), atlas);
  return atlas;
}

}  // namespace

const LetterAtlas& letterAtlas() {
  static const LetterAtlas atlas = makeAtlas();
  return atlas;
}

std::uint8_t takeLetter(std::string_view& text) {
  const char32_t letter = takeCodePoint(text).value_or(U'?');
  if (letter >= kFirst && letter < kFirst + kAscii) return static_cast<std::uint8_t>(letter - kFirst);
  const auto* more = std::find(kMore.begin(), kMore.end(), letter);
  return static_cast<std::uint8_t>(more == kMore.end() ? '?' - kFirst : kAscii + (more - kMore.begin()));
}

}  // namespace carom
