#pragma once
// The console's page for the presenter of a lesson: the question with its right answer, the number, what many
// predict wrongly and how to go on, with the buttons that lead through the lesson.

#include <cstddef>
#include <optional>
#include <string>

#include "app/operator/command.h"
#include "app/scenario/scenario.h"
#include "cave/record/lesson_words.h"

namespace carom::console {

/// How a lesson stands.
struct LessonCourse {
  LessonState state;
  std::size_t observer = 0;     ///< index of the velocity that the visitor has
  std::optional<Command> next;  ///< plays the next lesson; none in a replay, which has no buttons
};

/// Draws the page into the current window. Adds the presenter's commands to `commands`.
void drawLesson(const Lesson& lesson, const LessonCourse& course, Commands& commands);

/// Draws a text below a dim heading, unless it is empty.
void paragraph(const char* heading, const std::string& text);

}  // namespace carom::console
