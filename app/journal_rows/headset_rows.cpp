#include "app/journal_rows/headset_rows.h"

#include <fmt/format.h>

#include "app/journal_rows/frame_columns.h"
#include "app/journal_rows/rows.h"

namespace carom {
namespace {

SQLite::Database& withHeadsetTable(SQLite::Database& database) {
  database.exec(fmt::format("CREATE TABLE IF NOT EXISTS headset(frame INTEGER PRIMARY KEY{})",
                            namesOf<HeadsetState>().text()));
  return database;
}

}  // namespace

HeadsetWriter::HeadsetWriter(SQLite::Database& database)
    : row_(withHeadsetTable(database), insertInto("headset", "frame" + namesOf<HeadsetState>().text())) {}

void HeadsetWriter::write(const FrameRecord& record) {
  if (!record.headset.isWorn) return;
  RowWriter row(row_);
  row("frame", record.number);
  putColumns(row, record.headset);
  row_.exec();
}

HeadsetReader::HeadsetReader(SQLite::Database& database) {
  if (!database.tableExists("headset")) return;
  row_.emplace(database,
               fmt::format("SELECT frame{} FROM headset WHERE frame = ?", namesOf<HeadsetState>().text()));
}

void HeadsetReader::read(FrameRecord& record) {
  if (!row_) return;
  row_->reset();
  row_->bind(1, static_cast<std::int64_t>(record.number));
  if (!row_->executeStep()) return;
  RowReader row(*row_);
  std::uint64_t frame = 0;
  row("frame", frame);
  putColumns(row, record.headset);
  record.headset.isWorn = 1;
}

}  // namespace carom
