#pragma once
// `carom list`: the shipped games, lessons, rigs, playlists, studies, traces and languages, and those of a
// folder, with their titles.

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
  std::string title;  ///< its fault, if it cannot be read
  bool isFaulty = false;
};

struct ListedFiles {
  std::vector<ListedFile> lessons;  ///< in the order in which they build on one another, then by name
  std::vector<ListedFile> games, rigs, playlists, studies, traces;
  std::vector<ListedFile> languages;  ///< their titles say how much is translated
};

/// Returns the shipped files and the scenarios, rigs and playlists of `folder`. A file that can be read as
/// none of these is left out, unless it names a light speed, walls or games: then its first fault is listed.
ListedFiles listFiles(const std::filesystem::path& folder);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addList(CLI::App& app, int& status);

}  // namespace carom
