#include "app/journal/frame_rows.h"

#include <fmt/format.h>

#include <iterator>
#include <stdexcept>
#include <utility>

#include "app/journal/frame_columns.h"
#include "app/journal/rows.h"
#include "app/journal/version_3.h"
#include "cave/frame/record_rules.h"

namespace carom {
namespace {

Names frameNames() {
  return namesOf<FrameRecord>([](Names& names, const FrameRecord& record) { visitRecord(names, record); });
}
Names knotNames() {
  return namesOf<Knot>([](Names& names, const Knot& knot) { visitKnot(names, knot); });
}
Names eventNames() {
  return namesOf<GameEvent>([](Names& names, const GameEvent& event) { visitGameEvent(names, event); });
}

std::string framesOf(SQLite::Database& database, int version, const char* which) {
  return fmt::format("SELECT number{} FROM frame WHERE number >= ? {} ORDER BY number",
                     version == kVersion3 ? ", record, events" : selected(database, "frame", frameNames()),
                     which);
}
const char* changingOf(int version) {
  return version == kVersion3 ? ""
                              : "AND number IN (SELECT frame FROM knot UNION SELECT frame FROM frame_event)";
}
std::string knotsOf(SQLite::Database& database, int version) {
  return fmt::format("SELECT body{} FROM knot WHERE frame = ? ORDER BY rowid",
                     version == kVersion3 ? ", knot" : selected(database, "knot", knotNames()));
}

std::span<const std::byte> bytesOf(const SQLite::Column& column) {
  return {static_cast<const std::byte*>(column.getBlob()), static_cast<std::size_t>(column.getBytes())};
}

}  // namespace

std::string frameTables() {
  return fmt::format(
      "CREATE TABLE frame(number INTEGER PRIMARY KEY{}, known TEXT, celerity_x_m_s REAL, celerity_y_m_s "
      "REAL, celerity_z_m_s REAL);\n"
      "CREATE TABLE knot(frame INTEGER, body INTEGER{});\n"
      "CREATE INDEX knot_of_frame ON knot(frame);\n"
      "CREATE TABLE frame_event(frame INTEGER{}, PRIMARY KEY(frame, number)) WITHOUT ROWID;\n",
      frameNames().text(), knotNames().text(), eventNames().text());
}

void addColumns(SQLite::Database& database) {
  const std::pair<const char*, Names> tables[]{
      {"frame", frameNames()}, {"knot", knotNames()}, {"frame_event", eventNames()}};
  for (const auto& [table, names] : tables) {
    const std::set<std::string> columns = columnsOf(database, table);
    for (const std::string& name : names.all) {
      if (!columns.contains(name))
        database.exec(fmt::format("ALTER TABLE {} ADD COLUMN {} DEFAULT 0", table, name));
    }
  }
}

FrameWriter::FrameWriter(SQLite::Database& database)
    : frame_(database, insertInto("frame", "number" + frameNames().text() +
                                               ", known, celerity_x_m_s, celerity_y_m_s, celerity_z_m_s")),
      knot_(database, insertInto("knot", "frame, body" + knotNames().text())),
      event_(database, insertInto("frame_event", "frame" + eventNames().text())) {}

void FrameWriter::write(const FrameRecord& record, const std::string& known, const Vec3& celerity_m_s) {
  RowWriter row(frame_);
  row("", "number", record.number);
  visitRecord(row, record);
  row("", "known", known);
  for (const auto& [axis, name] : {std::pair(0, "x_m_s"), {1, "y_m_s"}, {2, "z_m_s"}})
    row("celerity_", name, celerity_m_s[axis]);
  frame_.exec();
}

void FrameWriter::write(std::uint64_t frame, const BodyKnot& knot) {
  RowWriter row(knot_);
  row("", "frame", frame);
  row("", "body", knot.body);
  visitKnot(row, knot.knot);
  knot_.exec();
}

void FrameWriter::write(std::uint64_t frame, const GameEvent& event) {
  RowWriter row(event_);
  row("", "frame", frame);
  visitGameEvent(row, event);
  event_.exec();
}

FrameReader::FrameReader(SQLite::Database& database, int version, double lightSpeed_m_s)
    : version_(version),
      lightSpeed_m_s_(lightSpeed_m_s),
      frame_(database, framesOf(database, version, "")),
      change_(database, framesOf(database, version, changingOf(version))),
      knot_(database, knotsOf(database, version)) {
  if (version != kVersion3)
    event_.emplace(database, fmt::format("SELECT frame{} FROM frame_event WHERE frame = ? ORDER BY number",
                                         selected(database, "frame_event", eventNames())));
  if (version > kVersion6) viewers_.emplace(database, lightSpeed_m_s);
  if (version > kVersion6) headset_.emplace(database);
  goTo(0);
}

void FrameReader::goTo(std::uint64_t number, bool changesOnly) {
  changesOnly_ = changesOnly;
  frames().reset();
  frames().bind(1, static_cast<std::int64_t>(number));
}

std::optional<std::uint64_t> FrameReader::step() {
  if (!frames().executeStep()) return std::nullopt;
  return static_cast<std::uint64_t>(frames().getColumn(0).getInt64());
}

void FrameReader::read(FrameState& state) {
  const std::int64_t number = frames().getColumn(0).getInt64();
  state.knots.clear();
  state.events.clear();
  knot_.reset();
  knot_.bind(1, number);
  version_ == kVersion3 ? readVersion3(state) : readFields(state);
  // As it was while there was one viewer.
  state.record.placeInRoom_m = state.record.observer.middle.positionInRoom_m;
  state.record.room_s = state.record.observer.properTime_s;
  if (viewers_) viewers_->read(state.record);
  if (headset_) headset_->read(state.record);
  if (state.record.number != static_cast<std::uint64_t>(number))
    throw std::runtime_error(fmt::format("its record is of frame {}", state.record.number));
  expectPossible(state.record, lightSpeed_m_s_);
  for (const BodyKnot& knot : state.knots) expectPossible(knot.knot);
  for (const GameEvent& event : state.events) expectPossible(event, state.record.pucks);
}

void FrameReader::readFields(FrameState& state) {
  state.record = FrameRecord();
  state.record.observer.headFromBoard = state.record.boardFromRoom = Lorentz(lightSpeed_m_s_);
  RowReader row(frames());
  row("", "number", state.record.number);
  visitRecord(row, state.record);
  while (knot_.executeStep()) {
    BodyKnot& knot = state.knots.emplace_back();
    RowReader knotRow(knot_);
    knotRow("", "body", knot.body);
    visitKnot(knotRow, knot.knot);
  }
  event_->reset();
  event_->bind(1, static_cast<std::int64_t>(state.record.number));
  while (event_->executeStep()) {
    RowReader eventRow(*event_);
    std::uint64_t frame = 0;
    eventRow("", "frame", frame);
    visitGameEvent(eventRow, state.events.emplace_back());
  }
}

void FrameReader::readVersion3(FrameState& state) {
  state.record = version3::frameOf(bytesOf(frames().getColumn(1)));
  state.record.forgetBefore_s = FrameRecord().forgetBefore_s;
  state.events = version3::eventsOf(bytesOf(frames().getColumn(2)));
  while (knot_.executeStep()) {
    state.knots.push_back({static_cast<std::uint64_t>(knot_.getColumn(0).getInt64()),
                           version3::knotOf(bytesOf(knot_.getColumn(1)))});
  }
}

}  // namespace carom
