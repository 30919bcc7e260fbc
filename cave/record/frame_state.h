#pragma once
// The record of one frame: everything that a node needs to draw its walls. Rank 0 decides it, and every rank
// holds the same bytes.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "cave/record/class_view.h"
#include "cave/record/hand_view.h"
#include "cave/record/headset_frame.h"
#include "cave/record/lesson_words.h"
#include "cave/record/notice.h"
#include "cave/record/sculpture_view.h"
#include "cave/record/time_views.h"
#include "cave/record/wall_controls.h"
#include "engine/base/limits.h"
#include "engine/base/pose.h"
#include "engine/game/game_event.h"
#include "engine/light/switches.h"
#include "engine/linked/told_path.h"
#include "engine/soft/soft_history.h"
#include "engine/spacetime/observer.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// A knot that has been added to a body's history. Bodies are numbered as in the scene.
struct BodyKnot {
  std::uint64_t body = 0;
  Knot knot;
};

/// The poses of the person's head sensor and hand as the trackers report them. Room frame.
struct Tracked {
  Pose roomFromHeadSensor, roomFromHand;
  std::uint8_t headKnown = 0, handKnown = 0;  ///< 1: a tracker has reported it recently
};

/// What a viewer has played in this game: strokes by hand, and caroms as they saw them.
struct Score {
  std::uint64_t caroms = 0, strokes = 0;

  bool operator==(const Score&) const = default;
};

/// The most languages of a session.
inline constexpr std::size_t kMostLanguages = 16;

/// What a frame holds of one viewer.
struct ViewerState {
  ObserverView observer;
  Tracked tracked;
  HandView hand;
  ForceView force;
  Notice notice;
  Vec3 placeInRoom_m{0.0};  ///< of the head, as its clock took it (engine/spacetime/observers.h)
  double lapse = 1.0;       ///< the rate of a clock there, relative to the room's time
  Score score;
  std::uint8_t hasTurn = 0;   ///< 1: of several who play, it is this one's turn
  std::uint8_t language = 0;  ///< which of the session's languages this one reads
};

struct FrameRecord {
  std::uint64_t viewerCount = 1;  ///< number of viewers, 1 to kMostViewers
  std::array<ViewerState, kMostViewers> viewers;
  /// Which person of the room the first viewer is, who in that one's place is the room's first: 0 unless a
  /// replay is another's.
  std::uint64_t firstOfRoom = 0;
  std::uint64_t number = 0;
  double display_s = 0.0;      ///< session clock: when the light of this frame leaves the walls
  Lorentz boardFromRoom{1.0};  ///< the room's attitude and motion
  double room_s = 0.0;         ///< the room's own clock
  /// Before the new knots are added, the pucks (bodies 1 to `pucks`) lose the knots whose turn is at or after
  /// this board time.
  double truncateFrom_s = std::numeric_limits<double>::infinity();
  std::uint64_t pucks = 0;
  /// Before the new events are added, the list of events loses those with this number or a higher one.
  std::uint64_t eventsKept = std::numeric_limits<std::uint64_t>::max();
  /// After both have been added, the pucks lose the legs that ended before this board time, and the list
  /// loses the events that were over by then: no eye will see them any more.
  double forgetBefore_s = -std::numeric_limits<double>::infinity();
  /// Likewise of the rows of soft bodies (engine/soft/soft_history.h), by their times in metres of light:
  /// before the new rows are added, those from the first of these times on are void; after that those before
  /// the last row at or before the second are forgotten.
  double rowsFrom_m = std::numeric_limits<double>::infinity();
  double rowsForgottenBefore_m = -std::numeric_limits<double>::infinity();
  std::uint64_t last = 0;  ///< 1: the frame loop ends after this frame: the end, or another game follows
  /// Speed of light for the person, in metres per second of their own clock. The game keeps its own speed of
  /// light (app/operator/operator_settings.h).
  double lightSpeed_m_s = 0.0;
  Switches switches;      ///< which effects are drawn
  WallControls controls;  ///< the operator's other choices
  TimeViews views;
  SculptureView sculpture;
  DriveView drive;
  LessonState lesson;
  ClassView classroom;  ///< of phones; the session file has its votes, and not this
  HeadsetState headset;
  double fade = 0.0;  ///< how black the walls are: 1 is wholly, as when a game begins
  /// Through how many of the session's languages a tile on the front wall goes; 0: there is no such tile.
  std::uint8_t languagesOnTile = 0;

  /// Returns the place in `viewers` of a person in the order of the room.
  std::size_t ofRoom(std::size_t person) const {
    return person == 0 ? firstOfRoom : person == firstOfRoom ? 0 : person;
  }
  /// The viewers in the room.
  std::span<const ViewerState> present() const { return std::span(viewers).first(viewerCount); }
  std::span<ViewerState> present() { return std::span(viewers).first(viewerCount); }
};

/// A frame's record as one of the viewers sees it. It refers to the record, which must outlive it.
struct SeenFrame {
  // Implicit: a record alone is seen by its first viewer.
  SeenFrame(const FrameRecord& frame, std::size_t seer = 0)  // NOLINT(google-explicit-constructor)
      : SeenFrame(frame, seer, frame.viewers[seer]) {}
  /// `state` stands in for the viewer's own.
  SeenFrame(const FrameRecord& frame, std::size_t seer, const ViewerState& state)
      : record(frame), viewer(seer), self(state) {}

  const FrameRecord& record;
  std::size_t viewer;
  const ViewerState& self;  ///< of the viewer

  /// Returns the state of a viewer in the order of RoomGeometry's seenBy (cave/room/room_geometry.h): the one
  /// who sees comes first, and the first viewer in that one's place.
  const ViewerState& inOrder(std::size_t index) const {
    return index == 0 ? self : record.viewers[index == viewer ? 0 : index];
  }
};

static_assert(std::is_trivially_copyable_v<FrameRecord> && std::is_trivially_copyable_v<BodyKnot> &&
              std::is_trivially_copyable_v<GameEvent> && std::is_trivially_copyable_v<SoftRow> &&
              std::is_trivially_copyable_v<SoftNode>);

/// A frame's record with its new knots, events and rows.
struct FrameState {
  FrameRecord record;
  std::vector<BodyKnot> knots;
  std::vector<GameEvent> events;
  std::vector<SoftRow> rows;  ///< `body`: as numbered in the scene
  std::vector<SoftNode> rowNodes;
  std::vector<ToldMoment> told{};  ///< of the people of another room
};

/// What a node has of a body that is soft: no rows, and it is not soft, or not yet.
struct SoftPast {
  SoftHistory rows;
  std::optional<WorldLine> rigid;  ///< its motion before the first row, if it was rigid until then
};

/// A node's copy of the game, built up from the frames.
struct World {
  std::vector<WorldLine> histories;  ///< of every body of the scene
  std::vector<GameEvent> events;     ///< in the order of their numbers; the earliest may have been forgotten
  std::vector<SoftPast> soft{};      ///< of every body of the scene; empty until there are rows
  std::vector<ToldPath> people{};    ///< of another room, by their numbers; empty until somebody is told of
};

/// Brings `world` up to date with the frame: truncates, appends, then forgets. Throws std::out_of_range if
/// the frame names a body that does not exist, and std::invalid_argument for a row that cannot follow the
/// last.
void applyFrame(const FrameState& state, World& world);

}  // namespace carom
