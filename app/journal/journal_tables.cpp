#include "app/journal/journal_tables.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "app/journal/language_keys.h"
#include "app/journal/session_games.h"

namespace carom {
namespace {

constexpr int kWriterWaits_ms = 2000;  // how long to wait for a reader of the file

// The tables besides those of the frames (frameTables).
constexpr const char* kTables = R"(
CREATE TABLE session(key TEXT PRIMARY KEY, value) WITHOUT ROWID;
CREATE TABLE sample(time_s REAL, sensor INTEGER, x_m REAL, y_m REAL, z_m REAL, qw REAL, qx REAL, qy REAL, qz REAL,
  tracker TEXT);
CREATE TABLE event(number INTEGER PRIMARY KEY, kind TEXT, pucks TEXT, cushion TEXT, t_s REAL, x_m REAL, y_m REAL,
  z_m REAL, heat_j REAL, without_delay INTEGER NOT NULL DEFAULT 0, side_on_side INTEGER NOT NULL DEFAULT 0);
CREATE TABLE turn(event INTEGER, puck TEXT, t_s REAL, x_m REAL, y_m REAL, z_m REAL, beta_before_x REAL,
  beta_before_y REAL, beta_after_x REAL, beta_after_y REAL, proper_time_s REAL,
  spin_before_kg_m2_s REAL NOT NULL DEFAULT 0, spin_after_kg_m2_s REAL NOT NULL DEFAULT 0);
CREATE INDEX turn_of_event ON turn(event);
CREATE TABLE stroke(frame INTEGER, puck TEXT, at_s REAL, from_x_m REAL, from_y_m REAL, from_z_m REAL,
  p_x_kg_m_s REAL, p_y_kg_m_s REAL, offset_m REAL NOT NULL DEFAULT 0, viewer TEXT, room INTEGER NOT NULL DEFAULT 0,
  number INTEGER);
CREATE TABLE input(frame INTEGER, what TEXT, value TEXT, viewer TEXT);
CREATE TABLE answer(frame INTEGER, lesson TEXT, question TEXT, answer TEXT, viewer TEXT);
CREATE TABLE run(first_frame INTEGER, started_utc TEXT, program TEXT);
CREATE TABLE latency(display_s REAL, frame INTEGER, node INTEGER, part TEXT, frames INTEGER, median_s REAL, p99_s REAL,
  most_s REAL, jitter_s REAL);
)";

// The table of a session with a class.
constexpr const char* kVoteTable = R"(
CREATE TABLE IF NOT EXISTS vote(frame INTEGER, round INTEGER, lesson TEXT, question TEXT, token TEXT, answer TEXT,
  confidence INTEGER, seconds REAL, reason TEXT);
)";

// A file that was begun before there were tasks gets it when it is continued.
constexpr const char* kTaskTable =
    "CREATE TABLE IF NOT EXISTS task(frame INTEGER, task TEXT, viewer TEXT, event TEXT, stars INTEGER, "
    "energy_j REAL)";

std::string utcNow() { return fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr))); }

void bind(SQLite::Statement& row, int& column, const Vec3& v) {
  for (const double component : {v.x, v.y, v.z}) row.bind(column++, component);
}
void bind(SQLite::Statement& row, int& column, const Vec2& v) {
  for (const double component : {v.x, v.y}) row.bind(column++, component);
}
void bind(SQLite::Statement& row, int& column, std::string_view text) {
  row.bind(column++, std::string(text));
}
void bind(SQLite::Statement& row, int& column, std::uint64_t number) {
  row.bind(column++, static_cast<std::int64_t>(number));
}
template <typename T>
void bind(SQLite::Statement& row, int& column, const T& value) {
  row.bind(column++, value);
}

/// Writes one row.
template <typename... T>
void put(SQLite::Statement& row, const T&... values) {
  int column = 1;
  (bind(row, column, values), ...);
  row.exec();
  row.reset();
}

}  // namespace

void Batch::clear() {
  frames.clear();
  events.clear();
  strokes.clear();
  inputs.clear();
  answers.clear();
  votes.clear();
  tasks.clear();
  link.clear();
  knots.clear();
  samples.clear();
  latencies.clear();
}

JournalTables::JournalTables(const std::filesystem::path& file)
    : database_(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kWriterWaits_ms) {
  database_.exec("PRAGMA journal_mode = WAL");
  // Safe for a killed program; a power failure may lose the last seconds, but never the file.
  database_.exec("PRAGMA synchronous = NORMAL");
}

void JournalTables::make(const SessionFacts& facts) {
  SQLite::Transaction transaction(database_);
  database_.exec(kTables);
  database_.exec(frameTables());
  database_.exec(viewerTables());
  database_.exec(fmt::format("PRAGMA application_id = {}", kJournalId));
  database_.exec(fmt::format("PRAGMA user_version = {}", kJournalVersion));
  SQLite::Statement row(database_, "INSERT INTO session VALUES(?, ?)");
  put(row, "program", facts.program);
  put(row, "started_utc", utcNow());
  put(row, "light_speed_m_s", facts.lightSpeed_m_s);
  put(row, "rig_file", std::filesystem::absolute(facts.rig).string());
  put(row, "rig", facts.rigText);
  put(row, "scenario_file", std::filesystem::absolute(facts.scenario).string());
  put(row, "scenario", facts.scenarioText);
  for (std::size_t viewer = 0; viewer < facts.viewers.size(); ++viewer)
    put(row, keyOfViewer(viewer), facts.viewers[viewer]);
  if (facts.textSize != 1.0) put(row, kKeyOfTextSize, facts.textSize);
  putFirstLanguages(database_, facts.languages, facts.viewers);
  for (const std::size_t axis : {0, 1}) {
    if (facts.eyePixels[axis] > 0) put(row, kKeysOfEyePixels[axis], facts.eyePixels[axis]);
  }
  addFirstGame(database_, facts);
  transaction.commit();
}

void JournalTables::refuse(const std::string& what) const {
  throw std::runtime_error(fmt::format("session file {}: {}", database_.getFilename(), what));
}

void JournalTables::begin(const SessionFacts& facts) {
  pucks_ = facts.pucks;
  viewers_ = facts.viewers;
  trackers_ = facts.trackers;
  const int version = database_.execAndGet("PRAGMA user_version").getInt();
  if (version != kJournalVersion)
    refuse(fmt::format("version {} of the tables, expected version {}", version, kJournalVersion));
  frames_.emplace(database_);
  viewerRows_.emplace(database_, viewers_);
  headsetRows_.emplace(database_);
  forceRows_.emplace(database_);
  if (facts.isLinked) linkRows_.emplace(database_);
  removeEmptyGames(database_);
  if (facts.hasClass) database_.exec(kVoteTable);
  database_.exec(kTaskTable);
  putLanguages(database_, facts.languages);
  if (facts.isAnotherGame) addGame(database_, facts);
  firstEvent_ = firstEventOfNewest(database_);
  const auto events = static_cast<std::uint64_t>(
      database_.execAndGet("SELECT coalesce(max(number) + 1, 0) FROM event").getInt64());
  listed_ = events - std::min(firstEvent_, events);
  const std::int64_t first =
      database_.execAndGet("SELECT coalesce(max(number) + 1, 0) FROM frame").getInt64();
  SQLite::Statement row(database_, "INSERT INTO run VALUES(?, ?, ?)");
  put(row, first, utcNow(), facts.program);
  database_.exec("DELETE FROM session WHERE key = 'ended_utc'");
  intoFile();
}

void JournalTables::intoFile() {
  try {
    database_.exec("PRAGMA wal_checkpoint(PASSIVE)");
  } catch (const SQLite::Exception&) {
    // Perhaps the disk is full: the data stays in FILE-wal, and the next time may succeed.
  }
}

void JournalTables::close() {
  try {
    SQLite::Statement row(database_, "INSERT OR REPLACE INTO session VALUES('ended_utc', ?)");
    put(row, utcNow());
    database_.exec("PRAGMA journal_mode = DELETE");
  } catch (const SQLite::Exception&) {
    // Another process is reading the file: it stays in WAL mode, which is as good.
  }
}

void JournalTables::write(const Batch& batch) {
  const std::uint64_t listedBefore = listed_;
  try {
    SQLite::Transaction transaction(database_);
    writeFrames(batch);
    writeInputs(batch);
    writeVotes(batch);
    writeTasks(batch);
    if (linkRows_) linkRows_->write(batch.link);
    writeSamples(batch);
    transaction.commit();
  } catch (...) {
    listed_ = listedBefore;
    throw;
  }
}

void JournalTables::writeFrames(const Batch& batch) {
  std::span<const GameEvent> events = batch.events;
  for (const Batch::Frame& row : batch.frames) {
    const std::span<const GameEvent> brought = events.first(row.events);
    events = events.subspan(row.events);
    list(brought, row.record.eventsKept);
    frames_->write(row.record, toString(row.heads[0].known), row.heads[0].celerity_m_s);
    viewerRows_->write(row.record, row.heads);
    headsetRows_->write(row.record);
    forceRows_->write(row.record);
    for (const GameEvent& event : brought) frames_->write(row.record.number, event);
  }
  for (const auto& [frame, knot] : batch.knots) frames_->write(frame, knot);
}

/// Updates the table of events to a frame: deletes those from number `kept` on and adds `brought`.
void JournalTables::list(std::span<const GameEvent> brought, std::uint64_t kept) {
  if (kept < listed_) {
    for (const char* sql : {"DELETE FROM event WHERE number >= ?", "DELETE FROM turn WHERE event >= ?"}) {
      SQLite::Statement old(database_, sql);
      put(old, firstEvent_ + kept);
    }
    listed_ = kept;
  }
  if (brought.empty()) return;
  SQLite::Statement& row = statement(event_, "INSERT OR REPLACE INTO event VALUES(?,?,?,?,?,?,?,?,?,?,?)");
  SQLite::Statement& turnRow = statement(turn_, "INSERT INTO turn VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?)");
  for (const GameEvent& event : brought) {
    std::string pucks;
    for (const Turn& turn : event.turns) {
      pucks += (pucks.empty() ? "" : ", ") + nameOf(turn.puck);
      put(turnRow, firstEvent_ + event.number, nameOf(turn.puck), turn.event.t_s, turn.event.r_m,
          turn.betaBefore, turn.betaAfter, turn.properTime_s, turn.spinBefore_kg_m2_s,
          turn.spinAfter_kg_m2_s);
    }
    put(row, firstEvent_ + event.number, carom::nameOf(event.kind), pucks,
        event.cushion ? carom::nameOf(*event.cushion) : std::string_view(), event.at.t_s, event.at.r_m,
        event.heat_j, event.withoutDelay ? 1 : 0, event.sideOnSide ? 1 : 0);
    listed_ = event.number + 1;
  }
}

void JournalTables::writeInputs(const Batch& batch) {
  if (!batch.strokes.empty()) {
    SQLite::Statement row(database_, "INSERT INTO stroke VALUES(?,?,?,?,?,?,?,?,?,?,?,?)");
    for (const auto& [frame, made] : batch.strokes) {
      const Stroke& stroke = made.stroke;
      put(row, frame, nameOf(stroke.puck), stroke.at_s, stroke.from_m.value(), stroke.momentum_kg_m_s,
          stroke.offset_m, viewerOf(made), std::uint64_t{made.room}, std::uint64_t{made.number});
    }
  }
  if (!batch.inputs.empty()) {
    SQLite::Statement row(database_, "INSERT INTO input VALUES(?,?,?,?)");
    for (const auto& [frame, input] : batch.inputs)
      put(row, frame, input.what, input.value, viewers_.at(input.viewer));
  }
  if (!batch.answers.empty()) {
    SQLite::Statement row(database_, "INSERT INTO answer VALUES(?,?,?,?,?)");
    for (const auto& [frame, a] : batch.answers)
      put(row, frame, a.lesson, a.question, a.answer, viewers_.at(a.viewer));
  }
}

void JournalTables::writeVotes(const Batch& batch) {
  if (batch.votes.empty()) return;
  SQLite::Statement row(database_, "INSERT INTO vote VALUES(?,?,?,?,?,?,nullif(?,0),?,?)");
  for (const auto& [frame, v] : batch.votes)
    put(row, frame, v.round, v.lesson, v.question, v.token, v.answer, v.confidence, v.seconds, v.reason);
}

void JournalTables::writeTasks(const Batch& batch) {
  if (batch.tasks.empty()) return;
  SQLite::Statement row(database_, "INSERT INTO task VALUES(?,?,?,?,?,?)");
  for (const auto& [frame, news] : batch.tasks)
    put(row, frame, news.task, viewers_.at(news.viewer), news.event, news.stars, news.energy_j);
}

void JournalTables::writeSamples(const Batch& batch) {
  SQLite::Statement& sample = statement(sample_, "INSERT INTO sample VALUES(?,?,?,?,?,?,?,?,?,?)");
  for (const auto& [tracker, s] : batch.samples) {
    const glm::dquat& q = s.pose.orientation;
    put(sample, s.time_s, s.sensor, s.pose.position_m, q.w, q.x, q.y, q.z,
        tracker < trackers_.size() ? trackers_[tracker] : fmt::format("tracker {}", tracker + 1));
  }
  SQLite::Statement& latency = statement(latency_, "INSERT INTO latency VALUES(?,?,?,?,?,?,?,?,?)");
  for (const LatencyRow& row : batch.latencies) {
    const PartStatistics& s = row.statistics;
    put(latency, row.display_s, row.frame, row.node, kFrameParts[static_cast<std::size_t>(row.part)],
        std::uint64_t{s.frames}, static_cast<double>(s.median_s), static_cast<double>(s.p99_s),
        static_cast<double>(s.most_s), static_cast<double>(s.jitter_s));
  }
}

std::string JournalTables::nameOf(std::size_t puck) const {
  return puck < pucks_.size() ? pucks_[puck] : fmt::format("puck {}", puck + 1);
}

std::string JournalTables::viewerOf(const HandStroke& stroke) const {
  return stroke.viewerName.empty() ? viewers_.at(stroke.viewer) : stroke.viewerName;
}

SQLite::Statement& JournalTables::statement(std::optional<SQLite::Statement>& kept, const char* sql) {
  if (!kept) kept.emplace(database_, sql);
  kept->tryReset();
  return *kept;
}

}  // namespace carom
