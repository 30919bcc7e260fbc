#include "app/toml/input_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace carom {

namespace {

/// Returns the least number of letters to add, drop, change or swap with a neighbour to make `a` into `b`.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

InputErrors::InputErrors(std::vector<InputError> faults)
    : InputError(faults.front()), faults_(std::move(faults)) {}

LineIndex::LineIndex(std::string_view text) {
  begins_.reserve(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1);
  begins_.push_back(0);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') begins_.push_back(static_cast<std::uint32_t>(i + 1));
  }
}

FilePlace LineIndex::at(std::size_t offset) const {
  const auto next = std::upper_bound(begins_.begin(), begins_.end(), offset);
  return {static_cast<int>(next - begins_.begin()), static_cast<int>(offset - *std::prev(next)) + 1};
}

std::optional<double> wholeNumber(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const auto [stop, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || stop != text.data() + text.size()) return {};
  return value;
}

std::string readText(const std::filesystem::path& file, InputKind kind) {
  try {
    return contentOf(file, kind);
  } catch (const InputError& error) {
    throw InputErrors({error});
  }
}

std::optional<std::string_view> nearestWord(std::string_view mistyped, std::span<const std::string> known) {
  constexpr std::size_t kLongestWord = 64;
  std::optional<std::string_view> nearest;
  std::size_t least = std::max<std::size_t>(2, mistyped.size() / 3) + 1;
  for (const std::string& word : known) {
    if (mistyped.size() > kLongestWord) break;
    // A forgotten or added unit (length for length_m) counts as near, however short the word.
    const bool prefix = word.starts_with(mistyped) || mistyped.starts_with(word);
    const std::size_t distance = prefix ? 1 : editDistance(mistyped, word);
    if (distance < least && distance < word.size()) {
      least = distance;
      nearest = word;
    }
  }
  return nearest;
}

}  // namespace carom
