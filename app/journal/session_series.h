#pragma once
// The names of the session files of games that are played one after the other: visit.db, visit-2.db,
// visit-3.db.

#include <filesystem>

namespace carom {

/// Returns the file of the next game, after those that exist.
std::filesystem::path fileAfter(const std::filesystem::path& first);

/// Returns the file of the newest game.
std::filesystem::path newestOf(const std::filesystem::path& first);

}  // namespace carom
