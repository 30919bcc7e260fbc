#pragma once
// `carom export`: what a person saw in a recorded session, or another person sees of the same game, as
// numbers and meshes. Needs no display.

#include <cstdint>
#include <filesystem>
#include <optional>

namespace CLI {
class App;
}

namespace carom {

struct ExportOptions {
  std::filesystem::path session;
  std::optional<std::filesystem::path> observer;  ///< a trace of another person's head (room axes)
  std::uint64_t every = 1;                        ///< frames whose numbers are multiples of this
  std::optional<std::filesystem::path> csv;       ///< "-": standard output
  std::optional<std::filesystem::path> paraview;  ///< a folder that is not there yet, or is empty
};

// clang-format off
/// The columns of the CSV, one row for each frame and body, in the order of both:
///   frame, display_s                  as in the session file (app/journal/journal.h)
///   proper_time_s                     of the observer's clock
///   t_s, x_m, y_m, z_m                the event at which the point between the eyes received the light, on the board
///   beta_x, beta_y, beta_z            the head's v/c there
///   body, status                      seen, or unseen: its light has not arrived yet, and the rest is empty
///   emission_t_s … emission_z_m       where and when the light left the body's centre, on the board
///   seen_x_m, seen_y_m, seen_z_m      emission − observation in the head's rest frame, axes by a rotation-free
///                                     boost of the board's
///   distance_m                        how far that is
///   doppler                           seen ÷ emitted frequency
///   body_proper_time_s                of the body's centre when the light left
// clang-format on
///
/// As `carom observe` has them; switches and views of time, which only change how things are drawn, do not
/// count.
///
/// The folder holds seen_000000.vtp …, a file a frame (`carom observe --vtp`), and seen.pvd, which ParaView
/// opens: all of them, at their display times. Both outputs appear whole or not at all. Returns the exit
/// status; throws InputErrors or std::runtime_error.
int runExport(const ExportOptions& options);

/// Adds the command to `app`; when it is called, its exit status is left in `status`.
void addExport(CLI::App& app, int& status);

}  // namespace carom
