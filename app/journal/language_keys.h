#pragma once
// The languages of a session in the table `session` (app/journal/journal.h): `language` is the one that all
// viewers read at first, or `language.NAME` that of each viewer where they differ. Where the session has
// several, `language_1`, `language_2` and so on are all of them; the frames count them from 0.

#include <span>
#include <string>

#include "app/file_keys/session_languages.h"

namespace SQLite {
class Database;
}

namespace carom {

/// Writes those that the viewers read at first, as the session begins.
void putFirstLanguages(SQLite::Database& database, const SessionLanguages& languages,
                       std::span<const std::string> viewers);

/// Writes all of them, if there are several, in the place of those that are there.
void putLanguages(SQLite::Database& database, const SessionLanguages& languages);

/// Returns the languages of a session; English if the file has none. Throws std::runtime_error for a name
/// that no language has.
SessionLanguages languagesIn(SQLite::Database& database, std::span<const std::string> viewers);

}  // namespace carom
