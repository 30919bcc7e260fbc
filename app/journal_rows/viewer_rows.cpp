#include "app/journal_rows/viewer_rows.h"

#include <fmt/format.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <stdexcept>
#include <utility>

#include "app/journal_rows/frame_columns.h"
#include "app/journal_rows/rows.h"
#include "engine/spacetime/attitude.h"

namespace carom {
namespace {

template <typename Row, typename Vector>
void putVector(Row& row, Vector& v) {
  for (int axis = 0; axis < 3; ++axis) row("", v[axis]);
}

}  // namespace

std::string viewerTables() {
  return fmt::format(
      "CREATE TABLE viewer(frame INTEGER, name TEXT, t_s, x_m, y_m, z_m, proper_time_s, room_x_m, room_y_m, "
      "room_z_m, lapse, celerity_x_m_s, celerity_y_m_s, celerity_z_m_s, known TEXT, PRIMARY KEY(frame, "
      "name)) "
      "WITHOUT ROWID;\n"
      "CREATE TABLE platform(frame INTEGER PRIMARY KEY, room_s, u_x, u_y, u_z, qw, qx, qy, qz, "
      "thrust_x_m_s2, "
      "thrust_y_m_s2, thrust_z_m_s2);\n"
      "CREATE TABLE other_viewer(frame INTEGER, viewer INTEGER{}, PRIMARY KEY(frame, viewer)) WITHOUT "
      "ROWID;\n",
      namesOf<ViewerState>().text());
}

ViewerWriter::ViewerWriter(SQLite::Database& database, std::vector<std::string> names)
    : names_(std::move(names)),
      viewer_(database, "INSERT OR REPLACE INTO viewer VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)"),
      platform_(database, "INSERT OR REPLACE INTO platform VALUES(?,?,?,?,?,?,?,?,?,?,?,?)"),
      other_(database, insertInto("other_viewer", "frame, viewer" + namesOf<ViewerState>().text())) {}

void ViewerWriter::write(const FrameRecord& record, std::span<const HeadWords> heads) {
  for (std::size_t i = 0; i < record.viewerCount; ++i) {
    const ViewerState& viewer = record.viewers[i];
    const Event& head = viewer.observer.middle.observation;
    RowWriter row(viewer_);
    row("frame", record.number);
    row("name", names_.at(i));
    row("t_s", head.t_s);
    putVector(row, head.r_m);
    row("proper_time_s", viewer.observer.properTime_s);
    putVector(row, viewer.placeInRoom_m);
    row("lapse", viewer.lapse);
    putVector(row, heads[i].celerity_m_s);
    row("known", std::string(toString(heads[i].known)));
    viewer_.exec();
    if (i == 0) continue;
    RowWriter other(other_);
    other("frame", record.number);
    other("viewer", std::uint64_t{i});
    putColumns(other, viewer);
    other_.exec();
  }
  RowWriter row(platform_);
  row("frame", record.number);
  row("room_s", record.room_s);
  const Vec3 u = record.boardFromRoom.u();
  putVector(row, u);
  const glm::dquat attitude = attitudeOf(record.boardFromRoom);
  for (const double component : {attitude.w, attitude.x, attitude.y, attitude.z}) row("", component);
  putVector(row, record.drive.thrust_m_s2);
  platform_.exec();
}

ViewerReader::ViewerReader(SQLite::Database& database, double lightSpeed_m_s)
    : lightSpeed_m_s_(lightSpeed_m_s),
      first_(
          database,
          "SELECT room_s, thrust_x_m_s2, thrust_y_m_s2, thrust_z_m_s2, room_x_m, room_y_m, room_z_m, lapse "
          "FROM platform JOIN viewer USING(frame) WHERE frame = ? AND name = "
          "(SELECT value FROM session WHERE key = 'viewer')"),
      other_(database, fmt::format("SELECT frame, viewer{} FROM other_viewer WHERE frame = ? ORDER BY viewer",
                                   namesOf<ViewerState>().text())) {
  if (database.tableExists("link")) linked_.emplace(database, "SELECT 1 FROM link WHERE frame = ? LIMIT 1");
}

void ViewerReader::read(FrameRecord& record) {
  ViewerState& own = record.viewers.front();
  first_.reset();
  first_.bind(1, static_cast<std::int64_t>(record.number));
  if (first_.executeStep()) {
    RowReader row(first_);
    row("room_s", record.room_s);
    putVector(row, record.drive.thrust_m_s2);
    putVector(row, own.placeInRoom_m);
    row("lapse", own.lapse);
  }
  bool anotherPlays = false;
  other_.reset();
  other_.bind(1, static_cast<std::int64_t>(record.number));
  while (other_.executeStep()) {
    if (record.viewerCount == kMostViewers)
      throw std::runtime_error(fmt::format("more than {} viewers", kMostViewers));
    ViewerState& viewer = record.viewers[record.viewerCount++];
    viewer.observer.headFromBoard = Lorentz(lightSpeed_m_s_);
    RowReader row(other_);
    std::uint64_t number = 0;
    row("frame", number);
    row("viewer", number);
    putColumns(row, viewer);
    anotherPlays = anotherPlays || viewer.hasTurn != 0;
  }
  if (record.viewerCount < 2 || anotherPlays) return;
  // Where there is another room, the turn is no one's here alone.
  if (linked_) {
    linked_->reset();
    linked_->bind(1, static_cast<std::int64_t>(record.number));
  }
  own.hasTurn = linked_ && linked_->executeStep() ? 0 : 1;
}

}  // namespace carom
