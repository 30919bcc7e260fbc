#include "cave/capture/work_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>

namespace carom {
namespace {

TEST(WorkQueue, EveryJobIsDoneAndWithOneThreadInOrder) {
  std::vector<int> done;
  {
    WorkQueue<int> queue(3, 1, [&](int& job) { done.push_back(job); });
    for (int job = 0; job < 100; ++job) queue.add(job);
  }
  ASSERT_EQ(done.size(), 100U);
  for (int job = 0; job < 100; ++job) EXPECT_EQ(done[static_cast<std::size_t>(job)], job);

  std::atomic<int> sum = 0;
  WorkQueue<int> queue(4, 3, [&](int& job) { sum += job; });
  for (int job = 0; job < 100; ++job) queue.add(job);
  queue.finish();
  EXPECT_EQ(sum, 4950);
}

TEST(WorkQueue, NoMoreThanItsCapacityWait) {
  std::atomic<bool> goOn = false;
  WorkQueue<int> queue(3, 1, [&](int&) {
    while (!goOn) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  EXPECT_EQ(queue.room(), 3U);
  for (int job = 0; job < 3; ++job) queue.add(job);
  EXPECT_EQ(queue.room(), 0U);
  std::atomic<bool> added = false;
  std::jthread adding([&] {
    queue.add(3);
    added = true;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_FALSE(added) << "it was added to a full queue";
  goOn = true;
  adding.join();
  queue.finish();
  EXPECT_EQ(queue.room(), 3U);
}

TEST(WorkQueue, AFailureIsToldToWhoeverAddsOrFinishes) {
  std::atomic<int> done = 0;
  WorkQueue<int> queue(2, 1, [&](int& job) {
    if (job == 1) throw std::runtime_error("job one");
    ++done;
  });
  const auto addAll = [&] {
    for (int job = 0; job < 100; ++job) queue.add(job);
  };
  EXPECT_THROW(addAll(), std::runtime_error);
  EXPECT_THROW(queue.finish(), std::runtime_error);
  EXPECT_LE(done, 2) << "jobs after it were done";
}

TEST(WorkQueue, MemoryIsUsedAgain) {
  WorkQueue<std::vector<int>> queue(2, 1, [](std::vector<int>&) {});
  EXPECT_EQ(queue.spare().capacity(), 0U);
  queue.add(std::vector<int>(1000));
  queue.finish();
  EXPECT_GE(queue.spare().capacity(), 1000U);
}

}  // namespace
}  // namespace carom
