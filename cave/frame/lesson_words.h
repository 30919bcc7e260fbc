#pragma once
// A lesson: a game with a few words, a question before it and the number behind it.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace carom {

/// A lesson has so many answers at most: as many as a pad has buttons for.
inline constexpr std::size_t kMostAnswers = 4;

/// What a lesson says. All of it short: it is read from a wall.
struct LessonWords {
  std::string title;
  std::string question;              ///< asked before anything is shown of the answer
  std::vector<std::string> answers;  ///< two to kMostAnswers
  std::size_t right = 0;             ///< of them
  std::string todo;                  ///< what to do
  std::string notice;                ///< what to look for meanwhile
  std::string number;                ///< what comes out, and why
};

enum class LessonPhase : std::uint8_t {
  none,      ///< there is no lesson
  asks,      ///< waits for an answer
  shows,     ///< what to do and to notice
  explains,  ///< the number behind it, and what was answered
};

struct LessonState {
  LessonPhase phase = LessonPhase::none;
  std::uint8_t answer = 0;  ///< the one that was given, from 1; 0: none, it was passed over

  bool operator==(const LessonState&) const = default;
};

}  // namespace carom
