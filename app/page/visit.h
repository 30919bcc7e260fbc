#pragma once
// What a page shows: a visitor's part of a session, or a game without one.

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "cave/mesh/tessellation.h"
#include "cave/record/frame_state.h"
#include "engine/billiard/billiard.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// Which part of a session a page shows, and how.
struct VisitOptions {
  std::optional<std::size_t> game;        ///< from 1; by default the newest
  std::string as;                         ///< the viewer whose visit it is; empty: the first
  std::optional<double> from_s, until_s;  ///< session times
  std::uint64_t every = 3;                ///< of the frames, those whose numbers are multiples of it
  bool hasStillEyes = false;              ///< the head stays at one place of the room
};

/// A frame of a visit.
struct VisitFrame {
  std::uint64_t number = 0;
  double display_s = 0.0;
  ObserverView observer;
  Lorentz boardFromRoom{1.0};
  Switches switches;
  TimeViews views;
  LessonState lesson;
  double fade = 0.0;
};

/// A change of the known game, with the first frame that has it.
struct VisitChange {
  std::size_t frame = 0;                                       ///< its place in the visit
  double cutFrom_s = std::numeric_limits<double>::infinity();  ///< FrameRecord::truncateFrom_s
  std::vector<BodyKnot> knots;
};

struct Visit {
  Scenario scenario;
  RoomAxes axes;
  std::vector<Wall> walls;         ///< flat ones that show the viewer's eyes
  std::vector<WorldLine> atStart;  ///< of all bodies of the scene
  std::vector<VisitFrame> frames;  ///< at least one
  std::vector<VisitChange> changes;
  std::vector<GameEvent> events;
  std::vector<Stroke> strokes;  ///< by hand, of the whole game
  Vec3 eyeBesideMiddle_m{0.0};  ///< the right eye; room frame
  double known_s = 0.0;         ///< board time until which the game is known
  Tessellation tessellation;
  std::optional<std::uint64_t> live;  ///< the number of the game that the page follows while it is played
};

/// The most that a page holds: a browser on a phone has little memory.
inline constexpr std::size_t kMostVisitFrames = 20000, kMostVisitPucks = 200;
/// The longest game that a page plays ahead of itself.
inline constexpr double kLongestGame_s = 3600.0;

/// Returns a part of a session. Throws InputErrors, what SessionFile throws, and std::runtime_error for a
/// part without frames, for too much for a page and for soft pucks.
Visit visitOf(const std::filesystem::path& session, const VisitOptions& options);

/// Returns the part of a frame that a page has of one viewer.
VisitFrame frameOf(const FrameRecord& record, std::size_t viewer);

/// Returns a game that is about to be played in a room, for a page that follows it live: one frame, of an
/// observer at its start. Throws std::runtime_error for what a page cannot hold.
Visit visitToFollow(const Rig& rig, const Scenario& scenario, std::uint64_t game);

/// Returns the game of a scenario until a board time, seen by an observer who stands at its start. Throws
/// likewise.
Visit visitOf(const std::filesystem::path& scenario, double until_s);

}  // namespace carom
