#pragma once
// `carom answers`: the answers of visitors to the questions of lessons, and the right ones.

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace carom {

/// One row of the table.
struct AnswerRow {
  std::string lesson, question, answer;
  std::optional<bool> isRight;  ///< none if the game's lesson has no such answer
  std::size_t attempt = 1;      ///< of this group and viewer at this question, from 1; of a class its vote
  double seconds = 0.0;         ///< from the question to the answer
  std::string viewer;           ///< of a class: the random number of the phone
  std::size_t group = 1;        ///< visitors who came together, counted from 1 through all files; 0: a class
  std::uint64_t frame = 0;
};

/// Returns the answers of session files, in their order. Throws std::runtime_error if one cannot be read.
std::vector<AnswerRow> answersOf(const std::vector<std::filesystem::path>& files);

/// The votes of a class on a question, the first and the second.
struct VotedQuestion {
  std::string lesson, question;
  struct Answer {
    std::string words;
    std::optional<bool> isRight;
    std::array<std::size_t, 2> count{};  ///< in each vote
  };
  std::vector<Answer> answers;       ///< in the lesson's order
  std::vector<AnswerRow> votes;      ///< in the order in which they counted
  std::array<std::size_t, 2> all{};  ///< phones that voted
};

/// Returns the votes of session files by question, in the order in which they were first asked. Throws
/// std::runtime_error if a file cannot be read.
std::vector<VotedQuestion> votesOf(const std::vector<std::filesystem::path>& files);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addAnswers(CLI::App& app, int& status);

}  // namespace carom
