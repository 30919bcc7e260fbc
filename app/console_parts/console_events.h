#pragma once
// The console's table of the game's events.

#include <cstddef>
#include <string>
#include <vector>

#include "app/console_parts/console_parts.h"
#include "app/scenario/scenario.h"
#include "cave/texts/language.h"

namespace carom::console {

class EventsPanel {
 public:
  /// Switches to another game.
  void play(const Scenario& scenario);

  /// Keeps events that the world will discard, up to the length of a readable table.
  void follow(const World& world);
  void draw(const FrameRecord& record);

 private:
  void nameInLanguage();
  static constexpr std::size_t kKept = 300;
  struct Row {
    const GameEvent* event;
    double board_s, mine_s;
    bool seen;
  };
  void find(const FrameRecord& record);
  void drawRow(const Row& row) const;

  std::vector<std::string> pucks_, flashes_;         ///< names, as the game has them
  std::vector<std::string> puckNames_, flashNames_;  ///< the same in the language in use
  const texts::Language* language_ = nullptr;
  double c_m_s_ = 1.0;
  std::vector<GameEvent> events_;  ///< in the order of their numbers
  std::vector<Row> rows_;          ///< newest first
  bool mine_ = false;              ///< times in the viewer's own frame
};

}  // namespace carom::console
