#pragma once
// The course of a lesson: the visitor predicts an outcome, then observes it, then the lesson gives the number
// behind it.
//
//   asks ── an answer, or "go on" ──> shows ── "go on" ──> explains ── "go on" ──> shows …
//
// While the lesson asks, the viewer's time is frozen so that nothing of the answer can be seen yet.

#include <cstddef>
#include <string>

#include "app/operator/operator_settings.h"
#include "app/scenario/scenario.h"
#include "cave/record/lesson_words.h"

namespace carom {

/// Returns the lesson's state after a visitor has pressed a button. `answer` counts from 1; 0 is none.
/// Answers beyond `answers` are ignored, and so are all answers once the question is over. `onwards` ("go
/// on") skips a question.
LessonState advance(const LessonState& state, std::size_t answers, int answer, bool onwards);

/// Sets up the scenario's lesson, if there is one: adds its views to those that are on, and starts with its
/// question if `asks`. Sessions of a fixed number of frames pass false: they have no one to answer, and they
/// would show nothing but the question.
void beginLesson(const Scenario& scenario, bool asks, OperatorSettings& settings);

/// Returns whether the lesson offers choices by number: answers while it asks, then the velocities of the
/// observer, if it has any.
bool offersChoices(const OperatorSettings& settings);

/// Gives the observer the velocity that the number is about, if the lesson explains it.
void explainInMotion(OperatorSettings& settings);

/// Goes on to the lesson's next phase. Returns whether that changes the settings.
bool goOn(OperatorSettings& settings);

/// Takes the choice with this number, counted from 1. Where velocities are offered, the last number that a
/// hand device has a button for goes on. Returns whether that changes the settings.
bool choose(OperatorSettings& settings, int choice);

/// Returns the text of the given answer.
std::string answerText(const LessonWords& words, const LessonState& state);

}  // namespace carom
