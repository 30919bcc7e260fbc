// Programs that are killed, discs that are full, files that are taken: what a journal keeps then.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <random>
#include <thread>

#include "app/journal/journal.h"
#include "app/journal/session_file.h"
#include "app/journal_frames.h"
#include "app/temporary_folder.h"
#include "log_lines.h"
#include "sanitized.h"

namespace carom {
namespace {

using namespace std::chrono_literals;
using namespace test;

/// Returns how many frames a file holds, 0 if it cannot be read.
std::uint64_t framesOf(const std::filesystem::path& file) {
  try {
    const auto frames = SessionFile(file).frames();
    return frames ? frames->second + 1 : 0;
  } catch (const std::runtime_error&) {
    return 0;
  }
}

// A frame is handed over only once the file lacks no more than the frame before it: a journal that waited for
// more frames before it wrote any would come to a halt here. How long each writing takes does not matter.
TEST(JournalFaults, AKilledProgramLacksTwoFramesAtMost) {
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
TEST(JournalFaults, TheFileOfAKilledProgramAloneLacksNoMoreThanItsLastMinute) {
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

TEST(JournalFaults, AFullDiskDoesNotEndTheSessionAndLosesNothingOnceThereIsRoom) {
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

TEST(JournalFaults, WhatAStrokeTookBackIsGoneAlsoIfTheFileCouldNotBeWrittenThen) {
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
TEST(JournalFaults, AfterALostFrameTheFileEndsWhole) {
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

TEST(JournalFaults, AFileThatIsThereIsNotWrittenOver) {
  TemporaryFolder folder;
  const auto file = folder / "game.db";
  { Journal(file, kFacts, false).add(frameOf(0), head(), {}); }
  EXPECT_THROW(Journal(file, kFacts, false), std::runtime_error);
  EXPECT_EQ(SessionFile(file).frames()->second, 0U);
  EXPECT_THROW(Journal(folder / "none/game.db", kFacts, false), std::runtime_error);
}

TEST(JournalFaults, OneSessionAtATimeWritesAndALaterOneMayGoOn) {
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

}  // namespace
}  // namespace carom
