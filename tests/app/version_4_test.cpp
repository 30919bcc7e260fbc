// Session files of version 4, which do not know of spins.

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "app/journal/journal.h"
#include "app/journal/session_file.h"
#include "journal_frames.h"
#include "log_lines.h"
#include "temporary_folder.h"

namespace carom {
namespace {

using namespace test;

constexpr int kFrames = 9;

/// The frame as a program that knew of no spins would have kept it.
FrameState plainFrameOf(std::uint64_t number) {
  FrameState state = frameOf(number);
  state.record.hand.offset_m = state.record.fade = 0.0;
  state.record.controls.comfort = 0;
  state.record.score = {};
  for (BodyKnot& knot : state.knots) knot.knot.spin = {};
  for (GameEvent& event : state.events) {
    for (Turn& turn : event.turns) turn.spinBefore_kg_m2_s = turn.spinAfter_kg_m2_s = 0.0;
  }
  return state;
}

void writeVersion4(const std::filesystem::path& file) {
  {
    Journal journal(file, kFacts, false);
    for (std::uint64_t number = 0; number < kFrames; ++number) journal.add(plainFrameOf(number), head(), {});
  }
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
  for (const char* column :
       {"frame DROP COLUMN comfort", "frame DROP COLUMN caroms", "frame DROP COLUMN strokes",
        "frame DROP COLUMN fade", "frame DROP COLUMN cue_offset_m", "knot DROP COLUMN angle_rad",
        "knot DROP COLUMN spin_rad_s", "knot DROP COLUMN rim_u", "knot DROP COLUMN spin_slowing_1_s",
        "frame_event DROP COLUMN first_spin_before_kg_m2_s",
        "frame_event DROP COLUMN first_spin_after_kg_m2_s",
        "frame_event DROP COLUMN second_spin_before_kg_m2_s",
        "frame_event DROP COLUMN second_spin_after_kg_m2_s", "turn DROP COLUMN spin_before_kg_m2_s",
        "turn DROP COLUMN spin_after_kg_m2_s", "stroke DROP COLUMN offset_m"})
    database.exec(std::string("ALTER TABLE ") + column);
  database.exec("PRAGMA user_version = 4");
}

void expectFrames(const std::filesystem::path& file, int plain, int spinning) {
  SessionFile session(file);
  FrameState state;
  for (int number = 0; number < plain + spinning; ++number) {
    ASSERT_TRUE(session.next(state));
    const auto of = static_cast<std::uint64_t>(number);
    EXPECT_TRUE(sameBits(state, number < plain ? plainFrameOf(of) : frameOf(of))) << number;
  }
  EXPECT_FALSE(session.next(state));
}

TEST(Version4, AFileOfVersion4IsReadAndGoneOnWith) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  writeVersion4(file);
  expectFrames(file, kFrames, 0);
  EXPECT_TRUE(SessionFile(file).strokes({}).empty());
  const test::LogLines lines;
  {
    Journal journal(file, SessionFile(file).facts(), true);
    for (std::uint64_t number = kFrames; number < 2 * kFrames; ++number)
      journal.add(frameOf(number), head(), {});
  }
  EXPECT_EQ(lines.said(), (std::vector<std::string>{"The session file " + file.string() +
                                                    " is of version 4 and becomes one of version 6."}));
  expectFrames(file, kFrames, kFrames);
  SQLite::Database database(file.string());
  EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), 6);
  EXPECT_EQ(database.execAndGet("PRAGMA integrity_check").getString(), "ok");
}

}  // namespace
}  // namespace carom
