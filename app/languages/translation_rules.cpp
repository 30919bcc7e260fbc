#include "app/languages/translation_rules.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "app/languages/letters.h"
#include "app/languages/text_values.h"
#include "engine/text/code_points.h"

namespace carom {
namespace {

std::string utf8Of(char32_t sign) {
  std::string text;
  if (sign < 0x80) return {static_cast<char>(sign)};
  const int more = sign < 0x800 ? 1 : sign < 0x10000 ? 2 : 3;
  constexpr unsigned kLead[] = {0, 0xC0, 0xE0, 0xF0};
  text += static_cast<char>(kLead[more] | (sign >> (6 * more)));
  for (int i = more - 1; i >= 0; --i) text += static_cast<char>(0x80U | ((sign >> (6 * i)) & 0x3FU));
  return text;
}

/// Returns the run of spaces at the beginning of a text, or at its end.
std::string_view spaceBefore(std::string_view text) { return text.substr(0, text.find_first_not_of(' ')); }
std::string_view spaceBehind(std::string_view text) {
  const std::size_t last = text.find_last_not_of(' ');
  return last == std::string_view::npos ? "" : text.substr(last + 1);
}

/// Returns the English words of a text that a translation has words for: three letters or more, not all
/// capitals ("PIN"), no options of the command line, none that is glued to a value.
std::vector<std::string> realWordsOf(std::string_view text) {
  constexpr std::size_t kLeast = 3;
  const auto isSmall = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto isCapital = [](char c) { return c >= 'A' && c <= 'Z'; };
  std::vector<std::string> words;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && (isSmall(text[end]) || isCapital(text[end]))) ++end;
    const std::string_view word = text.substr(i, end - i), before = text.substr(0, i);
    const bool isGlued = before.ends_with('}') || before.ends_with("--") || text.substr(end).starts_with('{');
    if (word.size() >= kLeast && !isGlued && std::ranges::any_of(word, isSmall)) words.emplace_back(word);
    i = std::max(end, i + 1);
  }
  return words;
}

/// Returns a formula of plural forms without its spaces and outer parentheses.
std::string plainFormula(std::string_view pluralForms) {
  std::string formula(
      pluralForms.substr(std::min(pluralForms.find("plural=", pluralForms.find(';')), pluralForms.size())));
  std::erase_if(formula, [](char c) { return std::string_view(" ()").find(c) != std::string_view::npos; });
  while (formula.ends_with(';')) formula.pop_back();
  return formula;
}

/// Judges one file.
class Judge {
 public:
  Judge(const PoFile& file, const TranslationRules& rules) : file_(file), rules_(rules) {
    for (std::size_t i = 0; i < rules.sources.size(); ++i) sources_.emplace(rules.sources[i].context, i);
  }

  JudgedTranslation judged() {
    judgeHead();
    for (const PoEntry& entry : file_.entries) {
      if (!entry.isObsolete) judge(entry);
    }
    for (const SourceText& source : rules_.sources) {
      if (!seen_.contains(source.context))
        warn(file_.end, fmt::format("text '{}' is missing: English is shown", source.context));
    }
    judged_.findings.assign(findings_.begin(), findings_.end());
    return std::move(judged_);
  }

 private:
  void error(FilePlace at, std::string words) {
    findings_.add({Finding::Kind::error, at, std::move(words)});
    isFaulty_ = true;
  }
  void warn(FilePlace at, std::string words) {
    findings_.add({Finding::Kind::warning, at, std::move(words)});
  }

  void judgeHead() {
    const auto head = headerOf(file_);
    if (!head) {
      return error({},
                   "there is no header, expected an entry with an empty msgid first, which names Language, "
                   "charset and Plural-Forms");
    }
    judged_.code = head->language;
    if (!isLanguageCode(head->language)) {
      error(head->at, head->language.empty()
                          ? "the header names no Language, expected its code, such as fr"
                          : fmt::format("Language is '{}', expected a code such as fr", head->language));
    } else if (!rules_.code.empty() && head->language != rules_.code &&
               !head->language.starts_with(rules_.code + "_")) {
      error(head->at, fmt::format("Language is '{}', expected '{}' here", head->language, rules_.code));
    }
    std::string charset = head->charset;
    std::ranges::transform(charset, charset.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    if (charset != "utf-8" && charset != "utf8" && !charset.empty())
      error(head->at, fmt::format("the charset is '{}', expected UTF-8", head->charset));
    judgePluralForms(*head);
  }

  void judgePluralForms(const PoHeader& head) {
    const std::string base = judged_.code.substr(0, judged_.code.find('_'));
    forms_ = texts::pluralForms(base);
    if (head.pluralForms.empty()) return;
    const std::size_t sign = head.pluralForms.find("nplurals=");
    const std::string count = sign == std::string::npos ? "" : head.pluralForms.substr(sign + 9, 1);
    if (count != std::to_string(forms_)) {
      return error(head.at, fmt::format("Plural-Forms is '{}', expected nplurals={}: forms of plural come "
                                        "from a table of the program, not from the file",
                                        head.pluralForms, forms_));
    }
    // The formulas by which translators' programs write the table's rules.
    const std::string formula = plainFormula(head.pluralForms);
    const bool isEnglish = texts::pluralForm(base, 0.0) == 1 && texts::pluralForm(base, 1.0) == 0;
    const std::string expected = forms_ == 1 ? "plural=0" : isEnglish ? "plural=n!=1" : "plural=n>1";
    if (forms_ <= 2 && formula != expected)
      warn(head.at, fmt::format("Plural-Forms has '{}', which is not used, expected {}: forms of plural come "
                                "from a table of the program",
                                formula, expected));
  }

  void judge(const PoEntry& entry) {
    if (!entry.context) return error(entry.id.at, "the text has no msgctxt, expected its name");
    const std::string& name = entry.context->words;
    const auto [seen, isFirst] = seen_.emplace(name, entry.context->at.line);
    if (!isFirst)
      return error(entry.context->at,
                   fmt::format("text '{}' stands twice, the first time on line {}, expected it once", name,
                               seen->second));
    const auto source = sources_.find(name);
    if (source == sources_.end())
      return warn(entry.context->at,
                  fmt::format("text '{}' is not in this version: its translation is not used", name));
    const SourceText& english = rules_.sources[source->second];
    const bool isEmpty =
        std::ranges::all_of(entry.forms, [](const PoText& form) { return form.words.empty(); });
    const FilePlace at = entry.forms.front().at;
    if (isEmpty) return warn(at, fmt::format("text '{}' is not translated: English is shown", name));
    if (entry.isFuzzy())
      return warn(at,
                  fmt::format("text '{}' is fuzzy: English is shown until somebody has looked at it", name));
    if (entry.id.words != english.english || (entry.plural ? entry.plural->words : "") != english.plural)
      return warn(entry.id.at, fmt::format("text '{}' is stale, its English is another now: English is "
                                           "shown. carom texts --update brings it in",
                                           name));
    isFaulty_ = false;
    judgeForms(entry, english);
    if (isFaulty_) return;
    judgeSameEnglish(entry, english);
    Translated translated{source->second, {}};
    for (const PoText& form : entry.forms) translated.forms.push_back(form.words);
    judged_.translated.push_back(std::move(translated));
  }

  void judgeForms(const PoEntry& entry, const SourceText& english) {
    const std::string& name = english.context;
    const std::size_t expected = english.plural.empty() ? 1 : forms_;
    if (entry.forms.size() != expected)
      error(entry.forms.back().at,
            fmt::format("text '{}' has {} forms of plural, expected {}", name, entry.forms.size(), expected));
    for (std::size_t i = 0; i < entry.forms.size(); ++i) {
      const PoText& form = entry.forms[i];
      if (form.words.empty()) {
        error(form.at, fmt::format("text '{}' has an empty msgstr[{}], expected words", name, i));
        continue;
      }
      const std::string& of =
          english.plural.empty() || (i == 0 && forms_ > 1) ? english.english : english.plural;
      judgeSigns(form, name);
      judgeValues(form, of, english);
      judgeKeys(form, of, name);
      judgeWords(form, of, name);
    }
  }

  void judgeSigns(const PoText& form, const std::string& name) {
    for (const char32_t sign : codePointsOf(form.words)) {
      const auto code = static_cast<unsigned>(sign);
      if (isDirectionMark(sign))
        return error(
            form.at,
            fmt::format("text '{}' has a mark of direction, U+{:04X}: right-to-left text is not drawn yet",
                        name, code));
      if (isRightToLeft(sign))
        return error(form.at,
                     fmt::format("text '{}' has the letter U+{:04X}: right-to-left text is not drawn yet",
                                 name, code));
      if (isControl(sign))
        return error(form.at,
                     fmt::format("text '{}' has the control sign U+{:04X}, expected none", name, code));
    }
  }

  void judgeValues(const PoText& form, const std::string& of, const SourceText& english) {
    if (!english.hasValues) return;
    const TextValues values = valuesOf(form.words), expected = valuesOf(of);
    if (!values.fault.empty())
      return error(form.at, fmt::format("text '{}' has {}", english.context, values.fault));
    if (values.values != expected.values) {
      return error(form.at, fmt::format("text '{}' has the values {}, expected {} as in English",
                                        english.context, wordsFor(values.values), wordsFor(expected.values)));
    }
    const auto printf = printfValuesOf(form.words), expectedPrintf = printfValuesOf(of);
    if (printf != expectedPrintf) {
      error(form.at, fmt::format("text '{}' has the values \"{}\", expected \"{}\" as in English",
                                 english.context, fmt::join(printf, " "), fmt::join(expectedPrintf, " ")));
    }
  }

  void judgeKeys(const PoText& form, const std::string& of, const std::string& name) {
    const TextKeys keys = keysOf(form.words, false), expected = keysOf(of, true);
    if (std::ranges::includes(keys.all, expected.sure) && std::ranges::includes(expected.all, keys.sure))
      return;
    const auto words = [](const std::set<std::string>& these) {
      return these.empty() ? std::string("none") : fmt::format("{}", fmt::join(these, " "));
    };
    error(form.at, fmt::format("text '{}' names the keys {}, expected {} as in English", name,
                               words(keys.all), words(expected.all)));
  }

  void judgeWords(const PoText& form, const std::string& of, const std::string& name) {
    const std::string& words = form.words;
    if (spaceBefore(words) != spaceBefore(of) || spaceBehind(words) != spaceBehind(of))
      warn(form.at,
           fmt::format("text '{}' begins with {} spaces and ends with {}, expected {} and {} as in English",
                       name, spaceBefore(words).size(), spaceBehind(words).size(), spaceBefore(of).size(),
                       spaceBehind(of).size()));
    if (words == of) {
      judgeSame(form, name);
    } else {
      for (const GlossaryTerm* term : rules_.glossary.missingIn(of, words))
        warn(form.at, fmt::format("text '{}' has none of the words of '{}', which the glossary asks for",
                                  name, term->line));
    }
    if (!rules_.lettersWithoutFont) return;
    std::vector<std::string> letters;
    for (const char32_t sign : rules_.lettersWithoutFont(words))
      letters.push_back(fmt::format("'{}' (U+{:04X})", utf8Of(sign), static_cast<unsigned>(sign)));
    if (!letters.empty())
      warn(form.at, fmt::format("text '{}' has letters that no font has, drawn as a box: {}", name,
                                fmt::join(letters, ", ")));
  }

  /// A text that is the same in both languages has no real words, or only such as both languages have.
  void judgeSame(const PoText& form, const std::string& name) {
    for (const std::string& word : realWordsOf(form.words)) {
      if (rules_.glossary.isShared(word)) continue;
      return warn(form.at,
                  fmt::format("text '{}' is the same as in English, expected a translation, or the line "
                              "\"{} = {}\" in glossary.txt",
                              name, word, word));
    }
  }

  /// Texts of games are looked up by their English when a game begins.
  void judgeSameEnglish(const PoEntry& entry, const SourceText& english) {
    if (english.hasValues) return;
    const auto [first, isFirst] = games_.emplace(english.english, &entry);
    if (isFirst || first->second->forms.front().words == entry.forms.front().words) return;
    warn(entry.forms.front().at, fmt::format("text '{}' is translated in another way than the same English "
                                             "in line {}, which is shown in both places",
                                             english.context, first->second->forms.front().at.line));
  }

  const PoFile& file_;
  const TranslationRules& rules_;
  std::unordered_map<std::string, std::size_t> sources_;   // by context
  std::unordered_map<std::string, int> seen_;              // contexts, and the line of each
  std::unordered_map<std::string, const PoEntry*> games_;  // by English
  std::size_t forms_ = 2;
  bool isFaulty_ = false;
  FindingList findings_;
  JudgedTranslation judged_;
};

}  // namespace

bool isLanguageCode(std::string_view code) {
  const auto isSmall = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto isLarge = [](char c) { return c >= 'A' && c <= 'Z'; };
  const std::string_view base = code.substr(0, code.find('_'));
  if (base.size() < 2 || base.size() > 3 || !std::ranges::all_of(base, isSmall)) return false;
  return code.size() == base.size() ||
         (code.size() == base.size() + 3 && std::ranges::all_of(code.substr(base.size() + 1), isLarge));
}

JudgedTranslation judge(const PoFile& file, const TranslationRules& rules) {
  return Judge(file, rules).judged();
}

}  // namespace carom
