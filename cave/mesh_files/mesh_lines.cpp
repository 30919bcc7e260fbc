#include "cave/mesh_files/mesh_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace carom {
namespace {

/// Returns the beginning of a text in printable form.
std::string shown(std::string_view text) {
  std::string printable(text.substr(0, 40));
  std::replace_if(
      printable.begin(), printable.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  return printable;
}

template <typename Number>
std::optional<Number> whole(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number value{};
  const auto [stop, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || stop != text.data() + text.size()) return {};
  return value;
}

}  // namespace

void meshFault(std::size_t line, std::size_t column, const std::string& message) {
  throw std::runtime_error(fmt::format("{}:{}: {}", line, column, message));
}

std::optional<double> numberIn(std::string_view text) { return whole<double>(text); }
std::optional<std::size_t> countIn(std::string_view text) { return whole<std::size_t>(text); }

bool MeshLines::next() {
  if (left_.empty()) return false;
  const std::size_t end = std::min(left_.find('\n'), left_.size());
  line_ = left_.substr(0, end);
  left_.remove_prefix(std::min(end + 1, left_.size()));
  ++number_;
  at_ = 0;
  return true;
}

bool MeshLines::nextWithWords() {
  while (next()) {
    if (line_.find_first_not_of(blanks_) != std::string_view::npos) return true;
  }
  return false;
}

std::string_view MeshLines::word() {
  wordAt_ = std::min(line_.find_first_not_of(blanks_, at_), line_.size());
  at_ = std::min(line_.find_first_of(blanks_, wordAt_), line_.size());
  return line_.substr(wordAt_, at_ - wordAt_);
}

double MeshLines::number(double farthest) {
  const std::string_view text = word();
  const auto value = numberIn(text);
  if (!value || !(std::abs(*value) <= farthest))  // nor NaN
    wrong(text, fmt::format("a number from {:g} to {:g}", -farthest, farthest));
  return *value;
}

void MeshLines::endLine() {
  if (const std::string_view more = word(); !more.empty()) wrong(more, "the line's end");
}

void MeshLines::wrong(std::string_view text, const std::string& expected) const {
  meshFault(number_, wordAt_ + 1,
            text.empty() ? "something is missing here, expected " + expected
                         : fmt::format("'{}' is wrong, expected {}", shown(text), expected));
}

}  // namespace carom
