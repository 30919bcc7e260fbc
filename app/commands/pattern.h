#pragma once
// `carom check --pattern`: the walls of a rig show test patterns, without a session.

#include <filesystem>
#include <optional>

namespace carom {

struct PatternOptions {
  std::filesystem::path rig;
  /// Draw four frames into this folder, without a window, and end: the test patterns, then the seam pattern
  /// after 0, 1 and 2 s.
  std::optional<std::filesystem::path> capture;
};

/// Shows the patterns until Escape; under mpirun, each rank those of its walls. The exit status: 0, or 1
/// after a message on standard error.
int runPattern(const PatternOptions& options);

}  // namespace carom
