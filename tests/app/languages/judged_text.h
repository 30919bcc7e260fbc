#pragma once
// What the rules of translations say of a file, a line for each finding.

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "app/languages/translation_rules.h"

namespace carom::test {

inline std::string headOf(const std::string& language,
                          const std::string& plurals = "nplurals=2; plural=(n != 1);",
                          const std::string& charset = "UTF-8") {
  return "msgid \"\"\nmsgstr \"\"\n\"Language: " + language +
         "\\n\"\n\"Content-Type: text/plain; charset=" + charset + "\\n\"\n\"Plural-Forms: " + plurals +
         "\\n\"\n\n";
}

/// Returns what the rules say of a content, a line each: "E 9: …" for an error in line 9, "W 9: …".
inline std::string said(const std::string& content, const TranslationRules& rules) {
  std::string all;
  for (const Finding& finding : judge(parsePo("a.po", content), rules).findings)
    all += fmt::format("{} {}: {}\n", finding.kind == Finding::Kind::error ? 'E' : 'W', finding.at.line,
                       finding.text);
  return all;
}

inline TranslationRules rulesOf(std::vector<SourceText> sources) {
  return {.code = "de", .sources = std::move(sources)};
}

/// Returns what is said of one translation; its msgstr stands on line 9.
inline std::string saidOf(const std::string& english, const std::string& german,
                          TranslationRules rules = rulesOf({})) {
  rules.sources = {{.context = "a.b", .english = english, .plural = {}, .note = {}, .reference = {}}};
  return said(
      headOf("de") + "msgctxt \"a.b\"\nmsgid " + quotedPo(english) + "\nmsgstr " + quotedPo(german) + "\n",
      rules);
}

}  // namespace carom::test
