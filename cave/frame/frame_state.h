#pragma once
// One drawn frame's record: all that a node needs to draw its walls. Rank 0 decides it, every rank holds the
// same bytes.

#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "cave/frame/hand_view.h"
#include "cave/frame/lesson_words.h"
#include "cave/frame/notice.h"
#include "cave/frame/time_views.h"
#include "cave/frame/wall_controls.h"
#include "engine/base/pose.h"
#include "engine/billiard/game_event.h"
#include "engine/light/switches.h"
#include "engine/spacetime/observer.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// A knot that a body's history has gained. Bodies are numbered as in the scene.
struct BodyKnot {
  std::uint64_t body = 0;
  Knot knot;
};

/// Where the trackers say that the person's head sensor and hand are. Room frame.
struct Tracked {
  Pose roomFromHeadSensor, roomFromHand;
  std::uint8_t headKnown = 0, handKnown = 0;  ///< 1: a tracker has told, lately
};

struct FrameRecord {
  std::uint64_t number = 0;
  double display_s = 0.0;  ///< session clock: when the light of this frame leaves the walls
  ObserverView observer;
  Lorentz boardFromRoom{1.0};  ///< the room's attitude and motion
  /// The pucks, bodies 1 to `pucks`, forget the knots whose turn is at or after this board time, before the
  /// new ones are added.
  double truncateFrom_s = std::numeric_limits<double>::infinity();
  std::uint64_t pucks = 0;
  /// The list of events forgets those of this number and above, before the new ones are added.
  std::uint64_t eventsKept = std::numeric_limits<std::uint64_t>::max();
  /// Then the pucks forget the legs that ended, and the list the events that were over, before this board
  /// time: no eye will see them any more.
  double forgetBefore_s = -std::numeric_limits<double>::infinity();
  std::uint64_t last = 0;  ///< 1: the session ends after this frame
  /// Light's speed for the person: metres in one second of their clock. The game keeps its own
  /// (app/operator/operator_settings.h).
  double lightSpeed_m_s = 0.0;
  Switches switches;      ///< which effects are drawn
  WallControls controls;  ///< what else the operator has chosen
  TimeViews views;
  Tracked tracked;
  HandView hand;
  DriveView drive;
  LessonState lesson;
  Notice notice;
};
static_assert(std::is_trivially_copyable_v<FrameRecord> && std::is_trivially_copyable_v<BodyKnot> &&
              std::is_trivially_copyable_v<GameEvent>);

/// The record, and the knots and events that came with it.
struct FrameState {
  FrameRecord record;
  std::vector<BodyKnot> knots;
  std::vector<GameEvent> events;
};

/// What a node knows of the game, as the frames have brought it.
struct World {
  std::vector<WorldLine> histories;  ///< of every body of the scene
  std::vector<GameEvent> events;     ///< in the order of their numbers; the first may be forgotten
};

/// Brings the world up to the frame: truncates, appends, forgets. Throws std::out_of_range if the frame
/// speaks of a body that is not there.
void applyFrame(const FrameState& state, World& world);

}  // namespace carom
