#include "app/study/study_tables.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

#include "app/journal/session_games.h"

namespace carom {
namespace {

constexpr int kBusy_ms = 4000;  // how long to wait for the journal's writer

constexpr const char* kTables = R"(
CREATE TABLE IF NOT EXISTS participant(code TEXT PRIMARY KEY, study TEXT, arm TEXT, order_row INTEGER, forms TEXT,
  consent TEXT, consent_version TEXT, number INTEGER, started_utc TEXT, step INTEGER, lesson INTEGER, excluded TEXT);
CREATE TABLE IF NOT EXISTS response(code TEXT, phase TEXT, form TEXT, item TEXT, answer TEXT, confidence INTEGER,
  seconds REAL, changes INTEGER, reason TEXT, t_s REAL, PRIMARY KEY(code, phase, item));
CREATE TABLE IF NOT EXISTS response_change(code TEXT, phase TEXT, item TEXT, answer TEXT, confidence INTEGER,
  t_s REAL);
CREATE TABLE IF NOT EXISTS participation(code TEXT, lesson TEXT, position INTEGER, first_frame INTEGER,
  PRIMARY KEY(code, lesson, first_frame));
)";

/// Binds the values to the parameters of a statement, in their order, and executes it.
template <typename... T>
void execute(SQLite::Statement& row, const T&... values) {
  int parameter = 1;
  (row.bind(parameter++, values), ...);
  row.exec();
}

std::int64_t whole(std::size_t number) { return static_cast<std::int64_t>(number); }

}  // namespace

bool ParticipantRow::allows(std::string_view box) const {
  return (" " + consent + " ").find(" " + std::string(box) + " ") != std::string::npos;
}

bool hasStudy(SQLite::Database& session) {
  return session.tableExists("participant") && session.tableExists("response") &&
         session.tableExists("participation");
}

std::vector<ParticipantRow> participantsIn(SQLite::Database& session) {
  std::vector<ParticipantRow> rows;
  SQLite::Statement row(session,
                        "SELECT code, arm, number, order_row, forms, consent, consent_version, started_utc, "
                        "step, lesson, excluded FROM participant ORDER BY number, code");
  while (row.executeStep()) {
    const auto text = [&](int column) { return row.getColumn(column).getString(); };
    const auto count = [&](int column) { return static_cast<std::size_t>(row.getColumn(column).getInt64()); };
    rows.push_back({text(0), text(1), count(2), count(3), text(4), text(5), text(6), text(7),
                    row.getColumn(8).getInt(), count(9), text(10)});
  }
  return rows;
}

std::vector<ResponseRow> responsesOf(SQLite::Database& session, const std::string& code) {
  std::vector<ResponseRow> rows;
  SQLite::Statement row(session,
                        "SELECT phase, form, item, answer, confidence, seconds, changes, reason, t_s FROM "
                        "response WHERE code = ? ORDER BY rowid");
  row.bind(1, code);
  while (row.executeStep()) {
    const auto text = [&](int column) { return row.getColumn(column).getString(); };
    rows.push_back({text(0), text(1), text(2), text(3), row.getColumn(4).getInt(),
                    row.getColumn(5).getDouble(), row.getColumn(6).getInt(), text(7),
                    row.getColumn(8).getDouble()});
  }
  return rows;
}

std::vector<ParticipationRow> participationsIn(SQLite::Database& session) {
  std::vector<ParticipationRow> rows;
  SQLite::Statement row(session,
                        "SELECT code, lesson, position, first_frame FROM participation ORDER BY first_frame");
  while (row.executeStep())
    rows.push_back({row.getColumn(0).getString(), row.getColumn(1).getString(),
                    static_cast<std::size_t>(row.getColumn(2).getInt64()), row.getColumn(3).getInt64()});
  return rows;
}

StudyTables::StudyTables(const std::filesystem::path& session, const Study& study, bool isAmended)
    : lock_(session), database_(session.string(), SQLite::OPEN_READWRITE, kBusy_ms), title_(study.title) {
  database_.exec("PRAGMA secure_delete = ON");
  if (!lock_.isTaken())
    throw std::runtime_error(
        fmt::format("session file {}: another session with a study has it open, expected that it is over",
                    session.string()));
  database_.exec(kTables);
  const std::string before = sessionValue(database_, "study_sha256");
  const bool isNew = database_.execAndGet("SELECT count(*) FROM participant").getInt() == 0;
  if (!isNew && before != study.sha256 && !isAmended)
    throw std::runtime_error(fmt::format(
        "session file {}: it has participants of the study with SHA-256 {}, and this one has {}, expected "
        "the same study, or --amended, which keeps both",
        session.string(), before, study.sha256));
  SQLite::Transaction transaction(database_);
  if (!isNew && before != study.sha256) {
    const std::string earlier = sessionValue(database_, "study_sha256_before");
    set("study_sha256_before", earlier.empty() ? before : earlier + " " + before);
  }
  set("study_sha256", study.sha256);
  set("study", study.text);
  set("study_items", study.bankText);
  set("study_bank", study.hasShippedBank ? "shipped" : "own");
  transaction.commit();
}

StudyTables::~StudyTables() {
  try {
    database_.exec("PRAGMA journal_mode = DELETE");
  } catch (const SQLite::Exception&) {
    // The journal is open, and does this when it is closed.
  }
}

void StudyTables::set(const std::string& key, const std::string& value) {
  SQLite::Statement row(database_, "INSERT OR REPLACE INTO session VALUES(?, ?)");
  execute(row, key, value);
}

void StudyTables::write(const ParticipantRow& p) {
  SQLite::Statement row(database_, "INSERT OR REPLACE INTO participant VALUES(?,?,?,?,?,?,?,?,?,?,?,?)");
  execute(row, p.code, title_, p.arm, whole(p.orderRow), p.forms, p.consent, p.consentVersion,
          whole(p.number), p.startedUtc, p.step, whole(p.lesson), p.excluded);
}

void StudyTables::write(const std::string& code, const ResponseRow& r, bool isChanged) {
  SQLite::Transaction transaction(database_);
  SQLite::Statement row(database_,
                        "INSERT INTO response VALUES(?,?,?,?,?,nullif(?,0),?,?,?,?) ON CONFLICT(code, phase, "
                        "item) DO UPDATE SET form = excluded.form, answer = excluded.answer, confidence = "
                        "excluded.confidence, seconds = excluded.seconds, changes = excluded.changes, reason "
                        "= excluded.reason, t_s = excluded.t_s");
  execute(row, code, r.phase, r.form, r.item, r.answer, r.confidence, r.seconds, r.changes, r.reason, r.t_s);
  if (isChanged) {
    SQLite::Statement change(database_, "INSERT INTO response_change VALUES(?,?,?,?,nullif(?,0),?)");
    execute(change, code, r.phase, r.item, r.answer, r.confidence, r.t_s);
  }
  transaction.commit();
}

void StudyTables::forget(const std::string& code) {
  for (const char* table : kStudyTables) {
    SQLite::Statement row(database_, fmt::format("DELETE FROM {} WHERE code = ?", table));
    execute(row, code);
  }
}

void StudyTables::beginLesson(const std::string& code, const std::string& lesson, std::size_t position) {
  SQLite::Statement row(database_,
                        "INSERT OR REPLACE INTO participation SELECT ?, ?, ?, max(first_frame) FROM game");
  execute(row, code, lesson, whole(position));
}

}  // namespace carom
