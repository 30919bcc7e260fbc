#pragma once
// `carom cave`: the immersive session.

#include <cstdint>
#include <filesystem>
#include <optional>

namespace carom {

struct CaveOptions {
  std::filesystem::path rig;
  std::filesystem::path scenario;
  std::optional<std::uint64_t> frames;           ///< play so many in simulated time, then end
  std::optional<std::filesystem::path> capture;  ///< folder for every wall and eye of every frame
  bool noWindow = false;
};

/// Runs a session to its end; under mpirun, this rank's part of it. The exit status: 0, or 1 after a message
/// on standard error.
int runCave(const CaveOptions& options);

}  // namespace carom
