#pragma once
// The rows of the force devices in a session file: where each was in a frame, as its loop took it, and what
// the hand felt. The table is empty where there was none, and is missing in older files.

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>

#include "cave/record/frame_state.h"

namespace carom {

class ForceWriter {
 public:
  /// Creates the table if it is not there.
  explicit ForceWriter(SQLite::Database& database);

  /// Writes a row for each viewer of the frame who has such a device.
  void write(const FrameRecord& record);

 private:
  SQLite::Statement row_;
};

class ForceReader {
 public:
  explicit ForceReader(SQLite::Database& database);

  /// Adds the stored devices of a frame to its record, whose viewers have been read.
  void read(FrameRecord& record);

 private:
  std::optional<SQLite::Statement> row_;  ///< empty in an older file
};

}  // namespace carom
