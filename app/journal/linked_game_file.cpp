#include "app/journal/linked_game_file.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "app/journal/session_file.h"
#include "engine/text/printable.h"

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

/// Returns the last frame of the run of the program that has this one. A run that was killed may lack its
/// last moments, which the next one lives in another way.
std::int64_t lastOfRun(SQLite::Database& database, std::int64_t frame) {
  SQLite::Statement row(database, "SELECT min(first_frame) FROM run WHERE first_frame > ?");
  row.bind(1, frame);
  return row.executeStep() && !row.getColumn(0).isNull() ? row.getColumn(0).getInt64() - 1 : kLast;
}

void readHeads(SQLite::Database& database, std::int64_t firstOfGame, std::int64_t lastOfRun,
               LinkedGameRows& game) {
  SQLite::Statement told = between(database,
                                   "SELECT viewer, t_s, x_m, y_m, z_m, proper_time_s FROM link_person "
                                   "WHERE number > 0 AND frame BETWEEN ? AND ? ORDER BY rowid",
                                   game.firstFrame, game.lastFrame);
  while (told.executeStep()) game.told.emplace_back(textOf(told, 0), numbersOf(told, 1));
  SQLite::Statement head =
      between(database,
              "SELECT frame, name, t_s, x_m, y_m, z_m, proper_time_s FROM viewer WHERE frame "
              "BETWEEN ? AND ?",
              firstOfGame, lastOfRun);
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

constexpr bool kQuiet = true;

SQLite::Database openLinked(const std::filesystem::path& file) {
  SQLite::Database database(file.string(), SQLite::OPEN_READONLY, 1000);
  if (!database.tableExists("link_note"))
    throw std::runtime_error(fmt::format(
        "session file {}: it has no linked game, expected one of carom cave --link", file.string()));
  return database;
}

/// Expects that each room's strokes are numbered from 0 on.
void expectNumbered(const std::vector<HandStroke>& strokes) {
  std::array<std::vector<std::uint32_t>, 2> numbers;
  for (const HandStroke& made : strokes) {
    if (made.room >= numbers.size()) throw std::runtime_error("a stroke of a third room");
    numbers[made.room].push_back(made.number);
  }
  for (std::vector<std::uint32_t>& ofRoom : numbers) {
    std::ranges::sort(ofRoom);
    for (std::uint32_t i = 0; i < ofRoom.size(); ++i)
      if (ofRoom[i] != i) throw std::runtime_error(fmt::format("stroke {} of a room is not there", i));
  }
}

}  // namespace

std::vector<HandStroke> hostedStrokesOf(const std::filesystem::path& file, std::span<const Puck> pucks) try {
  const SessionFile session(file, {}, kQuiet);
  SQLite::Database database = openLinked(file);
  std::vector<HandStroke> strokes;
  const auto ends = session.frames();
  if (!ends) return strokes;
  const auto first = static_cast<std::int64_t>(ends->first), last = static_cast<std::int64_t>(ends->second);
  if (between(database, "SELECT 1 FROM link WHERE room = 0 AND frame BETWEEN ? AND ? LIMIT 1", first, last)
          .executeStep())
    throw std::runtime_error(
        "another room has hosted its newest game, expected --link with the address of that room");
  for (const Stroke& stroke : session.strokes(pucks)) strokes.push_back({stroke});
  // In the order of SessionFile::strokes.
  SQLite::Statement row = between(database,
                                  "SELECT room, number, viewer, CASE WHEN room > 0 THEN (SELECT person FROM "
                                  "link_person AS told WHERE told.viewer = stroke.viewer LIMIT 1) END "
                                  "FROM stroke WHERE frame BETWEEN ? AND ? ORDER BY frame, rowid",
                                  first, last);
  for (HandStroke& made : strokes) {
    row.executeStep();
    made.room = row.getColumn(0).getUInt();
    made.number = row.getColumn(1).getUInt();
    made.viewerName = textOf(row, 2);
    made.viewer = std::min<std::size_t>(row.getColumn(3).getUInt(), kMostViewers - 1);
    if (made.room == 0) made.viewer = session.viewerNamed(made.viewerName);
  }
  expectNumbered(strokes);
  return strokes;
} catch (const std::exception& error) {
  const std::string words = error.what(), where = fmt::format("session file {}: ", file.string());
  throw std::runtime_error(words.starts_with("session file") ? words : where + words);
}

std::vector<LinkedGameRows> linkedGamesOf(const std::filesystem::path& file) {
  const SessionFile session(file, {}, kQuiet);  // refuses other files
  try {
    SQLite::Database database = openLinked(file);
    std::vector<LinkedGameRows> games = spansOf(database);
    const std::vector<SessionGame>& all = session.games();
    for (LinkedGameRows& game : games) {
      while (game.game < all.size() && all[game.game].firstFrame <= game.firstFrame) ++game.game;
      const SessionGame& played = all[game.game - 1];
      const SessionGame* const next = game.game < all.size() ? &all[game.game] : nullptr;
      if (next) game.lastFrame = std::min(game.lastFrame, next->firstFrame - 1);
      const std::int64_t ends = lastOfRun(database, game.firstFrame);
      game.lastFrame = std::min(game.lastFrame, ends);
      readPromises(database, game);
      readHeads(database, played.firstFrame, ends, game);
      readStrokes(database, played.firstFrame, next ? next->firstFrame - 1 : kLast, game);
      readTurns(database, played.firstEvent, next ? next->firstEvent - 1 : kLast, game);
    }
    return games;
  } catch (const SQLite::Exception& error) {
    throw std::runtime_error(fmt::format("session file {}: {}", file.string(), error.what()));
  }
}

}  // namespace carom
