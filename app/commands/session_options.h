#pragma once
// The command line options that the session commands share.

#include <CLI/App.hpp>
#include <filesystem>
#include <optional>

#include "app/stage/desk_windows.h"

namespace carom {

/// Adds the option --silent.
void addSilent(CLI::App& command, bool& silent);
/// Adds the options --console, --diagram and --outside.
void addExtraWindows(CLI::App& command, ExtraWindows& extra);
/// Adds the option --movie.
void addMovie(CLI::App& command, std::optional<std::filesystem::path>& movie);

}  // namespace carom
