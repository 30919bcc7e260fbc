#pragma once
// `carom doctor`: what a machine, or a room with all of its computers, has and lacks for a session.

#include <filesystem>
#include <optional>
#include <vector>

namespace CLI {
class App;
}

namespace carom {

struct DoctorOptions {
  std::optional<std::filesystem::path> rig;
  std::vector<int> withoutNodes;       ///< of the rig, whose computers are missing
  bool findings = false;               ///< print no facts
  bool noWindow = false;               ///< judge no displays
  bool byMouse = false;                ///< mouse and keys move heads and wands: the trackers are not judged
  std::filesystem::path folder = ".";  ///< of the session files
};

/// Prints what this machine has and lacks; under mpirun a table of all nodes. With a rig, judges whether they
/// can show it, and the room as a whole. Returns the exit status: 0, or 1 if something keeps a session from
/// running.
int runDoctor(const DoctorOptions& options);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addDoctor(CLI::App& app, int& status);

}  // namespace carom
