#pragma once
// The command line options that the session commands share.

#include <CLI/App.hpp>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/journal/session_file.h"
#include "app/stage/desk_windows.h"

namespace carom {

/// Adds the option --silent.
void addSilent(CLI::App& command, bool& silent);
/// Adds the options --console, --diagram and --outside.
void addExtraWindows(CLI::App& command, ExtraWindows& extra);
/// Adds the option --without-nodes.
void addWithoutNodes(CLI::App& command, std::vector<int>& nodes);
/// Adds the option --movie.
void addMovie(CLI::App& command, std::optional<std::filesystem::path>& movie);

/// Adds the option --game.
void addGame(CLI::App& command, std::optional<std::size_t>& game);
/// Prints which game of the session is read, and how to choose another, if it has several.
void sayGame(const SessionFile& session, const std::string& title);

}  // namespace carom
