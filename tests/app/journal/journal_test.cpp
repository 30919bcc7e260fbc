#include "app/journal/journal.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "app/journal/session_file.h"
#include "app/journal_frames.h"
#include "app/temporary_folder.h"
#include "log_lines.h"

namespace carom {
namespace {

using namespace test;

TEST(Journal, WhatWasWrittenIsReadWithTheSameBits) {
  const test::NothingIsLogged silence;
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  const std::vector<TrackerSample> samples(2);
  std::vector<FrameState> written;
  {
    Journal journal(file, kFacts, false);
    for (std::uint64_t number = 0; number < 500; ++number) {
      written.push_back(frameOf(number));
      journal.add(written.back(), head(), std::vector<TrackerSamples>{{0, samples}});
    }
  }
  SessionFile session(file);
  EXPECT_EQ(session.facts().scenarioText, kFacts.scenarioText);
  EXPECT_EQ(session.facts().rigText, kFacts.rigText);
  EXPECT_EQ(session.facts().lightSpeed_m_s, 1.42);
  EXPECT_EQ(session.frames(), (std::pair<std::uint64_t, std::uint64_t>(0, 499)));
  for (int pass = 0; pass < 2; ++pass, session.goTo(0)) {
    FrameState state;
    for (const FrameState& expected : written) {
      ASSERT_TRUE(session.next(state));
      ASSERT_TRUE(sameBits(state, expected)) << "frame " << expected.record.number;
    }
    EXPECT_FALSE(session.next(state));
  }
}

TEST(Journal, KeepsTheSizeOfTheWords) {
  const test::NothingIsLogged silence;
  TemporaryFolder folder;
  for (const double textSize : {1.0, 1.25, 2.0}) {
    const auto file = folder / fmt::format("{}.db", textSize);
    SessionFacts facts = kFacts;
    facts.textSize = textSize;
    { Journal(file, facts, false).add(frameOf(0), head(), {}); }
    EXPECT_EQ(SessionFile(file).facts().textSize, textSize);
  }
  // What a damaged file says is as ever.
  for (const char* value : {"nan", "7", "-1", "large"}) {
    SQLite::Database(folder / "2.db", SQLite::OPEN_READWRITE)
        .exec(fmt::format("UPDATE session SET value = '{}' WHERE key = 'text_size'", value));
    EXPECT_EQ(SessionFile(folder / "2.db").facts().textSize, 1.0) << value;
  }
}

TEST(Journal, SeveralViewersAreReadWithTheSameBits) {
  const test::NothingIsLogged silence;
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  SessionFacts facts = kFacts;
  facts.viewers = {"anna", "ben", "cleo"};
  std::vector<FrameState> written;
  {
    Journal journal(file, facts, false);
    for (std::uint64_t number = 0; number < 100; ++number) {
      FrameState& frame = written.emplace_back(frameOf(number));
      FrameRecord& record = frame.record;
      record.viewerCount = 3;
      record.viewers[0].hasTurn = 1;
      record.room_s = 0.3 * static_cast<double>(number);
      for (std::size_t i = 0; i < 3; ++i) {
        const FrameRecord other = frameOf(number + 10 * i).record;
        if (i > 0) record.viewers[i] = other.viewers[0];
        record.viewers[i].placeInRoom_m = {0.1, static_cast<double>(i), -0.3};
        record.viewers[i].lapse = 0.5 + 0.1 * static_cast<double>(i);
        record.viewers[i].notice = Notice("seen by " + facts.viewers[i]);
      }
      journal.add(frame, std::vector<HeadEstimate>(3), {});
    }
  }
  SessionFile session(file);
  FrameState state;
  for (const FrameState& expected : written) {
    ASSERT_TRUE(session.next(state));
    ASSERT_TRUE(sameBits(state, expected)) << "frame " << expected.record.number;
    ASSERT_EQ(state.record.viewers[0].placeInRoom_m, expected.record.viewers[0].placeInRoom_m);
    ASSERT_EQ(state.record.viewers[0].lapse, expected.record.viewers[0].lapse);
    ASSERT_EQ(state.record.room_s, expected.record.room_s);
  }
  SQLite::Database database(file.string());
  EXPECT_EQ(database.execAndGet("SELECT lapse FROM viewer WHERE frame = 7 AND name = 'cleo'").getDouble(),
            0.7);
  EXPECT_EQ(database.execAndGet("SELECT room_s FROM platform WHERE frame = 7").getDouble(), 0.3 * 7.0);
}

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

TEST(Journal, StrokesAreReadWithTheSameBitsInTheOrderOfTheFrames) {
  const test::NothingIsLogged silence;
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  SessionFacts facts = kFacts;
  facts.pucks = {"white", "red"};
  const std::vector<Puck> pucks{{"white", 0.03, 0.02, 0.2}, {"red", 0.03, 0.02, 0.2}};
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::vector<Stroke> written;
  {
    Journal journal(file, facts, false);
    for (std::uint64_t number = 0; number < 60; ++number) {
      if (number % 7 != 3) {
        journal.add(frameOf(number), head(), {});
        continue;
      }
      written.push_back({number % 2,
                         std::abs(any(random)),
                         Vec3(any(random), any(random), 1e-300),
                         {0.5 * any(random), 0.6}});
      journal.add(frameOf(number), head(), {}, std::vector<HandStroke>{{written.back()}});
    }
  }
  const SessionFile session(file);
  const std::vector<Stroke> read = session.strokes(pucks);
  ASSERT_EQ(read.size(), 9u);
  ASSERT_EQ(written.size(), read.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].puck, written[i].puck);
    EXPECT_EQ(read[i].at_s, written[i].at_s);
    EXPECT_EQ(read[i].from_m, written[i].from_m);
    EXPECT_EQ(read[i].momentum_kg_m_s, written[i].momentum_kg_m_s);
  }
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
  EXPECT_EQ(column(database, "SELECT puck FROM stroke WHERE frame IN (3, 10)"), (Strings{"red", "white"}));
  const auto refusal = [&](const std::string& sql) {
    database.exec(sql);
    try {
      (void)session.strokes(pucks);
      return std::string("accepted");
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
  };
  EXPECT_NE(refusal("UPDATE stroke SET puck = 'blue' WHERE frame = 10").find("frame 10: a stroke on 'blue'"),
            std::string::npos);
  for (const char* value : {"NULL", "1e999", "'far'", "x'00'"}) {
    EXPECT_NE(
        refusal(std::string("UPDATE stroke SET puck = 'red', p_x_kg_m_s = ") + value + " WHERE frame = 10")
            .find("frame 10: a stroke on 'red' that is none"),
        std::string::npos)
        << value;
  }
  EXPECT_NE(refusal("UPDATE stroke SET p_x_kg_m_s = 1e100 WHERE frame = 10")
                .find("frame 10: a stroke of 1e+100 kg m/s on 'red', expected"),
            std::string::npos);
}

}  // namespace
}  // namespace carom
