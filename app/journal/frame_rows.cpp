#include "app/journal/frame_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "app/journal/frame_columns.h"
#include "app/journal/rows.h"
#include "app/journal/version_3.h"
#include "cave/record/record_rules.h"

namespace carom {
namespace {

Names frameNames() {
  Names names;
  const FrameRecord any;
  putFrame(names, any);
  return names;
}

/// Returns the same names in the order of the table's columns: those of the first files of this version, by
/// the beginnings of their names, and then all later ones.
Names columnsInOrder() {
  constexpr const char* kFirst[]{"display_s",
                                 "proper_time_s",
                                 "t_s",
                                 "x_m",
                                 "y_m",
                                 "z_m",
                                 "switches",
                                 "views",
                                 "beside",
                                 "truncate_from_s",
                                 "pucks",
                                 "events_kept",
                                 "last",
                                 "light_speed_m_s",
                                 "left_t_s",
                                 "left_x_m",
                                 "left_y_m",
                                 "left_z_m",
                                 "right_t_s",
                                 "right_x_m",
                                 "right_y_m",
                                 "right_z_m",
                                 "left_in_room_",
                                 "right_in_room_",
                                 "middle_in_room_",
                                 "left_seen_from_",
                                 "right_seen_from_",
                                 "middle_seen_from_",
                                 "head_from_board_",
                                 "board_from_room_",
                                 "shown",
                                 "blank",
                                 "eyes_swapped",
                                 "tracker_cross",
                                 "latency",
                                 "head_known",
                                 "head_sensor_",
                                 "hand_known",
                                 "hand_",
                                 "cue_shown",
                                 "cue_pulling",
                                 "cue_target",
                                 "cue_from_",
                                 "cue_to_",
                                 "cue_target_",
                                 "cue_towards_",
                                 "cue_u",
                                 "thrust_",
                                 "drive_mode",
                                 "drive_at_limit",
                                 "lesson_phase",
                                 "lesson_answer",
                                 "notice",
                                 "cue_offset_m",
                                 "comfort",
                                 "caroms",
                                 "strokes",
                                 "fade"};
  const auto place = [&](const std::string& name) {
    return std::find_if(std::begin(kFirst), std::end(kFirst), [&](std::string_view first) {
      return first.back() == '_' ? name.starts_with(first) : name == first;
    });
  };
  Names names = frameNames();
  std::stable_sort(names.all.begin(), names.all.end(),
                   [&](const std::string& a, const std::string& b) { return place(a) < place(b); });
  return names;
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
                     version == kVersion3 ? ", knot" : selected(database, "knot", namesOf<Knot>()));
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
      columnsInOrder().text(), namesOf<Knot>().text(), namesOf<GameEvent>().text());
}

void addColumns(SQLite::Database& database) {
  const std::pair<const char*, Names> tables[]{
      {"frame", frameNames()}, {"knot", namesOf<Knot>()}, {"frame_event", namesOf<GameEvent>()}};
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

FrameReader::FrameReader(SQLite::Database& database, int version, double lightSpeed_m_s)
    : version_(version),
      lightSpeed_m_s_(lightSpeed_m_s),
      frame_(database, framesOf(database, version, "")),
      change_(database, framesOf(database, version, changingOf(version))),
      knot_(database, knotsOf(database, version)) {
  if (version != kVersion3)
    event_.emplace(database, fmt::format("SELECT frame{} FROM frame_event WHERE frame = ? ORDER BY number",
                                         selected(database, "frame_event", namesOf<GameEvent>())));
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
  ViewerState& own = state.record.viewers.front();
  own.placeInRoom_m = own.observer.middle.positionInRoom_m;
  state.record.room_s = own.observer.properTime_s;
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
  event_->reset();
  event_->bind(1, static_cast<std::int64_t>(state.record.number));
  while (event_->executeStep()) {
    RowReader eventRow(*event_);
    std::uint64_t frame = 0;
    eventRow("frame", frame);
    putColumns(eventRow, state.events.emplace_back());
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
