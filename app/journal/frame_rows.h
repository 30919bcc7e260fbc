#pragma once
// Frames as rows of a session file (app/journal/journal.h): each field of a record is a column, by its name.

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>
#include <string>

#include "cave/frame/frame_state.h"

namespace carom {

/// The newest version of the tables whose frames, knots and events lie there byte by byte
/// (app/journal/version_3.h).
inline constexpr int kVersion3 = 3;

/// The statements that make the tables frame, knot and frame_event.
std::string frameTables();

/// Fills the three tables.
class FrameWriter {
 public:
  explicit FrameWriter(SQLite::Database& database);

  /// `known`: how the head was known, as a word.
  void write(const FrameRecord& record, const std::string& known, const Vec3& celerity_m_s);
  void write(std::uint64_t frame, const BodyKnot& knot);
  /// What the frame brought to the list of events.
  void write(std::uint64_t frame, const GameEvent& event);

 private:
  SQLite::Statement frame_, knot_, event_;
};

/// Reads frames in the order of their numbers.
class FrameReader {
 public:
  /// `version`: of the file's tables, kVersion3 or kJournalVersion. `lightSpeed_m_s`: the game's.
  FrameReader(SQLite::Database& database, int version, double lightSpeed_m_s);

  /// The next frame will be the first whose number is at least this. From the first one at the beginning.
  void goTo(std::uint64_t number);
  /// The number of the frame that `read` reads; none after the last.
  std::optional<std::uint64_t> step();
  /// The frame that `step` has found, with its knots and events. Throws std::exception that says what cannot
  /// be, but not in which frame.
  void read(FrameState& state);

 private:
  void readFields(FrameState& state);
  void readVersion3(FrameState& state);

  int version_;
  double lightSpeed_m_s_;
  SQLite::Statement frame_, knot_;
  std::optional<SQLite::Statement> event_;  ///< version 3 has them in its frames
};

}  // namespace carom
