#pragma once
// Words and numbers of mesh files, and where they stand.

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "engine/text/input_error.h"

namespace carom {

/// A word of the file; empty beyond its end.
struct Word {
  std::string_view text;
  std::size_t at = 0;  ///< byte in the file
};

/// Returns the beginning of a word in printable form.
std::string shown(std::string_view text);

/// Reads a file word by word or line by line.
class Words {
 public:
  Words(const std::string& path, std::string_view content) : path_(path), content_(content) {}

  /// Returns the next word, on any line.
  Word next() {
    while (at_ < content_.size() && isBlank(content_[at_])) ++at_;
    return take();
  }
  /// Returns the next word of this line, or an empty one at its end.
  Word nextInLine() {
    while (at_ < content_.size() && content_[at_] != '\n' && isBlank(content_[at_])) ++at_;
    return take();
  }
  void skipLine() {
    while (at_ < content_.size() && content_[at_] != '\n') ++at_;
    if (at_ < content_.size()) ++at_;
  }
  bool atEnd() const { return at_ >= content_.size(); }
  std::size_t at() const { return at_; }
  std::size_t left() const { return content_.size() - at_; }

  [[noreturn]] void fault(const Word& word, const std::string& message) const {
    const std::string_view before = content_.substr(0, std::min(word.at, content_.size()));
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t lineStart = before.rfind('\n') + 1;  // npos + 1 is 0
    throw InputError(path_, static_cast<int>(lines) + 1, static_cast<int>(before.size() - lineStart) + 1,
                     message);
  }

  double number(const Word& word) const {
    double value = 0.0;
    if (!whole(word, value) || !std::isfinite(value)) fault(word, wrong(word, "a finite number"));
    return value;
  }
  long long integer(const Word& word, long long least, long long most, const char* what) const {
    long long value = 0;
    if (!whole(word, value) || value < least || value > most) {
      fault(word, wrong(word, fmt::format("{} from {} to {}", what, least, most)));
    }
    return value;
  }
  /// Returns a count of items that take at least one byte each.
  std::size_t count(const Word& word) const {
    return static_cast<std::size_t>(
        integer(word, 0, static_cast<long long>(content_.size()), "a count that this file has room for,"));
  }

 private:
  static bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
  }
  Word take() {
    const std::size_t from = at_;
    while (at_ < content_.size() && !isBlank(content_[at_])) ++at_;
    return {content_.substr(from, at_ - from), from};
  }
  template <typename Number>
  static bool whole(const Word& word, Number& value) {
    std::string_view text = word.text;
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [stop, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
    return failed == std::errc() && stop == text.data() + text.size();
  }
  static std::string wrong(const Word& word, const std::string& expected) {
    if (word.text.empty()) return "something is missing here, expected " + expected;
    return fmt::format("'{}' is wrong, expected {}", shown(word.text), expected);
  }

  std::string path_;
  std::string_view content_;
  std::size_t at_ = 0;
};

/// Returns the number in the bytes from `at` on.
template <typename Number>
Number numberAt(std::string_view content, std::size_t at, bool bigEndian = false) {
  std::array<char, sizeof(Number)> bytes{};
  std::memcpy(bytes.data(), content.data() + at, sizeof(Number));
  if (bigEndian) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

}  // namespace carom
