#pragma once
// A session file in memory, with the tables of frames and viewers.

#include <SQLiteCpp/SQLiteCpp.h>

#include "app/journal_rows/frame_rows.h"
#include "app/journal_rows/viewer_rows.h"

namespace carom::test {

struct FramesInMemory {
  FramesInMemory() {
    database.exec(
        "CREATE TABLE session(key TEXT PRIMARY KEY, value); INSERT INTO session VALUES('viewer', 'anna')");
    database.exec(frameTables());
    database.exec(viewerTables());
  }

  SQLite::Database database{":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE};
};

}  // namespace carom::test
