#pragma once
// How a lesson goes: first the visitor says what they expect, then they look, then the number behind it is
// told.
//
//   asks ── an answer, or "go on" ──> shows ── "go on" ──> explains ── "go on" ──> shows …
//
// While it asks, the person's time stands still: nothing of the answer is to be seen yet.

#include <cstddef>
#include <string>

#include "app/files/scenario.h"
#include "app/operator/operator_settings.h"
#include "cave/frame/lesson_words.h"

namespace carom {

/// Where a lesson goes when a visitor presses a button: `answer` counts from 1, 0 is none; those beyond
/// `answers` are none, and so is every answer once the question is over. "Go on" passes over a question.
LessonState advance(const LessonState& state, std::size_t answers, int answer, bool onwards);

/// Has a session begin with the scenario's lesson, if there is one: with its views beside those that are on,
/// and with its question if `asks`. A session that ends by itself, after so many frames, does not ask: nobody
/// is there to answer, and it would show nothing else.
void beginLesson(const Scenario& scenario, bool asks, OperatorSettings& settings);

/// What was answered, in the lesson's words.
std::string answerText(const LessonWords& words, const LessonState& state);

}  // namespace carom
