// Text in pages: what HTML would take for its own, and words in the places of their names.
#include "app/tables/html_text.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace carom {
namespace {

TEST(HtmlText, IsShownAsItWasWritten) {
  EXPECT_EQ(htmlOf("<a href=\"x\">1 & 2</a>"), "&lt;a href=&quot;x&quot;&gt;1 &amp; 2&lt;/a&gt;");
  EXPECT_EQ(htmlOf("&amp;"), "&amp;amp;") << "what was written, not what it would mean";
  EXPECT_EQ(htmlOf(""), "");
}

TEST(HtmlText, WordsStandInThePlacesOfTheirNames) {
  const PageWords words{{"a", "{{b}}"}, {"b", "two"}, {"", "none"}};
  EXPECT_EQ(filled("x {{a}}{{b}} y {{b}}", words), "x {{b}}two y two") << "words that look like names stay";
  EXPECT_EQ(filled("{{}}", words), "none");
  EXPECT_EQ(filled("{{a", words), "{{a") << "a place without an end is none";
  EXPECT_EQ(filled("no place", words), "no place");
  EXPECT_THROW(filled("{{c}}", words), std::out_of_range);
}

}  // namespace
}  // namespace carom
