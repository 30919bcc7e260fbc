#pragma once
// `carom export`: what the viewer saw in a recorded session, or what another viewer sees of the same game, as
// numbers and meshes. Needs no display.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace carom {

struct ExportOptions {
  std::filesystem::path session;
  std::optional<std::size_t> game;                ///< of the session, from 1; by default the newest
  std::optional<std::filesystem::path> observer;  ///< trace of another viewer's head (room axes)
  std::string as;           ///< of several viewers, the one whose view is exported; empty: the first
  std::uint64_t every = 1;  ///< exports the frames whose numbers are multiples of this
  std::optional<std::filesystem::path> csv;       ///< "-": standard output
  std::optional<std::filesystem::path> paraview;  ///< output folder; must not exist or be empty
};

// clang-format off
/// The columns of the CSV, one row for each frame and body, in the order of both:
///   frame, display_s                  as in the session file (app/journal/journal.h)
///   proper_time_s                     of the observer's clock
///   t_s, x_m, y_m, z_m                on the board: where the point between the eyes received the light
///   beta_x, beta_y, beta_z            the head's v/c there
///   body, status                      seen; or unseen, with empty fields, until its light arrives
///   emission_t_s … emission_z_m       where and when the light left the body's centre, on the board
///   seen_x_m, seen_y_m, seen_z_m      emission − observation in the head's rest frame, axes by a
///                                     rotation-free boost of the board's
///   distance_m                        length of that vector
///   doppler                           seen ÷ emitted frequency
///   body_proper_time_s                of the body's centre at emission
// clang-format on
///
/// The values are those of `carom observe`. Switches and time views, which only change the drawing, have no
/// effect.
///
/// The folder contains seen_000000.vtp …, one file per frame (`carom observe --vtp`), and seen.pvd, which
/// opens all of them in ParaView at their display times. Each output is written completely or not at all.
/// Returns the exit status. Throws InputErrors or std::runtime_error.
int runExport(const ExportOptions& options);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addExport(CLI::App& app, int& status);

}  // namespace carom
