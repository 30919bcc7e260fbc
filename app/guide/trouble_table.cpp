#include "app/guide/trouble_table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>

#include "trouble_text.h"

namespace carom {
namespace {

using Words = Trouble::Words;

constexpr std::size_t kLongestWords = 1000;  // of a message that somebody asks for
constexpr std::size_t kMostFound = 3;
constexpr double kLeastShare = 0.5;  // of the words of the row, or of those asked for, that must agree
constexpr double kNextBest = 0.6;    // of the best row's score, for another one to be shown

/// Returns the words by which a message is known. A place in a file ("FILE:12:8:") is a word of its own; what
/// has digits or quotes, and the page's placeholders, are left out.
Words wordsOf(std::string_view message) {
  static const std::regex kPlace(R"([^\s:]+:\d+:\d+:)");
  static const std::regex kWord(R"([^\s,;:()=\[\]…]+)");
  const std::string text =
      std::regex_replace(std::string(message.substr(0, kLongestWords)), kPlace, " PLACE ");
  Words words;
  for (std::sregex_iterator found(text.begin(), text.end(), kWord), end; found != end; ++found) {
    std::string one = found->str();
    while (!one.empty() && (one.back() == '.' || one.back() == '?' || one.back() == '!')) one.pop_back();
    const bool isPlain = std::all_of(one.begin(), one.end(), [](unsigned char c) {
      return std::isalpha(c) != 0 || c == '-' || c == '_' || c == '\'';
    });
    if (!isPlain || one.empty() || one == "NAME" || one == "FILE" || one == "RIG") continue;
    if (one != "PLACE") std::transform(one.begin(), one.end(), one.begin(), ::tolower);
    words.insert(one);
  }
  return words;
}

/// How much it tells that two messages have a word in common: the rarer it is in the table, the more.
class Weights {
 public:
  explicit Weights(const std::vector<Trouble>& rows) : rows_(static_cast<double>(rows.size())) {
    for (const Trouble& row : rows) {
      Words all;
      for (const Words& message : row.words) all.insert(message.begin(), message.end());
      for (const std::string& word : all) ++uses_[word];
    }
  }
  double of(const std::string& word) const {
    const auto found = uses_.find(word);
    return std::log(1.0 + rows_ / (found == uses_.end() ? 1.0 : found->second));
  }
  double of(const Words& words) const {
    double sum = 0.0;
    for (const std::string& word : words) sum += of(word);
    return sum;
  }

 private:
  double rows_;
  std::map<std::string, double> uses_;
};

/// Returns how alike a message of the table and the words asked for are; 0 if less than half of either
/// agrees.
double likeness(const Words& message, const Words& asked, const Weights& weights) {
  Words common;
  std::set_intersection(message.begin(), message.end(), asked.begin(), asked.end(),
                        std::inserter(common, common.end()));
  const double agrees = weights.of(common);
  const double share = std::max(agrees / weights.of(message), agrees / weights.of(asked));
  return share >= kLeastShare ? agrees * share : 0.0;
}

/// Returns the cells of a table's row, without the marks of the page's format; empty if the line is none.
std::vector<std::string> cellsOf(const std::string& line) {
  if (!line.starts_with("| ")) return {};
  std::vector<std::string> cells;
  for (std::size_t from = 2, to = 0; (to = line.find(" |", from)) != std::string::npos; from = to + 3)
    cells.push_back(line.substr(from, to - from));
  return cells;
}

std::string plain(const std::string& cell) {
  const std::regex toPlace(R"(\[([^\]]*)\]\(#[^)]*\))"), toPage(R"(\[([^\]]*)\]\(([^)#]*)[^)]*\))"),
      marks(R"([`*])");
  const std::string withoutLinks =
      std::regex_replace(std::regex_replace(cell, toPlace, "$1"), toPage, "$1 ($2)");
  return std::regex_replace(withoutLinks, marks, "");
}

}  // namespace

std::vector<Trouble> troublesOf(std::string_view page) {
  std::vector<Trouble> rows;
  std::string header;
  for (std::size_t from = 0, to = 0; from < page.size(); from = to + 1) {
    to = std::min(page.find('\n', from), page.size());
    const std::vector<std::string> cells = cellsOf(std::string(page.substr(from, to - from)));
    if (!cells.empty() && cells[0] == "---") continue;
    if (cells.size() != 2) {
      header.clear();
      continue;
    }
    if (std::exchange(header, cells[0]).empty()) continue;  // the names of the columns
    Trouble row{plain(cells[0]), plain(cells[1]), {}, {}};
    const std::regex code("`([^`]*)`");
    for (std::sregex_iterator found(cells[0].begin(), cells[0].end(), code), end; found != end; ++found)
      row.messages.push_back((*found)[1].str());
    if (row.messages.empty()) row.messages.push_back(row.says);
    for (const std::string& message : row.messages) row.words.push_back(wordsOf(message));
    rows.push_back(std::move(row));
  }
  return rows;
}

const std::vector<Trouble>& troubles() {
  static const std::vector<Trouble> rows = troublesOf(kTroubleText);
  return rows;
}

std::vector<const Trouble*> nearestTroubles(const std::vector<Trouble>& rows, std::string_view words) {
  const Weights weights(rows);
  const Words asked = wordsOf(words);
  std::vector<std::pair<double, const Trouble*>> found;
  for (const Trouble& row : rows) {
    double most = 0.0;
    for (const Words& message : row.words) most = std::max(most, likeness(message, asked, weights));
    if (most > 0.0) found.emplace_back(most, &row);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const Trouble*> best;
  for (const auto& [score, row] : found) {
    if (best.size() < kMostFound && score >= kNextBest * found.front().first) best.push_back(row);
  }
  return best;
}

}  // namespace carom
