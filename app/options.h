#pragma once
// The command line of carom: what each command takes and what it runs.

#include <CLI/App.hpp>

namespace carom {

/// Adds every command to `app`; the one that is called runs while the line is parsed and leaves its exit
/// status in `status`. Wrong arguments are CLI::ParseError; what the commands throw comes through.
void addCommands(CLI::App& app, int& status);

}  // namespace carom
