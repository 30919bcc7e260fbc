#pragma once
// The words and numbers of a text file with a mesh, line by line, and the faults of all files with meshes.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace carom {

/// Throws std::runtime_error, "LINE:COLUMN: message".
[[noreturn]] void meshFault(std::size_t line, std::size_t column, const std::string& message);

/// Returns the number that a text is, all of it, with or without a sign; none otherwise.
std::optional<double> numberIn(std::string_view text);
std::optional<std::size_t> countIn(std::string_view text);

class MeshLines {
 public:
  /// `blanks`: what stands between words. `content` must outlive this.
  explicit MeshLines(std::string_view content, std::string_view blanks = " \t\r\f\v")
      : left_(content), blanks_(blanks) {}

  /// Goes to the next line; returns whether there is one.
  bool next();
  /// Goes to the next line that has a word; returns whether there is one.
  bool nextWithWords();
  /// Returns the line's next word, or an empty one at its end.
  std::string_view word();
  /// Returns the next word as a number of at most `farthest` in magnitude; none other is finite. Throws a
  /// fault at the word otherwise.
  double number(double farthest);
  /// Throws a fault at the next word, if there is one.
  void endLine();
  /// Throws a fault at the last word.
  [[noreturn]] void wrong(std::string_view text, const std::string& expected) const;

  std::size_t lineNumber() const { return number_; }
  /// Returns the text after the lines read so far.
  std::string_view rest() const { return left_; }

 private:
  std::string_view left_, blanks_, line_;
  std::size_t number_ = 0, at_ = 0, wordAt_ = 0;
};

}  // namespace carom
