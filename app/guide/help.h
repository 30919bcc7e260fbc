#pragma once
// `carom help`: the commands, one command, or what a message of the program means and what helps.

namespace CLI {
class App;
}

namespace carom {

/// Adds the command to `app`, whose commands must have been added. When it runs, it stores its exit status in
/// `status`.
void addHelp(CLI::App& app, int& status);

}  // namespace carom
