#include "cave/gl/letter_atlas.h"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include <ft2build.h>
#include FT_FREETYPE_H

#include "cave/gl/glyph_bitmap.h"
#include "engine/text/code_points.h"

namespace carom {
namespace {

constexpr int kFirst = 32, kAscii = 95;  // the letters of ASCII that can be seen, and the blank
/// What follows them.
constexpr std::array<char32_t, 10> kMore{U'°', U'β', U'γ', U'τ', U'Δ', U'²', U'×', U'±', U'≈', U'−'};
static_assert(kAscii + kMore.size() <= kLetterColumns * kLetterRows);

constexpr std::size_t kAlways = kAscii + kMore.size();
constexpr std::size_t kMostSet = kMostLetterRows * kLetterColumns - kAlways;

/// The letters that were set, in their order.
std::u32string& setLetters() {
  static std::u32string letters;
  return letters;
}

bool isOnEveryPlate(char32_t letter) {
  return letter < kFirst + kAscii || std::find(kMore.begin(), kMore.end(), letter) != kMore.end();
}

constexpr unsigned kEm_px = 80;                                 // an advance is 0.602 of it
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

using Library = std::unique_ptr<FT_LibraryRec_, decltype(&FT_Done_FreeType)>;
using Face = std::unique_ptr<FT_FaceRec_, decltype(&FT_Done_Face)>;

/// Returns a font whose letters have this height; none if it is not installed.
Face faceOf(const Library& library, const char* file, unsigned height_px) {
  FT_Face face = nullptr;
  if (FT_New_Face(library.get(), file, 0, &face) != 0) return {nullptr, &FT_Done_Face};
  FT_Set_Pixel_Sizes(face, 0, height_px);
  return {face, &FT_Done_Face};
}

LetterAtlas makeAtlas() {
  FT_Library started = nullptr;
  if (FT_Init_FreeType(&started) != 0) throw std::runtime_error("FreeType does not start");
  const Library library(started, FT_Done_FreeType);
  const Face plates = faceOf(library, kPlateLettersFile, kEm_px);
  if (!plates)
    throw std::runtime_error(std::string("the font ") + kPlateLettersFile +
                             " cannot be read; expected the package fonts-dejavu-core");
  LetterAtlas atlas;
  const std::u32string& more = setLetters();
  const int cells = static_cast<int>(kAlways + more.size());
  atlas.rows = std::max(kLetterRows, (cells + kLetterColumns - 1) / kLetterColumns);
  atlas.size_px.y = atlas.rows * kLetterCell_px.y;
  atlas.ink.resize(static_cast<std::size_t>(atlas.size_px.x * atlas.size_px.y));
  for (int i = 0; i < kAscii; ++i) drawLetter(plates.get(), static_cast<char32_t>(kFirst + i), i, atlas);
  for (std::size_t i = 0; i < kMore.size(); ++i)
    drawLetter(plates.get(), kMore[i], kAscii + static_cast<int>(i), atlas);
  // What this face does not have is drawn by the others, as wide as a cell.
  std::vector<Face> others;
  for (const LetterFont& font : letterFonts()) {
    if (Face other = faceOf(library, font.file, kLetterCell_px.x)) others.push_back(std::move(other));
  }
  for (std::size_t i = 0; i < more.size(); ++i) {
    FT_Face face = plates.get();
    for (std::size_t next = 0; next < others.size() && FT_Get_Char_Index(face, more[i]) == 0; ++next)
      face = others[next].get();
    drawLetter(face, more[i], static_cast<int>(kAlways + i), atlas);
  }
  return atlas;
}

LetterAtlas& keptAtlas() {
  static LetterAtlas atlas = makeAtlas();
  return atlas;
}

}  // namespace

void setPlateLetters(std::u32string_view letters) {
  std::u32string more(letters);
  std::erase_if(more, isOnEveryPlate);
  std::sort(more.begin(), more.end());
  more.erase(std::unique(more.begin(), more.end()), more.end());
  more.resize(std::min(more.size(), kMostSet));
  if (more == setLetters()) return;
  setLetters() = std::move(more);
  keptAtlas() = makeAtlas();
}

const LetterAtlas& letterAtlas() { return keptAtlas(); }

std::uint8_t takeLetter(std::string_view& text) {
  const char32_t letter = takeCodePoint(text).value_or(U'?');
  if (letter >= kFirst && letter < kFirst + kAscii) return static_cast<std::uint8_t>(letter - kFirst);
  const auto* more = std::find(kMore.begin(), kMore.end(), letter);
  if (more != kMore.end()) return static_cast<std::uint8_t>(kAscii + (more - kMore.begin()));
  const std::size_t set = setLetters().find(letter);
  return static_cast<std::uint8_t>(set == std::u32string::npos ? '?' - kFirst : kAlways + set);
}

}  // namespace carom
