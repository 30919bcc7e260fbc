#pragma once
// The viewers and the platform of each frame as rows of a session file (app/journal/journal.h).

#include <SQLiteCpp/SQLiteCpp.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cave/record/frame_state.h"
#include "devices/filter/head_filter.h"

namespace carom {

/// How a viewer's head was known, and its filtered celerity.
struct HeadWords {
  Known known = Known::lost;
  Vec3 celerity_m_s{0.0};
};

/// Returns the SQL statements that create the tables viewer, platform and other_viewer.
std::string viewerTables();

class ViewerWriter {
 public:
  /// `names` are those of the rig's viewers.
  ViewerWriter(SQLite::Database& database, std::vector<std::string> names);

  /// Writes a frame's rows. `heads` has one for each viewer of the record.
  void write(const FrameRecord& record, std::span<const HeadWords> heads);

 private:
  std::vector<std::string> names_;
  SQLite::Statement viewer_, platform_, other_;
};

class ViewerReader {
 public:
  ViewerReader(SQLite::Database& database, double lightSpeed_m_s);

  /// Adds the viewers after the first to a record that has been read otherwise, the place of the first in the
  /// room and the room's time.
  void read(FrameRecord& record);

 private:
  double lightSpeed_m_s_;
  SQLite::Statement first_, other_;
  std::optional<SQLite::Statement> linked_;  ///< of files of linked rooms
};

}  // namespace carom
