#include "app/journal/session_file.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "app/journal/stored_event.h"
#include "cave/frame/time_views.h"
#include "engine/base/limits.h"

namespace carom {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw std::runtime_error(fmt::format("session file {}: {}", file.string(), what));
}

[[noreturn]] void refuse(const std::filesystem::path& file, const SQLite::Exception& error) {
  switch (error.getErrorCode()) {
    case SQLITE_NOTADB:
      refuse(file, "this is no session file, expected what carom cave --session wrote");
    case SQLITE_CORRUPT:
      refuse(file, std::string("it is damaged (") + error.what() +
                       "); sqlite3 FILE .recover may save what is left");
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      refuse(file, "another program has locked it; expected that one to have ended");
    default:
      refuse(file, error.what());
  }
}

/// Where a session is until it is closed, and after a crash what was not yet written into its own file.
std::filesystem::path besideOf(std::filesystem::path file) { return file += "-wal"; }

bool hasBeside(const std::filesystem::path& file) {
  std::error_code absent;
  const auto bytes = std::filesystem::file_size(besideOf(file), absent);
  return !absent && bytes > 0;
}

/// A value stored byte by byte.
template <typename T>
void read(const SQLite::Column& column, T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (column.getBytes() != static_cast<int>(sizeof value)) {
    throw std::runtime_error(
        fmt::format("a record of {} bytes, expected {}: another version of carom wrote it", column.getBytes(),
                    sizeof value));
  }
  std::memcpy(static_cast<void*>(&value), column.getBlob(), sizeof value);
}

void readEvents(const SQLite::Column& column, FrameState& state) {
  state.events.clear();
  const auto bytes = static_cast<std::size_t>(column.getBytes());
  StoredEvent event;
  for (std::size_t at = 0; at < bytes; at += sizeof event) {
    const bool whole = bytes - at >= sizeof event;
    if (whole) std::memcpy(&event, static_cast<const char*>(column.getBlob()) + at, sizeof event);
    const auto known = whole ? restored(event, state.record.pucks) : std::nullopt;
    if (!known) throw std::runtime_error("no such event can be");
    state.events.push_back(*known);
  }
}

void expectFinite(const char* field, std::initializer_list<double> values) {
  for (const double value : values) {
    if (!std::isfinite(value))
      throw std::runtime_error(fmt::format("{} is {}, expected a finite number", field, value));
  }
}
void expectFinite(const char* field, const Vec3& v) { expectFinite(field, {v.x, v.y, v.z}); }
void expectFinite(const char* field, const Event& e) {
  expectFinite(field, {e.t_s, e.r_m.x, e.r_m.y, e.r_m.z});
}
void expectFinite(const char* field, const Pose& pose) {
  const glm::dquat& q = pose.orientation;
  expectFinite(field, pose.position_m);
  expectFinite(field, {q.w, q.x, q.y, q.z});
}

void expectFlag(const char* field, std::uint64_t value) {
  if (value > 1) throw std::runtime_error(fmt::format("{} is {}, expected 0 or 1", field, value));
}
void expectFlags(const Switches& switches) {
  for (const NamedSwitch& named : kNamedSwitches) expectFlag(named.name, switches.*named.value);
}

void expectPossible(const char* frame, const Lorentz& transform, double gameLightSpeed_m_s) {
  const double c_m_s = transform.lightSpeed_m_s();
  if (c_m_s != gameLightSpeed_m_s) {
    throw std::runtime_error(
        fmt::format("{} has light at {} m/s, expected the game's {}", frame, c_m_s, gameLightSpeed_m_s));
  }
  // The inverse of a Lorentz transform is written down, not sought: of any other it is none.
  constexpr double kRounding = 1e-9;
  const glm::dmat4 one = (transform.inverse() * transform).matrix();
  const double gamma = transform.matrix()[0][0];
  bool possible = std::isfinite(gamma) && gamma > 0.0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      const double off = std::abs(one[column][row] - (row == column ? 1.0 : 0.0));
      possible = possible && off <= kRounding * gamma * gamma;
    }
  }
  if (!possible) throw std::runtime_error(fmt::format("{} is none, expected a Lorentz transform", frame));
}

void expectPossible(const ObserverView& observer, double gameLightSpeed_m_s) {
  expectPossible("the head's frame", observer.headFromBoard, gameLightSpeed_m_s);
  for (const EyeView& eye : observer.eyes) {
    expectFinite("an eye's event", eye.observation);
    expectFinite("an eye's place in the room", eye.positionInRoom_m);
    expectFinite("the place that an eye sees from", eye.seenFromInRoom_m);
  }
  expectFinite("the person's proper time", {observer.properTime_s});
}

void expectPossible(const WallControls& walls) {
  if (walls.shown > Shown::alignmentPattern) {
    throw std::runtime_error(fmt::format("controls.shown is {}, expected 0 to {}",
                                         static_cast<int>(walls.shown),
                                         static_cast<int>(Shown::alignmentPattern)));
  }
  expectFlag("controls.blank", walls.blank);
  expectFlag("controls.eyesSwapped", walls.eyesSwapped);
  expectFlag("controls.trackerCross", walls.trackerCross);
  expectFlag("controls.latency", walls.latency);
}

void expectPossible(const HandView& hand, const DriveView& drive) {
  expectFlag("hand.shown", hand.shown);
  expectFlag("hand.pulling", hand.pulling);
  for (const Vec3& place : {hand.from_m, hand.to_m, hand.target_m, hand.towards, drive.thrust})
    expectFinite("the hand", {place.x, place.y, place.z});
  expectFinite("the stroke", {hand.u});
  if (drive.mode > DriveMode::tour) throw std::runtime_error("drive.mode is none that there is");
  expectFlag("drive.atLimit", drive.atLimit);
}

/// As this program could have written it with the frame of that number, of a game with that light speed.
const FrameRecord& checked(const FrameRecord& record, std::int64_t number, double gameLightSpeed_m_s) {
  if (record.number != static_cast<std::uint64_t>(number))
    throw std::runtime_error(fmt::format("its record is of frame {}", record.number));
  expectFinite("display_s", {record.display_s});
  expectPossible(record.observer, gameLightSpeed_m_s);
  expectPossible("the room's frame", record.boardFromRoom, gameLightSpeed_m_s);
  if (std::isnan(record.truncateFrom_s))
    throw std::runtime_error("truncateFrom_s is no number, expected a board time or infinity");
  const double c_m_s = record.lightSpeed_m_s;
  const bool settable = c_m_s >= kLeastLightSpeed_m_s && c_m_s <= kMostLightSpeed_m_s;
  if (!settable && c_m_s != gameLightSpeed_m_s) {
    throw std::runtime_error(fmt::format("lightSpeed_m_s is {}, expected {} to {} or the game's {}", c_m_s,
                                         kLeastLightSpeed_m_s, kMostLightSpeed_m_s, gameLightSpeed_m_s));
  }
  expectFlag("last", record.last);
  expectFlags(record.switches);
  expectPossible(record.controls);
  for (const NamedView& named : kNamedViews) expectFlag(named.name, record.views.*named.value);
  expectFlags(record.views.beside);
  expectFinite("the head sensor's pose", record.tracked.roomFromHeadSensor);
  expectFinite("the hand's pose", record.tracked.roomFromHand);
  expectFlag("tracked.headKnown", record.tracked.headKnown);
  expectFlag("tracked.handKnown", record.tracked.handKnown);
  expectPossible(record.hand, record.drive);
  if (record.lesson.phase > LessonPhase::explains || record.lesson.answer > kMostAnswers)
    throw std::runtime_error("lesson is in no phase that there is");
  if (record.notice.text.back() != 0) throw std::runtime_error("notice has no end");
  return record;
}

const Knot& checked(const Knot& knot) {
  expectFinite("a knot's turn", knot.turn);
  expectFinite("a knot's u", knot.u);
  expectFinite("a knot's proper time", {knot.properTime_s});
  expectFinite("a knot's news", knot.signal);
  expectFinite("a knot's deceleration", {knot.deceleration_m_s2});
  return knot;
}

}  // namespace

struct SessionFile::Tables {
  explicit Tables(const std::filesystem::path& file) : database(file.string(), SQLite::OPEN_READONLY) {
    database.setBusyTimeout(1000);
  }
  void prepare() {
    frame.emplace(database, "SELECT number, record, events FROM frame WHERE number >= ? ORDER BY number");
    knot.emplace(database, "SELECT body, knot FROM knot WHERE frame = ? ORDER BY rowid");
    // Two searches of the key; both in one SELECT would read every row.
    ends.emplace(database,
                 "SELECT (SELECT min(number) FROM frame WHERE number >= 0), (SELECT max(number) FROM frame)");
    shown.emplace(database, "SELECT number, display_s FROM frame WHERE number >= ? ORDER BY number LIMIT 1");
  }
  std::string fact(const char* key) {
    SQLite::Statement row(database, "SELECT value FROM session WHERE key = ?");
    row.bind(1, key);
    return row.executeStep() ? row.getColumn(0).getString() : std::string();
  }

  SQLite::Database database;
  std::optional<SQLite::Statement> frame, knot, ends, shown;
};

SessionFile::SessionFile(const std::filesystem::path& file, const Say& say) : file_(file) {
  if (!std::filesystem::exists(file)) refuse(file, "there is no such file");
  if (std::filesystem::is_directory(file)) refuse(file, "this is a folder, expected a session file");
  const bool alone = !hasBeside(file);  // opening it makes an empty one
  try {
    tables_ = std::make_unique<Tables>(file);
    SQLite::Database& database = tables_->database;
    const bool open = database.execAndGet("PRAGMA journal_mode").getString() == "wal";
    if (open && alone && database.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0) {
      refuse(file,
             fmt::format(
                 "nothing is in it: what a session wrote that was not closed is in {}, expected beside it",
                 besideOf(file).filename().string()));
    }
    if (database.execAndGet("PRAGMA application_id").getInt() != kJournalId) {
      refuse(file, "this is another program's database, expected what carom cave --session wrote");
    }
    const int version = database.execAndGet("PRAGMA user_version").getInt();
    if (version > kJournalVersion) {
      refuse(file,
             fmt::format("a newer carom wrote it (version {} of the tables), expected at most version {}",
                         version, kJournalVersion));
    }
    if (version < kJournalVersion) {
      refuse(file, fmt::format("an older carom wrote it (version {} of the tables), expected version {}",
                               version, kJournalVersion));
    }
    const std::string check = database.execAndGet("PRAGMA quick_check").getString();
    if (check != "ok")
      refuse(file, "it is damaged (" + check + "); sqlite3 FILE .recover may save what is left");
    facts_ = {tables_->fact("program"),
              tables_->fact("rig_file"),
              tables_->fact("scenario_file"),
              tables_->fact("rig"),
              tables_->fact("scenario"),
              database.execAndGet("SELECT value FROM session WHERE key = 'light_speed_m_s'").getDouble()};
    if (open && alone && tables_->fact("ended_utc").empty()) {
      const std::string line = fmt::format(
          "warning: session file {0}: the session was not closed, and {1}, which belongs beside it, is not "
          "there: up to "
          "its last minute is missing.",
          file.string(), besideOf(file).filename().string());
      say ? say(line) : fmt::print(stderr, "{}\n", line);
    }
    tables_->prepare();
    goTo(0);
  } catch (const SQLite::Exception& error) {
    refuse(file, error);
  }
}

SessionFile::~SessionFile() = default;

std::optional<std::pair<std::uint64_t, std::uint64_t>> SessionFile::frames() const {
  SQLite::Statement& row = *tables_->ends;
  std::optional<std::pair<std::uint64_t, std::uint64_t>> ends;
  if (row.executeStep() && !row.getColumn(0).isNull()) {
    ends.emplace(static_cast<std::uint64_t>(row.getColumn(0).getInt64()),
                 static_cast<std::uint64_t>(row.getColumn(1).getInt64()));
  }
  row.reset();
  return ends;
}

std::vector<Stroke> SessionFile::strokes(std::span<const Puck> pucks) const try {
  std::vector<Stroke> strokes;
  SQLite::Statement row(
      tables_->database,
      "SELECT frame, puck, at_s, from_x_m, from_y_m, from_z_m, p_x_kg_m_s, p_y_kg_m_s FROM stroke "
      "ORDER BY frame, rowid");
  while (row.executeStep()) {
    const auto frame = static_cast<std::uint64_t>(row.getColumn(0).getInt64());
    const std::string name = row.getColumn(1).getString();
    const auto number = [&](int column) { return row.getColumn(column).getDouble(); };
    const auto found =
        std::find_if(pucks.begin(), pucks.end(), [&](const Puck& puck) { return puck.name == name; });
    const Stroke stroke{static_cast<std::size_t>(found - pucks.begin()),
                        number(2),
                        Vec3(number(3), number(4), number(5)),
                        {number(6), number(7)}};
    if (found == pucks.end())
      refuseFrame(frame, "a stroke on '" + name + "', expected a puck of the scenario");
    bool possible = stroke.at_s >= 0.0;
    for (int column = 2; column < 8; ++column)
      possible = possible && row.getColumn(column).isFloat() && std::isfinite(number(column));
    if (!possible) refuseFrame(frame, "a stroke on '" + name + "' that is none, expected finite numbers");
    const double most_kg_m_s = kStrongestU * found->mass_kg * facts_.lightSpeed_m_s;
    if (!(glm::length(stroke.momentum_kg_m_s) <= most_kg_m_s * (1.0 + 1e-9))) {
      refuseFrame(frame, fmt::format("a stroke of {} kg m/s on '{}', expected {} at most",
                                     glm::length(stroke.momentum_kg_m_s), name, most_kg_m_s));
    }
    strokes.push_back(stroke);
  }
  return strokes;
} catch (const SQLite::Exception& error) {
  refuse(file_, error);
}

void SessionFile::readFrame(std::int64_t number, FrameState& state) {
  read(tables_->frame->getColumn(1), state.record);
  checked(state.record, number, facts_.lightSpeed_m_s);
  // To others, or from a session that was gone on with, more may be seen than was then.
  state.record.forgetBefore_s = -std::numeric_limits<double>::infinity();
  readEvents(tables_->frame->getColumn(2), state);
  state.knots.clear();
  SQLite::Statement& knot = *tables_->knot;
  knot.reset();
  knot.bind(1, number);
  while (knot.executeStep()) {
    BodyKnot& added = state.knots.emplace_back();
    added.body = static_cast<std::uint64_t>(knot.getColumn(0).getInt64());
    read(knot.getColumn(1), added.knot);
    checked(added.knot);
  }
}

bool SessionFile::next(FrameState& state) try {
  if (!tables_->frame->executeStep()) return false;
  const std::int64_t number = tables_->frame->getColumn(0).getInt64();
  try {
    readFrame(number, state);
  } catch (const SQLite::Exception&) {
    throw;
  } catch (const std::exception& error) {
    refuseFrame(static_cast<std::uint64_t>(number), error.what());
  }
  return true;
} catch (const SQLite::Exception& error) {
  refuse(file_, error);
}

void SessionFile::refuseFrame(std::uint64_t number, const std::string& what) const {
  refuse(file_, fmt::format("frame {}: {}", number, what));
}

void SessionFile::goTo(std::uint64_t number) {
  tables_->frame->reset();
  tables_->frame->bind(1, static_cast<std::int64_t>(number));
}

double SessionFile::shownAt_s(std::uint64_t number) const {
  SQLite::Statement& row = *tables_->shown;
  row.bind(1, static_cast<std::int64_t>(number));
  const double shown_s = row.executeStep() ? row.getColumn(1).getDouble() : 0.0;
  row.reset();
  return shown_s;
}

// Bisects, as display_s grows with the number.
std::uint64_t SessionFile::frameAt(double display_s) const {
  const auto ends = frames();
  if (!ends) return 0;
  std::uint64_t number = ends->first, after = ends->second + 1;
  SQLite::Statement& row = *tables_->shown;
  while (number + 1 < after) {
    const std::uint64_t middle = number + (after - number) / 2;
    row.bind(1, static_cast<std::int64_t>(middle));
    const bool found = row.executeStep();
    const std::uint64_t there = found ? static_cast<std::uint64_t>(row.getColumn(0).getInt64()) : after;
    if (there < after && row.getColumn(1).getDouble() <= display_s) {
      number = there;
    } else {
      after = middle;
    }
    row.reset();
  }
  return number;
}

}  // namespace carom
