#pragma once
// The operator's console: a window on rank 0 that shows the state of the session and gives the same commands
// as the keys. It stays open as long as Graphics lives, over several games.

#include <chrono>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/console/live_diagram.h"
#include "app/console_parts/console_effects.h"
#include "app/console_parts/console_events.h"
#include "app/console_parts/console_games.h"
#include "app/console_parts/console_parts.h"
#include "app/console_parts/console_recording.h"
#include "app/console_parts/console_study.h"
#include "app/console_parts/console_time.h"
#include "app/console_parts/console_trackers.h"
#include "app/console_parts/console_walls.h"
#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "cave/cluster/cluster.h"
#include "cave/display/window.h"
#include "cave/scene/scene.h"

namespace carom {

class Console {
 public:
  /// Opens the window at `place`, out of sight until it is asked for if it `waits`. `rig` and `cluster` must
  /// outlive this object, `scenario` and `scene` until `play` is called.
  Console(Graphics& graphics, const WindowPlacement& place, const Rig& rig, const Cluster& cluster,
          KeysOf keys, const Scenario& scenario, const Scene& scene, bool waits = false);

  /// Switches to another game. `scenario` and `scene` must stay valid until the next call.
  void play(const Scenario& scenario, const Scene& scene);
  /// Sets the session file that is written from now on; none if the session is not recorded.
  void writeTo(const std::optional<std::filesystem::path>& file) { panels_.recording.writeTo(file); }

  ScreenPlace place() const { return window_.place(); }

  /// Adds a line to the log of messages.
  void say(const std::string& line);
  /// Draws and shows the console; call after the walls have been swapped. Draws at most 20 times per second
  /// and for a fifth of the time (a click is answered at once), and not while the window is iconified. Adds
  /// the operator's commands to those of the frame.
  void show(const ConsoleFrame& frame);

 private:
  using Clock = std::chrono::steady_clock;
  struct Line {
    double said_s;      ///< session clock
    std::string words;  ///< of a game, or of the log
    Notice notice;      ///< instead of them
  };
  void say(Line line);
  void drawAll(const ConsoleFrame& frame);
  void drawTop(const ConsoleFrame& frame, bool isNarrow);
  void drawButtons(const ConsoleFrame& frame, const ImVec2& size);
  void drawTabs(const ConsoleFrame& frame);
  void drawLessonOf(const ConsoleFrame& frame) const;
  void drawDiagram(const ConsoleFrame& frame);
  void drawSaid() const;
  void drawKeys(std::uint8_t language);

  Window window_;
  KeysOf keys_;
  bool waits_;  ///< where it lies it covers the game: it has a button that hides it
  KeyList keyMap_;
  std::string title_;
  const Scenario* scenario_;
  std::string file_;
  struct Panels {
    console::WallsPanel walls;
    console::EffectsPanel effects;
    console::GamesPanel games;
    console::EventsPanel events;
    console::RecordingPanel recording;
    console::StudyPanel study;
  } panels_;
  console::Playing playing_;
  console::SessionClocks clocks_;
  LiveDiagram diagram_;
  struct Log {
    std::deque<Line> lines;
    Notice latest;
  } log_;
  double now_s_ = 0.0;  ///< session clock
  struct Opens {
    bool keys = false;
    bool lesson = false;  ///< the tab of the lesson that has begun comes to the front
  } opens_;
  /// Earliest and intended time of the next drawing.
  struct Next {
    Clock::time_point earliest = Clock::now(), due = earliest;
  } next_;
};

}  // namespace carom
