#include "cave/hud/line_breaks.h"

#include <algorithm>

#include <glib.h>

#include "cave/gl/glyph_bitmap.h"
#include "engine/text/code_points.h"

extern "C" {
#include <linebreak.h>
}

namespace carom {
namespace {

constexpr char32_t kReplacement = 0xFFFD;
constexpr char32_t kIteration = U'々';  // begins no line

/// Returns whether a letter is a small kana or the sign of a long vowel. Whether a line may begin with them
/// is for an application to say (class CJ of the annex, section 5.1); in strict typography it may not.
bool beginsNoLine(char32_t code) {
  return g_unichar_break_type(code) == G_UNICODE_BREAK_CONDITIONAL_JAPANESE_STARTER;
}

/// Returns the first letter of a text that is not empty, and takes it.
char32_t taken(std::string_view& text) { return takeCodePoint(text).value_or(kReplacement); }

bool isDigit(char32_t code) { return code >= U'0' && code <= U'9'; }
bool isSmallLetter(char32_t code) { return code >= U'a' && code <= U'z'; }
bool isMark(char32_t code) { return g_unichar_iszerowidth(code) != 0; }
bool isWide(char32_t code) { return g_unichar_iswide(code) != 0; }
std::size_t columnsOf(char32_t code) { return isMark(code) ? 0 : isWide(code) ? 2 : 1; }
double widthOf_em(char32_t code) { return static_cast<double>(advanceOf_px(code)) / kMeasured_px; }

}  // namespace

std::size_t columnsOf(std::string_view text) {
  std::size_t columns = 0;
  while (!text.empty()) columns += columnsOf(taken(text));
  return columns;
}

double widthOf_em(std::string_view text) {
  double width = 0.0;
  while (!text.empty()) width += widthOf_em(taken(text));
  return width;
}

void LineBreaker::begin(std::string_view text) {
  text_ = text;
  next_ = 0;
  signs_.clear();
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t at = text.size() - rest.size();
    signs_.push_back({at, taken(rest)});
  }
  findEnds();
  while (!isAtEnd() && signs_[next_].isBlank()) ++next_;
}

void LineBreaker::findEnds() {
  [[maybe_unused]] static const bool isReady = (init_linebreak(), true);
  codes_.clear();
  for (const Sign& sign : signs_) codes_.push_back(beginsNoLine(sign.code) ? kIteration : sign.code);
  allowed_.resize(codes_.size());
  set_linebreaks_utf32(codes_.data(), codes_.size(), nullptr, allowed_.data());
  for (std::size_t i = 0; i + 1 < signs_.size(); ++i) {
    const char32_t before = i > 0 ? signs_[i - 1].code : 0, here = signs_[i].code, after = signs_[i + 1].code;
    const bool unitFollows = here == U' ' && isDigit(before) && isSmallLetter(after) &&
                             !(i + 2 < signs_.size() && isSmallLetter(signs_[i + 2].code));
    if (allowed_[i] == LINEBREAK_MUSTBREAK) {
      signs_[i].end = End::must;
    } else if (allowed_[i] == LINEBREAK_ALLOWBREAK && !unitFollows) {
      signs_[i].end = signs_[i].isBlank() || isWide(here) || isWide(after) ? End::yes : End::inWord;
    }
  }
}

/// Returns the sign behind the last one of the line.
std::size_t LineBreaker::endOfLine(const LineRoom& room) const {
  std::size_t columns = 0, whole = next_, part = next_, letters = next_;
  double width_em = 0.0;
  for (std::size_t i = next_; i < signs_.size(); ++i) {
    const Sign& sign = signs_[i];
    columns += columnsOf(sign.code);
    width_em += widthOf_em(sign.code);
    const bool fits = columns <= room.columns && width_em <= room.width_em;
    // Blanks at a line's end need no room.
    if (!fits && !sign.isBlank())
      return whole > next_ ? whole : part > next_ ? part : std::max(letters, next_ + 1);
    if (sign.end == End::must) return i + 1;
    if (sign.end == End::yes) whole = i + 1;
    if (sign.end == End::inWord) part = i + 1;
    if (i + 1 < signs_.size() && !isMark(signs_[i + 1].code)) letters = i + 1;
  }
  return signs_.size();
}

std::string_view LineBreaker::take(const LineRoom& room) {
  if (isAtEnd()) return {};
  const std::size_t begin = next_;
  next_ = endOfLine(room);
  std::size_t end = next_;
  while (end > begin && signs_[end - 1].isBlank()) --end;
  const bool isForced = signs_[next_ - 1].end == End::must;
  while (!isForced && !isAtEnd() && signs_[next_].isBlank()) ++next_;
  const auto byteOf = [&](std::size_t sign) {
    return sign < signs_.size() ? signs_[sign].begin : text_.size();
  };
  return text_.substr(byteOf(begin), byteOf(end) - byteOf(begin));
}

}  // namespace carom
