#pragma once
// The console's games: which are there, the one that is played, its lesson and tour.

#include <string>
#include <vector>

#include "app/console/console_parts.h"
#include "app/files/scenario.h"

namespace carom::console {

class GamesPanel {
 public:
  /// Reads the scenarios of the configuration folder; one that is chosen is read again.
  GamesPanel();

  /// Another game. `scenario` is kept; `file`: where it is from.
  void play(const Scenario& scenario, const std::string& file);
  void draw(const ConsoleFrame& frame);

 private:
  struct Game {
    std::string file, title;
    bool lesson = false;
    LessonWords words;  ///< of a lesson
    std::string fault;  ///< why it could not be played when it was looked at last
  };
  static Game gameIn(const std::string& file);
  void drawList(const ConsoleFrame& frame);
  void drawChosen() const;
  void drawPlayed(const ConsoleFrame& frame) const;
  void drawLesson(const ConsoleFrame& frame, const Lesson& lesson) const;

  std::vector<Game> games_;
  std::size_t chosen_ = 0, played_ = 0;  ///< in there
  const Scenario* scenario_ = nullptr;
  std::string file_;
};

}  // namespace carom::console
