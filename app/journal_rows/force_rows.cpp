#include "app/journal_rows/force_rows.h"

#include <fmt/format.h>

#include "app/journal_rows/frame_columns.h"
#include "app/journal_rows/rows.h"

namespace carom {
namespace {

SQLite::Database& withForceTable(SQLite::Database& database) {
  database.exec(
      fmt::format("CREATE TABLE IF NOT EXISTS force(frame INTEGER, viewer INTEGER{}, PRIMARY KEY(frame, "
                  "viewer)) WITHOUT ROWID",
                  namesOf<ForceView>().text()));
  return database;
}

}  // namespace

ForceWriter::ForceWriter(SQLite::Database& database)
    : row_(withForceTable(database), insertInto("force", "frame, viewer" + namesOf<ForceView>().text())) {}

void ForceWriter::write(const FrameRecord& record) {
  for (std::size_t viewer = 0; viewer < record.viewerCount; ++viewer) {
    if (!record.viewers[viewer].force.shown) continue;
    RowWriter row(row_);
    row("frame", record.number);
    row("viewer", std::uint64_t{viewer});
    putColumns(row, record.viewers[viewer].force);
    row_.exec();
  }
}

ForceReader::ForceReader(SQLite::Database& database) {
  if (!database.tableExists("force")) return;
  row_.emplace(database,
               fmt::format("SELECT frame, viewer{} FROM force WHERE frame = ?", namesOf<ForceView>().text()));
}

void ForceReader::read(FrameRecord& record) {
  if (!row_) return;
  row_->reset();
  row_->bind(1, static_cast<std::int64_t>(record.number));
  while (row_->executeStep()) {
    RowReader row(*row_);
    std::uint64_t frame = 0, viewer = 0;
    row("frame", frame);
    row("viewer", viewer);
    if (viewer >= record.viewerCount) continue;
    putColumns(row, record.viewers[viewer].force);
    record.viewers[viewer].force.shown = 1;
  }
}

}  // namespace carom
