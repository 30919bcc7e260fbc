#include "app/journal/journal.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstring>
#include <fstream>
#include <limits>
#include <random>
#include <thread>

#include "app/journal/session_file.h"
#include "app/journal/version_3.h"
#include "cave/frame/frame_digest.h"
#include "cave/frame/record_rules.h"
#include "log_lines.h"
#include "sanitized.h"
#include "temporary_folder.h"

namespace carom {
namespace {

using namespace std::chrono_literals;
using test::TemporaryFolder;

const SessionFacts kFacts{"carom 0",        "rigs/desk.toml",  "scenarios/three-pucks.toml",
                          "unit = \"m\"\n", "title = \"é\"\n", 1.42};

GameEvent eventOf(std::uint64_t number, double x) {
  GameEvent event;
  event.number = number;
  event.kind = number % 2 == 0 ? EventKind::puckCushion : EventKind::puckPuck;
  if (number % 2 == 0) event.cushion = Cushion::minusY;
  event.at = {x, {0.1, -x, 0.01}};
  event.withoutDelay = number % 3 == 0;
  event.heat_j = 1e-3 * x;
  for (std::size_t puck = 0; puck < 1 + number % 2; ++puck)
    event.turns.push_back({puck, {x, {x, 0.2, 0.01}}, {0.1, x}, {-0.1, x}, x / 3.0});
  return event;
}

/// A frame whose every number depends on its own; each third brings knots, each fourth an event.
FrameState frameOf(std::uint64_t number) {
  FrameState state;
  const double x = 0.1 * static_cast<double>(number);
  state.record.number = number;
  state.record.display_s = x / 6.0;
  state.record.lightSpeed_m_s = kFacts.lightSpeed_m_s;
  state.record.observer.headFromBoard = Lorentz::boost({x, -x, 0.3}, 1.42);
  state.record.boardFromRoom = Lorentz::boost({-x, 0.2, 0.0}, 1.42);
  state.record.observer.properTime_s = x / 7.0;
  ObserverView& observer = state.record.observer;
  observer.left = observer.right = observer.middle = {{x, {x / 3.0, -0.0, 1.7}}, {0.032, 1.7, x}};
  state.record.switches.colour = number % 2;
  state.record.pucks = 2;
  state.record.eventsKept = (number + 3) / 4;
  if (number % 4 == 0) state.events.push_back(eventOf(number / 4, x));
  if (number % 3 == 0) {
    state.knots.push_back({1, {{x, {x, 0.0, 0.01}}, {-0.0, 0.3, 0.0}, x, {x, {x, 0.0, 0.01}}, 0.0}});
    state.knots.push_back({2, {{x, {0.0, x, 0.01}}, {0.3, 0.0, 0.0}, x, {}, 0.1}});
  }
  return state;
}

bool sameBits(const GameEvent& a, const GameEvent& b) {
  return a.withoutDelay == b.withoutDelay &&
         digestOf(FrameState{{}, {}, {a}}, World{}) == digestOf(FrameState{{}, {}, {b}}, World{});
}

/// Of all fields; what lies between them is nothing.
bool sameBits(const FrameRecord& a, const FrameRecord& b) {
  return digestOf(FrameState{a, {}, {}}, World{}) == digestOf(FrameState{b, {}, {}}, World{});
}

bool sameBits(const FrameState& a, const FrameState& b) {
  return std::equal(a.events.begin(), a.events.end(), b.events.begin(), b.events.end(),
                    [](const GameEvent& x, const GameEvent& y) { return sameBits(x, y); }) &&
         sameBits(a.record, b.record) && a.knots.size() == b.knots.size() &&
         (a.knots.empty() ||
          std::memcmp(a.knots.data(), b.knots.data(), a.knots.size() * sizeof(BodyKnot)) == 0);
}

HeadEstimate head() {
  HeadEstimate estimate;
  estimate.known = Known::predicted;
  estimate.celerity_m_s = {0.1, 0.2, 0.3};
  return estimate;
}

std::string refusalOf(const std::filesystem::path& file) {
  try {
    SessionFile session(file);
    return "accepted";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

/// Returns how many frames a file holds, 0 if it cannot be read.
std::uint64_t framesOf(const std::filesystem::path& file) {
  try {
    const auto frames = SessionFile(file).frames();
    return frames ? frames->second + 1 : 0;
  } catch (const std::runtime_error&) {
    return 0;
  }
}

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
      journal.add(written.back(), head(), samples);
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

TEST(Journal, PlainSqlTellsWhatHappened) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  { Journal(file, kFacts, false).add(frameOf(3), head(), std::vector<TrackerSample>(2)); }
  SQLite::Database database(file.string());
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM sample").getInt(), 2);
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

std::vector<std::string> column(SQLite::Database& database, const std::string& sql) {
  std::vector<std::string> values;
  for (SQLite::Statement row(database, sql); row.executeStep();)
    values.push_back(row.getColumn(0).getString());
  return values;
}

using Strings = std::vector<std::string>;

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

// A session of twenty frames, two knots and three events, and its digests, by the program that wrote version
// 3 last. Earlier files of that version lack the column of delays.
TEST(Journal, AFileOfVersion3IsReadAndGoneOnWithAndHasTheSameDigests) {
  constexpr int kFrames = 20;
  constexpr std::array<std::uint64_t, FrameDigest::kFields.size()> kDigests{
      0x7bc6398e0441ce66, 0xd755289c3fb679ab, 0x8bfe3daf19946736, 0xc6e5478020b927f0, 0x943b3fbae892afe2,
      0x1b1862d38202954f, 0x905fd5898a5e2f90, 0x0000000000000000, 0x04e451a8e04c9c68};
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
                                     " is of version 3 and becomes one of version 5."}));
    EXPECT_EQ(digestsOf(file, kFrames), kDigests);
    SQLite::Database database(file.string());
    EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), 5);
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
TEST(Journal, ADamagedFileOfVersion3IsNotConverted) {
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

// At the end the tables tell the game as it was in the end; the frames keep what was known when they were
// shown.
TEST(Journal, EventsThatAStrokeTookBackAreGoneFromTheTableButNotFromTheFrames) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  const auto frame = [](std::uint64_t number, std::uint64_t kept, std::vector<GameEvent> events) {
    FrameState state;
    state.record.number = number;
    state.record.lightSpeed_m_s = kFacts.lightSpeed_m_s;
    state.record.observer.headFromBoard = state.record.boardFromRoom = Lorentz(kFacts.lightSpeed_m_s);
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
      journal.add(frameOf(number), head(), {}, std::span(&written.back(), 1));
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

// A frame is handed over only once the file lacks no more than the frame before it: a journal that waited for
// more frames before it wrote any would come to a halt here. How long each writing takes does not matter.
TEST(Journal, AKilledProgramLacksTwoFramesAtMost) {
  TemporaryFolder folder;
  auto* handedOver = static_cast<std::atomic<std::uint64_t>*>(
      mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  ASSERT_NE(handedOver, MAP_FAILED);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> frames(1, 20), moment_us(0, 5000);
  for (int run = 0; run < test::casesOf(100); ++run) {
    const auto file = folder / (std::to_string(run) + ".db");
    handedOver->store(0);
    const pid_t child = fork();
    if (child == 0) {
      Journal journal(file, kFacts, false);
      SQLite::Database reader(file.string(), SQLite::OPEN_READONLY, 10000);
      SQLite::Statement count(reader, "SELECT count(*) FROM frame");
      const auto inFile = [&] {
        count.reset();
        count.executeStep();
        return static_cast<std::uint64_t>(count.getColumn(0).getInt64());
      };
      for (std::uint64_t number = 0;; ++number) {
        while (inFile() + 1 < number) std::this_thread::sleep_for(100us);
        journal.add(frameOf(number), head(), {});
        handedOver->store(number + 1);
      }
    }
    const int after = frames(random), after_us = moment_us(random);
    while (handedOver->load() < static_cast<std::uint64_t>(after)) std::this_thread::sleep_for(100us);
    std::this_thread::sleep_for(after_us * 1us);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    SCOPED_TRACE(testing::Message() << "seed 5, run " << run << ", killed " << after_us << " us after frame "
                                    << after);
    std::uint64_t found = 0;
    {
      SessionFile session(file);
      for (FrameState state; session.next(state); ++found) ASSERT_TRUE(sameBits(state, frameOf(found)));
    }
    EXPECT_GE(found + 2, handedOver->load());
    EXPECT_EQ(SQLite::Database(file.string()).execAndGet("PRAGMA integrity_check").getString(), "ok");
    { Journal(file, kFacts, true).add(frameOf(found), head(), {}); }
    EXPECT_EQ(SessionFile(file).frames(), (std::pair<std::uint64_t, std::uint64_t>(0, found)));
    std::filesystem::remove(file);
  }
  munmap(handedOver, 4096);
}

// What operators do after a crash: they copy FILE, and forget FILE-wal.
TEST(Journal, TheFileOfAKilledProgramAloneLacksNoMoreThanItsLastMinute) {
  TemporaryFolder folder;
  for (const auto& [every, whole] : {std::pair(50ms, true), std::pair(3600000ms, false)}) {
    SCOPED_TRACE(every.count());
    const auto file = folder / (whole ? "whole.db" : "early.db"),
               copy = folder / ("copy of " + file.filename().string()),
               begun = folder / ("begun " + file.filename().string());
    const pid_t child = fork();
    if (child == 0) {
      Journal journal(file, kFacts, false, every);
      std::ofstream(begun) << "its tables are in the file\n";
      for (std::uint64_t number = 0; number < 200; ++number) journal.add(frameOf(number), head(), {});
      for (;;) pause();
    }
    const auto written = [&](const std::filesystem::path& of) -> std::uint64_t {
      const test::LogLines lines;
      SessionFile session(of);
      EXPECT_EQ(lines.said().size(), of == copy ? 1u : 0u);
      for (const std::string& line : lines.said())
        EXPECT_NE(line.find(of.filename().string() + "-wal, which belongs beside it"), std::string::npos)
            << line;
      const auto frames = session.frames();
      return frames ? frames->second + 1 : 0;
    };
    // Nobody reads while it is begun: its tables would then go into the file only with the first update.
    while (!std::filesystem::exists(begun)) std::this_thread::sleep_for(1ms);
    // Until all is written, and where it goes into the file at once, also until all has gone there: while the
    // file is being brought up to date, a copy of it alone is not whole.
    const auto gone = [&] {
      std::filesystem::copy_file(file, copy, std::filesystem::copy_options::overwrite_existing);
      return framesOf(copy) == 200;
    };
    while (framesOf(file) < 200 || (whole && !gone())) std::this_thread::sleep_for(1ms);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    std::filesystem::copy_file(file, copy, std::filesystem::copy_options::overwrite_existing);
    EXPECT_EQ(written(copy), whole ? 200u : 0u);
    EXPECT_EQ(written(file), 200u) << "with the file beside it";
  }
}

TEST(Journal, AFullDiskDoesNotEndTheSessionAndLosesNothingOnceThereIsRoom) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const test::LogLines lines;
  {
    Journal journal(file, kFacts, false);
    rlimit small = before;
    small.rlim_cur = 200000;  // bytes: some hundred frames
    setrlimit(RLIMIT_FSIZE, &small);
    for (std::uint64_t number = 0; number < 1500; ++number) {
      journal.add(frameOf(number), head(), {});
      if (number % 100 == 0) std::this_thread::sleep_for(2ms);
    }
    lines.waitFor(1);  // it is said once
    EXPECT_NE(lines.said()[0].find("game.db"), std::string::npos) << lines.said()[0];
    EXPECT_NE(lines.said()[0].find("session goes on"), std::string::npos) << lines.said()[0];
    setrlimit(RLIMIT_FSIZE, &before);
    lines.waitFor(2);  // and that it works again
  }
  EXPECT_EQ(SessionFile(file).frames()->second, 1499U);
  SessionFile session(file);
  std::uint64_t found = 0;
  for (FrameState state; session.next(state); ++found) ASSERT_TRUE(sameBits(state, frameOf(found)));
  EXPECT_EQ(found, 1500U);
}

/// From now on the file refuses rows of frames.
void refuseFrames(const std::filesystem::path& file) {
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE, 2000);
  database.exec("CREATE TRIGGER full BEFORE INSERT ON frame BEGIN SELECT RAISE(ABORT, 'full'); END");
}
void takeFrames(const std::filesystem::path& file) {
  SQLite::Database(file.string(), SQLite::OPEN_READWRITE, 2000).exec("DROP TRIGGER full");
}

TEST(Journal, WhatAStrokeTookBackIsGoneAlsoIfTheFileCouldNotBeWrittenThen) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  FrameState first = frameOf(0), stroke = frameOf(1);
  first.record.eventsKept = 0;
  first.events = {eventOf(0, 1.0), eventOf(1, 2.0), eventOf(2, 3.0)};
  stroke.record.eventsKept = 1;
  { Journal(file, kFacts, false).add(first, head(), {}); }
  refuseFrames(file);
  const test::LogLines lines;
  {
    Journal journal(file, kFacts, true);
    journal.add(stroke, head(), {});
    lines.waitFor(1);
    takeFrames(file);
    lines.waitFor(2);
  }
  SQLite::Database database(file.string());
  EXPECT_EQ(column(database, "SELECT t_s FROM event ORDER BY number"), (Strings{"1.0"}));
  EXPECT_EQ(column(database, "SELECT t_s FROM turn ORDER BY event"), (Strings{"1.0"}));
}

// What comes after a lost frame would build on its knots and events: the file ends before it, and is whole.
TEST(Journal, AfterALostFrameTheFileEndsWhole) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  const test::LogLines lines;
  constexpr std::uint64_t kMoreThanWait = 36010;
  {
    Journal journal(file, kFacts, false);
    refuseFrames(file);
    journal.add(frameOf(0), head(), {});
    lines.waitFor(1);
    for (std::uint64_t number = 1; number < kMoreThanWait; ++number) journal.add(frameOf(number), head(), {});
    lines.waitFor(2);  // once, of all that are lost
    takeFrames(file);
    lines.waitFor(3);
    for (std::uint64_t number = kMoreThanWait; number < kMoreThanWait + 10; ++number)
      journal.add(frameOf(number), head(), {});
  }
  ASSERT_EQ(lines.said().size(), 3U);
  SessionFile session(file);
  std::uint64_t found = 0;
  for (FrameState state; session.next(state); ++found)
    ASSERT_TRUE(sameBits(state, frameOf(found))) << "frame " << found;
  EXPECT_EQ(found, 36001U) << "ten minutes, and the one that was being written";
  EXPECT_NE(lines.said()[1].find("from 36001 on"), std::string::npos) << lines.said()[1];
  SQLite::Database database(file.string());
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM knot WHERE frame > 36000").getInt(), 0);
}

TEST(Journal, AFileThatIsThereIsNotWrittenOver) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  { Journal(file, kFacts, false).add(frameOf(0), head(), {}); }
  EXPECT_THROW(Journal(file, kFacts, false), std::runtime_error);
  EXPECT_EQ(SessionFile(file).frames()->second, 0U);
  EXPECT_THROW(Journal(folder / "none/game.db", kFacts, false), std::runtime_error);
}

TEST(Journal, OneSessionAtATimeWritesAndALaterOneMayGoOn) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  {
    Journal journal(file, kFacts, false);
    journal.add(frameOf(0), head(), {});
    EXPECT_THROW(Journal(file, kFacts, true), std::runtime_error);
  }
  { Journal(file, kFacts, true).add(frameOf(1), head(), {}); }
  EXPECT_EQ(SessionFile(file).frames(), (std::pair<std::uint64_t, std::uint64_t>(0, 1)));
  EXPECT_THROW(Journal(folder / "none.db", kFacts, true), std::runtime_error);
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
      {"controls.shown is 9", [](FrameState& s) { s.record.controls.shown = static_cast<Shown>(9); }},
      {"controls.blank is 2", [](FrameState& s) { s.record.controls.blank = 2; }},
      {"tracked.handKnown is 2", [](FrameState& s) { s.record.tracked.handKnown = 2; }},
      {"last is 7", [](FrameState& s) { s.record.last = 7; }},
      {"display_s is nan", [](FrameState& s) { s.record.display_s = kNan; }},
      {"lightSpeed_m_s is nan", [](FrameState& s) { s.record.lightSpeed_m_s = kNan; }},
      {"lightSpeed_m_s is 0", [](FrameState& s) { s.record.lightSpeed_m_s = 0.0; }},
      {"lightSpeed_m_s is 1e+300", [](FrameState& s) { s.record.lightSpeed_m_s = 1e300; }},
      {"truncateFrom_s", [](FrameState& s) { s.record.truncateFrom_s = kNan; }},
      {"the head's frame is",
       [](FrameState& s) {
         s.record.observer.headFromBoard = Lorentz::boost({kNan, 0.0, 0.0}, 1.42);
       }},
      {"an eye's event", [](FrameState& s) { s.record.observer.right.observation.r_m.z = kNan; }},
      {"an eye's place", [](FrameState& s) { s.record.observer.middle.positionInRoom_m.x = kNan; }},
      {"that an eye sees from", [](FrameState& s) { s.record.observer.left.seenFromInRoom_m.y = kNan; }},
      {"proper time", [](FrameState& s) { s.record.observer.properTime_s = kNan; }},
      {"the room's frame is none",
       [](FrameState& s) {
         s.record.boardFromRoom = Lorentz::rotation({1.0, 1.0, 0.0, 0.0}, 1.42);
       }},
      {"hand.pulling is 2", [](FrameState& s) { s.record.hand.pulling = 2; }},
      {"the hand is", [](FrameState& s) { s.record.hand.to_m.y = kNan; }},
      {"the stroke is", [](FrameState& s) { s.record.hand.u = kNan; }},
      {"drive.mode", [](FrameState& s) { s.record.drive.mode = static_cast<DriveMode>(4); }},
      {"lesson is", [](FrameState& s) { s.record.lesson.phase = static_cast<LessonPhase>(4); }},
      {"lesson is", [](FrameState& s) { s.record.lesson.answer = 5; }},
      {"head sensor", [](FrameState& s) { s.record.tracked.roomFromHeadSensor.orientation.w = kNan; }},
      {"the hand's", [](FrameState& s) { s.record.tracked.roomFromHand.position_m.y = kNan; }},
      {"a knot's turn", [](FrameState& s) { s.knots[0].knot.turn.t_s = kNan; }},
      {"a knot's u", [](FrameState& s) { s.knots[1].knot.u.y = kNan; }},
      {"a knot's proper time", [](FrameState& s) { s.knots[1].knot.properTime_s = kNan; }},
      {"a knot's signal", [](FrameState& s) { s.knots[1].knot.signal.r_m.x = kNan; }},
      {"a knot's deceleration", [](FrameState& s) { s.knots[1].knot.deceleration_m_s2 = kNan; }}};
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
  const std::vector<std::pair<const char*, const char*>> damages{
      {"switches is 64, expected 0 to 31", "frame SET switches = 64"},
      {"views is 512, expected 0 to 511", "frame SET views = 512"},
      {"beside is 32, expected 0 to 31", "frame SET beside = 32"},
      {"blank is 300, expected a whole number up to 255", "frame SET blank = 300"},
      {"shown is -1, expected", "frame SET shown = -1"},
      {"lesson_phase is two, expected", "frame SET lesson_phase = 'two'"},
      {"pucks is , expected", "frame SET pucks = NULL"},
      {"notice is of 130 bytes, expected at most 119", "frame SET notice = printf('%130s', 'late')"},
      {"display_s is nan", "frame SET display_s = 'soon'"},
      {"display_s is inf", "frame SET display_s = 1e999"},
      {"the head's frame is none", "frame SET head_from_board_xt = NULL"},
      {"the room's frame is none", "frame SET board_from_room_yz = 1e300"},
      {"a knot's signal is nan", "knot SET signal_x_m = x'00'"},
      {"body is 1.5, expected a whole number", "knot SET body = 1.5"},
      {"an event of a kind that there is not", "frame_event SET kind = 5"},
      {"an event at a cushion that there is not", "frame_event SET cushion = 5"},
      {"an event's heat is nan", "frame_event SET heat_j = NULL"},
      {"no such event can be", "frame_event SET turns = 3"},
      {"no such event can be", "frame_event SET without_delay = 2"},
      {"an event turns puck 2, expected one of 2", "frame_event SET first_puck = 2"},
      {"a turn's velocities is nan", "frame_event SET first_beta_after_y = NULL"}};
  TemporaryFolder folder;
  const auto whole = folder / "whole.db", file = folder / "game.db";
  { Journal(whole, kFacts, false).add(frameOf(12), head(), {}); }
  EXPECT_EQ(refusalOfFirst(whole), "accepted");
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
