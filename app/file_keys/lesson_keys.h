#pragma once
// The keys of a scenario's lesson.

#include "app/file_keys/file_key.h"

namespace carom {

/// Letters, at most, of the question and of the words that say what to do and to look for, of an answer, and
/// of the explanation. They are shown in a band of a wall (cave/overlay/hud_panel.h).
inline constexpr std::size_t kLessonTextLetters = 160, kAnswerLetters = 70, kLessonNumberLetters = 230;
/// Of a text that the console alone shows.
inline constexpr std::size_t kPresenterLetters = 400;

/// Returns the key of the names of time views.
FileKey viewsKey(std::string_view sentence, std::string_view name = "views");

FileKey lessonKeys();

}  // namespace carom
