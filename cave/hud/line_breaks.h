#pragma once
// Text in lines: broken where the Unicode Standard allows it (Annex 14, by libunibreak), by the number of
// their columns and by the width of their letters.
//
// Words stay whole where they can: a line ends behind a blank, or beside a letter of East Asia, which need no
// blanks; behind a hyphen or a slash within a word only if the line has no other end; between two letters of
// a word only if the word alone is wider than the line. A number and its unit stay together, as in "0.6 c".

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace carom {

/// The room that a line has.
struct LineRoom {
  std::size_t columns = 1;
  double width_em = 0.0;  ///< in the nominal height of the letters
};

/// Returns how many columns a text has: two for a wide letter of East Asia (Unicode Standard Annex 11), none
/// for a mark that stands over another letter, else one.
std::size_t columnsOf(std::string_view text);

/// Returns the width of a text, the sum of its letters' (cave/gl/glyph_bitmap.h), in their nominal height.
double widthOf_em(std::string_view text);

/// Takes the lines of a text one by one. Its memory is reused for the next text.
class LineBreaker {
 public:
  /// Begins a text in UTF-8, which must outlive the lines. A byte that is no UTF-8 is a letter.
  void begin(std::string_view text);

  bool isAtEnd() const { return next_ == signs_.size(); }
  /// Takes the next line, without blanks at its ends: as much of the text as the room holds, at least one
  /// letter. It is empty only if nothing but blanks is left, or between two line feeds.
  std::string_view take(const LineRoom& room);

 private:
  enum class End : std::uint8_t { no, inWord, yes, must };  ///< whether a line may end behind a sign
  struct Sign {
    std::size_t begin = 0;  ///< byte
    char32_t code = 0;
    End end = End::no;
    bool isBlank() const { return code == U' ' || code == U'\n' || code == U'\r' || code == U'\t'; }
  };
  void findEnds();
  std::size_t endOfLine(const LineRoom& room) const;

  std::string_view text_;
  std::vector<Sign> signs_;
  std::size_t next_ = 0;  ///< the sign with which the next line begins
  std::vector<std::uint32_t> codes_;
  std::vector<char> allowed_;
};

}  // namespace carom
