#include "app/journal_rows/link_batch.h"

#include <fmt/format.h>

#include <string>

#include "app/journal_rows/frame_columns.h"
#include "app/journal_rows/rows.h"
#include "cave/record/record_rules.h"
#include "engine/text/printable.h"

namespace carom {
namespace {

/// The tables; the place in braces is for the columns of a person's moment.
constexpr const char* kLinkTables = R"(
CREATE TABLE IF NOT EXISTS link(frame INTEGER, room INTEGER, state TEXT, heard INTEGER, round_trip_s REAL,
  promise_t_s REAL, promise_x_m REAL, promise_y_m REAL, promise_z_m REAL, viewer TEXT, waits INTEGER, pace REAL,
  digest_s INTEGER);
CREATE INDEX IF NOT EXISTS link_of_frame ON link(frame);
CREATE TABLE IF NOT EXISTS link_person(frame INTEGER, room INTEGER, viewer TEXT, number INTEGER, t_s, x_m, y_m, z_m,
  proper_time_s, person INTEGER{});
CREATE INDEX IF NOT EXISTS link_person_of_frame ON link_person(frame);
CREATE TABLE IF NOT EXISTS link_note(frame INTEGER, room INTEGER, what TEXT, value TEXT);
)";

/// Returns the columns of a moment besides those of its head, each after a comma.
std::string momentNames() { return namesOf<ToldMoment>().text(); }

SQLite::Database& withTables(SQLite::Database& database) {
  database.exec(fmt::format(kLinkTables, momentNames()));
  return database;
}

void putEvent(RowWriter& row, const Event& event) {
  row("t_s", event.t_s);
  for (int axis = 0; axis < 3; ++axis) row("r_m", event.r_m[axis]);
}

}  // namespace

void LinkBatch::add(std::uint64_t frame, const LinkNews& news) {
  for (const LinkRow& row : news.rows) rows.emplace_back(frame, row);
  for (const LinkPersonRow& person : news.persons) persons.emplace_back(frame, person);
  for (const LinkNoteRow& note : news.notes) notes.emplace_back(frame, note);
}

void LinkBatch::clear() {
  rows.clear();
  persons.clear();
  notes.clear();
}

LinkWriter::LinkWriter(SQLite::Database& database)
    : row_(withTables(database), "INSERT INTO link VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?)"),
      person_(database, insertInto("link_person",
                                   "frame, room, viewer, number, t_s, x_m, y_m, z_m, proper_time_s, person" +
                                       momentNames())),
      note_(database, "INSERT INTO link_note VALUES(?,?,?,?)") {}

void LinkWriter::write(const LinkBatch& batch) {
  for (const auto& [frame, link] : batch.rows) {
    RowWriter row(row_);
    row("frame", frame);
    row("room", link.room);
    row("state", std::string(link.state));
    row("heard", link.heard);
    row("round_trip_s", link.roundTrip_s);
    putEvent(row, link.promise);
    row("viewer", link.viewer);
    row("waits", std::uint8_t{link.waits});
    row("pace", link.pace);
    row("digest_s", link.digest_s);
    row_.exec();
  }
  for (const auto& [frame, person] : batch.persons) {
    RowWriter row(person_);
    row("frame", frame);
    row("room", person.room);
    row("viewer", std::string(person.moment.nameText()));
    row("number", person.number);
    putEvent(row, person.moment.head);
    row("proper_time_s", person.moment.properTime_s);
    row("person", person.moment.person);
    putColumns(row, person.moment);
    person_.exec();
  }
  for (const auto& [frame, note] : batch.notes) {
    RowWriter row(note_);
    row("frame", frame);
    row("room", note.room);
    row("what", note.what);
    row("value", note.value);
    note_.exec();
  }
}

ToldReader::ToldReader(SQLite::Database& database) {
  if (!hasTable(database)) return;
  row_.emplace(database,
               fmt::format("SELECT viewer, t_s, x_m, y_m, z_m, proper_time_s, person{} FROM link_person "
                           "WHERE frame = ? ORDER BY rowid",
                           momentNames()));
}

bool ToldReader::hasTable(const SQLite::Database& database) { return database.tableExists("link_person"); }

void ToldReader::read(std::uint64_t frame, std::vector<ToldMoment>& told) {
  told.clear();
  if (!row_) return;
  row_->reset();
  row_->bind(1, static_cast<std::int64_t>(frame));
  while (row_->executeStep()) {
    ToldMoment& moment = told.emplace_back();
    moment.setName(printable(row_->getColumn(0).getString()));
    RowReader row(*row_, 1);
    row("t_s", moment.head.t_s);
    for (int axis = 0; axis < 3; ++axis) row("r_m", moment.head.r_m[axis]);
    row("proper_time_s", moment.properTime_s);
    row("person", moment.person);
    putColumns(row, moment);
    expectPossible(moment);
  }
}

}  // namespace carom
