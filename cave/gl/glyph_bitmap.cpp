#include "cave/gl/glyph_bitmap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <unordered_map>

#include <raqm.h>
#include <glm/common.hpp>

#include <ft2build.h>
#include FT_FREETYPE_H

#include "engine/text/code_points.h"

namespace carom {
namespace {

constexpr std::array<LetterFont, 3> kFonts{
    {{kLettersFile, "fonts-dejavu-core"},
     {"/usr/share/fonts/opentype/ipafont-gothic/ipag.ttf", "fonts-ipafont-gothic"},
     {"/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc", "fonts-noto-cjk"}}};

/// Freetype's and raqm's lengths are 64ths of a pixel.
constexpr int kPart = 64;

int wholePixels(FT_Pos parts) { return static_cast<int>(std::lround(static_cast<double>(parts) / kPart)); }

/// The fonts of the chain that are installed, and a line that is being placed.
class Letters {
 public:
  Letters() {
    if (FT_Init_FreeType(&library_) != 0) throw std::runtime_error("FreeType does not start");
    for (const LetterFont& font : kFonts) {
      FT_Face face = nullptr;
      if (FT_New_Face(library_, font.file, 0, &face) == 0) {
        faces_.push_back(face);
        places_.push_back(static_cast<std::size_t>(&font - kFonts.data()));
      } else if (faces_.empty()) {
        FT_Done_FreeType(library_);
        throw std::runtime_error(std::string("the font ") + font.file +
                                 " cannot be read, expected the package " + font.package);
      }
    }
  }
  ~Letters() {
    raqm_destroy(line_);
    FT_Done_FreeType(library_);  // with its faces
  }
  Letters(const Letters&) = delete;
  Letters& operator=(const Letters&) = delete;

  /// Returns the place of the first font that has a letter; none.
  std::optional<std::size_t> fontOf(char32_t letter) const {
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (FT_Get_Char_Index(faces_[i], letter) != 0) return i;
    }
    return {};
  }

  std::size_t placeInChain(std::size_t face) const { return places_[face]; }

  /// Returns the letters of a line, placed. They are valid until the next call.
  std::span<const raqm_glyph_t> place(const std::u32string& text, int height_px);

  /// Returns how far the letters that reach deepest go below those that stand on the line.
  int descent_px(int height_px) {
    const auto [known, isNew] = descents_px_.try_emplace(height_px, 0);
    if (!isNew) return known->second;
    for (const raqm_glyph_t& glyph : place(U"_/7Agfy", height_px)) {
      const FT_GlyphSlot slot = drawn(glyph);
      known->second = std::max(known->second, static_cast<int>(slot->bitmap.rows) - slot->bitmap_top);
    }
    return known->second;
  }

  int advance_px(char32_t letter) {
    const auto [known, isNew] = advances_px_.try_emplace(letter, 0);
    if (isNew) {
      FT_Face face = faces_[fontOf(letter).value_or(0)];
      FT_Set_Pixel_Sizes(face, 0, kMeasured_px);
      if (FT_Load_Char(face, letter, FT_LOAD_DEFAULT) == 0)
        known->second = wholePixels(face->glyph->advance.x);
    }
    return known->second;
  }

  static FT_GlyphSlot drawn(const raqm_glyph_t& glyph) {
    FT_Load_Glyph(glyph.ftface, glyph.index, FT_LOAD_RENDER);
    return glyph.ftface->glyph;
  }

 private:
  FT_Library library_ = nullptr;
  std::vector<FT_Face> faces_;
  std::vector<std::size_t> places_;  ///< of the faces in the chain
  raqm_t* line_ = nullptr;
  std::map<int, int> descents_px_;  ///< by height
  std::unordered_map<char32_t, int> advances_px_;
};

std::span<const raqm_glyph_t> Letters::place(const std::u32string& text, int height_px) {
  for (FT_Face face : faces_) FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(height_px));
  // A line that was set anew keeps the properties of the one before: it is made anew.
  raqm_destroy(line_);
  line_ = raqm_create();
  if (!line_ || text.empty()) return {};
  static_assert(sizeof(char32_t) == sizeof(std::uint32_t));
  const std::vector<std::uint32_t> points(text.begin(), text.end());
  raqm_set_text(line_, points.data(), points.size());
  raqm_set_par_direction(line_, RAQM_DIRECTION_LTR);
  raqm_set_freetype_load_flags(line_, FT_LOAD_DEFAULT);
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end) {
    const std::size_t font = fontOf(text[begin]).value_or(0);
    while (end < text.size() && fontOf(text[end]).value_or(0) == font) ++end;
    raqm_set_freetype_face_range(line_, faces_[font], begin, end - begin);
  }
  if (!raqm_layout(line_)) return {};
  std::size_t count = 0;
  const raqm_glyph_t* glyphs = raqm_get_glyphs(line_, &count);
  return {glyphs, count};
}

/// Each thread has its own: neither library may be used by two at a time.
Letters& letters() {
  thread_local Letters owned;
  return owned;
}

/// The pixels of a letter in its line, from the foot of the line and the pen's beginning.
struct Place {
  glm::ivec2 from_px, to_px;
};

Place placeOf(FT_GlyphSlot slot, const raqm_glyph_t& glyph, FT_Pos pen) {
  const glm::ivec2 size(slot->bitmap.width, slot->bitmap.rows);
  const glm::ivec2 from(wholePixels(pen + glyph.x_offset) + slot->bitmap_left,
                        wholePixels(glyph.y_offset) + slot->bitmap_top - size.y);
  return {from, from + size};
}

}  // namespace

std::span<const LetterFont> letterFonts() { return kFonts; }

GlyphBitmap ink(std::string_view text, int height_px) {
  Letters& all = letters();
  const int descent_px = all.descent_px(height_px);
  const std::span<const raqm_glyph_t> glyphs = all.place(codePointsOf(text), height_px);
  glm::ivec2 from(std::numeric_limits<int>::max()), to(std::numeric_limits<int>::min());
  FT_Pos pen = 0;
  for (const raqm_glyph_t& glyph : glyphs) {
    const FT_GlyphSlot slot = Letters::drawn(glyph);
    if (slot->bitmap.rows > 0 && slot->bitmap.width > 0) {
      const Place place = placeOf(slot, glyph, pen);
      from = glm::min(from, place.from_px);
      to = glm::max(to, place.to_px);
    }
    pen += glyph.x_advance;
  }
  if (from.x >= to.x) return {};
  GlyphBitmap made{to - from, {}, from.y + descent_px};
  made.alpha.resize(static_cast<std::size_t>(made.size_px.x * made.size_px.y));
  pen = 0;
  for (const raqm_glyph_t& glyph : glyphs) {
    const FT_GlyphSlot slot = Letters::drawn(glyph);
    const Place place = placeOf(slot, glyph, pen);
    for (int y = place.from_px.y; y < place.to_px.y; ++y) {
      const unsigned char* row = slot->bitmap.buffer + (place.to_px.y - 1 - y) * slot->bitmap.pitch;
      for (int x = place.from_px.x; x < place.to_px.x; ++x) {
        auto& at = made.alpha[static_cast<std::size_t>((y - from.y) * made.size_px.x + x - from.x)];
        at = std::max(at, row[x - place.from_px.x]);  // letters may overlap
      }
    }
    pen += glyph.x_advance;
  }
  return made;
}

int widthOf_px(std::string_view text) {
  FT_Pos pen = 0;
  for (const raqm_glyph_t& glyph : letters().place(codePointsOf(text), kMeasured_px)) pen += glyph.x_advance;
  return wholePixels(pen);
}

int advanceOf_px(char32_t letter) { return letters().advance_px(letter); }

std::optional<std::size_t> fontOf(char32_t letter) {
  const std::optional<std::size_t> face = letters().fontOf(letter);
  return face ? std::optional(letters().placeInChain(*face)) : std::nullopt;
}

const char* fontFileOf(std::string_view text) {
  std::size_t last = 0;
  while (!text.empty()) {
    const std::optional<char32_t> letter = takeCodePoint(text);
    if (letter) last = std::max(last, fontOf(*letter).value_or(0));
  }
  return letterFonts()[last].file;
}

std::string missingFontPackage() {
  for (const LetterFont& font : letterFonts())
    if (!std::filesystem::exists(font.file)) return font.package;
  return {};
}

std::u32string lettersWithoutFont(std::string_view text) {
  std::u32string without;
  for (const char32_t letter : codePointsOf(text)) {
    if (!letters().fontOf(letter) && without.find(letter) == std::u32string::npos) without.push_back(letter);
  }
  return without;
}

}  // namespace carom
