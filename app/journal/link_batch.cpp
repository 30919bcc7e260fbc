#include "app/journal/link_batch.h"

#include <string>

#include "app/journal/rows.h"

namespace carom {
namespace {

constexpr const char* kLinkTables = R"(
CREATE TABLE IF NOT EXISTS link(frame INTEGER, room INTEGER, state TEXT, heard INTEGER, round_trip_s REAL,
  promise_t_s REAL, promise_x_m REAL, promise_y_m REAL, promise_z_m REAL, viewer TEXT, waits INTEGER, pace REAL,
  digest_s INTEGER);
CREATE TABLE IF NOT EXISTS link_person(frame INTEGER, room INTEGER, viewer TEXT, number INTEGER, t_s REAL, x_m REAL,
  y_m REAL, z_m REAL, proper_time_s REAL);
CREATE TABLE IF NOT EXISTS link_note(frame INTEGER, room INTEGER, what TEXT, value TEXT);
)";

SQLite::Database& withTables(SQLite::Database& database) {
  database.exec(kLinkTables);
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
      person_(database, "INSERT INTO link_person VALUES(?,?,?,?,?,?,?,?,?)"),
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
    row("viewer", person.viewer);
    row("number", person.number);
    putEvent(row, person.head);
    row("proper_time_s", person.properTime_s);
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

}  // namespace carom
