#include "app/journal.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

namespace carom {
namespace {

constexpr std::size_t kMostWaiting = 36000;  // frames: ten minutes at 60 Hz
constexpr std::chrono::milliseconds kRetry{500};

constexpr const char* kTables = R"(
CREATE TABLE session(key TEXT PRIMARY KEY, value) WITHOUT ROWID;
CREATE TABLE frame(number INTEGER PRIMARY KEY, display_s REAL, proper_time_s REAL, t_s REAL, x_m REAL, y_m REAL, z_m REAL,
  known TEXT, celerity_x_m_s REAL, celerity_y_m_s REAL, celerity_z_m_s REAL, switches INTEGER, truncate_from_s REAL,
  record BLOB);
CREATE TABLE knot(frame INTEGER, body INTEGER, t_s REAL, x_m REAL, y_m REAL, z_m REAL, u_x REAL, u_y REAL, u_z REAL,
  proper_time_s REAL, knot BLOB);
CREATE INDEX knot_of_frame ON knot(frame);
CREATE TABLE sample(time_s REAL, sensor INTEGER, x_m REAL, y_m REAL, z_m REAL, qw REAL, qx REAL, qy REAL, qz REAL);
)";

// The records of frames and knots are kept byte by byte: another layout is another version of the tables.
static_assert(sizeof(FrameRecord) == 368 && sizeof(BodyKnot) == 112, "count kJournalVersion up, then these");

struct FrameRow {
  FrameRecord record;
  Known known;
  glm::dvec3 celerity_m_s;
};

struct KnotRow {
  std::uint64_t frame;
  BodyKnot knot;
};

/// Rows that wait to be written.
struct Batch {
  std::vector<FrameRow> frames;
  std::vector<KnotRow> knots;
  std::vector<TrackerSample> samples;

  bool empty() const { return frames.empty() && knots.empty() && samples.empty(); }
  void clear() {
    frames.clear();
    knots.clear();
    samples.clear();
  }
};

/// Retardation is bit 0, then in the order of kNamedSwitches.
int bitsOf(const Switches& switches) {
  int bits = 0;
  for (std::size_t i = 0; i < kNamedSwitches.size(); ++i) {
    if (switches.*kNamedSwitches[i].value) bits |= 1 << i;
  }
  return bits;
}

/// The bytes of a value as this program holds it.
template <typename T>
struct BytesOf {
  const T& value;
};

void bind(SQLite::Statement& row, int& column, const glm::dvec3& v) {
  for (const double component : {v.x, v.y, v.z}) row.bind(column++, component);
}
template <typename T>
void bind(SQLite::Statement& row, int& column, const BytesOf<T>& bytes) {
  row.bindNoCopy(column++, &bytes.value, static_cast<int>(sizeof bytes.value));
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

/// The file and the statements that fill it.
class Tables {
 public:
  explicit Tables(const std::filesystem::path& file)
      : database_(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE) {
    database_.exec("PRAGMA journal_mode = WAL");
    // Enough for a killed program; a machine that loses power may lose the last seconds, never the file.
    database_.exec("PRAGMA synchronous = NORMAL");
  }

  void make(const SessionFacts& facts) {
    SQLite::Transaction transaction(database_);
    database_.exec(kTables);
    database_.exec(fmt::format("PRAGMA application_id = {}", kJournalId));
    database_.exec(fmt::format("PRAGMA user_version = {}", kJournalVersion));
    SQLite::Statement row(database_, "INSERT INTO session VALUES(?, ?)");
    put(row, "program", facts.program);
    put(row, "started_utc", fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr))));
    put(row, "light_speed_m_s", facts.lightSpeed_m_s);
    put(row, "rig_file", std::filesystem::absolute(facts.rig).string());
    put(row, "rig", facts.rigText);
    put(row, "scenario_file", std::filesystem::absolute(facts.scenario).string());
    put(row, "scenario", facts.scenarioText);
    transaction.commit();
  }

  /// One whole file again, that can be read where nothing can be written.
  void close() {
    try {
      database_.exec("PRAGMA journal_mode = DELETE");
    } catch (const SQLite::Exception&) {
      // Somebody is reading it: it stays as it is, which is as good.
    }
  }

  void write(const Batch& batch) {
    SQLite::Transaction transaction(database_);
    SQLite::Statement& frame =
        statement(frame_, "INSERT OR REPLACE INTO frame VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
    for (const FrameRow& row : batch.frames) {
      const FrameRecord& record = row.record;
      const Event& middle = record.observer.eyes[2].observation;
      put(frame, static_cast<std::int64_t>(record.number), record.display_s, record.observer.properTime_s,
          middle.t_s, middle.r_m, toString(row.known), row.celerity_m_s, bitsOf(record.switches),
          record.truncateFrom_s, BytesOf{record});
    }
    SQLite::Statement& knot = statement(knot_, "INSERT INTO knot VALUES(?,?,?,?,?,?,?,?,?,?,?)");
    for (const KnotRow& row : batch.knots) {
      const Knot& k = row.knot.knot;
      put(knot, static_cast<std::int64_t>(row.frame), static_cast<std::int64_t>(row.knot.body), k.turn.t_s,
          k.turn.r_m, k.u, k.properTime_s, BytesOf{k});
    }
    SQLite::Statement& sample = statement(sample_, "INSERT INTO sample VALUES(?,?,?,?,?,?,?,?,?)");
    for (const TrackerSample& s : batch.samples) {
      const glm::dquat& q = s.pose.orientation;
      put(sample, s.time_s, s.sensor, s.pose.position_m, q.w, q.x, q.y, q.z);
    }
    transaction.commit();
  }

 private:
  SQLite::Statement& statement(std::optional<SQLite::Statement>& kept, const char* sql) {
    if (!kept) kept.emplace(database_, sql);
    kept->tryReset();
    return *kept;
  }

  SQLite::Database database_;
  std::optional<SQLite::Statement> frame_, knot_, sample_;
};

/// Held while a session writes to a file, by the system's own lock: it goes with the process.
class FileLock {
 public:
  FileLock(const std::filesystem::path& file, bool there)
      : fd_(open(file.c_str(), O_RDWR | O_CLOEXEC | (there ? 0 : O_CREAT | O_EXCL), 0644)) {
    if (fd_ < 0) {
      const bool exists = errno == EEXIST;
      throw std::runtime_error(
          fmt::format("session file {}: {}", file.string(),
                      exists ? "it is there already, expected a new name, or --resume to go on with it"
                             : std::strerror(errno)));
    }
    if (flock(fd_, LOCK_EX | LOCK_NB) == 0) return;
    const bool taken = errno == EWOULDBLOCK;
    const std::string why = taken ? "another session is writing to it" : std::strerror(errno);
    close(fd_);
    throw std::runtime_error(fmt::format("session file {}: {}", file.string(), why));
  }
  ~FileLock() { close(fd_); }
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int fd_;
};

}  // namespace

struct Journal::Writer {
  Writer(const std::filesystem::path& path, const SessionFacts& facts, bool goOn, Say sayTo)
      : file(path),
        say(sayTo ? std::move(sayTo) : [](const std::string&) {}),
        lock(path, goOn),
        tables(path) {
    if (!goOn) tables.make(facts);
    thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }

  void run(const std::stop_token& stop) {
    Batch batch;
    while (!stop.stop_requested() || !empty()) {
      {
        std::unique_lock hold(mutex);
        changed.wait(hold, stop, [this] { return !waiting.empty(); });
        std::swap(batch, waiting);
      }
      bool done = written(batch);
      while (!done && !stop.stop_requested()) {
        std::this_thread::sleep_for(kRetry);
        done = written(batch);
      }
      if (!done) {
        say(fmt::format("warning: the session file {} lacks its last {} frames.", file.string(),
                        batch.frames.size()));
      }
      batch.clear();
    }
  }

  bool empty() {
    const std::scoped_lock hold(mutex);
    return waiting.empty();
  }

  void sayOnce(const std::string& line) {
    if (!overfull) say(line);
    overfull = true;
  }

  bool written(const Batch& batch) {
    try {
      tables.write(batch);
      if (troubled) say(fmt::format("The session file {} is being written again.", file.string()));
      troubled = false;
      return true;
    } catch (const std::exception& error) {
      if (!troubled) {
        say(fmt::format("warning: the session file {} cannot be written: {}. The session goes on.",
                        file.string(), error.what()));
      }
      troubled = true;
      return false;
    }
  }

  std::filesystem::path file;
  Say say;
  FileLock lock;  // closed after the tables: closing any handle on the file would drop SQLite's own locks
  Tables tables;
  bool troubled = false;  // the writing thread's
  bool overfull = false;  // the session's

  std::mutex mutex;
  std::condition_variable_any changed;
  Batch waiting;
  std::jthread thread;  // last: it uses the rest
};

Journal::Journal(const std::filesystem::path& file, const SessionFacts& facts, bool goOn, Say say) try
    : writer_(std::make_unique<Writer>(file, facts, goOn, std::move(say))) {
} catch (const SQLite::Exception& error) {
  throw std::runtime_error(fmt::format("session file {}: {}", file.string(), error.what()));
}

Journal::~Journal() {
  writer_->thread.request_stop();
  writer_->thread.join();
  writer_->tables.close();
}

void Journal::add(const FrameState& state, const HeadEstimate& head, std::span<const TrackerSample> samples) {
  const std::scoped_lock hold(writer_->mutex);
  Batch& waiting = writer_->waiting;
  for (const BodyKnot& knot : state.knots) waiting.knots.push_back({state.record.number, knot});
  if (waiting.frames.size() >= kMostWaiting) {
    writer_->sayOnce(fmt::format("warning: the session file {} lacks the frames from {} on.",
                                 writer_->file.string(), state.record.number));
    return;
  }
  waiting.frames.push_back({state.record, head.known, head.celerity_m_s});
  waiting.samples.insert(waiting.samples.end(), samples.begin(), samples.end());
  writer_->changed.notify_one();
}

}  // namespace carom
