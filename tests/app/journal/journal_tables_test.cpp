// The tables of a session file as plain SQL reads them.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "app/journal/journal.h"
#include "app/journal/session_file.h"
#include "app/journal_frames.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using namespace test;

TEST(Journal, PlainSqlTellsWhatHappened) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  const std::vector<TrackerSample> samples(2);
  SessionFacts facts = kFacts;
  facts.trackers = {"art"};
  { Journal(file, facts, false).add(frameOf(3), head(), std::vector<TrackerSamples>{{0, samples}}); }
  SQLite::Database database(file.string());
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM sample WHERE tracker = 'art'").getInt(), 2);
  EXPECT_EQ(database.execAndGet("SELECT value FROM session WHERE key = 'scenario'").getString(),
            kFacts.scenarioText);
  SQLite::Statement frame(database, "SELECT t_s, known, celerity_y_m_s, switches FROM frame");
  ASSERT_TRUE(frame.executeStep());
  EXPECT_EQ(frame.getColumn(0).getDouble(), 0.1 * 3.0);
  EXPECT_EQ(frame.getColumn(1).getString(), "predicted");
  EXPECT_EQ(frame.getColumn(2).getDouble(), 0.2);
  EXPECT_EQ(frame.getColumn(3).getInt(), 0b01111) << "colour is bit 3";
  SQLite::Statement knots(database, "SELECT body, u_y FROM knot ORDER BY body");
  ASSERT_TRUE(knots.executeStep());
  EXPECT_EQ(knots.getColumn(0).getInt(), 1);
  EXPECT_EQ(knots.getColumn(1).getDouble(), 0.3);
}

TEST(Journal, LatenciesAreRowsOfNodeAndPart) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  const PartStatistics statistics{60, 0.25F, 0.5F, 0.75F, 0.125F};
  const std::vector<LatencyRow> rows{{3.5, 210, 0, FramePart::sample, statistics},
                                     {3.5, 209, 1, FramePart::late, statistics}};
  {
    Journal journal(file, kFacts, false);
    journal.add(rows);
    journal.add(frameOf(0), head(), {});
  }
  SQLite::Database database(file.string());
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM latency").getInt(), 2);
  SQLite::Statement row(database, "SELECT * FROM latency WHERE node = 1");
  ASSERT_TRUE(row.executeStep());
  EXPECT_EQ(row.getColumn("display_s").getDouble(), 3.5);
  EXPECT_EQ(row.getColumn("frame").getInt(), 209);
  EXPECT_EQ(row.getColumn("part").getString(), "late");
  EXPECT_EQ(row.getColumn("frames").getInt(), 60);
  EXPECT_EQ(row.getColumn("median_s").getDouble(), 0.25);
  EXPECT_EQ(row.getColumn("p99_s").getDouble(), 0.5);
  EXPECT_EQ(row.getColumn("most_s").getDouble(), 0.75);
  EXPECT_EQ(row.getColumn("jitter_s").getDouble(), 0.125);
}

TEST(Journal, EventsAndTurnsCanBeReadWithPlainSql) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  SessionFacts facts = kFacts;
  facts.pucks = {"white", "red"};
  {
    Journal journal(file, facts, false);
    for (std::uint64_t number = 0; number < 5; ++number) journal.add(frameOf(number), head(), {});
  }
  SQLite::Database database(file.string());
  SQLite::Statement row(database,
                        "SELECT number, kind, pucks, cushion, t_s, y_m, heat_j FROM event ORDER BY number");
  ASSERT_TRUE(row.executeStep());
  EXPECT_EQ(row.getColumn(1).getString(), "puck-cushion");
  EXPECT_EQ(row.getColumn(2).getString(), "white");
  EXPECT_EQ(row.getColumn(3).getString(), "-y");
  ASSERT_TRUE(row.executeStep());
  const GameEvent expected = eventOf(1, 0.4);
  EXPECT_EQ(row.getColumn(0).getInt(), 1);
  EXPECT_EQ(row.getColumn(1).getString(), "puck-puck");
  EXPECT_EQ(row.getColumn(2).getString(), "white, red");
  EXPECT_EQ(row.getColumn(3).getString(), "");
  EXPECT_EQ(row.getColumn(4).getDouble(), expected.at.t_s);
  EXPECT_EQ(row.getColumn(5).getDouble(), expected.at.r_m.y);
  EXPECT_EQ(row.getColumn(6).getDouble(), expected.heat_j);
  EXPECT_FALSE(row.executeStep());
  EXPECT_EQ(column(database, "SELECT without_delay FROM event ORDER BY number"), (Strings{"1", "0"}));
  EXPECT_EQ(column(database, "SELECT puck FROM turn ORDER BY event, puck"),
            (Strings{"white", "red", "white"}));
  EXPECT_EQ(database.execAndGet("SELECT beta_after_y FROM turn WHERE event = 1 AND puck = 'red'").getDouble(),
            expected.turns[1].betaAfter.y);
}

// At the end the tables tell the game as it was in the end; the frames keep what was known when they were
// shown.
TEST(Journal, EventsThatAStrokeTookBackAreGoneFromTheTableButNotFromTheFrames) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  const auto frame = [](std::uint64_t number, std::uint64_t kept, std::vector<GameEvent> events) {
    FrameState state;
    state.record.number = number;
    state.record.lightSpeed_m_s = kFacts.lightSpeed_m_s;
    state.record.viewers[0].observer.headFromBoard = state.record.boardFromRoom =
        Lorentz(kFacts.lightSpeed_m_s);
    state.record.pucks = 2;
    state.record.eventsKept = kept;
    state.events = std::move(events);
    return state;
  };
  const std::vector<FrameState> frames{frame(0, 0, {eventOf(0, 1.0), eventOf(1, 2.0), eventOf(2, 3.0)}),
                                       frame(1, 3, {}), frame(2, 1, {eventOf(1, 2.5)}),
                                       // The next session begins with all of the game once more.
                                       frame(3, 0, {eventOf(0, 1.0), eventOf(1, 2.5), eventOf(2, 4.0)})};
  {
    Journal journal(file, kFacts, false);
    for (int i = 0; i < 3; ++i) journal.add(frames[i], head(), {});
  }
  {
    SQLite::Database database(file.string());
    EXPECT_EQ(column(database, "SELECT t_s FROM event ORDER BY number"), (Strings{"1.0", "2.5"}));
    EXPECT_EQ(column(database, "SELECT t_s FROM turn ORDER BY event"), (Strings{"1.0", "2.5", "2.5"}));
  }
  { Journal(file, kFacts, true).add(frames[3], head(), {}); }
  SQLite::Database database(file.string());
  EXPECT_EQ(column(database, "SELECT t_s FROM event ORDER BY number"), (Strings{"1.0", "2.5", "4.0"}));
  EXPECT_EQ(column(database, "SELECT t_s FROM turn ORDER BY event"), (Strings{"1.0", "2.5", "2.5", "4.0"}));
  EXPECT_EQ(column(database, "SELECT first_frame FROM run"), (Strings{"0", "3"})) << "each run is noted";
  SessionFile session(file);
  FrameState state;
  for (const FrameState& expected : frames) {
    ASSERT_TRUE(session.next(state));
    EXPECT_EQ(state.record.eventsKept, expected.record.eventsKept);
    ASSERT_EQ(state.events.size(), expected.events.size());
    for (std::size_t i = 0; i < expected.events.size(); ++i)
      EXPECT_TRUE(sameBits(state.events[i], expected.events[i]));
  }
}

TEST(Journal, KeepsWhatWasDoneAndAnswered) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  {
    Journal journal(file, kFacts, false);
    journal.addInput(7, "colour", "on");
    journal.addAnswer(9, "lesson 1", "Which came first?", "neither; it's 'both'");
  }
  SQLite::Database database(file.string());
  EXPECT_EQ(column(database, "SELECT frame || what || value FROM input"), Strings{"7colouron"});
  EXPECT_EQ(column(database, "SELECT frame || lesson || question || answer FROM answer"),
            Strings{"9lesson 1Which came first?neither; it's 'both'"});
}

}  // namespace
}  // namespace carom
