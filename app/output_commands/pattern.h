#pragma once
// `carom check --pattern`: shows test patterns on the walls of a rig, without a session.

#include <filesystem>
#include <optional>
#include <string>

namespace carom {

struct PatternOptions {
  std::filesystem::path rig;
  /// If given, draws four frames into this folder without a window and ends: the test patterns, then the seam
  /// pattern after 0, 1 and 2 s.
  std::optional<std::filesystem::path> capture;
  std::string language;  ///< of their words; empty: the one in which the rig's first viewer begins
};

/// Shows the patterns until Escape is pressed; under mpirun, each rank shows those of its walls. Returns the
/// exit status: 0, or 1 after a message on standard error.
int runPattern(const PatternOptions& options);

}  // namespace carom
