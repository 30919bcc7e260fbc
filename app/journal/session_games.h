#pragma once
// The games of a session file, one after the other, and the values that belong to the whole session: the
// tables `game` and `session` (app/journal/journal.h).

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/journal/session_facts.h"

namespace SQLite {
class Database;
}

namespace carom {

/// The frames and events of a game are those up to the next game's first ones.
struct SessionGame {
  std::int64_t firstFrame = 0, firstEvent = 0;
  std::string startedUtc;
  std::filesystem::path scenario;
  std::string scenarioText;
  double lightSpeed_m_s = 0.0;
  double from_s = 0.0, to_s = 0.0;  ///< session clock: its first and its last frame
  bool hasFrames = false;
};

/// Returns a value of the table `session`; empty if it is not there.
std::string sessionValue(SQLite::Database& session, const std::string& key);

/// Creates the table, with the first game.
void addFirstGame(SQLite::Database& database, const SessionFacts& facts);

/// Adds a game whose frames and events are those after the ones in the file.
void addGame(SQLite::Database& database, const SessionFacts& facts);

/// Removes games that ended before their first frame, unless it is the only one.
void removeEmptyGames(SQLite::Database& database);

/// Returns the number of the newest game's first event.
std::uint64_t firstEventOfNewest(SQLite::Database& database);

/// Returns the games that have frames, or the first if none has.
std::vector<SessionGame> gamesIn(SQLite::Database& database);

/// Makes `frame`, in SQL of this connection, mean the frames of this game alone, also while more are written.
void showOnly(SQLite::Database& database, const SessionGame& game);

}  // namespace carom
