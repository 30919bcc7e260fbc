#pragma once
// `carom events`: the events of a recorded session or of a scenario, in any inertial frame.

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "engine/spacetime/event.h"

namespace CLI {
class App;
}

namespace carom {

struct EventsOptions {
  std::filesystem::path source;     ///< a session file or a scenario
  std::optional<std::size_t> game;  ///< of a session, from 1; by default the newest
  Vec3 movingBeta{0.0};             ///< v/c of the other frame on the board, below 1
  std::optional<double> until_s;    ///< board time of the last event; by default the session's end, or 10 s
  std::vector<Vec3> places_m;  ///< places on the board where the reception of each event's light is computed
  /// Numbers of two events; only these are listed.
  std::optional<std::pair<std::uint64_t, std::uint64_t>> pair;
  std::optional<std::filesystem::path> csv;  ///< if empty, a readable table on standard output
};

// clang-format off
/// The columns of the CSV, one row an event, in the order of board time:
///   number, kind, who, cushion, heat_j,    as in the session file (app/journal/journal.h);
///     without_delay                        who: pucks, or the flash
///   t_s, x_m, y_m, z_m, order              on the board; order from 1, shared by events at the same time
///   moving_t_s … moving_z_m, moving_order  in the moving frame
///   next, interval                         number of the next row's event; timelike, lightlike or spacelike
///   proper_time_s                          timelike: of a clock that moves from one event to the other
///   distance_m                             spacelike: in the frame where both are simultaneous
///   beta_x, beta_y, beta_z                 v/c on the board of that clock, or of the slowest such frame
///   seen_frame, seen_t_s,                  sessions: when the event's light reached the viewer's head
///     seen_proper_time_s
///   place_1_t_s, …                         with --place: when the light reached that place
///   first_spin_kg_m2_s,                    angular momenta after it, in the order of `who`
///     second_spin_kg_m2_s
///   side_on_side                           1 if several corners touched at one time, else 0
// clang-format on
///
/// Returns the exit status. Throws InputErrors or std::runtime_error.
int runEvents(const EventsOptions& options);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addEvents(CLI::App& app, int& status);

}  // namespace carom
