#pragma once
// The spacetime diagram: all world lines with the observer's, and at the observer's present event the light
// cones and the observer's axes; where several share a room, each one's world line and line of simultaneity.

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/report/chart_file.h"
#include "app/report/soft_sides.h"
#include "app/scenario/scenario.h"
#include "cave/record/frame_state.h"
#include "engine/game/game_event.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// Another observer in the room.
struct OtherObserver {
  std::string name;
  std::vector<Event> line{};  ///< the world line up to the present event
  Vec3 beta{0.0};             ///< at the present event
};

/// The content of a diagram. Board frame.
struct DiagramSubject {
  std::string title;
  double c_m_s = 1.0;
  std::vector<std::string> names;
  std::vector<WorldLine> lines;  ///< one for each name
  std::vector<SoftSides> softSides{};
  std::optional<Board> board;
  std::vector<Event> mine;            ///< the observer's world line up to the present event; never empty
  Vec3 beta{0.0};                     ///< the observer's, at the present event
  std::vector<OtherObserver> others;  ///< whose presents are simultaneous with mine in the room's frame
  std::vector<OtherObserver> told;    ///< people of another room, as far as was told of them
  std::vector<GameEvent> events;      ///< the events to mark
  std::vector<std::string> flashes;   ///< the names of the flashes
  /// Board time up to which all world lines are known; each ends there, or at its last knot if that is later.
  double knownUntil_s = std::numeric_limits<double>::infinity();
};

/// Returns the diagram content of a scenario before the game.
DiagramSubject subjectOf(const Scenario& scenario);

/// Continues an observer's world line. It begins anew where an observer is put elsewhere, as a lesson does
/// when it plays its game again: no observer goes back in time or overtakes light.
void continueLine(std::vector<Event>& line, double c_m_s, const Event& here);

/// Takes the observers of a frame: continues all world lines. The first viewer's is mine; `names` are those
/// of all.
void follow(DiagramSubject& subject, const FrameRecord& record, std::span<const std::string> names);

/// Takes the people of another room, from a board time on.
void followTold(DiagramSubject& subject, std::span<const ToldPath> people,
                double from_s = -std::numeric_limits<double>::infinity());

struct DiagramFrame {
  char along = 'x';  ///< the board axis shown beside time: x or y
  /// Board time at the lower edge; by default 5 s before the present, at least 0.
  std::optional<double> from_s;
};

/// Creates the diagram. Light is at 45°, and the present event is at the upper third. Throws
/// std::runtime_error if there is nothing to show: less than 0.2 s up to the present event.
Chart spacetimeChart(const DiagramSubject& subject, const DiagramFrame& frame);

}  // namespace carom
