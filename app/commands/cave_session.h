#pragma once
// `carom cave`: the immersive session.

#include <cstdint>
#include <filesystem>
#include <optional>

#include "app/stage/recording.h"
#include "cave/frame/time_views.h"
#include "engine/light/switches.h"

namespace CLI {
class App;
}

namespace carom {

struct CaveOptions {
  std::filesystem::path rig;
  std::filesystem::path scenario;
  std::optional<std::uint64_t> frames;           ///< play so many in simulated time, then end
  RecordingOptions recording;                    ///< pictures and movie
  std::optional<std::filesystem::path> session;  ///< the session file to write
  bool resume = false;  ///< go on from the end of `session`, with its rig and scenario
  bool noWindow = false;
  bool silent = false;   ///< no sounds
  Switches switches;     ///< at the start
  TimeViews views;       ///< at the start
  bool outside = false;  ///< the first node shows the room from outside, too
  bool diagram = false;  ///< and the spacetime diagram
  bool console = false;  ///< and the operator's console
};

/// Runs a session to its end; under mpirun, this rank's part of it. The exit status: 0, or 1 after a message
/// on standard error.
int runCave(const CaveOptions& options);

/// Adds the command to `app`; when it is called, its exit status is left in `status`.
void addCave(CLI::App& app, int& status);

}  // namespace carom
