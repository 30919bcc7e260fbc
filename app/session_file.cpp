#include "app/session_file.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <cstring>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "app/stored_event.h"

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

/// A value stored byte by byte.
template <typename T>
void read(const SQLite::Column& column, T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (column.getBytes() != static_cast<int>(sizeof value)) {
    throw std::runtime_error(
        fmt::format("a record of {} bytes, expected {}: another version of carom wrote it", column.getBytes(),
                    sizeof value));
  }
  std::memcpy(static_cast<void*>(&value), column.getBlob(), sizeof value);
}

void readEvents(const SQLite::Column& column, FrameState& state) {
  state.events.clear();
  const auto bytes = static_cast<std::size_t>(column.getBytes());
  StoredEvent event;
  for (std::size_t at = 0; at < bytes; at += sizeof event) {
    const bool whole = bytes - at >= sizeof event;
    if (whole) std::memcpy(&event, static_cast<const char*>(column.getBlob()) + at, sizeof event);
    const auto known = whole ? restored(event, state.record.pucks) : std::nullopt;
    if (!known) throw std::runtime_error(fmt::format("frame {}: no such event can be", state.record.number));
    state.events.push_back(*known);
  }
}

}  // namespace

struct SessionFile::Tables {
  explicit Tables(const std::filesystem::path& file) : database(file.string(), SQLite::OPEN_READONLY) {
    database.setBusyTimeout(1000);
  }
  void prepare() {
    frame.emplace(database, "SELECT number, record, events FROM frame WHERE number >= ? ORDER BY number");
    knot.emplace(database, "SELECT body, knot FROM knot WHERE frame = ? ORDER BY rowid");
  }
  std::string fact(const char* key) {
    SQLite::Statement row(database, "SELECT value FROM session WHERE key = ?");
    row.bind(1, key);
    return row.executeStep() ? row.getColumn(0).getString() : std::string();
  }

  SQLite::Database database;
  std::optional<SQLite::Statement> frame, knot;
};

SessionFile::SessionFile(const std::filesystem::path& file) : file_(file) {
  if (!std::filesystem::exists(file)) refuse(file, "there is no such file");
  if (std::filesystem::is_directory(file)) refuse(file, "this is a folder, expected a session file");
  try {
    tables_ = std::make_unique<Tables>(file);
    SQLite::Database& database = tables_->database;
    if (database.execAndGet("PRAGMA application_id").getInt() != kJournalId) {
      refuse(file, "this is another program's database, expected what carom cave --session wrote");
    }
    const int version = database.execAndGet("PRAGMA user_version").getInt();
    if (version > kJournalVersion) {
      refuse(file,
             fmt::format("a newer carom wrote it (version {} of the tables), expected at most version {}",
                         version, kJournalVersion));
    }
    if (version < kJournalVersion) {
      refuse(file, fmt::format("an older carom wrote it (version {} of the tables), expected version {}",
                               version, kJournalVersion));
    }
    const std::string check = database.execAndGet("PRAGMA quick_check").getString();
    if (check != "ok")
      refuse(file, "it is damaged (" + check + "); sqlite3 FILE .recover may save what is left");
    facts_ = {tables_->fact("program"),
              tables_->fact("rig_file"),
              tables_->fact("scenario_file"),
              tables_->fact("rig"),
              tables_->fact("scenario"),
              database.execAndGet("SELECT value FROM session WHERE key = 'light_speed_m_s'").getDouble()};
    tables_->prepare();
    goTo(0);
  } catch (const SQLite::Exception& error) {
    refuse(file, error);
  }
}

SessionFile::~SessionFile() = default;

std::optional<std::pair<std::uint64_t, std::uint64_t>> SessionFile::frames() const {
  SQLite::Statement row(tables_->database, "SELECT min(number), max(number) FROM frame");
  if (!row.executeStep() || row.getColumn(0).isNull()) return std::nullopt;
  return std::pair{static_cast<std::uint64_t>(row.getColumn(0).getInt64()),
                   static_cast<std::uint64_t>(row.getColumn(1).getInt64())};
}

bool SessionFile::next(FrameState& state) try {
  if (!tables_->frame->executeStep()) return false;
  const std::int64_t number = tables_->frame->getColumn(0).getInt64();
  read(tables_->frame->getColumn(1), state.record);
  // To others, or from a session that was gone on with, more may be seen than was then.
  state.record.forgetBefore_s = -std::numeric_limits<double>::infinity();
  readEvents(tables_->frame->getColumn(2), state);
  state.knots.clear();
  SQLite::Statement& knot = *tables_->knot;
  knot.reset();
  knot.bind(1, number);
  while (knot.executeStep()) {
    BodyKnot& added = state.knots.emplace_back();
    added.body = static_cast<std::uint64_t>(knot.getColumn(0).getInt64());
    read(knot.getColumn(1), added.knot);
  }
  return true;
} catch (const SQLite::Exception& error) {
  refuse(file_, error);
} catch (const std::exception& error) {
  refuse(file_, error.what());
}

void SessionFile::goTo(std::uint64_t number) {
  tables_->frame->reset();
  tables_->frame->bind(1, static_cast<std::int64_t>(number));
}

std::uint64_t SessionFile::frameAt(double display_s) const {
  SQLite::Statement row(
      tables_->database,
      "SELECT coalesce((SELECT max(number) FROM frame WHERE display_s <= ?), min(number)) FROM frame");
  row.bind(1, display_s);
  row.executeStep();
  return static_cast<std::uint64_t>(row.getColumn(0).getInt64());
}

}  // namespace carom
