#pragma once
// `carom compare`: whether two linked rooms have played one game, by their session files.

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace carom {

/// The outcome of a comparison.
struct Compared {
  std::vector<std::string> lines;  ///< for people
  std::string difference;          ///< the first; empty: there is none
};

/// Compares the linked games that both files have. Throws std::runtime_error if a file cannot be read or has
/// no linked game.
Compared compared(const std::filesystem::path& first, const std::filesystem::path& second);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addCompare(CLI::App& app, int& status);

}  // namespace carom
