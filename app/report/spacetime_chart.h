#pragma once
// The spacetime diagram: the world lines, mine among them, and at my present event its light cones and my
// axes.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/files/scenario.h"
#include "app/report/chart_file.h"
#include "engine/billiard/game_event.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// What a diagram is of. Board frame.
struct DiagramSubject {
  std::string title;
  double c_m_s = 1.0;
  std::vector<std::string> names;
  std::vector<WorldLine> lines;  ///< one for each name
  std::optional<Board> board;
  std::vector<Event> mine;        ///< my world line, to the present event; never empty
  Vec3 beta{0.0};                 ///< mine, there
  std::vector<GameEvent> events;  ///< that are marked
  /// Board time up to which all of this is known; lines end there, or with their last turn.
  double knownUntil_s = std::numeric_limits<double>::infinity();
};

/// Of a scenario, before it is played.
DiagramSubject subjectOf(const Scenario& scenario);

struct DiagramFrame {
  char along = 'x';              ///< the board's axis that is shown beside time: x or y
  std::optional<double> from_s;  ///< board time at the lower edge; none: 5 s before the present, at least 0
};

/// Light goes at 45°; the present event is at the upper third. Throws std::runtime_error where there is
/// nothing to show: less than 0.2 s up to the present event.
Chart spacetimeChart(const DiagramSubject& subject, const DiagramFrame& frame);

}  // namespace carom
