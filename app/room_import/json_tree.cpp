#include "app/room_import/json_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

namespace carom {

namespace {

constexpr std::size_t kDeepestJson = 32, kMostValues = 100'000, kShown = 40;

/// Iterates over the text and counts in `*read` the characters that any copy has passed, which is where the
/// parser's newest token ends.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* read) : at_(at), read_(read) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    ++*read_;
    return *this;
  }
  CountingIterator operator++(int) {
    const CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  std::size_t* read_;
};

/// Builds the tree from nlohmann's events. Each token begins at the first character after the previous one
/// that is neither white space, comma nor colon.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, const std::size_t& read) : text_(text), read_(read), lines_(text) {}

  JsonNode root;
  std::optional<std::pair<FilePlace, std::string>> fault;

  bool null() override { return add({.kind = JsonNode::Kind::null}); }
  bool boolean(bool value) override { return add({.kind = JsonNode::Kind::flag, .flag = value}); }
  bool number_integer(number_integer_t value) override { return addWhole(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return addWhole(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) override {
    return add({.kind = JsonNode::Kind::number, .number = value});
  }
  bool string(string_t& value) override { return add({.kind = JsonNode::Kind::text, .text = value}); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return enter(JsonNode::Kind::object); }
  bool start_array(std::size_t) override { return enter(JsonNode::Kind::array); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }
  bool key(string_t& value) override {
    keyAt_ = beginOfToken();
    key_ = value;
    return true;
  }
  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::json::exception& error) override {
    // Also called for numbers beyond the range of double: out_of_range.
    const bool tooLarge = error.id == 406;
    const std::size_t end = std::min(std::max<std::size_t>(position, 1), text_.size() + 1) - 1;
    const FilePlace at = tooLarge ? beginOfToken() : lines_.at(end);
    const std::string shown = printable(token.substr(0, kShown));
    if (tooLarge) {
      fault = {at, fmt::format("the number {} is too large, expected one that can be counted with", shown)};
    } else if (position > text_.size() && open_ > 0) {
      const JsonNode& last = current();
      fault = {at, fmt::format("the file ends within {}{} of line {}, expected '{}'", last.words(),
                               last.key.empty() ? "" : fmt::format(" '{}'", printable(last.key)),
                               last.at.line, last.kind == JsonNode::Kind::array ? ']' : '}')};
    } else {
      fault = {at, fmt::format("this is no JSON at '{}', expected a value, a comma or a bracket", shown)};
    }
    return false;
  }

 private:
  FilePlace beginOfToken() {
    const std::size_t begin = std::min(text_.find_first_not_of(" \t\r\n,:", previousEnd_), text_.size());
    previousEnd_ = read_;
    return lines_.at(begin);
  }
  JsonNode& current() {
    JsonNode* node = &root;
    for (const std::size_t child : path_) node = &node->children[child];
    return *node;
  }
  bool addWhole(double value) { return add({.kind = JsonNode::Kind::whole, .number = value}); }
  bool add(JsonNode node) {
    node.at = beginOfToken();
    if (++values_ > kMostValues) {
      fault = {node.at, fmt::format("too many values, expected at most {}", kMostValues)};
      return false;
    }
    if (open_ == 0) {
      root = std::move(node);
      return true;
    }
    JsonNode& parent = current();
    if (parent.kind == JsonNode::Kind::object) {
      node.key = std::move(key_);
      node.keyAt = keyAt_;
    }
    parent.children.push_back(std::move(node));
    return true;
  }
  bool enter(JsonNode::Kind kind) {
    if (open_ >= kDeepestJson) {
      fault = {beginOfToken(), "values are nested too deep, expected at most 32"};
      return false;
    }
    if (!add({.kind = kind})) return false;
    if (open_++ > 0) path_.push_back(current().children.size() - 1);
    return true;
  }
  bool leave() {
    beginOfToken();
    --open_;
    if (!path_.empty()) path_.pop_back();
    return true;
  }

  std::string_view text_;
  const std::size_t& read_;
  LineIndex lines_;
  std::size_t previousEnd_ = 0;
  std::vector<std::size_t> path_;  // from the root to the open node, as indices among children
  std::size_t open_ = 0, values_ = 0;
  std::string key_;
  FilePlace keyAt_;
};

/// Replaces comments outside texts by blanks, so that all else keeps its place.
void blankComments(std::string& text) {
  bool isText = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') isText = !isText;
    if (isText) {
      if (text[i] == '\\') ++i;
      if (i < text.size() && text[i] == '\n') isText = false;  // no text of JSON goes on in another line
      continue;
    }
    if (text[i] != '/' || i + 1 == text.size() || (text[i + 1] != '/' && text[i + 1] != '*')) continue;
    const bool isLine = text[i + 1] == '/';
    const std::size_t found = isLine ? text.find('\n', i) : text.find("*/", i + 2);
    const std::size_t end = found == std::string::npos ? text.size() : found + (isLine ? 0 : 2);
    for (; i < end; ++i) {
      if (text[i] != '\n') text[i] = ' ';
    }
    --i;
  }
}

JsonNode parseJson(const std::filesystem::path& file, const std::string& text) {
  std::size_t read = 0;
  TreeBuilder builder(text, read);
  const bool sound = nlohmann::json::sax_parse(CountingIterator(text.data(), &read),
                                               CountingIterator(text.data() + text.size(), &read), &builder);
  if (sound) return std::move(builder.root);
  const auto [at, what] = builder.fault.value_or(std::pair(FilePlace{}, std::string("this is no JSON")));
  throw InputErrors({InputError(file.string(), at.line, at.column, what)});
}

}  // namespace

const JsonNode* JsonNode::member(std::string_view wanted) const {
  const auto found = std::find_if(children.rbegin(), children.rend(),
                                  [&](const JsonNode& child) { return child.key == wanted; });
  return found == children.rend() ? nullptr : &*found;
}

std::string JsonNode::words() const {
  switch (kind) {
    case Kind::null:
      return "null";
    case Kind::flag:
      return flag ? "true" : "false";
    case Kind::whole:
    case Kind::number:
      return fmt::format("{}", number);
    case Kind::text:
      return fmt::format("the text '{}'", printable(text));
    case Kind::array:
      return "an array";
    case Kind::object:
      break;
  }
  return "an object";
}

JsonNode readJson(const std::filesystem::path& file) {
  return parseJson(file, readText(file, InputKind::json));
}

JsonNode readJsonWithComments(const std::filesystem::path& file) {
  std::string text = readText(file, InputKind::json);
  blankComments(text);
  return parseJson(file, text);
}

}  // namespace carom
