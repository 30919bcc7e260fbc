#pragma once
// `carom list`: the games, lessons, rigs and traces that are shipped or in a folder, with their titles.

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace carom {

/// One file of the list.
struct ListedFile {
  std::string name;   ///< as a command takes it: the bare name of a shipped file, otherwise its path
  std::string title;  ///< what is wrong with it, if it cannot be read
  bool isFaulty = false;
};

struct ListedFiles {
  std::vector<ListedFile> lessons;  ///< in the order in which they build on one another, then by name
  std::vector<ListedFile> games, rigs, traces;
};

/// Returns the shipped files and those of `folder`. Files of `folder` that are neither scenarios nor rigs nor
/// traces are left out.
ListedFiles listFiles(const std::filesystem::path& folder);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addList(CLI::App& app, int& status);

}  // namespace carom
