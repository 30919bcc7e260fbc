#pragma once
// `carom check --pattern`: shows test patterns on the walls of a rig, without a session.

#include <filesystem>
#include <optional>

namespace carom {

struct PatternOptions {
  std::filesystem::path rig;
  /// If given, draws four frames into this folder without a window and ends: the test patterns, then the seam
  /// pattern after 0, 1 and 2 s.
  std::optional<std::filesystem::path> capture;
};

/// Shows the patterns until Escape is pressed; under mpirun, each rank shows those of its walls. Returns the
/// exit status: 0, or 1 after a message on standard error.
int runPattern(const PatternOptions& options);

}  // namespace carom
