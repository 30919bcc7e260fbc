#include "app/operator/lesson.h"

namespace carom {

LessonState advance(const LessonState& state, std::size_t answers, int answer, bool onwards) {
  LessonState next = state;
  switch (state.phase) {
    case LessonPhase::none:
      break;
    case LessonPhase::asks:
      if (answer >= 1 && static_cast<std::size_t>(answer) <= answers) {
        next = {LessonPhase::shows, static_cast<std::uint8_t>(answer)};
      } else if (onwards) {
        next = {LessonPhase::shows, 0};
      }
      break;
    case LessonPhase::shows:
      if (onwards) next.phase = LessonPhase::explains;
      break;
    case LessonPhase::explains:
      if (onwards) next.phase = LessonPhase::shows;
      break;
  }
  return next;
}

void beginLesson(const Scenario& scenario, bool asks, OperatorSettings& settings) {
  settings.lesson = {};
  settings.lessonAnswers = 0;
  if (!scenario.lesson) return;
  settings.lesson.phase = asks ? LessonPhase::asks : LessonPhase::shows;
  settings.lessonAnswers = scenario.lesson->words.answers.size();
  for (const NamedView& view : kNamedViews) {
    if (scenario.lesson->views.*view.value) settings.views.*view.value = 1;
  }
}

std::string answerText(const LessonWords& words, const LessonState& state) {
  return state.answer == 0 || state.answer > words.answers.size() ? "(passed over)"
                                                                  : words.answers[state.answer - 1U];
}

}  // namespace carom
