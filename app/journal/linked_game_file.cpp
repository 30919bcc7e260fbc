#include "app/journal/linked_game_file.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "app/journal/session_file.h"
#include "engine/base/printable.h"

namespace carom {
namespace {

constexpr std::int64_t kLast = std::numeric_limits<std::int64_t>::max();

using Numbers = LinkedGameRows::Numbers;

Numbers numbersOf(SQLite::Statement& row, int first) {
  Numbers numbers;
  for (int column = first; column < row.getColumnCount(); ++column)
    numbers.push_back(row.getColumn(column).getDouble());
  return numbers;
}

std::string textOf(SQLite::Statement& row, int column) {
  return printable(row.getColumn(column).getString());
}

/// A query of the rows between two frames, or other bounds.
SQLite::Statement between(SQLite::Database& database, const char* sql, std::int64_t from, std::int64_t to) {
  SQLite::Statement row(database, sql);
  row.bind(1, from);
  row.bind(2, to);
  return row;
}

/// Returns the spans of the linked games: each begins where rooms are paired, and ends where they part.
std::vector<LinkedGameRows> spansOf(SQLite::Database& database) {
  std::vector<LinkedGameRows> games;
  SQLite::Statement row(database, "SELECT frame, room, what, value FROM link_note ORDER BY rowid");
  bool isOpen = false;
  while (row.executeStep()) {
    const std::int64_t frame = row.getColumn(0).getInt64();
    const std::string what = textOf(row, 2), value = textOf(row, 3);
    const bool begins = what == "paired", ends = what == "gone" || what == "mismatch" || what == "refused";
    if (isOpen && (begins || ends)) {
      games.back().lastFrame = frame;
      isOpen = false;
    }
    if (!begins) continue;
    LinkedGameRows& game = games.emplace_back();
    constexpr std::size_t kDigits = 16, kWord = 5;  // "game "
    game.number = value.substr(std::min(kWord, value.size()), kDigits);
    game.otherRoom = static_cast<std::uint32_t>(row.getColumn(1).getInt64());
    game.firstFrame = frame;
    game.lastFrame = kLast;
    isOpen = true;
  }
  return games;
}

void readPromises(SQLite::Database& database, LinkedGameRows& game) {
  SQLite::Statement row =
      between(database,
              "SELECT frame, promise_t_s, promise_x_m, promise_y_m, promise_z_m FROM link "
              "WHERE frame BETWEEN ? AND ? ORDER BY frame",
              game.firstFrame, game.lastFrame);
  while (row.executeStep()) {
    const Numbers at = numbersOf(row, 1);
    game.promises[row.getColumn(0).getInt64()].push_back({at[0], {at[1], at[2], at[3]}});
  }
  if (game.promises.empty()) return;
  game.knownUntil_s = std::numeric_limits<double>::infinity();
  for (const Event& promise : game.promises.rbegin()->second)
    game.knownUntil_s = std::min(game.knownUntil_s, promise.t_s);
}

void readHeads(SQLite::Database& database, std::int64_t firstOfGame, LinkedGameRows& game) {
  SQLite::Statement told = between(database,
                                   "SELECT viewer, t_s, x_m, y_m, z_m, proper_time_s FROM link_person "
                                   "WHERE number > 0 AND frame BETWEEN ? AND ? ORDER BY rowid",
                                   game.firstFrame, game.lastFrame);
  while (told.executeStep()) game.told.emplace_back(textOf(told, 0), numbersOf(told, 1));
  SQLite::Statement head =
      between(database,
              "SELECT frame, name, t_s, x_m, y_m, z_m, proper_time_s FROM viewer WHERE frame "
              "BETWEEN ? AND ?",
              firstOfGame, kLast);
  while (head.executeStep()) game.heads[textOf(head, 1)][numbersOf(head, 2)] = head.getColumn(0).getInt64();
}

void readStrokes(SQLite::Database& database, std::int64_t first, std::int64_t last, LinkedGameRows& game) {
  SQLite::Statement row = between(
      database,
      "SELECT room, number, puck, at_s, from_x_m, from_y_m, from_z_m, p_x_kg_m_s, p_y_kg_m_s, offset_m "
      "FROM stroke WHERE frame BETWEEN ? AND ?",
      first, last);
  while (row.executeStep())
    game.strokes[{row.getColumn(0).getInt64(), row.getColumn(1).getInt64()}] = {textOf(row, 2),
                                                                                numbersOf(row, 3)};
}

void readTurns(SQLite::Database& database, std::int64_t first, std::int64_t last, LinkedGameRows& game) {
  SQLite::Statement row =
      between(database,
              "SELECT puck, t_s, x_m, y_m, z_m, beta_before_x, beta_before_y, beta_after_x, beta_after_y, "
              "proper_time_s, spin_before_kg_m2_s, spin_after_kg_m2_s FROM turn WHERE event BETWEEN ? AND ?",
              first, last);
  while (row.executeStep()) game.turns[textOf(row, 0)].push_back(numbersOf(row, 1));
  for (auto& [puck, turns] : game.turns) std::sort(turns.begin(), turns.end());
}

}  // namespace

std::vector<LinkedGameRows> linkedGamesOf(const std::filesystem::path& file) {
  constexpr bool kQuiet = true;
  const SessionFile session(file, {}, kQuiet);  // refuses other files
  try {
    SQLite::Database database(file.string(), SQLite::OPEN_READONLY, 1000);
    if (!database.tableExists("link_note"))
      throw std::runtime_error(fmt::format(
          "session file {}: it has no linked game, expected one of carom cave --link", file.string()));
    std::vector<LinkedGameRows> games = spansOf(database);
    const std::vector<SessionGame>& all = session.games();
    for (LinkedGameRows& game : games) {
      while (game.game < all.size() && all[game.game].firstFrame <= game.firstFrame) ++game.game;
      const SessionGame& played = all[game.game - 1];
      const SessionGame* const next = game.game < all.size() ? &all[game.game] : nullptr;
      if (next) game.lastFrame = std::min(game.lastFrame, next->firstFrame - 1);
      readPromises(database, game);
      readHeads(database, played.firstFrame, game);
      readStrokes(database, played.firstFrame, next ? next->firstFrame - 1 : kLast, game);
      readTurns(database, played.firstEvent, next ? next->firstEvent - 1 : kLast, game);
    }
    return games;
  } catch (const SQLite::Exception& error) {
    throw std::runtime_error(fmt::format("session file {}: {}", file.string(), error.what()));
  }
}

}  // namespace carom
