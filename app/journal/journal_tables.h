#pragma once
// The tables of a session file (app/journal/journal.h) and the rows still to be written to them.

#include <SQLiteCpp/SQLiteCpp.h>

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/journal/session_facts.h"
#include "app/journal_rows/force_rows.h"
#include "app/journal_rows/frame_rows.h"
#include "app/journal_rows/headset_rows.h"
#include "app/journal_rows/journal_news.h"
#include "app/journal_rows/link_batch.h"
#include "app/journal_rows/viewer_rows.h"
#include "cave/frame/frame_timing.h"
#include "cave/record/frame_state.h"
#include "devices/filter/head_filter.h"
#include "devices/tracker/tracker.h"
#include "engine/billiard/billiard.h"

namespace carom {

/// Rows still to be written.
struct Batch {
  struct Frame {
    FrameRecord record;
    std::array<HeadWords, kMostViewers> heads;
    std::size_t events;  ///< number of its events in `events`, in order
  };
  template <typename Value>
  struct OfFrame {
    std::uint64_t frame;
    Value value;
  };
  struct Input {
    std::string what, value;
    std::size_t viewer;
  };
  struct Answer {
    std::string lesson, question, answer;
    std::size_t viewer;
  };
  struct Sample {
    std::size_t tracker;
    TrackerSample sample;
  };

  std::vector<Frame> frames;
  std::vector<GameEvent> events;
  std::vector<OfFrame<BodyKnot>> knots;
  std::vector<OfFrame<HandStroke>> strokes;
  std::vector<OfFrame<Input>> inputs;
  std::vector<OfFrame<Answer>> answers;
  std::vector<OfFrame<ClassVote>> votes;
  std::vector<OfFrame<TaskNews>> tasks;
  LinkBatch link;
  std::vector<Sample> samples;
  std::vector<LatencyRow> latencies;

  bool empty() const {
    return frames.empty() && knots.empty() && inputs.empty() && answers.empty() && votes.empty() &&
           tasks.empty() && samples.empty() && link.empty();
  }
  void clear();
};

/// The database file and its SQL statements. Lets SQLite::Exception through.
class JournalTables {
 public:
  explicit JournalTables(const std::filesystem::path& file);

  /// Creates the tables of a new file.
  void make(const SessionFacts& facts);
  /// Records that a run of the program begins to write, for the first time or again, or another game. Throws
  /// std::runtime_error if the file has another version.
  void begin(const SessionFacts& facts);
  /// Writes all rows, or none if it throws.
  void write(const Batch& batch);
  /// Moves the data of FILE-wal into the file itself, as far as readers allow.
  void intoFile();
  /// Makes the file complete without FILE-wal, so that it can be read where nothing can be written.
  void close();

 private:
  void writeFrames(const Batch& batch);
  void list(std::span<const GameEvent> brought, std::uint64_t kept);
  void writeInputs(const Batch& batch);
  void writeVotes(const Batch& batch);
  void writeTasks(const Batch& batch);
  std::string viewerOf(const HandStroke& stroke) const;
  void writeSamples(const Batch& batch);
  std::string nameOf(std::size_t puck) const;
  SQLite::Statement& statement(std::optional<SQLite::Statement>& kept, const char* sql);
  [[noreturn]] void refuse(const std::string& what) const;

  SQLite::Database database_;
  std::vector<std::string> pucks_, viewers_, trackers_;  // their names
  std::uint64_t firstEvent_ = 0;                         // number in table event of the game's first event
  std::uint64_t listed_ = 0;                             // number of the game's events in table event
  std::optional<FrameWriter> frames_;
  std::optional<ViewerWriter> viewerRows_;
  std::optional<HeadsetWriter> headsetRows_;
  std::optional<ForceWriter> forceRows_;
  std::optional<LinkWriter> linkRows_;  ///< none without a link
  std::optional<SQLite::Statement> event_, turn_, sample_, latency_;
};

}  // namespace carom
