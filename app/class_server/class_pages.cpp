#include "app/class_server/class_pages.h"

#include <cstddef>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/classroom/class_flow.h"
#include "app/tables/html_text.h"
#include "cave/texts/language.h"
#include "cave/texts/texts.h"
#include "pages/class_css.h"
#include "pages/class_html.h"
#include "pages/class_js.h"

namespace carom {
namespace {

/// Returns the words that the script needs, as a JavaScript value.
std::string wordsOfScript() {
  nlohmann::json all;
  for (const auto& [name, words] : texts::pageWords("phone")) all[name] = words;
  for (const texts::Text& step : texts::phone::kConfidence) all["confidence"].push_back(step.words());
  nlohmann::ordered_json steps;
  for (std::size_t i = 0; i < kClassSteps.size(); ++i)
    steps[kClassSteps[i]] = texts::phone::kSteps.at(i).words();
  std::string words = all.dump();
  words.back() = ',';  // in the place of its closing brace
  return words + "\"steps\":" + steps.dump() + "}";
}

}  // namespace

ClassPages classPages(const std::string& word, bool follows) {
  const texts::InLanguage read(texts::ofSession(0));
  PageWords ofPage{{"word", htmlOf(word)}, {"language", texts::languageCode()}, {"follow", ""}};
  if (follows)
    ofPage["follow"] = fmt::format("<p><a href=\"/follow\">{}</a></p>", htmlOf(texts::page::kFollow.words()));
  for (const auto& [name, words] : texts::pageWords("phone")) ofPage[name] = htmlOf(words);
  return {filled(pages::class_html, ofPage), pages::class_css,
          filled(pages::class_js, {{"texts", wordsOfScript()}})};
}

}  // namespace carom
