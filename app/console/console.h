#pragma once
// The operator's console: one window on rank 0 that shows how the session goes and gives the same commands
// as the keys do. It is there as long as the graphics are, through one game after the other.

#include <chrono>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/console/console_effects.h"
#include "app/console/console_events.h"
#include "app/console/console_games.h"
#include "app/console/console_parts.h"
#include "app/console/console_recording.h"
#include "app/console/console_time.h"
#include "app/console/console_trackers.h"
#include "app/console/console_walls.h"
#include "app/console/live_diagram.h"
#include "app/files/rig.h"
#include "app/files/scenario.h"
#include "cave/cluster/cluster.h"
#include "cave/display/window.h"
#include "cave/scene/scene.h"

namespace carom {

class Console {
 public:
  /// Opens the window where the rig wants it. Rig and cluster are used as long as this lives; so are scenario
  /// and scene until `play`.
  Console(Graphics& graphics, const Rig& rig, const Cluster& cluster, KeysOf keys, const Scenario& scenario,
          const Scene& scene);

  /// Another game: the scenario and scene that it was made with hold it.
  void play(const Scenario& scenario, const Scene& scene);
  /// The session is written to this file from now on; none: it is not.
  void writeTo(const std::optional<std::filesystem::path>& file) { recording_.writeTo(file); }

  /// Another line of what has been said.
  void say(const std::string& line);
  /// After the walls have been swapped: draws the console and shows it, if that is due: 20 times a second at
  /// most and a fifth of the time at most (a click is answered at once), and not while it is iconified.
  /// Adds what the operator asks for to the frame's commands.
  void show(const ConsoleFrame& frame);

 private:
  using Clock = std::chrono::steady_clock;
  struct Line {
    double said_s;  ///< session clock
    std::string words;
  };
  void drawAll(const ConsoleFrame& frame);
  void drawTop(const ConsoleFrame& frame);
  void drawTabs(const ConsoleFrame& frame);
  void drawDiagram(const ConsoleFrame& frame);
  void drawSaid() const;
  void drawKeys();

  Window window_;
  KeysOf keys_;
  std::vector<KeyLine> keyMap_;
  std::string title_;
  const Scenario* scenario_;
  std::string file_;
  console::WallsPanel walls_;
  console::EffectsPanel effects_;
  console::GamesPanel games_;
  console::EventsPanel events_;
  console::RecordingPanel recording_;
  console::Playing playing_;
  LiveDiagram diagram_;
  std::deque<Line> said_;
  std::string notice_;
  double now_s_ = 0.0;  ///< session clock
  bool opensKeys_ = false;
  bool keysShown_ = false;  ///< over the walls: the list opens here, too, when that changes
  Clock::time_point earliest_ = Clock::now(), due_ = earliest_;  ///< when it may, and should, be drawn again
};

}  // namespace carom
