#include "cave/display/parallel_calls.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <system_error>

namespace carom {
namespace {

// Calls that wait for each other return only if all of them run at once.
TEST(ParallelCalls, AllRunAtOnce) {
  constexpr int kCalls = 4, kRuns = 1000;
  std::barrier all(kCalls);
  std::array<int, kCalls> made{};
  std::vector<std::function<void()>> calls;
  for (int& count : made) {
    calls.emplace_back([&all, &count] {
      all.arrive_and_wait();
      ++count;
    });
  }
  ParallelCalls parallel(std::move(calls));
  for (int run = 1; run <= kRuns; ++run) {
    parallel.run();
    for (const int count : made) ASSERT_EQ(count, run) << "run returned before every call had";
  }
}

TEST(ParallelCalls, EndWithoutARun) {
  std::atomic<int> made = 0;
  {
    const ParallelCalls parallel({[&] { ++made; }, [&] { ++made; }});
  }
  EXPECT_EQ(made, 0);
}

/// Ends with status 0 if ParallelCalls throws where memory for the stacks of a few threads is left, not of
/// all.
[[noreturn]] void makeTooMany() {
  std::ifstream sizes("/proc/self/statm");
  rlim_t pages = 0;
  sizes >> pages;
  const rlim_t most = pages * 4096 + (64U << 20U);
  const rlimit limit{most, most};
  setrlimit(RLIMIT_AS, &limit);
  try {
    const ParallelCalls parallel(std::vector<std::function<void()>>(200, [] {}));
  } catch (const std::system_error&) {
    std::_Exit(0);
  }
  std::_Exit(1);
}

TEST(ParallelCalls, ThrowWhereThereAreNoMoreThreads) {
  EXPECT_EXIT(makeTooMany(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace carom
