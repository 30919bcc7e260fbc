#pragma once
// `carom cave`: the immersive session.

#include <cstdint>
#include <filesystem>
#include <optional>

#include "engine/switches.h"

namespace carom {

struct CaveOptions {
  std::filesystem::path rig;
  std::filesystem::path scenario;
  std::optional<std::uint64_t> frames;           ///< play so many in simulated time, then end
  std::optional<std::filesystem::path> capture;  ///< folder for every wall and eye of every frame
  std::optional<std::filesystem::path> session;  ///< the session file to write
  bool resume = false;  ///< go on from the end of `session`, with its rig and scenario
  bool noWindow = false;
  Switches switches;  ///< at the start
};

/// Runs a session to its end; under mpirun, this rank's part of it. The exit status: 0, or 1 after a message
/// on standard error.
int runCave(const CaveOptions& options);

}  // namespace carom
