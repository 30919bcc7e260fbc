#pragma once
// `carom force`: the force device of a rig: live, or its loop on a recorded hand.

#include <filesystem>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace carom {

struct ForceOptions {
  std::filesystem::path rig, scenario;
  std::optional<std::filesystem::path> positions;  ///< the hand is where this trace says: open loop
  std::optional<std::filesystem::path> pushes;     ///< the hand wants to be there, in the simulated device
  std::filesystem::path csv = "-";
  std::optional<std::string> hold;  ///< the puck that the hand holds, in the place of the cue
  double atSpeed = 0.0;             ///< of the held puck, in units of c
  std::optional<double> seconds;    ///< of the live display; if empty, until interrupted
};

/// Returns the exit status. Throws InputError or InputErrors for files that are at fault.
int runForce(const ForceOptions& options);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addForce(CLI::App& app, int& status);

}  // namespace carom
