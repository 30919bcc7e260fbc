#pragma once
// The rows of the headset in a session file: its eyes in each frame, and the runtime's own account of the
// head's velocity. The table is empty where none was worn, and is missing in older files.

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>

#include "cave/record/frame_state.h"

namespace carom {

class HeadsetWriter {
 public:
  /// Creates the table if it is not there.
  explicit HeadsetWriter(SQLite::Database& database);

  /// Writes the row of a frame that a headset shows.
  void write(const FrameRecord& record);

 private:
  SQLite::Statement row_;
};

class HeadsetReader {
 public:
  explicit HeadsetReader(SQLite::Database& database);

  /// Adds the stored headset of a frame to its record.
  void read(FrameRecord& record);

 private:
  std::optional<SQLite::Statement> row_;  ///< empty in an older file
};

}  // namespace carom
