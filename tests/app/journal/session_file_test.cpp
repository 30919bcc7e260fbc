#include "app/journal/session_file.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <limits>
#include <random>
#include <string>

#include "app/journal/journal.h"
#include "app/journal_frames.h"
#include "app/temporary_folder.h"
#include "cave/record/record_rules.h"
#include "cave/record/time_views.h"
#include "log_lines.h"

namespace carom {
namespace {

using namespace test;

std::string refusalOf(const std::filesystem::path& file) {
  try {
    SessionFile session(file);
    return "accepted";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(SessionFile, SaysWhatIsWrongWithAFile) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  {
    Journal journal(file, kFacts, false);
    for (std::uint64_t number = 0; number < 300; ++number) journal.add(frameOf(number), head(), {});
  }
  EXPECT_NE(refusalOf(folder / "none.db").find("no such file"), std::string::npos);

  EXPECT_NE(refusalOf(folder / "").find("a folder"), std::string::npos) << refusalOf(folder / "");

  const auto text = folder / "text.db";
  std::ofstream(text) << std::string(5000, 'x');
  EXPECT_NE(refusalOf(text).find("no session file"), std::string::npos) << refusalOf(text);

  const auto foreign = folder / "foreign.db";
  SQLite::Database(foreign.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("CREATE TABLE frame(number)");
  EXPECT_NE(refusalOf(foreign).find("another program's"), std::string::npos) << refusalOf(foreign);

  const auto empty = folder / "empty.db";
  SQLite::Database(empty.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("PRAGMA journal_mode = WAL");
  EXPECT_NE(refusalOf(empty).find("is in empty.db-wal, expected beside it"), std::string::npos)
      << refusalOf(empty);

  const auto newer = folder / "newer.db";
  std::filesystem::copy_file(file, newer);
  SQLite::Database(newer.string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 99");
  EXPECT_NE(refusalOf(newer).find("newer carom wrote it (version 99"), std::string::npos) << refusalOf(newer);

  const auto older = folder / "older.db";
  std::filesystem::copy_file(file, older);
  SQLite::Database(older.string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 1");
  EXPECT_NE(refusalOf(older).find("an older carom wrote it (version 1"), std::string::npos)
      << refusalOf(older);
  EXPECT_THROW(Journal(older, kFacts, true), std::runtime_error);

  const auto odd = folder / "odd.db";
  std::filesystem::copy_file(file, odd);
  SQLite::Database(odd.string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE frame_event SET turns = 3 WHERE frame = 8");
  SessionFile oddSession(odd);
  FrameState state;
  for (int frame = 0; frame < 8; ++frame) ASSERT_TRUE(oddSession.next(state));
  try {
    oddSession.next(state);
    ADD_FAILURE() << "an event of three turns was read";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("frame 8"), std::string::npos) << error.what();
  }

  const auto locked = folder / "locked.db";
  std::filesystem::copy_file(file, locked);
  SQLite::Database holder(locked.string(), SQLite::OPEN_READWRITE);
  holder.exec("PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE; CREATE TABLE mine(x)");
  EXPECT_NE(refusalOf(locked).find("locked"), std::string::npos) << refusalOf(locked);
}

// Closing takes the file out of WAL mode; a process that is killed then leaves its notes in FILE-journal.
TEST(SessionFile, IsReadWhereTheWriterWasKilledInTheMiddle) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  {
    Journal journal(file, kFacts, false);
    for (std::uint64_t number = 0; number < 300; ++number) journal.add(frameOf(number), head(), {});
  }
  const pid_t writer = fork();
  if (writer == 0) {
    SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
    database.exec("PRAGMA cache_size = 1");  // so that changed pages go to the file before the end
    database.exec("BEGIN IMMEDIATE; DELETE FROM frame WHERE number > 100; DELETE FROM session");
    _exit(0);
  }
  int status = -1;
  waitpid(writer, &status, 0);
  ASSERT_EQ(status, 0);
  ASSERT_TRUE(std::filesystem::exists(folder / "game.db-journal")) << "nothing was left in the middle";
  const SessionFile session(file);
  EXPECT_EQ(session.frames(), std::pair(std::uint64_t{0}, std::uint64_t{299}));
  EXPECT_EQ(session.facts().program, kFacts.program);
}

TEST(SessionFile, FindsTheFrameOfATime) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  std::mt19937 random(11);
  std::vector<FrameState> frames;
  {
    Journal journal(file, kFacts, false);
    for (std::uint64_t number = 7; number < 400; number += 1 + random() % 3) {  // with gaps
      frames.push_back(frameOf(number));
      journal.add(frames.back(), head(), {});
    }
  }
  const SessionFile session(file);
  EXPECT_EQ(session.frames(), (std::pair<std::uint64_t, std::uint64_t>(7, frames.back().record.number)));
  for (int run = 0; run < 500; ++run) {
    double time_s = std::uniform_real_distribution<>(-1.0, 8.0)(random);
    if (run % 2 == 0) time_s = frames[random() % frames.size()].record.display_s;
    std::uint64_t expected = 7;  // by going through all
    for (const FrameState& frame : frames)
      if (frame.record.display_s <= time_s) expected = frame.record.number;
    ASSERT_EQ(session.frameAt(time_s), expected) << "seed 11, run " << run << ", " << time_s << " s";
  }
}

TEST(SessionFile, ARecordThatCannotBeIsRefusedWithFileFrameAndField) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  struct Damage {
    const char* said;
    void (*make)(FrameState&);
  };
  const std::vector<Damage> damages{
      {"shown is 9", [](FrameState& s) { s.record.controls.shown = static_cast<Shown>(9); }},
      {"blank is 2", [](FrameState& s) { s.record.controls.blank = 2; }},
      {"hand_known is 2", [](FrameState& s) { s.record.viewers[0].tracked.handKnown = 2; }},
      {"last is 7", [](FrameState& s) { s.record.last = 7; }},
      {"display_s is nan", [](FrameState& s) { s.record.display_s = kNan; }},
      {"light_speed_m_s is nan", [](FrameState& s) { s.record.lightSpeed_m_s = kNan; }},
      {"light_speed_m_s is 0", [](FrameState& s) { s.record.lightSpeed_m_s = 0.0; }},
      {"light_speed_m_s is 1e+300", [](FrameState& s) { s.record.lightSpeed_m_s = 1e300; }},
      {"truncate_from_s is nan, expected a number", [](FrameState& s) { s.record.truncateFrom_s = kNan; }},
      {"head_from_board_ is no Lorentz transform",
       [](FrameState& s) {
         s.record.viewers[0].observer.headFromBoard = Lorentz::boost({kNan, 0.0, 0.0}, 1.42);
       }},
      {"right_z_m is nan, expected a finite number",
       [](FrameState& s) { s.record.viewers[0].observer.right.observation.r_m.z = kNan; }},
      {"middle_in_room_x_m is nan",
       [](FrameState& s) { s.record.viewers[0].observer.middle.positionInRoom_m.x = kNan; }},
      {"left_seen_from_y_m is nan",
       [](FrameState& s) { s.record.viewers[0].observer.left.seenFromInRoom_m.y = kNan; }},
      {"proper_time_s is nan", [](FrameState& s) { s.record.viewers[0].observer.properTime_s = kNan; }},
      {"board_from_room_ is no Lorentz transform",
       [](FrameState& s) {
         s.record.boardFromRoom = Lorentz::rotation({1.0, 1.0, 0.0, 0.0}, 1.42);
       }},
      {"cue_pulling is 2, expected 0 to 1", [](FrameState& s) { s.record.viewers[0].hand.pulling = 2; }},
      {"cue_to_y_m is nan", [](FrameState& s) { s.record.viewers[0].hand.to_m.y = kNan; }},
      {"cue_u is nan", [](FrameState& s) { s.record.viewers[0].hand.u = kNan; }},
      {"drive_mode is 4, expected 0 to 3",
       [](FrameState& s) { s.record.drive.mode = static_cast<DriveMode>(4); }},
      {"lesson_phase is 4", [](FrameState& s) { s.record.lesson.phase = static_cast<LessonPhase>(4); }},
      {"lesson_answer is 5", [](FrameState& s) { s.record.lesson.answer = 5; }},
      {"head_sensor_qw is nan",
       [](FrameState& s) { s.record.viewers[0].tracked.roomFromHeadSensor.orientation.w = kNan; }},
      {"hand_y_m is nan",
       [](FrameState& s) { s.record.viewers[0].tracked.roomFromHand.position_m.y = kNan; }},
      {"a knot's t_s", [](FrameState& s) { s.knots[0].knot.turn.t_s = kNan; }},
      {"a knot's u_y", [](FrameState& s) { s.knots[1].knot.u.y = kNan; }},
      {"a knot's proper_time_s", [](FrameState& s) { s.knots[1].knot.properTime_s = kNan; }},
      {"a knot's signal_x_m", [](FrameState& s) { s.knots[1].knot.signal.r_m.x = kNan; }},
      {"a knot's deceleration_m_s2", [](FrameState& s) { s.knots[1].knot.deceleration_m_s2 = kNan; }}};
  TemporaryFolder folder;
  for (const Damage& damage : damages) {
    SCOPED_TRACE(damage.said);
    const auto file = folder / "game.db";
    {
      Journal journal(file, kFacts, false);
      FrameState damaged = frameOf(3);
      damage.make(damaged);
      journal.add(frameOf(0), head(), {});
      journal.add(damaged, head(), {});
    }
    SessionFile session(file);
    FrameState state;
    ASSERT_TRUE(session.next(state));
    try {
      session.next(state);
      ADD_FAILURE() << "accepted";
    } catch (const std::runtime_error& error) {
      for (const std::string& part :
           {std::string("game.db"), std::string("frame 3"), std::string(damage.said)})
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
    std::filesystem::remove(file);
  }
}

/// What is said of the first frame of a file that is one.
std::string refusalOfFirst(const std::filesystem::path& file) {
  SessionFile session(file);
  FrameState state;
  try {
    session.next(state);
    return "accepted";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(SessionFile, AColumnThatCannotBeIsRefusedWithFileFrameAndField) {
  constexpr unsigned allViews = (1U << kNamedViews.size()) - 1;
  const std::vector<std::pair<std::string, std::string>> damages{
      {"switches is 64, expected 0 to 31", "frame SET switches = 64"},
      {"views is " + std::to_string(allViews + 1) + ", expected 0 to " + std::to_string(allViews),
       "frame SET views = " + std::to_string(allViews + 1)},
      {"beside is 32, expected 0 to 31", "frame SET beside = 32"},
      {"blank is 300, expected a whole number up to 255", "frame SET blank = 300"},
      {"shown is -1, expected", "frame SET shown = -1"},
      {"lesson_phase is two, expected", "frame SET lesson_phase = 'two'"},
      {"pucks is , expected", "frame SET pucks = NULL"},
      {"notice is of 130 bytes, expected at most 119", "frame SET notice = printf('%130s', 'late')"},
      {"display_s is nan", "frame SET display_s = 'soon'"},
      {"display_s is inf", "frame SET display_s = 1e999"},
      {"head_from_board_ is no Lorentz transform", "frame SET head_from_board_xt = NULL"},
      {"board_from_room_ is no Lorentz transform", "frame SET board_from_room_yz = 1e300"},
      {"a knot's signal_x_m is nan", "knot SET signal_x_m = x'00'"},
      {"body is 1.5, expected a whole number", "knot SET body = 1.5"},
      {"an event's kind is 9, expected 0 to 8", "frame_event SET kind = 9"},
      {"an event's cushion is 4, expected 0 to 3", "frame_event SET cushion = 5"},
      {"an event's heat_j is nan", "frame_event SET heat_j = NULL"},
      {"no such event can be", "frame_event SET turns = 3"},
      {"no such event can be", "frame_event SET without_delay = 2"},
      {"an event turns puck 2, expected one of 2", "frame_event SET first_puck = 2"},
      {"an event's beta_after_y is nan", "frame_event SET first_beta_after_y = NULL"}};
  TemporaryFolder folder;
  const auto whole = folder / "whole.db", file = folder / "game.db";
  { Journal(whole, kFacts, false).add(frameOf(12), head(), {}); }
  EXPECT_EQ(refusalOfFirst(whole), "accepted");
  static_assert(kLastEventKind == EventKind{8});
  for (const auto& [said, sql] : damages) {
    std::filesystem::copy_file(whole, file, std::filesystem::copy_options::overwrite_existing);
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec(std::string("UPDATE ") + sql);
    const std::string refusal = refusalOfFirst(file);
    EXPECT_NE(refusal.find(std::string("game.db: frame 12: ") + said), std::string::npos)
        << sql << ": " << refusal;
  }
}

TEST(SessionFile, DamagedBytesAreFoundOrReadAsTheyWereNeverACrash) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  {
    Journal journal(file, kFacts, false);
    for (std::uint64_t number = 0; number < 60; ++number) journal.add(frameOf(number), head(), {});
  }
  std::ifstream in(file, std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(in)), {});
  std::mt19937 random(9);
  int refused = 0;
  for (int run = 0; run < 300; ++run) {
    std::string bytes = whole;
    for (int i = 0; i < 20; ++i) bytes[random() % bytes.size()] = static_cast<char>(random());
    if (run % 3 == 0) bytes.resize(random() % bytes.size());
    const auto damaged = folder / "damaged.db";
    std::ofstream(damaged, std::ios::binary | std::ios::trunc) << bytes;
    try {
      SessionFile session(damaged);
      FrameState state;
      for (int frames = 0; frames < 1000 && session.next(state); ++frames) {
      }
    } catch (const std::runtime_error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100) << "most damage hits what SQLite checks";
}

}  // namespace
}  // namespace carom
