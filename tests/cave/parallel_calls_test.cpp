#include "cave/display/parallel_calls.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>

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

}  // namespace
}  // namespace carom
