#pragma once
// The words of a lesson in the language in use (cave/texts/language.h).

#include "cave/frame/lesson_plan.h"
#include "cave/record/lesson_words.h"

namespace carom {

/// Returns the same lesson with its words, and the names that people read, in the language in use.
LessonWords inLanguage(LessonWords english);
LessonPlan inLanguage(LessonPlan english);

}  // namespace carom
