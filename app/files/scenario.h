#pragma once
// A scenario file: the light speed, the board, what moves on and over it, and where the observer starts.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cave/frame/lesson_words.h"
#include "cave/frame/time_views.h"
#include "engine/billiard/billiard.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/observer.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// A body that moves as told and collides with nothing: a rod, a train, a clock.
struct ScriptedBody {
  std::string name;
  /// Board frame; its radius is infinite, since how far a mesh reaches is not known here. The centre's clock
  /// shows 0 at `appears_s` where the file gives it, else at board time 0.
  WorldLine worldLine;
  std::optional<std::filesystem::path> mesh;  ///< exists; in metres, in the body's rest frame
};

/// A stretch of the platform's own way, on its clock (app/viewer/platform_motion.h) from when the tour sets out.
struct ThrustLeg {
  double from_s = 0.0;
  double for_s = 0.0;
  Vec3 thrust_m_s2{
      0.0};  ///< proper acceleration: person's right, forward and up in the room; c²/2 a metre at most
};

/// A pulse of light that is told: it goes straight from place to place at c and is seen by what it strikes on
/// its way.
struct Pulse {
  std::string name;
  double at_s = 0.0;         ///< when it starts
  std::vector<Vec3> path_m;  ///< two places at least; board frame
};

/// A game that teaches. What it says is read from a panel on a wall (cave/overlay/hud_panel.h), so it is
/// short: letters that a question, an answer, and each of the rest may have.
struct Lesson {
  static constexpr std::size_t kQuestionLetters = 160, kAnswerLetters = 70, kTextLetters = 230;

  LessonWords words;
  TimeViews views;  ///< that it begins with
};

struct Scenario {
  std::string title;
  BilliardSetup billiard;                                        ///< can be played
  std::vector<std::optional<std::filesystem::path>> puckMeshes;  ///< one for each puck; scaled to its radius
  std::vector<ScriptedBody> bodies;
  ObserverStart observer;
  std::vector<ThrustLeg> tour;  ///< in the order of time, none overlapping
  bool tourAtOnce = false;      ///< it sets out with the game; else when it is asked for
  std::vector<Pulse> pulses;
  std::optional<Lesson> lesson;
};

/// Reads and checks the whole file. Throws InputErrors (app/files/toml_file.h), which names every fault's
/// place. Meshes are looked for beside the file, then in the configuration folder.
Scenario readScenario(const std::filesystem::path& file);
/// The same of what the file held when a session was recorded.
Scenario readScenario(const std::filesystem::path& file, const std::string& kept);

}  // namespace carom
