#include "app/toml/toml_scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace carom {
namespace {

/// Goes through a text and knows what stands in quotes and comments.
class TomlScan {
 public:
  explicit TomlScan(std::string_view text) : text_(text) {}

  std::optional<Finding> run() {
    std::optional<Finding> fault;
    for (std::size_t i = text_.starts_with("\xEF\xBB\xBF") ? 3 : 0; i < text_.size() && !fault;) {
      const std::size_t length = quote_.empty() ? outside(text_.substr(i), fault) : inside(text_.substr(i));
      for (const char c : text_.substr(i, length)) place_.column += (c & 0xC0) == 0x80 ? 0 : 1;
      if (text_[i] == '\n') place_ = {place_.line + 1, 1};
      i += length;
    }
    return fault;
  }

 private:
  /// Returns the number of bytes of this step, all in one line.
  std::size_t outside(std::string_view rest, std::optional<Finding>& fault) {
    const char c = rest[0];
    if (static_cast<unsigned char>(c) >= 0x80)
      return refuse(fault, "a letter beyond ASCII, expected it in quotes or in a comment only");
    if (c == '#') quote_ = "\n";
    for (const std::string_view mark : {"\"\"\"", "'''", "\"", "'"}) {
      if (!rest.starts_with(mark)) continue;
      quote_ = mark;
      return mark.size();
    }
    count(c);
    if (depth_ > kDeepestToml || dots_ > kDeepestToml)
      return refuse(fault, fmt::format("values are nested too deep, expected at most {}", kDeepestToml));
    if (values_ > kMostTomlValues)
      return refuse(fault, fmt::format("too many values, expected at most {}", kMostTomlValues));
    return 1;
  }

  /// Counts values, the depth of brackets, and the parts of a dotted key: a value has one dot at most.
  void count(char c) {
    constexpr std::string_view kEnds = "=,[]{}\n";
    if (c == '[' || c == '{') ++depth_;
    if ((c == ']' || c == '}') && depth_ > 0) --depth_;
    values_ += c == '[' || c == '{' || c == ',' || c == '=' || c == '.' ? 1 : 0;
    if (c == '.') ++dots_;
    if (kEnds.find(c) != std::string_view::npos) dots_ = 0;
  }

  std::size_t inside(std::string_view rest) {
    std::size_t length = 1;
    if (rest[0] == '\\' && quote_[0] == '"' && rest.size() > 1 && rest[1] != '\n') return 2;
    if (rest.starts_with(quote_)) {
      if (quote_ == "\n") dots_ = 0;
      length = quote_.size();
      while (quote_.size() == 3 && length < 5 && length < rest.size() && rest[length] == quote_[0]) ++length;
      quote_ = {};
    } else if (rest[0] == '\n' && quote_.size() == 1) {
      quote_ = {};
      dots_ = 0;
    }
    return length;
  }

  std::size_t refuse(std::optional<Finding>& fault, std::string why) const {
    fault = Finding{Finding::Kind::error, place_, std::move(why)};
    return 0;
  }

  std::string_view text_;
  std::string_view quote_;  // delimiter that ends the current string; "\n" in a comment; empty outside both
  FilePlace place_;
  std::size_t depth_ = 0, dots_ = 0, values_ = 0;
};

}  // namespace

std::optional<Finding> faultBeforeParsing(std::string_view text) { return TomlScan(text).run(); }

}  // namespace carom
