#pragma once
// The command line of carom: what each command takes and what it runs.

namespace carom {

/// Runs the command that the command line names and returns the exit status: its own, 0 after help, 2 where the
/// arguments are wrong. Throws what the command throws.
int runCommandLine(int argc, char** argv);

}  // namespace carom
