#pragma once
// `carom replay`: a recorded session again, as it was seen or as another person sees it.

#include <filesystem>
#include <optional>

#include "app/stage/recording.h"
#include "engine/spacetime/event.h"

namespace CLI {
class App;
}

namespace carom {

struct ReplayOptions {
  std::filesystem::path session;
  std::optional<std::filesystem::path> observer;  ///< a trace of another person's head (room axes)
  bool walk = false;                              ///< another person: whom the rig's tracker follows
  std::optional<Vec3> beta;                       ///< v/c of the other person's room on the board
  std::optional<Vec3> from_m;                     ///< where that room's floor origin begins, on the board
  std::optional<double> facing_rad;               ///< and its forward, anticlockwise from +x
  std::optional<double> at_s;                     ///< begins at this time of the session's clock; no visit
  RecordingOptions recording;                     ///< pictures and movie
  bool noWindow = false;                          ///< as fast as it goes
  bool silent = false;                            ///< no sounds
  bool outside = false;                           ///< the first node shows the room from outside, too
  bool diagram = false;                           ///< and the spacetime diagram
  bool console = false;                           ///< and the operator's console
};

/// The exit status: 0, or 1 after a message on standard error.
int runReplay(const ReplayOptions& options);

/// Adds the command to `app`; when it is called, its exit status is left in `status`.
void addReplay(CLI::App& app, int& status);

}  // namespace carom
