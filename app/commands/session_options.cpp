#include "app/commands/session_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/file_keys/rig_keys.h"
#include "cave/capture/movie.h"
#include "engine/text/log.h"

namespace carom {

void addSilent(CLI::App& command, bool& silent) {
  command.add_flag("--silent", silent,
                   "Play no sounds. Without it, each collision and stroke clicks when it is seen");
}

void addExtraWindows(CLI::App& command, ExtraWindows& extra) {
  command.add_flag(
      "--console", extra.console,
      "Open the operator's console on the first node: walls in small, trackers, switches, games, events");
  command.add_flag(
      "--diagram", extra.diagram,
      "Show the spacetime diagram in a window of its own; the observer's axes tilt as they move");
  command.add_flag(
      "--outside", extra.outside,
      "Show the room from outside, too: its walls, the person, the table where it is. With --capture "
      "also as outside-mono-FRAME.png");
}

void addWithoutNodes(CLI::App& command, std::vector<int>& nodes) {
  command
      .add_option(
          "--without-nodes", nodes,
          "Leave out these nodes of the rig and their walls, as 'carom room' does where a computer is "
          "missing: 1,3. Those that follow move up")
      ->type_name("RANKS")
      ->delimiter(',')
      ->check(CLI::Range(1, kMostRanks));
}

void addMovie(CLI::App& command, std::optional<std::filesystem::path>& movie) {
  command
      .add_option(
          "--movie", movie,
          "Movie of this node's walls, the left eye's, encoded by the program ffmpeg: .mp4, .webm or .ogv. "
          "With several nodes each writes its own: FILE-node1.mp4 is node 1's")
      ->type_name("FILE")
      ->check(CLI::Validator(
          [](std::string& text) {
            if (isMovieName(text)) return std::string();
            return fmt::format("'{}' is wrong, expected a name that ends in {}", text, kMovieEndings);
          },
          ""));
}

void addGame(CLI::App& command, std::optional<std::size_t>& game) {
  command
      .add_option("--game", game,
                  "Which game of a session with several, from 1; by default the newest: carom list SESSION")
      ->type_name("N")
      ->check(CLI::Range(1L, 1000000000L));
}

void sayGame(const SessionFile& session, const std::string& title) {
  const std::size_t games = session.games().size();
  if (games == 1) return;
  log::note(fmt::format("Game {} of {} of this session: {}. --game 1 to {} chooses another.", session.game(),
                        games, title, games));
}

}  // namespace carom
