#pragma once
// `carom cave`: the immersive session.

#include "app/commands/cave_options.h"

namespace CLI {
class App;
}

namespace carom {

/// Runs a session to its end; under mpirun, this rank's part of it. Returns the exit status: 0, or 1 after a
/// message on standard error.
int runCave(const CaveOptions& options);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addCave(CLI::App& app, int& status);

}  // namespace carom
