#include "app/journal/version_3.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <random>

#include "app/journal/journal.h"
#include "app/journal/session_file.h"
#include "app/journal_frames.h"
#include "app/temporary_folder.h"
#include "cave/record/frame_digest.h"
#include "cave/record/record_rules.h"
#include "log_lines.h"

namespace carom {
namespace {

using namespace test;

/// The digests of all that was kept of a session, field by field of `FrameDigest`.
std::array<std::uint64_t, FrameDigest::kFields.size()> digestsOf(const std::filesystem::path& file,
                                                                 int frames) {
  std::array<std::uint64_t, FrameDigest::kFields.size()> digests{};
  SessionFile session(file);
  FrameState state;
  for (int frame = 0; frame < frames && session.next(state); ++frame) {
    const FrameDigest one = digestOf(state, World{});
    for (std::size_t i = 0; i < digests.size(); ++i) digests[i] = digests[i] * 1099511628211U + one.fields[i];
  }
  return digests;
}

// A session of twenty frames, two knots and three events, by the program that wrote version 3 last, and its digests.
// The program whose digests covered fewer fields read the same from it: carom export gave the same bytes. Earlier files of that version lack the column of delays.
TEST(Version3, AFileOfVersion3IsReadAndGoneOnWithAndHasTheSameDigests) {
  constexpr int kFrames = 20;
  constexpr std::array<std::uint64_t, FrameDigest::kFields.size()> kDigests{
      0x7bc6398e0441ce66, 0xd755289c3fb679ab, 0x295a8a85bfac7d47, 0x619ff81dcf11d808, 0x67264c3c5a75d9b9,
      0xadf725af024dc4d7, 0x26ab3ac2261bf8ff, 0x0000000000000000, 0x04e451a8e04c9c68};
  TemporaryFolder folder;
  for (const bool hasDelays : {true, false}) {
    SCOPED_TRACE(hasDelays);
    const auto file = folder / (hasDelays ? "game.db" : "earlier.db");
    std::filesystem::copy_file(std::filesystem::path(CAROM_TESTS_DIR) / "app/data/session-version-3.db",
                               file);
    std::filesystem::permissions(file, std::filesystem::perms::owner_write,
                                 std::filesystem::perm_options::add);
    if (!hasDelays)
      SQLite::Database(file.string(), SQLite::OPEN_READWRITE)
          .exec("ALTER TABLE event DROP COLUMN without_delay");
    const SessionFacts facts = SessionFile(file).facts();
    for (std::size_t field = 0; field < kDigests.size(); ++field)
      EXPECT_EQ(digestsOf(file, kFrames)[field], kDigests[field]) << FrameDigest::kFields[field];
    SessionFile old(file);
    for (FrameState state; old.next(state);) {
      EXPECT_EQ(state.record.room_s, state.record.viewers[0].observer.properTime_s)
          << "the room's time was the only viewer's";
      EXPECT_EQ(state.record.viewers[0].placeInRoom_m,
                state.record.viewers[0].observer.middle.positionInRoom_m);
    }
    FrameState later = frameOf(kFrames);
    later.record.eventsKept = 3;
    later.events[0].number = 3;
    later.events[0].withoutDelay = true;
    const test::LogLines lines;
    {
      Journal journal(file, facts, true);
      journal.add(later, head(), {});
    }
    EXPECT_EQ(lines.said(), (Strings{"The session file " + file.string() +
                                     " is of version 3 and becomes one of version 8."}));
    EXPECT_EQ(digestsOf(file, kFrames), kDigests);
    SQLite::Database database(file.string());
    EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), 8);
    EXPECT_EQ(database.execAndGet("PRAGMA integrity_check").getString(), "ok");
    EXPECT_EQ(column(database, "SELECT without_delay FROM event ORDER BY number"),
              (Strings{"0", "0", "0", "1"}));
    EXPECT_EQ(column(database, "SELECT known FROM frame WHERE number IN (0, 19) ORDER BY number"),
              (Strings{"predicted", "predicted"}));
    SessionFile session(file);
    session.goTo(kFrames);
    FrameState state;
    ASSERT_TRUE(session.next(state));
    EXPECT_TRUE(sameBits(state, later));
  }
}

// A record of version 3 that cannot be stops the conversion, and the file stays what it was.
TEST(Version3, ADamagedFileOfVersion3IsNotConverted) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  std::filesystem::copy_file(std::filesystem::path(CAROM_TESTS_DIR) / "app/data/session-version-3.db", file);
  std::filesystem::permissions(file, std::filesystem::perms::owner_write, std::filesystem::perm_options::add);
  SQLite::Database(file.string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE frame SET record = zeroblob(1008) WHERE number = 7");
  try {
    Journal(file, kFacts, true);
    ADD_FAILURE() << "converted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("game.db: frame 7: its record is of frame 0"), std::string::npos)
        << error.what();
  }
  SQLite::Database database(file.string());
  EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), 3);
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM frame WHERE length(record) = 1008").getInt(), 20);
}

TEST(Version3, AnyBytesAreEventsOrNone) {
  std::mt19937 random(3);
  int read = 0;
  for (int run = 0; run < 20000; ++run) {
    std::array<std::byte, 216> bytes{};
    for (int i = 0; i < 12; ++i)
      bytes[random() % (run % 2 == 0 ? 16 : bytes.size())] = static_cast<std::byte>(random() % 4);
    try {
      for (const GameEvent& event : version3::eventsOf(bytes)) {
        expectPossible(event, 2);
        ASSERT_LE(event.turns.size(), 2u);
        for (const Turn& turn : event.turns) ASSERT_LT(turn.puck, 2u);
        ASSERT_FALSE(nameOf(event.kind).empty());
        ASSERT_TRUE(!event.cushion || !nameOf(*event.cushion).empty());
      }
      ++read;
    } catch (const std::exception&) {
    }
  }
  EXPECT_GT(read, 1000) << "harmless changes pass";
  EXPECT_LT(read, 19000);
  EXPECT_THROW(version3::eventsOf(std::array<std::byte, 217>{}), std::runtime_error);
  EXPECT_THROW(version3::frameOf(std::array<std::byte, 1007>{}), std::runtime_error);
  EXPECT_THROW(version3::knotOf(std::array<std::byte, 105>{}), std::runtime_error);
}

}  // namespace
}  // namespace carom
