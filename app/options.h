#pragma once
// The command line of carom: the arguments of each command and what it runs.

namespace carom {

/// Runs the command that the command line names and returns the exit status: that of the command, 0 after
/// help, 2 if the arguments are wrong. Throws what the command throws.
int runCommandLine(int argc, char** argv);

}  // namespace carom
