// The pages of a study: whole HTML whatever people have typed, and the fields that come back with their
// forms.
#include "app/study/study_pages.h"

#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

namespace carom {
namespace {

const std::string kHostile = "</p><script>\"'&";

const StudyPageFrame kFrame{"17\"<", 3, 2, kHostile};

Item hostileItem() {
  return {"i", "k", 0, "What " + kHostile, {{"a", "A " + kHostile, true, ""}, {"b", "B", false, "m"}}};
}

std::size_t countOf(const std::string& page, const std::string& words) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = page.find(words, at)) != std::string::npos; at += words.size()) ++count;
  return count;
}

/// Returns the fault of the elements of a page: each must end, in the reverse order of their beginnings.
std::string faultOf(const std::string& page) {
  static const std::regex tag("<(/?)(!?[a-zA-Z0-9]+)[^>]*>");
  std::vector<std::string> open;
  for (std::sregex_iterator it(page.begin(), page.end(), tag), end; it != end; ++it) {
    const std::string name = (*it)[2];
    if (name == "!DOCTYPE" || name == "meta" || name == "link" || name == "input") continue;
    if ((*it)[1].length() == 0) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return "unexpected end of " + name;
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back() + " does not end";
}

TEST(StudyPages, AreWholeWhateverPeopleHaveTyped) {
  const FormAnswer given{"a", 2, kHostile};
  const std::vector<std::string> forms{consentPage(kFrame, "# " + kHostile + "\n\n**" + kHostile + "**\n"),
                                       backgroundPage(kFrame, true),
                                       itemPage(kFrame, hostileItem(), 1, 18, given, true),
                                       handInPage(kFrame, 3),
                                       ratingPage(kFrame, kRatingsAfter),
                                       stopPage(kFrame, true),
                                       onwardsPage(kFrame),
                                       lessonPage(kFrame, 0, 2, false),
                                       lessonPage(kFrame, 0, 2, true)};
  for (const std::string& page : forms) {
    EXPECT_EQ(faultOf(page), "") << page;
    EXPECT_EQ(countOf(page, "<script"), 0U) << page;
    EXPECT_EQ(countOf(page, "name=\"token\" value=\"17&quot;&lt;\""), 1U) << page;
    EXPECT_EQ(countOf(page, "name=\"step\" value=\"3\""), 1U);
    EXPECT_EQ(countOf(page, "name=\"item\" value=\"2\""), 1U);
    EXPECT_EQ(countOf(page, "value=\"stop\""), countOf(page, "value=\"stop-now\"") == 1 ? 0U : 1U)
        << "everybody may stop on every page but the one that asks whether to stop" << page;
  }
  for (const std::string& page : {codePage(kHostile, kHostile), endPage(kHostile)}) {
    EXPECT_EQ(faultOf(page), "") << page;
    EXPECT_EQ(countOf(page, "<script"), 0U) << page;
  }
}

TEST(StudyPages, TheConsentIsMarkdown) {
  const std::string page =
      consentPage({}, "# Taking *part*\n\nOne **strong** and *other*\nword.\n## Next\nTwo & three");
  EXPECT_NE(page.find("<h2>Taking <em>part</em></h2><p>One <strong>strong</strong> and <em>other</em> "
                      "word.</p><h2>Next</h2><p>Two &amp; three</p>"),
            std::string::npos)
      << page;
  for (const char* box : {"part", "paths", "publish", "guardian"})
    EXPECT_EQ(countOf(page, "type=\"checkbox\" name=\"" + std::string(box) + "\" value=\"yes\">"), 1U) << box;
}

TEST(StudyPages, AnItemShowsWhatWasAnsweredBefore) {
  const std::string first = itemPage({}, hostileItem(), 0, 18, {}, false);
  EXPECT_EQ(countOf(first, " checked"), 0U);
  EXPECT_EQ(countOf(first, "name=\"answer\""), 3U) << "its two and \"I do not know\"";
  EXPECT_EQ(countOf(first, "name=\"confidence\""), 4U);
  EXPECT_EQ(countOf(first, "value=\"back\"") + countOf(first, "<textarea"), 0U);
  EXPECT_EQ(countOf(first, "Question 1 of 18"), 2U) << "title and heading";
  const std::string later = itemPage({}, hostileItem(), 4, 18, {kDontKnow, 3, "Because"}, true);
  EXPECT_EQ(countOf(later, " checked"), 2U);
  EXPECT_EQ(countOf(later, "value=\"dont-know\" checked"), 1U);
  EXPECT_EQ(countOf(later, "value=\"3\" checked> fairly sure"), 1U);
  EXPECT_EQ(countOf(later, ">Because</textarea>"), 1U);
  EXPECT_EQ(countOf(later, "value=\"back\""), 1U);
}

TEST(StudyPages, AskWhatTheStudyAsks) {
  EXPECT_EQ(countOf(backgroundPage({}, false), "gender"), 0U);
  const std::string background = backgroundPage({}, true);
  EXPECT_NE(background.find("name=\"gender\""), std::string::npos);
  EXPECT_EQ(countOf(background, "value=\"65-\"> 65 or more"), 1U);
  EXPECT_EQ(countOf(background, "value=\"under-18\"> under 18"), 1U);
  const std::string rating = ratingPage({}, kRatingsAfter);
  for (const RatingQuestion& question : kRatingsAfter)
    EXPECT_EQ(countOf(rating, "name=\"" + std::string(question.id) + "\""), 11U) << "0 to 10";
  EXPECT_NE(handInPage({}, 0).find("You have answered all questions"), std::string::npos);
  EXPECT_NE(lessonPage({}, 1, 2, false).find("The lessons are over"), std::string::npos);
  EXPECT_NE(lessonPage({}, 0, 2, false).find("The next lesson"), std::string::npos);
}

}  // namespace
}  // namespace carom
