// Journals and session files: what was written is read with the same bits.
#include "app/journal/journal.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

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
