// Lines of text as bitmaps: where their letters stand, how wide they are, and which letters no font has.
#include "cave/gl/glyph_bitmap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

namespace carom {
namespace {

long inkOf(const GlyphBitmap& bitmap) {
  return std::accumulate(bitmap.alpha.begin(), bitmap.alpha.end(), 0L);
}

TEST(GlyphBitmap, StandsOnTheFootOfItsLine) {
  constexpr int kHeight_px = 40;
  const GlyphBitmap capital = ink("H", kHeight_px), deep = ink("g", kHeight_px), dash = ink("-", kHeight_px);
  EXPECT_NEAR(capital.size_px.y, 0.72 * kHeight_px, 1.0);
  EXPECT_EQ(capital.below_px, ink("x", kHeight_px).below_px) << "both stand on the line";
  EXPECT_LT(deep.below_px, capital.below_px);
  EXPECT_GE(deep.below_px, 0);
  EXPECT_GT(dash.below_px, capital.below_px);
  EXPECT_EQ(ink("Hg-", kHeight_px).below_px, deep.below_px);
  EXPECT_EQ(ink(" ", kHeight_px).size_px, glm::ivec2(0));
  EXPECT_EQ(ink("", kHeight_px).size_px, glm::ivec2(0));
}

TEST(GlyphBitmap, HasTheInkOfItsLettersAndIsAsWideAsTheyAre) {
  for (const int height_px : {12, 40, kMeasured_px}) {
    const GlyphBitmap one = ink("m", height_px), three = ink("m m m", height_px);
    EXPECT_EQ(inkOf(three), 3 * inkOf(one)) << height_px;
  }
  EXPECT_EQ(widthOf_px("Hallo Welt"), widthOf_px("Hallo") + widthOf_px(" ") + widthOf_px("Welt"));
  EXPECT_LT(widthOf_px("AV"), widthOf_px("A") + widthOf_px("V")) << "kerned";
  EXPECT_NEAR(ink("Hallo Welt", kMeasured_px).size_px.x, widthOf_px("Hallo Welt"), 0.2 * kMeasured_px);
}

TEST(GlyphBitmap, TakesEachLetterFromAFontThatHasIt) {
  EXPECT_EQ(lettersWithoutFont("Quantité γ β Ширина 0,5 c — “Licht”"), U"");
  EXPECT_EQ(lettersWithoutFont("a\U00013000b\U00013000"), U"\U00013000") << "an Egyptian one, once";
  const auto fonts = letterFonts();
  const bool hasJapanese = std::any_of(fonts.begin() + 1, fonts.end(), [](const LetterFont& font) {
    return std::filesystem::exists(font.file);
  });
  EXPECT_EQ(lettersWithoutFont("光は遅い。").empty(), hasJapanese);
  if (!hasJapanese) return;
  EXPECT_NEAR(widthOf_px("光は遅い"), 4 * kMeasured_px, 0.06 * kMeasured_px) << "each is a square";
  EXPECT_NE(ink("光", 40).alpha, ink("遅", 40).alpha);
  EXPECT_EQ(inkOf(ink("光c", 40)), inkOf(ink("光", 40)) + inkOf(ink("c", 40)));
}

TEST(GlyphBitmap, OfWhatIsNoTextIsABox) {
  const GlyphBitmap box = ink("\U00013000", 40);
  EXPECT_GT(inkOf(box), 0);
  EXPECT_EQ(ink("\xff", 40).alpha, ink("\uFFFD", 40).alpha) << "a byte that is no UTF-8";
}

}  // namespace
}  // namespace carom
