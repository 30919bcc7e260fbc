#include "app/languages/glossary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "app/languages/letters.h"
#include "app/toml/findings.h"
#include "engine/text/code_points.h"

namespace carom {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

GlossaryTerm termOf(std::string_view english, std::string_view words) {
  GlossaryTerm term{wordsOf(english), {}, {}};
  std::erase(term.english, std::u32string());
  std::size_t end = std::min(words.find('|'), words.size());  // the translation may have a comma
  term.line = fmt::format("{} = {}", english, trimmed(words.substr(0, end)));
  while (!words.empty()) {
    if (const auto word = trimmed(words.substr(0, end)); !word.empty()) term.words.push_back(folded(word));
    words.remove_prefix(std::min(end + 1, words.size()));
    end = std::min(words.find_first_of("|,"), words.size());
  }
  return term;
}

/// Returns whether a word of a text is one of a term; of the last one, the plural with s too.
bool isWord(const std::u32string& word, const std::u32string& ofTerm, bool isLast) {
  return word == ofTerm || (isLast && (word == ofTerm + U"s" || word == ofTerm + U"es"));
}

/// Returns whether a term's words stand in a text at a place.
bool standsAt(const std::vector<std::u32string>& text, std::size_t place, const GlossaryTerm& term) {
  if (place + term.english.size() > text.size()) return false;
  for (std::size_t i = 0; i < term.english.size(); ++i) {
    if (!isWord(text[place + i], term.english[i], i + 1 == term.english.size())) return false;
  }
  return true;
}

}  // namespace

Glossary Glossary::read(const std::filesystem::path& file) {
  const std::string content = readText(file, InputKind::glossary);
  Glossary glossary;
  std::vector<InputError> faults;
  std::string_view rest = content;
  for (int number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.empty() || line.starts_with('#')) continue;
    const std::size_t sign = line.find('=');
    GlossaryTerm term = sign == std::string_view::npos
                            ? GlossaryTerm{}
                            : termOf(trimmed(line.substr(0, sign)), line.substr(sign + 1));
    if ((term.english.empty() || term.words.empty()) && faults.size() < kMostFindings) {
      faults.emplace_back(file.string(), number, 1,
                          "a line without a term, expected: english = translation | stem, stem");
    }
    glossary.terms_.push_back(std::move(term));
  }
  if (!faults.empty()) throw InputErrors(std::move(faults));
  std::ranges::stable_sort(glossary.terms_, std::ranges::greater(),
                           [](const GlossaryTerm& term) { return term.english.size(); });
  return glossary;
}

Glossary Glossary::beside(const std::filesystem::path& file) {
  const auto path = file.parent_path() / "glossary.txt";
  std::error_code failed;
  return std::filesystem::exists(path, failed) ? read(path) : Glossary();
}

std::vector<const GlossaryTerm*> Glossary::missingIn(std::string_view english,
                                                     std::string_view translation) const {
  std::vector<std::u32string> text = wordsOf(english);
  const std::u32string words = folded(translation);
  std::vector<const GlossaryTerm*> missing;
  for (const GlossaryTerm& term : terms_) {
    bool stands = false;
    for (std::size_t place = 0; place < text.size(); ++place) {
      if (!standsAt(text, place, term)) continue;
      stands = true;
      for (std::size_t i = 0; i < term.english.size(); ++i) text[place + i].clear();  // taken
    }
    const bool isThere = std::ranges::any_of(
        term.words, [&](const std::u32string& word) { return words.find(word) != std::u32string::npos; });
    if (stands && !isThere) missing.push_back(&term);
  }
  return missing;
}

bool Glossary::isShared(std::string_view word) const {
  const std::u32string small = folded(word);
  return std::ranges::any_of(terms_, [&](const GlossaryTerm& term) {
    return term.english.size() == 1 && isWord(small, term.english[0], true) &&
           std::ranges::find(term.words, term.english[0]) != term.words.end();
  });
}

}  // namespace carom
