#pragma once
// A lesson: a game with short texts, a question before it and a number that explains it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// The most answers that a lesson can have: as many as a gamepad has buttons for.
inline constexpr std::size_t kMostAnswers = 4;

/// What stands before the answers on walls and in windows.
inline constexpr std::array<std::string_view, kMostAnswers> kAnswerNumbers{"1   ", "2   ", "3   ", "4   "};

/// The texts of a lesson. They are short, because they are read from a wall.
struct LessonWords {
  std::string title;
  std::string question;              ///< asked before the answer can be seen
  std::vector<std::string> answers;  ///< two to kMostAnswers
  std::size_t right = 0;             ///< index of the right answer; beyond all: it is not told
  std::string todo;                  ///< what to do
  std::string notice;                ///< what to look for meanwhile
  std::string number;                ///< the number that comes out, and why
  // For the presenter alone:
  std::string predictedWrongly;  ///< the prediction that many make, and their reason
  std::string goOnWith;          ///< questions for a discussion
};

enum class LessonPhase : std::uint8_t {
  none,      ///< there is no lesson
  asks,      ///< waits for an answer
  shows,     ///< says what to do and what to look for
  explains,  ///< explains the number and repeats the answer
};

struct LessonState {
  LessonPhase phase = LessonPhase::none;
  std::uint8_t answer = 0;  ///< the answer that was given, from 1; 0: none, the question was skipped

  bool operator==(const LessonState&) const = default;
};

}  // namespace carom
