#pragma once
// `carom events`: what happened in a recorded session or happens in a scenario, in any frame.

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
  std::filesystem::path source;   ///< a session file, or a scenario
  Vec3 movingBeta{0.0};           ///< v/c of the other frame on the board, below 1
  std::optional<double> until_s;  ///< board time of the last event; none: the session's end, or 10 s
  std::vector<Vec3> places_m;     ///< who rests there receives the light of each
  std::optional<std::pair<std::uint64_t, std::uint64_t>> pair;  ///< numbers: these two events alone
  std::optional<std::filesystem::path> csv;  ///< none: a table for people on standard output
};

// clang-format off
/// The columns of the CSV, one row an event, in the order of board time:
///   number, kind, who, cushion, heat_j,    as in the session file (app/journal/journal.h); who: pucks, or the flash
///     without_delay
///   t_s, x_m, y_m, z_m, order              on the board; order from 1, shared by events at the same time
///   moving_t_s … moving_z_m, moving_order  in the moving frame
///   next, interval                         number of the next row's event; timelike, lightlike or spacelike
///   proper_time_s                          timelike: of a clock that goes from one to the other
///   distance_m                             spacelike: where they happen at once
///   beta_x, beta_y, beta_z                 v/c on the board of that clock; or of the slowest for whom they are at once
///   seen_frame, seen_t_s,                  of a session: when its light reached the person's head
///     seen_proper_time_s
///   place_1_t_s, …                         of --place: when it reached who rests there
// clang-format on
///
/// Returns the exit status; throws InputErrors or std::runtime_error.
int runEvents(const EventsOptions& options);

/// Adds the command to `app`; when it is called, its exit status is left in `status`.
void addEvents(CLI::App& app, int& status);

}  // namespace carom
