#include "app/operator/lesson.h"

#include "cave/record/effects.h"
#include "cave/texts/texts.h"

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
  settings.lessonAnswers = settings.lessonObservers = 0;
  settings.lessonObserver = settings.lessonExplainedFor = 0;
  settings.lessonExplains = {};
  settings.lessonEffects.clear();
  if (!scenario.lesson) return;
  for (const std::uint8_t effect : scenario.lesson->plan.effects)
    settings.lessonEffects.emplace_back(effect, settings.switches.*kNamedSwitches[effect].value);
  settings.lesson.phase = asks ? LessonPhase::asks : LessonPhase::shows;
  settings.lessonAnswers = scenario.lesson->words.answers.size();
  settings.lessonObservers = scenario.lesson->plan.observers.size();
  settings.lessonExplainedFor = scenario.lesson->plan.explainedFor;
  settings.lessonExplains = scenario.lesson->explains;
  for (const NamedView& view : kNamedViews) {
    if (scenario.lesson->views.*view.value) settings.views.*view.value = 1;
  }
}

/// Turns on or off the views that are among `which`.
static void setViews(const TimeViews& which, std::uint8_t value, TimeViews& views) {
  for (const NamedView& view : kNamedViews)
    if (which.*view.value) views.*view.value = value;
}

bool offersChoices(const OperatorSettings& settings) {
  if (settings.lesson.phase == LessonPhase::none) return false;
  return settings.lesson.phase == LessonPhase::asks || settings.lessonObservers > 0;
}

void explainInMotion(OperatorSettings& settings) {
  if (settings.lesson.phase != LessonPhase::explains) return;
  settings.lessonObserver = settings.lessonExplainedFor;
  for (const auto& [effect, atFirst] : settings.lessonEffects)
    settings.switches.*kNamedSwitches[effect].value = atFirst;
  setViews(settings.lessonExplains, 1, settings.views);
}

bool goOn(OperatorSettings& settings) {
  const LessonState before = settings.lesson;
  settings.lesson = advance(before, settings.lessonAnswers, 0, true);
  if (before.phase == LessonPhase::explains) setViews(settings.lessonExplains, 0, settings.views);
  explainInMotion(settings);
  return settings.lesson != before;
}

bool choose(OperatorSettings& settings, int choice) {
  const LessonState before = settings.lesson;
  const std::size_t observer = settings.lessonObserver;
  if (settings.lesson.phase == LessonPhase::asks) {
    settings.lesson = advance(settings.lesson, settings.lessonAnswers, choice, false);
  } else if (offersChoices(settings) && choice >= 1 &&
             static_cast<std::size_t>(choice) <= settings.lessonObservers) {
    settings.lessonObserver = static_cast<std::size_t>(choice) - 1;
  } else if (offersChoices(settings) && choice == static_cast<int>(kMostAnswers)) {
    return goOn(settings);
  }
  return settings.lesson != before || settings.lessonObserver != observer;
}

std::string answerText(const LessonWords& words, const LessonState& state) {
  return state.answer == 0 || state.answer > words.answers.size() ? texts::lesson::kSkipped.english()
                                                                  : words.answers[state.answer - 1U];
}

}  // namespace carom
