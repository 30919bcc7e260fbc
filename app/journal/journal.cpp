#include "app/journal/journal.h"

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
#include <string_view>
#include <thread>
#include <vector>

#include "app/journal/stored_event.h"

namespace carom {
namespace {

constexpr std::size_t kMostWaiting = 36000;  // frames: ten minutes at 60 Hz
constexpr std::chrono::milliseconds kRetry{500};
constexpr int kBusy_ms = 2000;  // how long somebody who reads the file is waited for

constexpr const char* kTables = R"(
CREATE TABLE session(key TEXT PRIMARY KEY, value) WITHOUT ROWID;
CREATE TABLE frame(number INTEGER PRIMARY KEY, display_s REAL, proper_time_s REAL, t_s REAL, x_m REAL, y_m REAL, z_m REAL,
  known TEXT, celerity_x_m_s REAL, celerity_y_m_s REAL, celerity_z_m_s REAL, switches INTEGER, views INTEGER,
  truncate_from_s REAL, record BLOB, events BLOB);
CREATE TABLE knot(frame INTEGER, body INTEGER, t_s REAL, x_m REAL, y_m REAL, z_m REAL, u_x REAL, u_y REAL, u_z REAL,
  proper_time_s REAL, knot BLOB);
CREATE INDEX knot_of_frame ON knot(frame);
CREATE TABLE sample(time_s REAL, sensor INTEGER, x_m REAL, y_m REAL, z_m REAL, qw REAL, qx REAL, qy REAL, qz REAL);
CREATE TABLE event(number INTEGER PRIMARY KEY, kind TEXT, pucks TEXT, cushion TEXT, t_s REAL, x_m REAL, y_m REAL,
  z_m REAL, heat_j REAL, without_delay INTEGER NOT NULL DEFAULT 0);
CREATE TABLE turn(event INTEGER, puck TEXT, t_s REAL, x_m REAL, y_m REAL, z_m REAL, beta_before_x REAL,
  beta_before_y REAL, beta_after_x REAL, beta_after_y REAL, proper_time_s REAL);
CREATE INDEX turn_of_event ON turn(event);
CREATE TABLE stroke(frame INTEGER, puck TEXT, at_s REAL, from_x_m REAL, from_y_m REAL, from_z_m REAL,
  p_x_kg_m_s REAL, p_y_kg_m_s REAL);
CREATE TABLE input(frame INTEGER, what TEXT, value TEXT);
CREATE TABLE answer(frame INTEGER, lesson TEXT, question TEXT, answer TEXT);
CREATE TABLE run(first_frame INTEGER, started_utc TEXT, program TEXT);
CREATE TABLE latency(display_s REAL, frame INTEGER, node INTEGER, part TEXT, frames INTEGER, median_s REAL, p99_s REAL,
  most_s REAL, jitter_s REAL);
)";

// The records of frames and knots are kept byte by byte: another layout is another version of the tables.
static_assert(sizeof(FrameRecord) == 1008 && sizeof(BodyKnot) == 112 && sizeof(StoredEvent) == 216,
              "count kJournalVersion up, then these");

struct FrameRow {
  FrameRecord record;
  Known known;
  glm::dvec3 celerity_m_s;
  std::size_t events;  // of the batch's, in order
};

struct KnotRow {
  std::uint64_t frame;
  BodyKnot knot;
};

struct StrokeRow {
  std::uint64_t frame;
  Stroke stroke;
};

struct InputRow {
  std::uint64_t frame;
  std::string what, value;
};

struct AnswerRow {
  std::uint64_t frame;
  std::string lesson, question, answer;
};

/// Rows that wait to be written.
struct Batch {
  std::vector<FrameRow> frames;
  std::vector<GameEvent> events;
  std::vector<KnotRow> knots;
  std::vector<StrokeRow> strokes;
  std::vector<InputRow> inputs;
  std::vector<AnswerRow> answers;
  std::vector<TrackerSample> samples;
  std::vector<LatencyRow> latencies;

  bool empty() const {
    return frames.empty() && knots.empty() && inputs.empty() && answers.empty() && samples.empty();
  }
  void clear() {
    frames.clear();
    events.clear();
    strokes.clear();
    inputs.clear();
    answers.clear();
    knots.clear();
    samples.clear();
    latencies.clear();
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

/// In the order of kNamedViews.
int bitsOf(const TimeViews& views) {
  int bits = 0;
  for (std::size_t i = 0; i < kNamedViews.size(); ++i) {
    if (views.*kNamedViews[i].value) bits |= 1 << i;
  }
  return bits;
}

std::string utcNow() { return fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr))); }

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
void bind(SQLite::Statement& row, int& column, std::span<const StoredEvent> events) {
  if (events.empty()) {
    row.bind(column++);
  } else {
    row.bindNoCopy(column++, events.data(), static_cast<int>(events.size_bytes()));
  }
}
void bind(SQLite::Statement& row, int& column, std::string_view text) {
  row.bind(column++, std::string(text));
}
void bind(SQLite::Statement& row, int& column, std::uint64_t number) {
  row.bind(column++, static_cast<std::int64_t>(number));
}
void bind(SQLite::Statement& row, int& column, const Vec2& v) {
  for (const double component : {v.x, v.y}) row.bind(column++, component);
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
      : database_(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kBusy_ms) {
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
    put(row, "started_utc", utcNow());
    put(row, "light_speed_m_s", facts.lightSpeed_m_s);
    put(row, "rig_file", std::filesystem::absolute(facts.rig).string());
    put(row, "rig", facts.rigText);
    put(row, "scenario_file", std::filesystem::absolute(facts.scenario).string());
    put(row, "scenario", facts.scenarioText);
    transaction.commit();
  }

  /// Notes that a run of the program begins to write, now or again.
  void begin(const SessionFacts& facts) {
    pucks_ = facts.pucks;
    const auto version = database_.execAndGet("PRAGMA user_version").getInt();
    if (version != kJournalVersion) {
      throw std::runtime_error(fmt::format("session file {}: version {} of the tables, expected version {}",
                                           database_.getFilename(), version, kJournalVersion));
    }
    const char* const kHasColumn =
        "SELECT count(*) FROM pragma_table_info('event') WHERE name = 'without_delay'";
    if (database_.execAndGet(kHasColumn).getInt() == 0)  // an older file is gone on with
      database_.exec("ALTER TABLE event ADD COLUMN without_delay INTEGER NOT NULL DEFAULT 0");
    listed_ = static_cast<std::uint64_t>(
        database_.execAndGet("SELECT coalesce(max(number) + 1, 0) FROM event").getInt64());
    const std::int64_t first =
        database_.execAndGet("SELECT coalesce(max(number) + 1, 0) FROM frame").getInt64();
    SQLite::Statement row(database_, "INSERT INTO run VALUES(?, ?, ?)");
    put(row, first, utcNow(), facts.program);
    database_.exec("DELETE FROM session WHERE key = 'ended_utc'");
    intoFile();
  }

  /// What is in the file beside goes into the file itself, as far as readers let it.
  void intoFile() {
    try {
      database_.exec("PRAGMA wal_checkpoint(PASSIVE)");
    } catch (const SQLite::Exception&) {
      // The disk is full, perhaps: it stays where it is, and the next time may be better.
    }
  }

  /// One whole file again, that can be read where nothing can be written.
  void close() {
    try {
      SQLite::Statement row(database_, "INSERT OR REPLACE INTO session VALUES('ended_utc', ?)");
      put(row, utcNow());
      database_.exec("PRAGMA journal_mode = DELETE");
    } catch (const SQLite::Exception&) {
      // Somebody is reading it: it stays as it is, which is as good.
    }
  }

  /// All of it or, when it throws, nothing.
  void write(const Batch& batch) {
    const std::uint64_t listedBefore = listed_;
    try {
      writeAll(batch);
    } catch (...) {
      listed_ = listedBefore;
      throw;
    }
  }

 private:
  void writeAll(const Batch& batch) {
    SQLite::Transaction transaction(database_);
    SQLite::Statement& frame =
        statement(frame_, "INSERT OR REPLACE INTO frame VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
    std::span<const GameEvent> events = batch.events;
    for (const FrameRow& row : batch.frames) {
      const std::span<const GameEvent> brought = events.first(row.events);
      events = events.subspan(row.events);
      list(brought, row.record.eventsKept);
      bytes_.clear();
      for (const GameEvent& event : brought) bytes_.push_back(stored(event));
      const FrameRecord& record = row.record;
      const Event& middle = record.observer.middle.observation;
      put(frame, static_cast<std::int64_t>(record.number), record.display_s, record.observer.properTime_s,
          middle.t_s, middle.r_m, toString(row.known), row.celerity_m_s, bitsOf(record.switches),
          bitsOf(record.views), record.truncateFrom_s, BytesOf{record}, std::span<const StoredEvent>(bytes_));
    }
    writeInputs(batch);
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
    SQLite::Statement& latency = statement(latency_, "INSERT INTO latency VALUES(?,?,?,?,?,?,?,?,?)");
    for (const LatencyRow& row : batch.latencies) {
      const PartStatistics& s = row.statistics;
      put(latency, row.display_s, static_cast<std::int64_t>(row.frame), row.node,
          kFrameParts[static_cast<std::size_t>(row.part)], static_cast<std::int64_t>(s.frames),
          static_cast<double>(s.median_s), static_cast<double>(s.p99_s), static_cast<double>(s.most_s),
          static_cast<double>(s.jitter_s));
    }
    transaction.commit();
  }

  /// The table of events becomes what it is after a frame: those from `kept` on go, these come.
  void list(std::span<const GameEvent> brought, std::uint64_t kept) {
    if (kept < listed_) {
      for (const char* sql : {"DELETE FROM event WHERE number >= ?", "DELETE FROM turn WHERE event >= ?"}) {
        SQLite::Statement old(database_, sql);
        put(old, kept);
      }
      listed_ = kept;
    }
    if (brought.empty()) return;
    SQLite::Statement& row = statement(event_, "INSERT OR REPLACE INTO event VALUES(?,?,?,?,?,?,?,?,?,?)");
    SQLite::Statement& turnRow = statement(turn_, "INSERT INTO turn VALUES(?,?,?,?,?,?,?,?,?,?,?)");
    for (const GameEvent& event : brought) {
      std::string pucks;
      for (const Turn& turn : event.turns) {
        pucks += (pucks.empty() ? "" : ", ") + nameOf(turn.puck);
        put(turnRow, event.number, nameOf(turn.puck), turn.event.t_s, turn.event.r_m, turn.betaBefore,
            turn.betaAfter, turn.properTime_s);
      }
      put(row, event.number, carom::nameOf(event.kind), pucks,
          event.cushion ? carom::nameOf(*event.cushion) : std::string_view(), event.at.t_s, event.at.r_m,
          event.heat_j, event.withoutDelay ? 1 : 0);
      listed_ = event.number + 1;
    }
  }

  void writeInputs(const Batch& batch) {
    if (!batch.strokes.empty()) {
      SQLite::Statement row(database_, "INSERT INTO stroke VALUES(?,?,?,?,?,?,?,?)");
      for (const auto& [frame, stroke] : batch.strokes)
        put(row, frame, nameOf(stroke.puck), stroke.at_s, stroke.from_m.value(), stroke.momentum_kg_m_s);
    }
    if (!batch.inputs.empty()) {
      SQLite::Statement row(database_, "INSERT INTO input VALUES(?,?,?)");
      for (const InputRow& input : batch.inputs) put(row, input.frame, input.what, input.value);
    }
    if (!batch.answers.empty()) {
      SQLite::Statement row(database_, "INSERT INTO answer VALUES(?,?,?,?)");
      for (const AnswerRow& a : batch.answers) put(row, a.frame, a.lesson, a.question, a.answer);
    }
  }

  std::string nameOf(std::size_t puck) const {
    return puck < pucks_.size() ? pucks_[puck] : fmt::format("puck {}", puck + 1);
  }

  SQLite::Statement& statement(std::optional<SQLite::Statement>& kept, const char* sql) {
    if (!kept) kept.emplace(database_, sql);
    kept->tryReset();
    return *kept;
  }

  SQLite::Database database_;
  std::vector<std::string> pucks_;  // their names
  std::uint64_t listed_ = 0;        // events in their table
  std::vector<StoredEvent> bytes_;  // scratch
  std::optional<SQLite::Statement> frame_, event_, turn_, knot_, sample_, latency_;
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
  Writer(const std::filesystem::path& path, const SessionFacts& facts, bool goOn, Say sayTo,
         std::chrono::milliseconds every)
      : file(path),
        say(sayTo ? std::move(sayTo) : [](const std::string&) {}),
        intoFileEvery(every),
        lock(path, goOn),
        tables(path) {
    if (!goOn) tables.make(facts);
    tables.begin(facts);
    thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }

  void run(const std::stop_token& stop) {
    using Clock = std::chrono::steady_clock;
    Batch batch;
    auto next = Clock::now() + intoFileEvery;
    while (!stop.stop_requested() || !empty()) {
      {
        std::unique_lock hold(mutex);
        changed.wait_until(hold, stop, next, [this] { return !waiting.empty(); });
        std::swap(batch, waiting);
      }
      if (Clock::now() >= next) {
        tables.intoFile();
        next = Clock::now() + intoFileEvery;
      }
      if (batch.empty()) continue;
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

  void close() {
    std::call_once(closed, [this] {
      thread.request_stop();
      thread.join();
      tables.close();
    });
  }

  bool empty() {
    const std::scoped_lock hold(mutex);
    return waiting.empty();
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
  std::chrono::milliseconds intoFileEvery;
  FileLock lock;  // closed after the tables: closing any handle on the file would drop SQLite's own locks
  Tables tables;
  bool troubled = false;  // the writing thread's
  bool ended = false;     // the session's: a frame was lost, so what followed could not be understood

  std::mutex mutex;
  std::condition_variable_any changed;
  Batch waiting;
  std::once_flag closed;
  std::jthread thread;  // last: it uses the rest
};

Journal::Journal(const std::filesystem::path& file, const SessionFacts& facts, bool goOn, Say say,
                 std::chrono::milliseconds intoFileEvery) try
    : writer_(std::make_unique<Writer>(file, facts, goOn, std::move(say), intoFileEvery)) {
} catch (const SQLite::Exception& error) {
  throw std::runtime_error(fmt::format("session file {}: {}", file.string(), error.what()));
}

Journal::~Journal() { close(); }

void Journal::close() { writer_->close(); }

void Journal::add(const FrameState& state, const HeadEstimate& head, std::span<const TrackerSample> samples,
                  std::span<const Stroke> strokes) {
  const std::scoped_lock hold(writer_->mutex);
  Batch& waiting = writer_->waiting;
  if (writer_->ended) return;
  if (waiting.frames.size() >= kMostWaiting) {
    writer_->ended = true;
    writer_->say(fmt::format("warning: the session file {} lacks the frames from {} on.",
                             writer_->file.string(), state.record.number));
    return;
  }
  for (const BodyKnot& knot : state.knots) waiting.knots.push_back({state.record.number, knot});
  waiting.frames.push_back({state.record, head.known, head.celerity_m_s, state.events.size()});
  waiting.events.insert(waiting.events.end(), state.events.begin(), state.events.end());
  for (const Stroke& stroke : strokes) waiting.strokes.push_back({state.record.number, stroke});
  waiting.samples.insert(waiting.samples.end(), samples.begin(), samples.end());
  writer_->changed.notify_one();
}

void Journal::addInput(std::uint64_t frame, const std::string& what, const std::string& value) {
  const std::scoped_lock hold(writer_->mutex);
  writer_->waiting.inputs.push_back({frame, what, value});
  writer_->changed.notify_one();
}

void Journal::addAnswer(std::uint64_t frame, const std::string& lesson, const std::string& question,
                        const std::string& answer) {
  const std::scoped_lock hold(writer_->mutex);
  writer_->waiting.answers.push_back({frame, lesson, question, answer});
  writer_->changed.notify_one();
}

void Journal::add(std::span<const LatencyRow> rows) {
  const std::scoped_lock hold(writer_->mutex);
  if (writer_->ended) return;
  std::vector<LatencyRow>& waiting = writer_->waiting.latencies;
  waiting.insert(waiting.end(), rows.begin(), rows.end());
}

}  // namespace carom
