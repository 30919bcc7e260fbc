#include "app/journal/journal.h"

#include <SQLiteCpp/Exception.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include "app/journal/journal_tables.h"
#include "engine/text/log.h"

namespace carom {
namespace {

constexpr std::size_t kMostWaiting = 36000;  // frames: ten minutes at 60 Hz
constexpr std::chrono::milliseconds kRetry{500};

/// A lock of the operating system, held while a session writes to a file; it ends with the process.
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
  Writer(const std::filesystem::path& path, const SessionFacts& facts, bool goOn,
         std::chrono::milliseconds every)
      : file(path), intoFileEvery(every), lock(path, goOn), tables(path) {
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
        log::warn(
            fmt::format("the session file {} lacks its last {} frames.", file.string(), batch.frames.size()));
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
      if (troubled) log::note(fmt::format("The session file {} is being written again.", file.string()));
      troubled = false;
      return true;
    } catch (const std::exception& error) {
      if (!troubled) {
        log::warn(fmt::format("the session file {} cannot be written: {}. The session goes on.",
                              file.string(), error.what()));
      }
      troubled = true;
      return false;
    }
  }

  std::filesystem::path file;
  std::chrono::milliseconds intoFileEvery;
  FileLock lock;  // closed after the tables: closing any handle on the file would drop SQLite's own locks
  JournalTables tables;
  bool troubled = false;  // used by the writing thread
  bool ended = false;     // a frame was lost, so later ones could not be understood

  std::mutex mutex;
  std::condition_variable_any changed;
  Batch waiting;
  std::once_flag closed;
  std::jthread thread;  // last, because it uses the other members
};

Journal::Journal(const std::filesystem::path& file, const SessionFacts& facts, bool goOn,
                 std::chrono::milliseconds intoFileEvery) try
    : writer_(std::make_unique<Writer>(file, facts, goOn, intoFileEvery)) {
} catch (const SQLite::Exception& error) {
  throw std::runtime_error(fmt::format("session file {}: {}", file.string(), error.what()));
}

Journal::~Journal() { close(); }

void Journal::close() { writer_->close(); }

void Journal::add(const FrameState& state, std::span<const HeadEstimate> heads,
                  std::span<const TrackerSamples> samples, std::span<const HandStroke> strokes,
                  const LinkNews& link) {
  const std::scoped_lock hold(writer_->mutex);
  Batch& waiting = writer_->waiting;
  if (writer_->ended) return;
  if (waiting.frames.size() >= kMostWaiting) {
    writer_->ended = true;
    log::warn(fmt::format("the session file {} lacks the frames from {} on.", writer_->file.string(),
                          state.record.number));
    return;
  }
  for (const BodyKnot& knot : state.knots) waiting.knots.push_back({state.record.number, knot});
  Batch::Frame& frame = waiting.frames.emplace_back(Batch::Frame{state.record, {}, state.events.size()});
  for (std::size_t i = 0; i < std::min<std::size_t>(heads.size(), state.record.viewerCount); ++i)
    frame.heads[i] = {heads[i].known, heads[i].celerity_m_s};
  waiting.events.insert(waiting.events.end(), state.events.begin(), state.events.end());
  for (const HandStroke& stroke : link.strokes) waiting.strokes.push_back({state.record.number, stroke});
  for (const HandStroke& stroke : strokes) waiting.strokes.push_back({state.record.number, stroke});
  waiting.link.add(state.record.number, link);
  for (const TrackerSamples& ofOne : samples) {
    for (const TrackerSample& sample : ofOne.samples) waiting.samples.push_back({ofOne.tracker, sample});
  }
  writer_->changed.notify_one();
}

void Journal::addInput(std::uint64_t frame, const std::string& what, const std::string& value,
                       std::size_t viewer) {
  const std::scoped_lock hold(writer_->mutex);
  if (writer_->ended) return;
  writer_->waiting.inputs.push_back({frame, {what, value, viewer}});
  writer_->changed.notify_one();
}

void Journal::addAnswer(std::uint64_t frame, const std::string& lesson, const std::string& question,
                        const std::string& answer, std::size_t viewer) {
  const std::scoped_lock hold(writer_->mutex);
  if (writer_->ended) return;
  writer_->waiting.answers.push_back({frame, {lesson, question, answer, viewer}});
  writer_->changed.notify_one();
}

void Journal::addVote(std::uint64_t frame, const ClassVote& vote) {
  const std::scoped_lock hold(writer_->mutex);
  if (writer_->ended) return;
  writer_->waiting.votes.push_back({frame, vote});
  writer_->changed.notify_one();
}

void Journal::addTask(std::uint64_t frame, const TaskNews& news) {
  const std::scoped_lock hold(writer_->mutex);
  if (writer_->ended) return;
  writer_->waiting.tasks.push_back({frame, news});
  writer_->changed.notify_one();
}

void Journal::add(std::span<const LatencyRow> rows) {
  const std::scoped_lock hold(writer_->mutex);
  if (writer_->ended) return;
  std::vector<LatencyRow>& waiting = writer_->waiting.latencies;
  waiting.insert(waiting.end(), rows.begin(), rows.end());
}

}  // namespace carom
