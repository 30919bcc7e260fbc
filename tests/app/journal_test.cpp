#include "app/journal.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstring>
#include <fstream>
#include <mutex>
#include <random>
#include <thread>

#include "app/session_file.h"
#include "temporary_folder.h"

namespace carom {
namespace {

using namespace std::chrono_literals;
using test::TemporaryFolder;

const SessionFacts kFacts{"carom 0",        "rigs/desk.toml",  "scenarios/three-pucks.toml",
                          "unit = \"m\"\n", "title = \"é\"\n", 1.42};

/// A frame whose every number depends on its own; each third brings knots.
FrameState frameOf(std::uint64_t number) {
  FrameState state;
  const double x = 0.1 * static_cast<double>(number);
  state.record.number = number;
  state.record.display_s = x / 6.0;
  state.record.observer.headFromBoard = Lorentz::boost({x, -x, 0.3}, 1.42);
  state.record.observer.properTime_s = x / 7.0;
  for (EyeView& eye : state.record.observer.eyes) eye = {{x, {x / 3.0, -0.0, 1.7}}, {0.032, 1.7, x}};
  state.record.switches.colour = number % 2;
  if (number % 3 == 0) {
    state.knots.push_back({1, {{x, {x, 0.0, 0.01}}, {-0.0, 0.3, 0.0}, x, {x, {x, 0.0, 0.01}}, 0.0}});
    state.knots.push_back({2, {{x, {0.0, x, 0.01}}, {0.3, 0.0, 0.0}, x, {}, 0.1}});
  }
  return state;
}

bool sameBits(const FrameState& a, const FrameState& b) {
  return std::memcmp(&a.record, &b.record, sizeof a.record) == 0 && a.knots.size() == b.knots.size() &&
         (a.knots.empty() ||
          std::memcmp(a.knots.data(), b.knots.data(), a.knots.size() * sizeof(BodyKnot)) == 0);
}

HeadEstimate head() {
  HeadEstimate estimate;
  estimate.known = Known::Predicted;
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

TEST(Journal, WhatWasWrittenIsReadWithTheSameBits) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  const std::vector<TrackerSample> samples(2);
  std::vector<FrameState> written;
  {
    Journal journal(file, kFacts, false, [](const std::string& line) { ADD_FAILURE() << line; });
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
  for (int pass = 0; pass < 2; ++pass, session.rewind()) {
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
  { Journal(file, kFacts, false, {}).add(frameOf(3), head(), std::vector<TrackerSample>(2)); }
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

TEST(Journal, AKilledProgramLacksTwoFramesAtMost) {
  TemporaryFolder folder;
  auto* handedOver = static_cast<std::atomic<std::uint64_t>*>(
      mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  ASSERT_NE(handedOver, MAP_FAILED);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> moment_ms(1, 250);
  for (int run = 0; run < 12; ++run) {
    const auto file = folder / (std::to_string(run) + ".db");
    handedOver->store(0);
    const pid_t child = fork();
    if (child == 0) {
      Journal journal(file, kFacts, false, {});
      for (std::uint64_t number = 0;; ++number) {
        journal.add(frameOf(number), head(), {});
        handedOver->store(number + 1);
        std::this_thread::sleep_for(4ms);  // four times as fast as a session
      }
    }
    while (handedOver->load() == 0) std::this_thread::sleep_for(1ms);
    const int after_ms = moment_ms(random);
    std::this_thread::sleep_for(after_ms * 1ms);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    SessionFile session(file);
    std::uint64_t found = 0;
    for (FrameState state; session.next(state); ++found) ASSERT_TRUE(sameBits(state, frameOf(found)));
    EXPECT_GE(found + 2, handedOver->load()) << "killed after " << after_ms << " ms";
  }
  munmap(handedOver, 4096);
}

TEST(Journal, AFullDiskDoesNotEndTheSessionAndLosesNothingOnceThereIsRoom) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  std::mutex mutex;
  std::vector<std::string> said;
  const auto linesSaid = [&] {
    const std::scoped_lock hold(mutex);
    return said;
  };
  {
    Journal journal(file, kFacts, false, [&](const std::string& line) {
      const std::scoped_lock hold(mutex);
      said.push_back(line);
    });
    rlimit small = before;
    small.rlim_cur = 200000;  // bytes: some hundred frames
    setrlimit(RLIMIT_FSIZE, &small);
    for (std::uint64_t number = 0; number < 1500; ++number) {
      journal.add(frameOf(number), head(), {});
      if (number % 100 == 0) std::this_thread::sleep_for(2ms);
    }
    for (int wait = 0; wait < 500 && linesSaid().empty(); ++wait) std::this_thread::sleep_for(10ms);
    ASSERT_EQ(linesSaid().size(), 1U) << "it is said once";
    EXPECT_NE(linesSaid()[0].find("game.db"), std::string::npos) << linesSaid()[0];
    EXPECT_NE(linesSaid()[0].find("session goes on"), std::string::npos) << linesSaid()[0];
    setrlimit(RLIMIT_FSIZE, &before);
    for (int wait = 0; wait < 500 && linesSaid().size() < 2; ++wait) std::this_thread::sleep_for(10ms);
    EXPECT_EQ(linesSaid().size(), 2U) << "and that it works again";
  }
  EXPECT_EQ(SessionFile(file).frames()->second, 1499U);
  SessionFile session(file);
  std::uint64_t found = 0;
  for (FrameState state; session.next(state); ++found) ASSERT_TRUE(sameBits(state, frameOf(found)));
  EXPECT_EQ(found, 1500U);
}

TEST(Journal, AFileThatIsThereIsNotWrittenOver) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  { Journal(file, kFacts, false, {}).add(frameOf(0), head(), {}); }
  EXPECT_THROW(Journal(file, kFacts, false, {}), std::runtime_error);
  EXPECT_EQ(SessionFile(file).frames()->second, 0U);
  EXPECT_THROW(Journal(folder / "none/game.db", kFacts, false, {}), std::runtime_error);
}

TEST(Journal, OneSessionAtATimeWritesAndALaterOneMayGoOn) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  {
    Journal journal(file, kFacts, false, {});
    journal.add(frameOf(0), head(), {});
    EXPECT_THROW(Journal(file, kFacts, true, {}), std::runtime_error);
  }
  { Journal(file, kFacts, true, {}).add(frameOf(1), head(), {}); }
  EXPECT_EQ(SessionFile(file).frames(), (std::pair<std::uint64_t, std::uint64_t>(0, 1)));
  EXPECT_THROW(Journal(folder / "none.db", kFacts, true, {}), std::runtime_error);
}

TEST(SessionFile, SaysWhatIsWrongWithAFile) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  {
    Journal journal(file, kFacts, false, {});
    for (std::uint64_t number = 0; number < 300; ++number) journal.add(frameOf(number), head(), {});
  }
  EXPECT_NE(refusalOf(folder / "none.db").find("no such file"), std::string::npos);

  const auto text = folder / "text.db";
  std::ofstream(text) << std::string(5000, 'x');
  EXPECT_NE(refusalOf(text).find("no session file"), std::string::npos) << refusalOf(text);

  const auto foreign = folder / "foreign.db";
  SQLite::Database(foreign.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("CREATE TABLE frame(number)");
  EXPECT_NE(refusalOf(foreign).find("another program's"), std::string::npos) << refusalOf(foreign);

  const auto newer = folder / "newer.db";
  std::filesystem::copy_file(file, newer);
  SQLite::Database(newer.string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 99");
  EXPECT_NE(refusalOf(newer).find("newer carom wrote it (version 99"), std::string::npos) << refusalOf(newer);

  const auto locked = folder / "locked.db";
  std::filesystem::copy_file(file, locked);
  SQLite::Database holder(locked.string(), SQLite::OPEN_READWRITE);
  holder.exec("PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE; CREATE TABLE mine(x)");
  EXPECT_NE(refusalOf(locked).find("locked"), std::string::npos) << refusalOf(locked);
}

TEST(SessionFile, DamagedBytesAreFoundOrReadAsTheyWereNeverACrash) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  {
    Journal journal(file, kFacts, false, {});
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
