#pragma once
// Frames as rows of a session file (app/journal/journal.h): each field of a record is a column with its name.

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>
#include <string>

#include "app/journal_rows/force_rows.h"
#include "app/journal_rows/headset_rows.h"
#include "app/journal_rows/link_batch.h"
#include "app/journal_rows/viewer_rows.h"
#include "cave/record/frame_state.h"

namespace carom {

/// Returns the SQL statements that create the tables frame, knot and frame_event.
std::string frameTables();

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
  /// `lightSpeed_m_s` is that of the game.
  FrameReader(SQLite::Database& database, double lightSpeed_m_s);

  /// Makes the next frame the first whose number is at least `number`. Initially it is the first frame. With
  /// `changesOnly`, the frames are from then on those alone that change the game: those with knots or events,
  /// or moments of people of another room, as a frame that removes some has others in their place.
  void goTo(std::uint64_t number, bool changesOnly = false);
  /// Returns the number of the frame that `read` will read, or nothing after the last.
  std::optional<std::uint64_t> step();
  /// Reads the frame that `step` has found, with its knots and events. Throws std::exception that gives the
  /// fault but not the frame.
  void read(FrameState& state);

 private:
  void readFields(FrameState& state);

  SQLite::Statement& frames() { return changesOnly_ ? change_ : frame_; }

  double lightSpeed_m_s_;
  bool changesOnly_ = false;
  SQLite::Statement frame_, change_, knot_, event_;
  ViewerReader viewers_;
  HeadsetReader headset_;
  ForceReader force_;
  ToldReader told_;
};

}  // namespace carom
