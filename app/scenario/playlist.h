#pragma once
// A playlist file: the games that a visitor may play, in their order, for how long, and what the moderator
// says.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace carom {

struct PlaylistGame {
  std::filesystem::path scenario;  ///< an existing file that can be played
  std::string title;               ///< the scenario's
  bool isLesson = false;
  bool attracts = false;        ///< played by itself while the room is empty
  std::optional<double> for_s;  ///< after so long the next game begins; empty: when somebody chooses one
  std::string note;             ///< for the person at the console
};

struct Playlist {
  std::string title;
  std::vector<PlaylistGame> games;       ///< at least one; a session begins with the first
  std::vector<std::string> languages{};  ///< in the place of the rig's; empty: as the rig says
};

/// Reads and checks the whole file and every scenario that it names. Throws InputErrors
/// (app/toml/input_file.h) with the position of every fault: a scenario that is not there, one that cannot
/// be played.
Playlist readPlaylist(const std::filesystem::path& file);

/// Returns the number of the game with this scenario file, or how many there are if it has none.
std::size_t numberOf(const Playlist& playlist, const std::filesystem::path& scenario);

}  // namespace carom
