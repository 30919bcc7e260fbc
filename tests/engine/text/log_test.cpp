#include "engine/text/log.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <vector>

#include "log_lines.h"

namespace carom {
namespace {

using Strings = std::vector<std::string>;

TEST(Log, LinesOfEachLevelReachTheSinkInTheirOrder) {
  const test::LogLines lines;
  log::note("The session is in a.db.");
  log::warn("node 1 has no wall to draw.");
  log::error("b.toml:1:2: 'x' is wrong");
  EXPECT_EQ(lines.said(), (Strings{"The session is in a.db.", "warning: node 1 has no wall to draw.",
                                   "error: b.toml:1:2: 'x' is wrong"}));
}

TEST(Log, ASinkThatIsReplacedComesBack) {
  const test::LogLines outer;
  {
    const test::LogLines inner;
    log::note("within");
    EXPECT_EQ(inner.said(), Strings{"within"});
  }
  log::note("without");
  EXPECT_EQ(outer.said(), Strings{"without"});
}

TEST(Log, WithoutASinkOfItsOwnItWritesWholeLinesToStandardError) {
  testing::internal::CaptureStderr();
  log::note("a note");
  log::warn("a warning");
  log::error("an error");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "a note\nwarning: a warning\nerror: an error\n");
}

TEST(Log, ManyThreadsLoseNoLine) {
  constexpr int kThreads = 8, kLines = 500;
  const test::LogLines lines;
  {
    std::vector<std::jthread> threads;
    for (int thread = 0; thread < kThreads; ++thread) {
      threads.emplace_back([thread] {
        for (int line = 0; line < kLines; ++line)
          log::note(std::to_string(thread) + " " + std::to_string(line));
      });
    }
  }
  const Strings said = lines.said();
  ASSERT_EQ(said.size(), std::size_t{kThreads * kLines});
  for (int thread = 0; thread < kThreads; ++thread) {
    const std::string prefix = std::to_string(thread) + " ";
    int next = 0;
    for (const std::string& line : said) {
      if (line.starts_with(prefix)) {
        EXPECT_EQ(line, prefix + std::to_string(next++));
      }
    }
    EXPECT_EQ(next, kLines);
  }
}

}  // namespace
}  // namespace carom
