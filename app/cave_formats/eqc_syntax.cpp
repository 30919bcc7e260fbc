#include "app/cave_formats/eqc_syntax.h"

#include <fmt/format.h>

#include <algorithm>

namespace carom {
namespace {

constexpr std::size_t kDeepestSection = 32, kMostEqcParts = 100'000;
constexpr std::string_view kApart = " \t\r\n{}[]()\"#";

struct Token {
  enum class Kind { end, word, text, open, close, openList, closeList };
  Kind kind = Kind::end;
  std::string_view text;
  std::size_t at = 0;
};

class EqcParser {
 public:
  EqcParser(const std::filesystem::path& file, std::string_view text)
      : file_(file), text_(text), lines_(text) {}

  Part parse() {
    Part root;
    next();
    readParts(root, 0, 0);
    return root;
  }

 private:
  [[noreturn]] void refuse(std::size_t at, const std::string& what) const {
    const FilePlace place = lines_.at(std::min(at, text_.size()));
    throw InputErrors({InputError(file_.string(), place.line, place.column, what)});
  }
  std::string shownToken() const { return printable(std::string(token_.text.substr(0, 40))); }

  void next() {
    while (at_ < text_.size()) {
      at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
      if (at_ == text_.size() || text_[at_] != '#') break;
      at_ = std::min(text_.find('\n', at_), text_.size());
    }
    if (at_ >= text_.size()) {
      token_ = {Token::Kind::end, "", text_.size()};
      return;
    }
    const std::size_t begin = at_;
    const auto single = [&](Token::Kind kind) {
      ++at_;
      token_ = {kind, text_.substr(begin, 1), begin};
    };
    switch (text_[begin]) {
      case '{':
        return single(Token::Kind::open);
      case '}':
        return single(Token::Kind::close);
      case '[':
      case '(':
        return single(Token::Kind::openList);
      case ']':
      case ')':
        return single(Token::Kind::closeList);
      case '"': {
        const std::size_t end = text_.find('"', begin + 1);
        if (end == std::string_view::npos) refuse(begin, "this text has no closing quote");
        at_ = end + 1;
        token_ = {Token::Kind::text, text_.substr(begin + 1, end - begin - 1), begin};
        return;
      }
      default:
        at_ = std::min(text_.find_first_of(kApart, begin), text_.size());
        token_ = {Token::Kind::word, text_.substr(begin, at_ - begin), begin};
    }
  }

  void count(std::size_t at) {
    if (++parts_ > kMostEqcParts)
      refuse(at, fmt::format("too many values, expected at most {}", kMostEqcParts));
  }

  /// Reads names with what follows each, up to the closing brace of the section that opened at `open`.
  void readParts(Part& whole, std::size_t depth, std::size_t open) {
    if (depth > kDeepestSection) refuse(open, "sections are nested too deep, expected at most 32");
    for (; token_.kind != Token::Kind::close || depth == 0;) {
      if (token_.kind == Token::Kind::end) {
        if (depth == 0) return;
        const FilePlace from = lines_.at(open);
        refuse(text_.size(),
               fmt::format("the file ends within the section of line {}, expected '}}'", from.line));
      }
      if (token_.kind != Token::Kind::word)
        refuse(token_.at, fmt::format("'{}' stands where a name was expected", shownToken()));
      const FilePlace at = lines_.at(token_.at);
      Part part{std::string(token_.text), {}, at, at};
      count(token_.at);
      next();
      readValue(part, depth);
      whole.parts.push_back(std::move(part));
    }
    next();
  }

  void readValue(Part& part, std::size_t depth) {
    const std::size_t begin = token_.at;
    part.textAt = lines_.at(begin);
    switch (token_.kind) {
      case Token::Kind::open:
        next();
        return readParts(part, depth + 1, begin);
      case Token::Kind::openList:
        return readList(part);
      case Token::Kind::word:
      case Token::Kind::text:
        part.text = std::string(token_.text);
        return next();
      case Token::Kind::end:
        refuse(begin, fmt::format("the file ends within {} of line {}, expected its value",
                                  printable(part.name.substr(0, 40)), part.at.line));
      default:
        refuse(begin, fmt::format("{} has no value, expected a number, a text, a list or a section",
                                  printable(part.name.substr(0, 40))));
    }
  }

  void readList(Part& part) {
    const std::size_t open = token_.at;
    for (next(); token_.kind != Token::Kind::closeList; next()) {
      if (token_.kind == Token::Kind::end)
        refuse(text_.size(),
               fmt::format("the file ends within the list of line {}, expected ']'", lines_.at(open).line));
      if (token_.kind != Token::Kind::word && token_.kind != Token::Kind::text)
        refuse(token_.at, fmt::format("'{}' stands in a list, expected numbers or words", shownToken()));
      count(token_.at);
      const FilePlace at = lines_.at(token_.at);
      part.parts.push_back({"", std::string(token_.text), at, at});
    }
    next();
  }

  const std::filesystem::path& file_;
  std::string_view text_;
  LineIndex lines_;
  std::size_t at_ = 0, parts_ = 0;
  Token token_;
};

}  // namespace

Part readEqcParts(const std::filesystem::path& file) {
  const std::string text = readText(file, InputKind::xml);
  return EqcParser(file, text).parse();
}

}  // namespace carom
