#include "app/journal/session_file.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "app/journal/language_keys.h"
#include "app/journal_rows/frame_rows.h"
#include "app/toml/input_file.h"
#include "engine/base/limits.h"
#include "engine/text/log.h"
#include "engine/text/outside_file.h"
#include "engine/text/printable.h"

namespace carom {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw std::runtime_error(fmt::format("session file {}: {}", file.string(), what));
}

[[noreturn]] void refuse(const std::filesystem::path& file, const SQLite::Exception& error) {
  switch (error.getErrorCode()) {
    case SQLITE_NOTADB:
      refuse(file, "this is no session file, expected what carom cave --session wrote");
    case SQLITE_CORRUPT:
      refuse(file, std::string("it is damaged (") + error.what() +
                       "); sqlite3 FILE .recover may save what is left");
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      refuse(file, "another program has locked it; expected that one to have ended");
    default:
      refuse(file, error.what());
  }
}

/// Returns FILE-wal, which holds an open session's data and, after a crash, what was not yet moved into the
/// file.
std::filesystem::path besideOf(std::filesystem::path file) { return file += "-wal"; }

bool hasBeside(const std::filesystem::path& file) {
  std::error_code absent;
  const auto bytes = std::filesystem::file_size(besideOf(file), absent);
  return !absent && bytes > 0;
}

constexpr int kReaderWaits_ms = 1000;

/// Takes back what a process was writing when it was killed, which it has noted in FILE-journal: a reader
/// that may not write cannot, and would find the file damaged.
void takeBackUnfinished(const std::filesystem::path& file) {
  std::filesystem::path notes = file;
  if (!std::filesystem::exists(notes += "-journal")) return;
  try {
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE, kReaderWaits_ms)
        .execAndGet("SELECT count(*) FROM sqlite_schema");
  } catch (const SQLite::Exception&) {  // who reads it then says why not
  }
}

}  // namespace

struct SessionFile::Tables {
  explicit Tables(const std::filesystem::path& file)
      : database((takeBackUnfinished(file), file.string()), SQLite::OPEN_READONLY, kReaderWaits_ms) {}
  void prepare(double lightSpeed_m_s) {
    frames.emplace(database, lightSpeed_m_s);
    // Two key lookups; both in one SELECT would read every row.
    ends.emplace(database,
                 "SELECT (SELECT min(number) FROM frame WHERE number >= 0), (SELECT max(number) FROM frame)");
    shown.emplace(database, "SELECT number, display_s FROM frame WHERE number >= ? ORDER BY number LIMIT 1");
  }

  SQLite::Database database;
  std::optional<FrameReader> frames;
  std::optional<SQLite::Statement> ends, shown;
};

SessionFile::SessionFile(const std::filesystem::path& file, std::optional<std::size_t> game, bool quiet)
    : file_(file) {
  if (const std::string refusal = refusalOf(file, InputKind::session); !refusal.empty())
    refuse(file, refusal);
  const bool alone = !hasBeside(file);  // opening the database creates an empty one
  try {
    tables_ = std::make_unique<Tables>(file);
    SQLite::Database& database = tables_->database;
    const bool open = database.execAndGet("PRAGMA journal_mode").getString() == "wal";
    if (open && alone && database.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0) {
      refuse(file,
             fmt::format(
                 "nothing is in it: what a session wrote that was not closed is in {}, expected beside it",
                 besideOf(file).filename().string()));
    }
    if (database.execAndGet("PRAGMA application_id").getInt() != kJournalId) {
      refuse(file, "this is another program's database, expected what carom cave --session wrote");
    }
    const int version = database.execAndGet("PRAGMA user_version").getInt();
    if (version != kJournalVersion) {
      refuse(file, fmt::format("{} carom wrote it (version {} of the tables), expected version {}",
                               version > kJournalVersion ? "a newer" : "an older", version, kJournalVersion));
    }
    const std::string check = database.execAndGet("PRAGMA quick_check").getString();
    if (check != "ok")
      refuse(file, "it is damaged (" + check + "); sqlite3 FILE .recover may save what is left");
    // A view or a trigger in the place of a table could compute without end.
    if (database.execAndGet("SELECT count(*) FROM sqlite_schema WHERE type IN ('view', 'trigger')").getInt() >
        0)
      refuse(file, "it has views or triggers, expected what carom cave --session wrote, tables alone");
    games_ = gamesIn(database);
    game_ = game.value_or(games_.size());
    if (game_ < 1 || game_ > games_.size())
      refuse(file, fmt::format("it has {} game{}, expected the number of one of them", games_.size(),
                               games_.size() == 1 ? "" : "s"));
    const SessionGame& chosen = games_[game_ - 1];
    const auto fact = [&](const std::string& key) { return sessionValue(database, key); };
    const double first_m_s =
        database.execAndGet("SELECT value FROM session WHERE key = 'light_speed_m_s'").getDouble();
    for (const double light_m_s : {chosen.lightSpeed_m_s, first_m_s}) {
      if (light_m_s >= kSmallest && within(kPositive, light_m_s)) continue;
      refuse(file, fmt::format("light_speed_m_s is {}, expected {}", light_m_s, wordsFor(kPositive, false)));
    }
    facts_ = {fact("program"), fact("rig_file"),    chosen.scenario,
              fact("rig"),     chosen.scenarioText, chosen.lightSpeed_m_s};
    showOnly(database, chosen);
    const double textSize = std::strtod(fact(kKeyOfTextSize).c_str(), nullptr);
    if (textSize > 1.0 && textSize <= 2.0) facts_.textSize = textSize;
    for (const std::size_t axis : {0, 1}) {
      constexpr long kMost = 8192;
      const std::string pixels = fact(kKeysOfEyePixels[axis]);
      facts_.eyePixels[axis] =
          static_cast<int>(std::clamp(std::strtol(pixels.c_str(), nullptr, 10), 0L, kMost));
    }
    facts_.isLinked = ToldReader::hasTable(database);
    for (std::size_t viewer = 0; viewer < kMostViewers; ++viewer) {
      const std::string name = printable(fact(keyOfViewer(viewer)));
      if (name.empty()) break;
      if (viewer == 0) facts_.viewers.clear();
      facts_.viewers.push_back(name);
    }
    facts_.languages = languagesIn(database, facts_.viewers);
    if (!quiet && open && alone && fact("ended_utc").empty()) {
      log::warn(fmt::format(
          "session file {0}: the session was not closed, and {1}, which belongs beside it, is not "
          "there: up to "
          "its last minute is missing.",
          file.string(), besideOf(file).filename().string()));
    }
    tables_->prepare(facts_.lightSpeed_m_s);
  } catch (const SQLite::Exception& error) {
    refuse(file, error);
  }
}

SessionFile::~SessionFile() = default;

std::size_t SessionFile::viewerNamed(const std::string& name) const {
  const auto found = std::find(facts_.viewers.begin(), facts_.viewers.end(), name);
  if (found == facts_.viewers.end())
    refuse(file_,
           fmt::format("there is no viewer '{}', expected {}", name, fmt::join(facts_.viewers, " or ")));
  return static_cast<std::size_t>(found - facts_.viewers.begin());
}

std::optional<std::pair<std::uint64_t, std::uint64_t>> SessionFile::frames() const {
  SQLite::Statement& row = *tables_->ends;
  std::optional<std::pair<std::uint64_t, std::uint64_t>> ends;
  if (row.executeStep() && !row.getColumn(0).isNull()) {
    ends.emplace(static_cast<std::uint64_t>(row.getColumn(0).getInt64()),
                 static_cast<std::uint64_t>(row.getColumn(1).getInt64()));
  }
  row.reset();
  return ends;
}

Scenario SessionFile::scenario() const {
  Scenario scenario = readScenario(facts_.scenario, facts_.scenarioText);
  if (scenario.billiard.lightSpeed_m_s != facts_.lightSpeed_m_s) {
    refuse(file_, fmt::format("light_speed_m_s is {}, expected {} as in its scenario", facts_.lightSpeed_m_s,
                              scenario.billiard.lightSpeed_m_s));
  }
  return scenario;
}

std::vector<Stroke> SessionFile::strokes(std::span<const Puck> pucks) const {
  std::vector<Stroke> strokes;
  for (const auto& [frame, stroke] : strokesByFrame(pucks)) strokes.push_back(stroke);
  return strokes;
}

std::vector<std::pair<std::uint64_t, Stroke>> SessionFile::strokesByFrame(std::span<const Puck> pucks) const
    try {
  std::vector<std::pair<std::uint64_t, Stroke>> strokes;
  const auto ends = frames();
  if (!ends) return strokes;
  SQLite::Statement row(
      tables_->database,
      "SELECT frame, puck, at_s, from_x_m, from_y_m, from_z_m, p_x_kg_m_s, p_y_kg_m_s, offset_m FROM stroke "
      "WHERE frame BETWEEN ? AND ? ORDER BY frame, rowid");
  row.bind(1, static_cast<std::int64_t>(ends->first));
  row.bind(2, static_cast<std::int64_t>(ends->second));
  while (row.executeStep()) {
    const auto frame = static_cast<std::uint64_t>(row.getColumn(0).getInt64());
    const std::string name = printable(row.getColumn(1).getString());
    const auto number = [&](int column) { return row.getColumn(column).getDouble(); };
    const auto found =
        std::find_if(pucks.begin(), pucks.end(), [&](const Puck& puck) { return puck.name == name; });
    const Stroke stroke{static_cast<std::size_t>(found - pucks.begin()),
                        number(2),
                        Vec3(number(3), number(4), number(5)),
                        {number(6), number(7)},
                        number(8)};
    if (found == pucks.end())
      refuseFrame(frame, "a stroke on '" + name + "', expected a puck of the scenario");
    bool possible = stroke.at_s >= 0.0;
    for (int column = 2; column < 9; ++column)
      possible = possible && row.getColumn(column).isFloat() && std::isfinite(number(column));
    if (!possible) refuseFrame(frame, "a stroke on '" + name + "' that is none, expected finite numbers");
    const double most_kg_m_s = kStrongestU * found->mass_kg * facts_.lightSpeed_m_s;
    if (!(glm::length(stroke.momentum_kg_m_s) <= most_kg_m_s * (1.0 + 1e-9))) {
      refuseFrame(frame, fmt::format("a stroke of {} kg m/s on '{}', expected {} at most",
                                     glm::length(stroke.momentum_kg_m_s), name, most_kg_m_s));
    }
    if (!(std::abs(stroke.offset_m) <= found->radius_m)) {
      refuseFrame(frame, fmt::format("a stroke {} m beside the centre of '{}', expected {} at most",
                                     stroke.offset_m, name, found->radius_m));
    }
    strokes.emplace_back(frame, stroke);
  }
  return strokes;
} catch (const SQLite::Exception& error) {
  refuse(file_, error);
}

std::vector<GivenAnswer> SessionFile::answers() const try {
  // The question stands from the frame after the newest one in another phase, or from the game's first frame.
  SQLite::Statement row(tables_->database, R"(
    WITH given AS (
      SELECT rowid AS place, *, (SELECT max(first_frame) FROM game WHERE first_frame <= answer.frame) AS first
      FROM answer),
    asked AS (
      SELECT *, coalesce((SELECT number + 1 FROM main.frame
                          WHERE number >= first AND number < given.frame AND lesson_phase <> ?
                          ORDER BY number DESC LIMIT 1), first) AS since
      FROM given)
    SELECT frame, first, lesson, question, answer, viewer,
           (SELECT display_s FROM main.frame WHERE number = asked.frame) -
             (SELECT display_s FROM main.frame WHERE number >= since ORDER BY number LIMIT 1),
           1 + (SELECT count(*) FROM input WHERE what = 'visitor' AND input.frame <= asked.frame)
    FROM asked ORDER BY frame, place)");
  row.bind(1, static_cast<int>(LessonPhase::asks));
  const auto words = [&row](int column) { return printable(row.getColumn(column).getString()); };
  std::vector<GivenAnswer> answers;
  while (row.executeStep()) {
    const std::int64_t first = row.getColumn(1).getInt64();
    const auto game = std::find_if(games_.begin(), games_.end(),
                                   [first](const SessionGame& one) { return one.firstFrame == first; });
    if (game == games_.end() || row.getColumn(6).isNull()) continue;  // of a frame that the file lacks
    answers.push_back({static_cast<std::uint64_t>(row.getColumn(0).getInt64()),
                       static_cast<std::size_t>(game - games_.begin()), words(2), words(3), words(4),
                       words(5), row.getColumn(6).getDouble(),
                       static_cast<std::size_t>(row.getColumn(7).getInt64())});
  }
  return answers;
} catch (const SQLite::Exception& error) {
  refuse(file_, error);
}

std::vector<CountedVote> SessionFile::votes() const try {
  std::vector<CountedVote> votes;
  SQLite::Database& database = tables_->database;
  if (!database.tableExists("vote")) return votes;
  SQLite::Statement row(
      database,
      "SELECT frame, round, lesson, question, token, answer, coalesce(confidence, 0), seconds, reason, "
      "(SELECT count(*) FROM game WHERE first_frame <= vote.frame) FROM vote ORDER BY frame, rowid");
  const auto words = [&row](int column) { return printable(row.getColumn(column).getString()); };
  while (row.executeStep()) {
    const auto game = static_cast<std::size_t>(row.getColumn(9).getInt64());
    if (game < 1 || game > games_.size()) continue;
    votes.push_back({static_cast<std::uint64_t>(row.getColumn(0).getInt64()), game - 1,
                     ClassVote{row.getColumn(1).getInt(), words(2), words(3), words(4), words(5),
                               row.getColumn(6).getInt(), row.getColumn(7).getDouble(), words(8)}});
  }
  return votes;
} catch (const SQLite::Exception& error) {
  refuse(file_, error);
}

ClassLeft SessionFile::classLeft() const try {
  ClassLeft left;
  SQLite::Statement row(tables_->database,
                        "SELECT value, (SELECT coalesce(max(frame), 0) FROM input WHERE what = 'class' AND "
                        "value = 'idle') FROM input WHERE what = 'class' ORDER BY rowid DESC LIMIT 1");
  if (!row.executeStep()) return left;
  const std::string phase = row.getColumn(0).getString();
  const std::size_t space = phase.find(' ');
  left.phase = phase.substr(0, space);
  if (space != std::string::npos) left.round = std::atoi(phase.c_str() + space);
  const auto asked = static_cast<std::uint64_t>(row.getColumn(1).getInt64());
  for (const CountedVote& counted : votes()) {
    left.tokens.push_back(counted.vote.token);
    if (counted.frame >= asked) left.votes.push_back(counted.vote);
  }
  return left;
} catch (const SQLite::Exception& error) {
  refuse(file_, error);
}

bool SessionFile::next(FrameState& state) try {
  const std::optional<std::uint64_t> number = tables_->frames->step();
  if (!number) return false;
  try {
    tables_->frames->read(state);
    for (const ViewerState& viewer : state.record.present()) {
      if (const std::size_t all = facts_.languages.all.size(); viewer.language >= all)
        throw std::runtime_error(fmt::format("language is {}, expected below {}", viewer.language, all));
    }
  } catch (const SQLite::Exception&) {
    throw;
  } catch (const std::exception& error) {
    refuseFrame(*number, error.what());
  }
  return true;
} catch (const SQLite::Exception& error) {
  refuse(file_, error);
}

void SessionFile::refuseFrame(std::uint64_t number, const std::string& what) const {
  refuse(file_, fmt::format("frame {}: {}", number, what));
}

void SessionFile::goTo(std::uint64_t number) { tables_->frames->goTo(number); }

void SessionFile::goToChanges() { tables_->frames->goTo(0, true); }

double SessionFile::shownAt_s(std::uint64_t number) const {
  SQLite::Statement& row = *tables_->shown;
  row.bind(1, static_cast<std::int64_t>(number));
  const double shown_s = row.executeStep() ? row.getColumn(1).getDouble() : 0.0;
  row.reset();
  return shown_s;
}

// Bisection works because display_s grows with the frame number.
std::uint64_t SessionFile::frameAt(double display_s) const {
  const auto ends = frames();
  if (!ends) return 0;
  std::uint64_t number = ends->first, after = ends->second + 1;
  SQLite::Statement& row = *tables_->shown;
  while (number + 1 < after) {
    const std::uint64_t middle = number + (after - number) / 2;
    row.bind(1, static_cast<std::int64_t>(middle));
    const bool found = row.executeStep();
    const std::uint64_t there = found ? static_cast<std::uint64_t>(row.getColumn(0).getInt64()) : after;
    if (there < after && row.getColumn(1).getDouble() <= display_s) {
      number = there;
    } else {
      after = middle;
    }
    row.reset();
  }
  return number;
}

}  // namespace carom
