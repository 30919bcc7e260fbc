#pragma once
// The commands' part of the manual page carom(1), made from the commands themselves.

#include <string>

namespace CLI {
class App;
}

namespace carom {

/// Returns, in troff's language for manual pages (man(7)), a section for each command of `app`: its usage,
/// its sentence, its arguments and options, and its examples.
std::string manualOfCommands(const CLI::App& app);

}  // namespace carom
