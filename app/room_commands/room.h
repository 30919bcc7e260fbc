#pragma once
// `carom room`: starts a session on every host of a rig by mpirun, and again whenever it loses a node.

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace carom {

struct RoomOptions {
  std::filesystem::path rig;
  std::vector<std::string> arguments;  ///< for `carom cave`
  bool lineOnly = false;               ///< print the line of mpirun and start nothing
  std::vector<std::string> without{};  ///< hosts that are left out with their walls
  bool doctor = false;                 ///< run `carom doctor` on every node instead
  std::filesystem::path folder{};  ///< of session files, whose disk the doctor judges; empty: the current one
  bool noDoctor = false;           ///< do not run it before the session
  bool pattern = false;            ///< show the test patterns instead
};

/// Runs the session to its end. Returns the exit status: 0, or 1 after a message on standard error.
int runRoom(const RoomOptions& options);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addRoom(CLI::App& app, int& status);

}  // namespace carom
