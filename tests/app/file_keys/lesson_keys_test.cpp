// The keys of lessons: how many of each thing a lesson may have, and how long its words are.
#include "app/file_keys/lesson_keys.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "app/repeated_text.h"
#include "app/scenario/scenario.h"
#include "app/temporary_folder.h"
#include "app/toml/input_file.h"
#include "cave/frame/lesson_plan.h"
#include "cave/record/effects.h"
#include "cave/record/lesson_words.h"
#include "cave/record/time_views.h"

namespace carom {
namespace {

using test::repeated;

/// Returns what is wrong with a lesson of this number of answers with these lines; empty if nothing is.
std::string faultsOf(std::size_t answers, const std::string& question, const std::string& lines) {
  const test::TemporaryFolder folder;
  const std::string lesson = "light_speed_m_s = 1\n[lesson]\nquestion = '" + question + "'\nanswers = [" +
                             repeated("'a', ", answers) +
                             "]\nright = 1\ntodo = 't'\nnotice = 'n'\nnumber = 'm'\nfrom_s = 0\nuntil_s = 1\n"
                             "moment_s = 1\n";
  try {
    readScenario(folder.file("given.toml", lesson + lines));
  } catch (const InputErrors& errors) {
    std::string all;
    for (const InputError& fault : errors.faults()) all += fault.message() + "\n";
    return all;
  }
  return {};
}

// Each kind is taken up to its limit, and refused beyond it.
TEST(LessonKeys, LimitWhatALessonHas) {
  const std::string line = "[[lesson.line]]\nfrom_m = [0, 0, 0]\nto_m = [1, 0, 0]\n";
  const std::string observer = "[[lesson.observer]]\nname = 'o'\nbeta = [0, 0, 0]\n";
  EXPECT_EQ(faultsOf(kMostAnswers, repeated("q", kLessonTextLetters),
                     repeated(line, kMostLessonDrawings) + repeated(observer, kMostAnswers - 1)),
            "");
  EXPECT_NE(faultsOf(1, "q", "").find("a lesson has 1 answer here"), std::string::npos);
  EXPECT_NE(faultsOf(kMostAnswers + 1, "q", "").find("a lesson has 5 answers here"), std::string::npos);
  EXPECT_NE(faultsOf(2, repeated("q", kLessonTextLetters + 1), "").find("question has 161 letters"),
            std::string::npos);
  EXPECT_NE(faultsOf(2, "q", repeated(line, kMostLessonDrawings + 1)).find("expected 4 at most"),
            std::string::npos);
  EXPECT_NE(faultsOf(2, "q", repeated(observer, kMostAnswers)).find("expected 3 at most"), std::string::npos);
}

// Editors complete the names of views and effects: all that the program knows, under those names.
TEST(LessonKeys, NameEveryViewAndEffect) {
  const FileKey views = viewsKey("sentence", "some_views");
  EXPECT_EQ(views.name, "some_views");
  EXPECT_EQ(views.type, FileKey::Type::texts);
  ASSERT_EQ(views.choices.size(), std::size(kNamedViews));
  for (std::size_t i = 0; i < views.choices.size(); ++i) EXPECT_EQ(views.choices[i], kNamedViews[i].name);
  const FileKey lesson = lessonKeys();
  const FileKey* effects = findKey(lesson, "offers_effects");
  ASSERT_NE(effects, nullptr);
  ASSERT_EQ(effects->choices.size(), std::size(kNamedSwitches));
  for (std::size_t i = 0; i < effects->choices.size(); ++i)
    EXPECT_EQ(effects->choices[i], kNamedSwitches[i].name);
}

}  // namespace
}  // namespace carom
