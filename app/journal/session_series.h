#pragma once
// The names of the session files of games that are played one after the other: visit.db, visit-2.db,
// visit-3.db; and of those that have the date in their name.

#include <filesystem>

namespace carom {

/// Returns the file of the next game, after those that exist; the first if there is none.
std::filesystem::path fileAfter(const std::filesystem::path& first);

/// Returns the name with today's date in the place of its date ("monday-%F.db", as strftime has it). Throws
/// std::runtime_error if the name is too long.
std::filesystem::path namedToday(const std::filesystem::path& name);

/// Returns the session file that a name with a date asks for ("monday-%F.db", as strftime has it), today and free;
/// other names as they are. Throws std::runtime_error if the name is too long.
std::filesystem::path datedFile(const std::filesystem::path& name);

/// Returns the file of the newest game.
std::filesystem::path newestOf(const std::filesystem::path& first);

}  // namespace carom
