#pragma once
// The console's list of games, with lesson and tour of the current one.

#include <string>
#include <vector>

#include "app/console_parts/console_parts.h"
#include "app/scenario/scenario.h"

namespace carom::console {

class GamesPanel {
 public:
  /// Reads the scenarios of the configuration folder. A scenario is read again when it is chosen.
  GamesPanel();

  /// Switches to another game. `scenario` must stay valid; `file` is where it was read from.
  void play(const Scenario& scenario, const std::string& file);
  void draw(const ConsoleFrame& frame);

 private:
  struct Game {
    std::string file, title;
    bool lesson = false;
    LessonWords words;  ///< of a lesson
    std::string fault;  ///< why it could not be played when last read; empty if it could
  };
  static Game gameIn(const std::string& file);
  void restrictTo(const Playlist& playlist);
  void drawProgramme(const ConsoleFrame& frame) const;
  void drawList(const ConsoleFrame& frame);
  void drawChosen() const;
  void drawPlayed(const ConsoleFrame& frame) const;

  const Playlist* playlist_ = nullptr;  ///< to which the list is restricted
  std::vector<Game> games_;
  std::size_t chosen_ = 0, played_ = 0;  ///< indices into `games_`
  const Scenario* scenario_ = nullptr;
  std::string file_;
};

}  // namespace carom::console
