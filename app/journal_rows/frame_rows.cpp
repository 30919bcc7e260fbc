#include "app/journal_rows/frame_rows.h"

#include <fmt/format.h>

#include <stdexcept>

#include "app/journal_rows/frame_columns.h"
#include "app/journal_rows/rows.h"
#include "cave/record/record_rules.h"

namespace carom {
namespace {

Names frameNames() {
  Names names;
  const FrameRecord any;
  putFrame(names, any);
  return names;
}

std::string framesOf(const char* which) {
  return fmt::format("SELECT number{} FROM frame WHERE number >= ? {} ORDER BY number", frameNames().text(),
                     which);
}

/// Returns which frames change the game.
std::string changes(const SQLite::Database& database) {
  return fmt::format("AND number IN (SELECT frame FROM knot UNION SELECT frame FROM frame_event{})",
                     ToldReader::hasTable(database) ? " UNION SELECT frame FROM link_person" : "");
}

}  // namespace

std::string frameTables() {
  return fmt::format(
      "CREATE TABLE frame(number INTEGER PRIMARY KEY{}, known TEXT, celerity_x_m_s REAL, celerity_y_m_s "
      "REAL, celerity_z_m_s REAL);\n"
      "CREATE TABLE knot(frame INTEGER, body INTEGER{});\n"
      "CREATE INDEX knot_of_frame ON knot(frame);\n"
      "CREATE TABLE frame_event(frame INTEGER{}, PRIMARY KEY(frame, number)) WITHOUT ROWID;\n",
      frameNames().text(), namesOf<Knot>().text(), namesOf<GameEvent>().text());
}

FrameWriter::FrameWriter(SQLite::Database& database)
    : frame_(database, insertInto("frame", "number" + frameNames().text() +
                                               ", known, celerity_x_m_s, celerity_y_m_s, celerity_z_m_s")),
      knot_(database, insertInto("knot", "frame, body" + namesOf<Knot>().text())),
      event_(database, insertInto("frame_event", "frame" + namesOf<GameEvent>().text())) {}

void FrameWriter::write(const FrameRecord& record, const std::string& known, const Vec3& celerity_m_s) {
  RowWriter row(frame_);
  row("number", record.number);
  putFrame(row, record);
  row("known", known);
  for (int axis = 0; axis < 3; ++axis) row("celerity", celerity_m_s[axis]);
  frame_.exec();
}

void FrameWriter::write(std::uint64_t frame, const BodyKnot& knot) {
  RowWriter row(knot_);
  row("frame", frame);
  row("body", knot.body);
  putColumns(row, knot.knot);
  knot_.exec();
}

void FrameWriter::write(std::uint64_t frame, const GameEvent& event) {
  RowWriter row(event_);
  row("frame", frame);
  putColumns(row, event);
  event_.exec();
}

FrameReader::FrameReader(SQLite::Database& database, double lightSpeed_m_s)
    : lightSpeed_m_s_(lightSpeed_m_s),
      frame_(database, framesOf("")),
      change_(database, framesOf(changes(database).c_str())),
      knot_(database,
            fmt::format("SELECT body{} FROM knot WHERE frame = ? ORDER BY rowid", namesOf<Knot>().text())),
      event_(database, fmt::format("SELECT frame{} FROM frame_event WHERE frame = ? ORDER BY number",
                                   namesOf<GameEvent>().text())),
      viewers_(database, lightSpeed_m_s),
      headset_(database),
      force_(database),
      told_(database) {
  goTo(0);
}

void FrameReader::goTo(std::uint64_t number, bool changesOnly) {
  changesOnly_ = changesOnly;
  frames().reset();
  frames().bind(1, static_cast<std::int64_t>(number));
}

std::optional<std::uint64_t> FrameReader::step() {
  if (frames().isDone() || !frames().executeStep()) return std::nullopt;
  return static_cast<std::uint64_t>(frames().getColumn(0).getInt64());
}

void FrameReader::read(FrameState& state) {
  const std::int64_t number = frames().getColumn(0).getInt64();
  state.knots.clear();
  state.events.clear();
  knot_.reset();
  knot_.bind(1, number);
  readFields(state);
  viewers_.read(state.record);
  headset_.read(state.record);
  force_.read(state.record);
  told_.read(static_cast<std::uint64_t>(number), state.told);
  if (state.record.number != static_cast<std::uint64_t>(number))
    throw std::runtime_error(fmt::format("its record is of frame {}", state.record.number));
  expectPossible(state.record, lightSpeed_m_s_);
  for (const BodyKnot& knot : state.knots) expectPossible(knot.knot);
  for (const GameEvent& event : state.events) expectPossible(event, state.record.pucks);
}

void FrameReader::readFields(FrameState& state) {
  state.record = FrameRecord();
  state.record.boardFromRoom = Lorentz(lightSpeed_m_s_);
  state.record.viewers.front().observer.headFromBoard = Lorentz(lightSpeed_m_s_);
  RowReader row(frames());
  row("number", state.record.number);
  putFrame(row, state.record);
  while (knot_.executeStep()) {
    BodyKnot& knot = state.knots.emplace_back();
    RowReader knotRow(knot_);
    knotRow("body", knot.body);
    putColumns(knotRow, knot.knot);
  }
  event_.reset();
  event_.bind(1, static_cast<std::int64_t>(state.record.number));
  while (event_.executeStep()) {
    RowReader eventRow(event_);
    std::uint64_t frame = 0;
    eventRow("frame", frame);
    putColumns(eventRow, state.events.emplace_back());
  }
}

}  // namespace carom
