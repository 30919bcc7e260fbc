#pragma once
// A scenario file: light speed, board, pucks and other bodies, and the observer's initial state.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/toml/findings.h"
#include "cave/frame/body_colour.h"
#include "cave/frame/hall.h"
#include "cave/frame/lesson_plan.h"
#include "cave/frame/wall_action.h"
#include "cave/outlines/footprint.h"
#include "cave/record/lesson_words.h"
#include "cave/record/time_views.h"
#include "engine/base/limits.h"
#include "engine/billiard/billiard.h"
#include "engine/light/sampled_history.h"
#include "engine/sculpture/sculpture_place.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/observer.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// What a puck looks like.
struct PuckMesh {
  std::filesystem::path file;      ///< exists
  std::optional<MeshPlace> place;  ///< of what collides as it looks; otherwise scaled to the puck's radius
  bool isInOnePiece = true;        ///< seen from above
  int sectors = 0;  ///< an even number, in which it is painted around its axis; 0: it has one colour
};

/// A body with prescribed motion that collides with nothing: a rod, a train, a clock.
struct ScriptedBody {
  std::string name;
  /// Board frame. The radius is infinite because the mesh's extent is unknown here. The centre's clock shows
  /// 0 at `appears_s` if the file gives it, otherwise at board time 0.
  WorldLine worldLine;
  std::optional<std::filesystem::path> mesh;  ///< existing file; in metres, in the body's rest frame
  Material material = Material::lacquer;      ///< of the mesh
  bool isDrawn = true;                        ///< not without a mesh, if it holds the side of a soft puck
};

/// A body that moves and deforms as told, and collides with nothing.
struct ToldBody {
  std::string name;
  SampledHistory history;
  std::vector<std::array<std::uint32_t, 3>> triangles{};  ///< of its mesh, by its vertices; none: points
};

/// One leg of the tour. Times are on the platform's clock (app/viewer/platform_motion.h), from the start of
/// the tour.
struct ThrustLeg {
  double from_s = 0.0;
  double for_s = 0.0;
  Vec3 thrust_m_s2{
      0.0};  ///< proper acceleration: the viewer's right, forward and up in the room; at most c²/2 per metre
};

/// A scripted light pulse: it moves along straight lines from point to point at c and is seen through the
/// scattering of what it hits on its way.
struct Pulse {
  std::string name;
  double at_s = 0.0;         ///< start time
  std::vector<Vec3> path_m;  ///< at least two points; board frame
};

struct Lesson {
  LessonWords words;
  LessonPlan plan;
  TimeViews views;     ///< that are on when it begins
  TimeViews explains;  ///< and while it explains
};

/// The world of a task: light that is slow, without relativity; contraction without any delay; all that is
/// seen.
enum class TaskWorld : std::uint8_t { newton, measured, seen };

/// What a task asks for (app/play/task_judge.h).
struct TaskGoal {
  enum class Kind : std::uint8_t { hit, cushions, hitBoth, looksFaster, clockReads };
  Kind kind = Kind::hit;
  std::vector<std::size_t> pucks;  ///< one or two, as the kind needs; indices of the setup's pucks
  std::size_t cushions = 0;        ///< at least, of `cushions`
};

struct Task {
  std::string name, text;
  TaskGoal goal;
  TaskWorld world = TaskWorld::seen;
  std::array<double, 2> stars_j{};  ///< energies of the strokes up to which there are three stars, and two
};

/// A sentence shown in the room while the observer's proper time in this game is in its interval, with the
/// time views that belong to it.
struct Caption {
  double from_s = 0.0, for_s = 0.0;
  std::string text;
  std::string handText;  ///< for viewers with a tracked hand, which has no keys
  TimeViews views;
  bool colour = false;  ///< Doppler colour and searchlight are on
};

struct Scenario {
  std::string title;
  BilliardSetup billiard;                           ///< checked to be playable
  std::vector<std::optional<PuckMesh>> puckMeshes;  ///< one for each puck
  std::vector<ScriptedBody> bodies;
  std::vector<ToldBody> told;
  ObserverStart observer;
  std::vector<ThrustLeg> tour;     ///< in the order of time, without overlap
  bool tourAtOnce = false;         ///< the tour starts with the game; otherwise when requested
  double most_u = kMostPlatformU;  ///< γβ beyond which the drive makes the platform no faster
  std::vector<Pulse> pulses;
  std::vector<FollowedLamp> lamps;  ///< with any, the hall's own light is off
  std::vector<Caption> captions;    ///< in the order of time, without overlap
  std::optional<Lesson> lesson;
  std::vector<Task> tasks;                    ///< one after the other
  std::vector<Finding> odd;                   ///< values that can be played but are unusual
  std::optional<SpacetimeSetup> spacetime{};  ///< in the place of the rig's
  bool choices = false;  ///< the front wall offers the visitor's choices (cave/record/choice.h)
};

/// Returns what the game offers on the front wall.
inline GameOffers offersOf(const Scenario& scenario) {
  return {scenario.choices, scenario.billiard.board.has_value(), !scenario.tasks.empty()};
}

/// Reads and checks the whole file. Throws InputErrors (app/toml/toml_file.h) with the position of every
/// fault. Mesh files are searched beside the file, then in the configuration folder.
Scenario readScenario(const std::filesystem::path& file);
/// Reads `kept`, the content that the file had when a session was recorded or handed over. The files that it
/// names are looked for below `root` first, if one is given.
Scenario readScenario(const std::filesystem::path& file, const std::string& kept,
                      const std::filesystem::path& root = {});

}  // namespace carom
