#include "app/journal/session_games.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

#include "engine/text/printable.h"

namespace carom {
namespace {

/// Returns the SQL expression for the first frame of the game after that which begins with `firstFrame`.
std::string endOf(const std::string& firstFrame) {
  return fmt::format(
      "(SELECT coalesce(min(first_frame), 9223372036854775807) FROM main.game WHERE first_frame > {})",
      firstFrame);
}

std::vector<SessionGame> allGames(SQLite::Database& database) {
  std::vector<SessionGame> games;
  SQLite::Statement row(database,
                        "SELECT first_frame, first_event, started_utc, scenario_file, scenario, "
                        "light_speed_m_s FROM game ORDER BY first_frame");
  while (row.executeStep()) {
    SessionGame& game = games.emplace_back();
    game.firstFrame = row.getColumn(0).getInt64();
    game.firstEvent = row.getColumn(1).getInt64();
    game.startedUtc = printable(row.getColumn(2).getString());
    game.scenario = row.getColumn(3).getString();
    game.scenarioText = row.getColumn(4).getString();
    game.lightSpeed_m_s = row.getColumn(5).getDouble();
  }
  return games;
}

/// Fills in when the first and the last frame of each game were shown.
void findSpans(SQLite::Database& database, std::vector<SessionGame>& games) {
  SQLite::Statement first(database,
                          "SELECT number, display_s FROM frame WHERE number >= ? ORDER BY number LIMIT 1");
  SQLite::Statement last(database,
                         "SELECT number, display_s FROM frame WHERE number < ? ORDER BY number DESC LIMIT 1");
  for (std::size_t i = 0; i < games.size(); ++i) {
    SessionGame& game = games[i];
    first.reset();
    first.bind(1, game.firstFrame);
    last.reset();
    last.bind(1, i + 1 < games.size() ? games[i + 1].firstFrame : INT64_MAX);
    if (!first.executeStep() || !last.executeStep()) continue;
    game.hasFrames = first.getColumn(0).getInt64() <= last.getColumn(0).getInt64();
    game.from_s = first.getColumn(1).getDouble();
    game.to_s = last.getColumn(1).getDouble();
  }
}

/// `firsts`: the numbers of its first frame and event, in SQL.
void add(SQLite::Database& database, const char* firsts, const SessionFacts& facts) {
  SQLite::Statement row(database, fmt::format("INSERT INTO game VALUES({}, ?, ?, ?, ?)", firsts));
  row.bind(1, fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr))));
  row.bind(2, std::filesystem::absolute(facts.scenario).string());
  row.bind(3, facts.scenarioText);
  row.bind(4, facts.lightSpeed_m_s);
  row.exec();
}

}  // namespace

std::string sessionValue(SQLite::Database& session, const std::string& key) {
  SQLite::Statement row(session, "SELECT value FROM session WHERE key = ?");
  row.bind(1, key);
  return row.executeStep() ? row.getColumn(0).getString() : "";
}

void addFirstGame(SQLite::Database& database, const SessionFacts& facts) {
  database.exec(
      "CREATE TABLE game(first_frame INTEGER PRIMARY KEY, first_event INTEGER, started_utc TEXT, "
      "scenario_file TEXT, scenario TEXT, light_speed_m_s REAL)");
  add(database, "0, 0", facts);
}

void addGame(SQLite::Database& database, const SessionFacts& facts) {
  add(database,
      "(SELECT coalesce(max(number), 0) + 1 FROM frame), (SELECT coalesce(max(number) + 1, 0) FROM event)",
      facts);
}

void removeEmptyGames(SQLite::Database& database) {
  database.exec(
      "DELETE FROM game WHERE first_frame > (SELECT coalesce(max(number), 0) FROM frame) AND first_frame > "
      "(SELECT min(first_frame) FROM game)");
}

std::uint64_t firstEventOfNewest(SQLite::Database& database) {
  return static_cast<std::uint64_t>(
      database.execAndGet("SELECT first_event FROM game ORDER BY first_frame DESC LIMIT 1").getInt64());
}

std::vector<SessionGame> gamesIn(SQLite::Database& database) {
  std::vector<SessionGame> games = allGames(database);
  findSpans(database, games);
  std::vector<SessionGame> shown;
  for (const SessionGame& game : games)
    if (game.hasFrames) shown.push_back(game);
  if (shown.empty() && !games.empty()) shown.push_back(games.front());
  return shown;
}

void showOnly(SQLite::Database& database, const SessionGame& game) {
  const std::string first = std::to_string(game.firstFrame);
  database.exec(
      fmt::format("CREATE TEMP VIEW frame AS SELECT * FROM main.frame WHERE number >= {} AND number < {}",
                  first, endOf(first)));
}

}  // namespace carom
