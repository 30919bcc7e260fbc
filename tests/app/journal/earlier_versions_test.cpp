// Session files of versions 4 to 7, which do not know of spins, of scores and comfort, of several games, of several
// viewers and of sides on sides.

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <initializer_list>
#include <string>

#include "app/journal/frame_rows.h"
#include "app/journal/journal.h"
#include "app/journal/session_file.h"
#include "app/journal_frames.h"
#include "app/temporary_folder.h"
#include "log_lines.h"

namespace carom {
namespace {

using namespace test;

constexpr int kFrames = 9;

/// The frame as a program of that version would have kept it: without sides on sides, before 6 without scores and
/// comfort, 4 without spins.
FrameState plainFrameOf(std::uint64_t number, int version) {
  FrameState state = frameOf(number);
  for (GameEvent& event : state.events) event.sideOnSide = false;
  if (version >= kVersion6) return state;
  state.record.fade = 0.0;
  state.record.controls.comfort = 0;
  state.record.viewers[0].score = {};
  if (version > kVersion4) return state;
  state.record.viewers[0].hand.offset_m = 0.0;
  for (BodyKnot& knot : state.knots) knot.knot.spin = {};
  for (GameEvent& event : state.events) {
    for (Turn& turn : event.turns) turn.spinBefore_kg_m2_s = turn.spinAfter_kg_m2_s = 0.0;
  }
  return state;
}

void write(const std::filesystem::path& file, int version) {
  {
    Journal journal(file, kFacts, false);
    for (std::uint64_t number = 0; number < kFrames; ++number)
      journal.add(plainFrameOf(number, version), head(), {});
  }
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
  const auto drop = [&](std::initializer_list<const char*> columns) {
    for (const char* column : columns) database.exec(std::string("ALTER TABLE ") + column);
  };
  drop({"event DROP COLUMN side_on_side", "frame_event DROP COLUMN side_on_side"});
  database.exec("PRAGMA user_version = " + std::to_string(version));
  if (version == kVersion7) return;
  database.exec(
      "DROP TABLE game; DROP TABLE viewer; DROP TABLE platform; DROP TABLE other_viewer; DELETE FROM session "
      "WHERE key = 'viewer'");
  drop({"sample DROP COLUMN tracker", "stroke DROP COLUMN viewer", "input DROP COLUMN viewer",
        "answer DROP COLUMN viewer"});
  if (version < kVersion6)
    drop({"frame DROP COLUMN comfort", "frame DROP COLUMN caroms", "frame DROP COLUMN strokes",
          "frame DROP COLUMN fade"});
  if (version == kVersion4) {
    drop({"frame DROP COLUMN cue_offset_m", "knot DROP COLUMN angle_rad", "knot DROP COLUMN spin_rad_s",
          "knot DROP COLUMN rim_u", "knot DROP COLUMN spin_slowing_1_s",
          "frame_event DROP COLUMN first_spin_before_kg_m2_s",
          "frame_event DROP COLUMN first_spin_after_kg_m2_s",
          "frame_event DROP COLUMN second_spin_before_kg_m2_s",
          "frame_event DROP COLUMN second_spin_after_kg_m2_s", "turn DROP COLUMN spin_before_kg_m2_s",
          "turn DROP COLUMN spin_after_kg_m2_s", "stroke DROP COLUMN offset_m"});
  }
}

void expectFrames(const std::filesystem::path& file, int version, int plain, int later) {
  SessionFile session(file);
  FrameState state;
  for (int number = 0; number < plain + later; ++number) {
    ASSERT_TRUE(session.next(state));
    const auto of = static_cast<std::uint64_t>(number);
    EXPECT_TRUE(sameBits(state, number < plain ? plainFrameOf(of, version) : frameOf(of))) << number;
  }
  EXPECT_FALSE(session.next(state));
}

TEST(EarlierVersions, FilesOfVersions4To7AreReadAndGoneOnWith) {
  TemporaryFolder folder;
  for (const int version : {kVersion4, kVersion5, kVersion6, kVersion7}) {
    SCOPED_TRACE(version);
    const auto file = folder / ("game" + std::to_string(version) + ".db");
    write(file, version);
    expectFrames(file, version, kFrames, 0);
    EXPECT_TRUE(SessionFile(file).strokes({}).empty());
    const test::LogLines lines;
    {
      Journal journal(file, SessionFile(file).facts(), true);
      for (std::uint64_t number = kFrames; number < 2 * kFrames; ++number)
        journal.add(frameOf(number), head(), {});
    }
    EXPECT_EQ(lines.said(), (std::vector<std::string>{fmt::format(
                                "The session file {} is of version {} and becomes one of version {}.",
                                file.string(), version, kJournalVersion)}));
    expectFrames(file, version, kFrames, kFrames);
    SQLite::Database database(file.string());
    EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), kJournalVersion);
    EXPECT_EQ(database.execAndGet("PRAGMA integrity_check").getString(), "ok");
    EXPECT_EQ(database.execAndGet("SELECT count(*) FROM viewer WHERE name = 'viewer'").getInt(), 2 * kFrames);
  }
}

}  // namespace
}  // namespace carom
