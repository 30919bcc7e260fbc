#include "app/toml/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>
#include <tuple>
#include <utility>

namespace carom {
namespace {

constexpr std::size_t kKeptAlike = 100, kGroup = 8, kLinesNamed = 3;

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Returns the text without quoted names and numbers.
std::string sortOf(std::string_view text) {
  std::string sort;
  sort.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t end = text[i] == '\'' ? text.find('\'', i + 1) : std::string_view::npos;
    if (end != std::string_view::npos) i = end;
    if (!isDigit(text[i])) sort += text[i];
  }
  return sort;
}

std::uint64_t hashOf(const Finding& finding) {
  return std::hash<std::string>()(finding.kind == Finding::Kind::error ? "e" + sortOf(finding.text)
                                                                       : sortOf(finding.text));
}

/// Returns the word for several of that which a text is about: "walls", "pairs of walls".
std::string_view nounOf(std::string_view text) {
  struct Noun {
    std::string_view word, several;
  };
  constexpr std::array<Noun, 16> kNouns{{{"walls", "pairs of walls"},
                                         {"tiles", "pairs of tiles"},
                                         {"wall", "walls"},
                                         {"overlaps puck", "pairs of pucks"},
                                         {"puck", "pucks"},
                                         {"body", "bodies"},
                                         {"key", "keys"},
                                         {"name", "names"},
                                         {"tracker", "trackers"},
                                         {"viewer", "viewers"},
                                         {"rank", "ranks"},
                                         {"game", "games"},
                                         {"mesh", "meshes"},
                                         {"element", "elements"},
                                         {"window", "windows"},
                                         {"text", "texts"}}};
  for (const Noun& noun : kNouns) {
    if (text.find(fmt::format("{} '", noun.word)) != std::string_view::npos) return noun.several;
  }
  return "times";
}

bool isBefore(const Finding& a, const Finding& b) {
  return std::tie(a.at.line, a.at.column) < std::tie(b.at.line, b.at.column);
}

/// Returns findings that are alike as one; they are in the order of their places.
Finding together(const std::vector<Finding>& alike) {
  Finding all = alike.front();
  all.count = 0;
  std::string lines;
  int line = all.at.line;
  std::size_t named = 0;
  for (const Finding& finding : alike) {
    all.count += finding.count;
    if (finding.at.line == line || named > kLinesNamed) continue;
    line = finding.at.line;
    lines += named++ == kLinesNamed ? ", …" : fmt::format("{}{}", named == 1 ? "" : ", ", line);
  }
  all.text =
      fmt::format("{} {}: {}{}", all.count, nounOf(all.text), all.text,
                  lines.empty() ? "" : fmt::format(" (also in line{} {})", named > 1 ? "s" : "", lines));
  return all;
}

}  // namespace

void FindingList::add(Finding finding) {
  constexpr std::size_t kLongest = 1000;  // bytes
  if (finding.text.size() > kLongest) {
    std::size_t end = kLongest;
    while (end > 0 && (finding.text[end] & 0xC0) == 0x80) --end;  // not within a letter
    finding.text.replace(end, std::string::npos, "…");
  }
  Alike& alike = alike_[hashOf(finding)];
  if (alike.kept >= kKeptAlike) {
    kept_[alike.last].count += finding.count;
    return;
  }
  const auto place =
      static_cast<std::uint64_t>(finding.at.line) << 32U ^ static_cast<std::uint64_t>(finding.at.column);
  if (!known_
           .insert(std::hash<std::string>()(finding.text) ^
                   std::hash<std::uint64_t>()(place * 0x9E3779B97F4A7C15U))
           .second)
    return;
  alike = {alike.kept + 1, kept_.size()};
  kept_.push_back(std::move(finding));
}

std::vector<Finding> toldOf(std::vector<Finding> findings) {
  std::stable_sort(findings.begin(), findings.end(), isBefore);
  std::unordered_map<std::uint64_t, std::vector<Finding>> sorts;
  for (const Finding& finding : findings) sorts[hashOf(finding)].push_back(finding);
  std::vector<Finding> told;
  for (const Finding& finding : findings) {
    std::vector<Finding>& alike = sorts[hashOf(finding)];
    if (alike.empty()) continue;  // told by the first of its sort
    std::size_t count = 0;
    for (const Finding& one : alike) count += one.count;
    if (count < kGroup) {
      told.push_back(finding);
    } else {
      told.push_back(together(alike));
      alike.clear();
    }
  }
  if (told.size() <= kMostFindings) return told;
  Finding rest{told[kMostFindings].kind, told[kMostFindings].at, {}, 0};
  for (std::size_t i = kMostFindings; i < told.size(); ++i) {
    rest.count += told[i].count;
    if (told[i].kind == Finding::Kind::error) rest.kind = Finding::Kind::error;
  }
  rest.text = fmt::format("and {} more", rest.count);
  told.resize(kMostFindings);
  told.push_back(std::move(rest));
  return told;
}

}  // namespace carom
