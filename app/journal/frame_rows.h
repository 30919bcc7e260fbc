#pragma once
// Frames as rows of a session file (app/journal/journal.h): each field of a record is a column with its name.

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>
#include <string>

#include "app/journal/headset_rows.h"
#include "app/journal/viewer_rows.h"
#include "cave/record/frame_state.h"

namespace carom {

/// The newest version of the tables that stores frames, knots and events as raw bytes
/// (app/journal/version_3.h).
inline constexpr int kVersion3 = 3;
/// The version before the columns that tell of spins; in its files these are read as 0.
inline constexpr int kVersion4 = 4;

/// Returns the SQL statements that create the tables frame, knot and frame_event.
std::string frameTables();

/// The version before the columns of the score and of comfort; in its files, too, these are read as 0.
inline constexpr int kVersion5 = 5;
/// The version before the tables of several games and several viewers.
inline constexpr int kVersion6 = 6;
/// The version before the columns that tell of sides on sides; in its files these are read as 0.
inline constexpr int kVersion7 = 7;

/// Adds the columns that a file of version 4 to 7 lacks, with 0 in every row.
void addColumns(SQLite::Database& database);

/// Writes the three tables.
class FrameWriter {
 public:
  explicit FrameWriter(SQLite::Database& database);

  /// `known` is a word for how the head was known.
  void write(const FrameRecord& record, const std::string& known, const Vec3& celerity_m_s);
  void write(std::uint64_t frame, const BodyKnot& knot);
  /// Writes an event that the frame added to the list of events.
  void write(std::uint64_t frame, const GameEvent& event);

 private:
  SQLite::Statement frame_, knot_, event_;
};

/// Reads frames in the order of their numbers.
class FrameReader {
 public:
  /// Reads tables of a version from kVersion3 on. `lightSpeed_m_s` is that of the game.
  FrameReader(SQLite::Database& database, int version, double lightSpeed_m_s);

  /// Makes the next frame the first whose number is at least `number`. Initially it is the first frame. With
  /// `changesOnly`, the frames are from then on those alone that change the game: those with knots or events,
  /// as a frame that removes some has others in their place. Of version 3, they are all.
  void goTo(std::uint64_t number, bool changesOnly = false);
  /// Returns the number of the frame that `read` will read, or nothing after the last.
  std::optional<std::uint64_t> step();
  /// Reads the frame that `step` has found, with its knots and events. Throws std::exception that gives the
  /// fault but not the frame.
  void read(FrameState& state);

 private:
  void readFields(FrameState& state);
  void readVersion3(FrameState& state);

  SQLite::Statement& frames() { return changesOnly_ ? change_ : frame_; }

  int version_;
  double lightSpeed_m_s_;
  bool changesOnly_ = false;
  SQLite::Statement frame_, change_, knot_;
  std::optional<ViewerReader> viewers_;  ///< not before version 7
  std::optional<HeadsetReader> headset_;
  std::optional<SQLite::Statement> event_;  ///< not in version 3, which stores events with the frame
};

}  // namespace carom
