#include "app/console_parts/console_lesson.h"

#include <imgui.h>

#include "app/console_parts/console_parts.h"
#include "cave/frame/lesson_language.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom::console {
namespace {

const char* wordsOf(LessonPhase phase) {
  switch (phase) {
    case LessonPhase::none:
      return texts::console::kSkippedPhase;
    case LessonPhase::asks:
      return texts::console::kAsks;
    case LessonPhase::shows:
      return texts::console::kShows;
    case LessonPhase::explains:
      return texts::console::kExplains;
  }
  return "";
}

/// Draws the answers, as buttons while the lesson asks. The right one and the one that was given are marked.
void drawAnswers(const LessonWords& said, const LessonCourse& course, Commands& commands) {
  const bool asks = course.next && course.state.phase == LessonPhase::asks;
  for (std::size_t i = 0; i < said.answers.size(); ++i) {
    const std::string numbered = texts::format(texts::console::kNumbered, i + 1, said.answers[i]);
    if (asks && ImGui::Button(numbered.c_str()))
      commands.emplace_back(ChooseInLesson{static_cast<int>(i) + 1});
    if (!asks) words(numbered);
    const auto mark = [](const char* word) {
      sameLineFor(ImGui::CalcTextSize(word).x);
      dim(word);
    };
    if (i == said.right) mark(texts::console::kCorrect);
    if (i + 1 == course.state.answer) mark(texts::console::kAnswer);
  }
}

/// Draws a button for each velocity that the lesson offers.
void drawObservers(const LessonPlan& plan, const LessonCourse& course, Commands& commands) {
  if (plan.observers.empty() || course.state.phase == LessonPhase::asks) return;
  dim(texts::console::kVelocity);
  for (std::size_t i = 0; i < plan.observers.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    ImGui::BeginDisabled(i == course.observer);
    if (ImGui::Button(texts::other(plan.observers[i].name).c_str()))
      commands.emplace_back(ChooseInLesson{static_cast<int>(i) + 1});
    ImGui::EndDisabled();
  }
}

void drawSteps(const LessonCourse& course, Commands& commands) {
  ImGui::BeginDisabled(course.state.phase == LessonPhase::none);
  const bool asks = course.state.phase == LessonPhase::asks;
  if (ImGui::Button(asks ? texts::console::kSkip : texts::console::kNext))
    commands.emplace_back(AdvanceLesson{});
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button(texts::console::kNextLesson)) commands.push_back(*course.next);
}

}  // namespace

void paragraph(const char* heading, const std::string& text) {
  if (text.empty()) return;
  dim(heading);
  ImGui::TextWrapped("%s", text.c_str());
}

void drawLesson(const Lesson& lesson, const LessonCourse& course, Commands& commands) {
  const LessonWords said = inLanguage(lesson.words);
  heading(texts::format(texts::console::kLesson, said.title).c_str());
  dim(wordsOf(course.state.phase));
  ImGui::TextWrapped("%s", said.question.c_str());
  drawAnswers(said, course, commands);
  if (course.next) {
    drawObservers(lesson.plan, course, commands);
    drawSteps(course, commands);
  }
  ImGui::Spacing();
  paragraph(texts::console::kPredictedWrongly, said.predictedWrongly);
  paragraph(texts::console::kTryThis, said.todo);
  paragraph(texts::console::kLookFor, said.notice);
  paragraph(texts::console::kNumber, said.number);
  paragraph(texts::console::kGoOnWith, said.goOnWith);
}

}  // namespace carom::console
