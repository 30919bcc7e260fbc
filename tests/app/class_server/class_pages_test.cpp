// The pages of a class: all words are the catalogue's, and nothing comes from elsewhere.
#include "app/class_server/class_pages.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

#include "app/tables/html_text.h"
#include "cave/record/class_view.h"
#include "cave/texts/texts.h"
#include "places.h"

namespace carom {
namespace {

std::string sourceOf(const char* name) {
  const auto root = std::filesystem::path(CAROM_TESTS_DIR).parent_path();
  std::ifstream file(root / "app/class_server/pages" / name);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(ClassPages, AreFilledWithTheCatalogue) {
  const ClassPages pages = classPages("<KIWI>");
  for (const std::string* text : {&pages.page, &pages.style, &pages.script}) {
    EXPECT_EQ(text->find("{{"), std::string::npos);
    EXPECT_EQ(text->find("://"),
              text->find("ws://") == std::string::npos ? std::string::npos : text->find("ws://") + 2)
        << "nothing but the socket has an address";
  }
  EXPECT_NE(pages.page.find(">&lt;KIWI&gt;</strong>"), std::string::npos);
  const std::string html = sourceOf("class.html"), js = sourceOf("class.js");
  for (const auto& [name, words] : texts::pageWords("phone")) {
    const bool inPage = html.find("{{" + name + "}}") != std::string::npos;
    const std::regex used("T\\." + name + "\\b");
    const bool isState = std::ranges::find(kClassPhases, name) != kClassPhases.end();
    EXPECT_TRUE(inPage || isState || std::regex_search(js, used)) << name;
    if (inPage) {
      EXPECT_NE(pages.page.find(htmlOf(words)), std::string::npos) << name;
    } else {
      EXPECT_NE(pages.script.find(words), std::string::npos) << name;
    }
  }
}

TEST(ClassPages, HaveNoWordsOfTheirOwn) {
  std::string page = sourceOf("class.html");
  page = std::regex_replace(page, std::regex("\\{\\{\\w+\\}\\}"), "");
  page = std::regex_replace(page, std::regex("<[^>]*>"), "");
  EXPECT_FALSE(std::regex_search(page, std::regex("[A-Za-z]"))) << page;
  const std::string script = sourceOf("class.js");
  for (const char* unsafe : {"innerHTML", "outerHTML", "insertAdjacentHTML", "document.write", "eval("})
    EXPECT_EQ(script.find(unsafe), std::string::npos) << unsafe;
}

}  // namespace
}  // namespace carom
