#pragma once
// `carom doctor`: what a machine, or each node of a room, has and lacks for a session.

#include <filesystem>
#include <optional>

namespace CLI {
class App;
}

namespace carom {

/// Prints what this machine has and lacks; under mpirun a table of all nodes. With a rig, judges whether they
/// can show it. Returns the exit status: 0, or 1 if something keeps a session from running.
int runDoctor(const std::optional<std::filesystem::path>& rig);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addDoctor(CLI::App& app, int& status);

}  // namespace carom
