#pragma once
// The names of session files that have the date in their name, and of those of a series: visit.db,
// visit-2.db, visit-3.db.

#include <filesystem>

namespace carom {

/// Returns the next file of the series, after those that exist; the first if there is none.
std::filesystem::path fileAfter(const std::filesystem::path& first);

/// Returns the name with today's date in the place of its date ("monday-%F.db", as strftime has it). Throws
/// std::runtime_error if the name is too long.
std::filesystem::path namedToday(const std::filesystem::path& name);

/// Returns the session file that a name with a date asks for ("monday-%F.db", as strftime has it), today and
/// free; other names as they are. Throws std::runtime_error if the name is too long.
std::filesystem::path datedFile(const std::filesystem::path& name);

/// Returns the newest file of the series.
std::filesystem::path newestOf(const std::filesystem::path& first);

}  // namespace carom
