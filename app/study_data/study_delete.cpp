#include "app/study_data/study_delete.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <random>
#include <stdexcept>
#include <vector>

#include "app/study/study_code.h"
#include "app/study/study_lock.h"
#include "app/study/study_tables.h"
#include "engine/text/outside_file.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

/// Returns whether the file has the bytes of the code, as they are, in small letters, or as UTF-16.
bool holds(const fs::path& file, const std::string& code) {
  std::string small = code, wide;
  std::transform(small.begin(), small.end(), small.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  for (const char letter : code) wide += {letter, '\0'};
  wide.pop_back();
  std::ifstream in(file, std::ios::binary);
  std::string window;
  std::vector<char> block(1U << 20U);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
    window.append(block.data(), static_cast<std::size_t>(in.gcount()));
    for (const std::string& word : {code, small, wide}) {
      if (window.find(word) != std::string::npos) return true;
    }
    window.erase(0, window.size() - std::min(window.size(), wide.size()));
  }
  return false;
}

/// The lock that a session holds while it writes to its file.
class NoWriter {
 public:
  explicit NoWriter(const fs::path& file) : fd_(::open(file.c_str(), O_RDWR | O_CLOEXEC)) {
    if (fd_ >= 0 && ::flock(fd_, LOCK_EX | LOCK_NB) == 0) return;
    const bool isTaken = fd_ >= 0;
    if (fd_ >= 0) ::close(fd_);
    throw std::runtime_error(fmt::format("{}: {}, expected a session file that can be changed", file.string(),
                                         isTaken ? "a session is writing to it" : "it cannot be written"));
  }
  ~NoWriter() { ::close(fd_); }
  NoWriter(const NoWriter&) = delete;
  NoWriter& operator=(const NoWriter&) = delete;

 private:
  int fd_;
};

std::int64_t numberIn(SQLite::Database& database, const std::string& sql, std::int64_t at) {
  SQLite::Statement row(database, sql);
  row.bind(1, at);
  return row.executeStep() ? row.getColumn(0).getInt64() : 0;
}

void remove(SQLite::Database& database, const std::string& sql, std::int64_t from, std::int64_t to) {
  SQLite::Statement row(database, sql);
  row.bind(1, from);
  row.bind(2, to);
  row.exec();
}

/// Removes a game: every row of its frames, its events, and the samples and timings that were taken while it
/// was played. Of other games nothing refers to it.
void removeGame(SQLite::Database& database, std::int64_t firstFrame) {
  constexpr std::int64_t kEver = INT64_MAX;
  const auto or_ = [](std::int64_t number, std::int64_t otherwise) {
    return number == 0 ? otherwise : number;
  };
  const std::int64_t end =
      or_(numberIn(database, "SELECT min(first_frame) FROM game WHERE first_frame > ?", firstFrame), kEver);
  const std::int64_t firstEvent =
      numberIn(database, "SELECT first_event FROM game WHERE first_frame = ?", firstFrame);
  SQLite::Statement next(database, "SELECT first_event FROM game WHERE first_frame = ?");
  next.bind(1, end);
  const std::int64_t endEvent = next.executeStep() ? next.getColumn(0).getInt64() : kEver;
  next.reset();
  SQLite::Statement span(database,
                         "SELECT min(display_s), max(display_s) FROM frame WHERE number >= ? AND "
                         "number < ?");
  span.bind(1, firstFrame);
  span.bind(2, end);
  if (span.executeStep() && !span.isColumnNull(0)) {
    constexpr double kAround_s = 0.5;  // a frame's samples are a little older than it
    SQLite::Statement samples(database, "DELETE FROM sample WHERE time_s >= ? AND time_s <= ?");
    samples.bind(1, span.getColumn(0).getDouble() - kAround_s);
    samples.bind(2, span.getColumn(1).getDouble() + kAround_s);
    samples.exec();
  }
  span.reset();
  std::vector<std::string> tables;
  SQLite::Statement names(database,
                          "SELECT m.name FROM sqlite_master m JOIN pragma_table_info(m.name) c ON "
                          "c.name = 'frame' WHERE m.type = 'table'");
  while (names.executeStep()) tables.push_back(names.getColumn(0).getString());
  names.reset();
  for (const std::string& table : tables)
    remove(database, fmt::format("DELETE FROM {} WHERE frame >= ? AND frame < ?", table), firstFrame, end);
  remove(database, "DELETE FROM frame WHERE number >= ? AND number < ?", firstFrame, end);
  remove(database, "DELETE FROM run WHERE first_frame >= ? AND first_frame < ?", firstFrame, end);
  remove(database, "DELETE FROM turn WHERE event >= ? AND event < ?", firstEvent, endEvent);
  remove(database, "DELETE FROM event WHERE number >= ? AND number < ?", firstEvent, endEvent);
  remove(database, "DELETE FROM game WHERE first_frame >= ? AND first_frame < ?", firstFrame, firstFrame + 1);
}

/// Adds a word to a text of the table session.
void addWord(SQLite::Database& database, const std::string& key, const std::string& word) {
  SQLite::Statement row(database,
                        "INSERT OR REPLACE INTO session VALUES(?1, coalesce((SELECT value FROM session WHERE "
                        "key = ?1) || ' ', '') || ?2)");
  row.bind(1, key);
  row.bind(2, word);
  row.exec();
}

/// Makes the file complete without FILE-wal. Throws while a session, also one between two lessons, or another
/// program has it open.
void closeLog(SQLite::Database& database, const fs::path& file) {
  bool isAlone = false;
  try {
    isAlone = database.execAndGet("PRAGMA journal_mode = DELETE").getString() == "delete";
  } catch (const SQLite::Exception&) {
    // It is in use.
  }
  if (!isAlone)
    throw std::runtime_error(
        fmt::format("{}: another program has it open, expected that its session is over", file.string()));
}

StudyDeletion deleteFromSession(const std::string& code, const fs::path& file,
                                const std::string& withdrawal) {
  const NoWriter alone(file);
  const StudyLock lock(file);
  if (!lock.isTaken())
    throw std::runtime_error(fmt::format(
        "{}: a session with its study is open, expected that its session is over", file.string()));
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE, 2000);
  if (!hasStudy(database))
    throw std::runtime_error(
        fmt::format("{}: there is no study in this file, expected a session of carom cave "
                    "--study",
                    file.string()));
  closeLog(database, file);
  StudyDeletion deleted;
  database.exec("PRAGMA secure_delete = ON");
  SQLite::Transaction transaction(database);
  for (const ParticipationRow& lesson : participationsIn(database)) {
    if (lesson.code != code) continue;
    removeGame(database, lesson.firstFrame);
    ++deleted.games;
  }
  for (const char* table : kStudyTables) {
    SQLite::Statement row(database, fmt::format("DELETE FROM {} WHERE code = ?", table));
    row.bind(1, code);
    deleted.rows += static_cast<std::size_t>(row.exec());
  }
  if (deleted.any()) {
    database.exec(
        "INSERT OR REPLACE INTO session VALUES('study_withdrew', 1 + coalesce((SELECT CAST(value AS INTEGER) "
        "FROM session WHERE key = 'study_withdrew'), 0))");
    addWord(database, "study_withdrawn", withdrawnMark(code));
    addWord(database, "study_withdrawals", withdrawal);
  }
  transaction.commit();
  database.exec("VACUUM");
  return deleted;
}

/// Returns the lines of a CSV file, a field in quotes with its breaks of lines.
std::vector<std::string> recordsOf(const std::string& text) {
  std::vector<std::string> records(1);
  bool isQuoted = false;
  for (const char letter : text) {
    records.back() += letter;
    if (letter == '"') isQuoted = !isQuoted;
    if (letter == '\n' && !isQuoted) records.emplace_back();
  }
  if (records.back().empty()) records.pop_back();
  return records;
}

/// Counts one more in the row of those who withdrew.
std::string countedIn(const std::string& record) {
  const std::string key = "withdrew,";
  return record.starts_with(key) ? key + std::to_string(std::atoi(record.c_str() + key.size()) + 1) + "\n"
                                 : record;
}

StudyDeletion deleteFromFolder(const std::string& code, const fs::path& folder) {
  StudyDeletion deleted;
  std::map<fs::path, std::string> changed;
  std::vector<fs::path> removed;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path file = entry.path();
    if (entry.is_directory() && file.filename() == "sub-" + code) removed.push_back(file);
    if (!entry.is_regular_file() || !holds(file, code)) continue;
    if (file.extension() != ".csv") {
      removed.push_back(file);  // a report that names the code is made again
      continue;
    }
    std::string kept;
    for (const std::string& record : recordsOf(contentOf(file, InputKind::trace))) {
      if (record.find(code) == std::string::npos)
        kept += record;
      else
        ++deleted.rows;
    }
    changed[file] = kept;
  }
  for (const auto& [file, text] : changed) WholeFile(file).commit(text);
  std::error_code ignored;
  for (const fs::path& file : removed)
    deleted.files += static_cast<std::size_t>(fs::remove_all(file, ignored));
  if (!deleted.any()) return deleted;
  std::string study;
  for (const std::string& record : recordsOf(contentOf(folder / "study.csv", InputKind::trace)))
    study += countedIn(record);
  WholeFile(folder / "study.csv").commit(study);
  return deleted;
}

/// Throws if the code is still somewhere.
void checkGone(const std::string& code, const fs::path& file) {
  for (const char* ending : {"", "-wal", "-shm", "-journal"}) {
    const fs::path part = file.string() + ending;
    if (fs::is_regular_file(part) && holds(part, code))
      throw std::runtime_error(
          fmt::format("{} still holds the code: it stands in words that nobody can tell apart from others' "
                      "data, expected to find it in rows of its own",
                      part.string()));
  }
}

}  // namespace

std::string newWithdrawal() {
  std::random_device any;
  return fmt::format("{:08x}{:08x}", any(), any());
}

StudyDeletion deleteParticipant(const std::string& code, const fs::path& file,
                                const std::string& withdrawal) try {
  if (fs::is_directory(file)) {
    if (!fs::is_regular_file(file / "study.csv"))
      throw std::runtime_error(
          fmt::format("{} has no study.csv, expected a folder that carom study export has "
                      "written",
                      file.string()));
    return deleteFromFolder(code, file);
  }
  if (const std::string refusal = refusalOf(file, InputKind::session); !refusal.empty())
    throw std::runtime_error(fmt::format("{}: {}", file.string(), refusal));
  const StudyDeletion deleted = deleteFromSession(code, file, withdrawal);
  checkGone(code, file);
  return deleted;
} catch (const SQLite::Exception& error) {
  throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
}

}  // namespace carom
