// A lesson in several languages.
#include "cave/frame/lesson_language.h"

#include <gtest/gtest.h>

#include "cave/texts/some_french.h"

namespace carom {
namespace {

TEST(InLanguages, EachReadsTheirOwn) {
  const texts::Language french = texts::test::french();
  LessonPlan plan;
  plan.labels = {{"red", {}, false}};
  InLanguages<LessonPlan> said(plan);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(said.read().labels.front().words, "red");
    const texts::InLanguage reads(&french);
    EXPECT_EQ(said.read().labels.front().words, "rouge");
  }
}

}  // namespace
}  // namespace carom
