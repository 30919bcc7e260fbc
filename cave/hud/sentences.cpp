#include "cave/hud/sentences.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cave/hud/line_breaks.h"

namespace carom {
namespace {

constexpr std::string_view kEndsInEastAsia = "。";

/// Returns the text without blanks at its ends.
std::string_view trimmed(std::string_view text) {
  const std::size_t from = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(from, text.find_last_not_of(' ') + 1 - from);
}

/// Returns how many bytes of a sentence's end stand at the beginning of this text; 0: it does not end here.
std::size_t endAt(std::string_view text) {
  constexpr std::array<std::string_view, 5> kQuotes{"\"", "”", "“", "»", ")"};
  if (text.starts_with(kEndsInEastAsia)) return kEndsInEastAsia.size();
  if (std::string_view(".?!").find(text.front()) == std::string_view::npos) return 0;
  std::size_t end = 1;
  for (bool goesOn = true; goesOn;) {
    goesOn = false;
    for (const std::string_view quote : kQuotes) {
      if (!text.substr(end).starts_with(quote)) continue;
      end += quote.size();
      goesOn = true;
    }
  }
  const std::string_view behind = text.substr(end);
  if (!behind.starts_with(' ')) return 0;
  const std::size_t next = behind.find_first_not_of(' ');
  const bool isSmall = next != std::string_view::npos && behind[next] >= 'a' && behind[next] <= 'z';
  return isSmall ? 0 : end;
}

}  // namespace

std::vector<std::string_view> sentencesOf(std::string_view text) {
  std::vector<std::string_view> sentences;
  const auto add = [&](std::string_view sentence) {
    if (!trimmed(sentence).empty()) sentences.push_back(trimmed(sentence));
  };
  std::size_t begin = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::size_t end = endAt(text.substr(at));
    if (end == 0) continue;
    add(text.substr(begin, at + end - begin));
    begin = at + end;
    at = begin - 1;
  }
  add(text.substr(begin));
  return sentences;
}

double standsFor_s(std::string_view sentence) {
  constexpr double kLook_s = 2.0, kPerColumn_s = 0.08;
  return kLook_s + kPerColumn_s * static_cast<double>(columnsOf(sentence));
}

std::size_t sentenceAt(const std::vector<std::string_view>& sentences, double since_s) {
  double all_s = 0.0;
  for (const std::string_view sentence : sentences) all_s += standsFor_s(sentence);
  if (sentences.empty()) return 0;
  double left_s = std::fmod(std::max(since_s, 0.0), all_s);
  std::size_t at = 0;
  while (at + 1 < sentences.size() && left_s >= standsFor_s(sentences[at]))
    left_s -= standsFor_s(sentences[at++]);
  return at;
}

}  // namespace carom
