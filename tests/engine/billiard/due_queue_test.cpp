#include "engine/billiard/due_queue.h"

#include <cmath>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "engine/base/never.h"
#include "engine/random_world.h"

namespace carom {
namespace {

// Beside a sorted set of (time, number), which is what the queue stands for. Times are coarse, so that many
// are equal, and move on as a game's do; the larger number is beyond the heap.
class DueQueueOf : public testing::TestWithParam<int> {};

TEST_P(DueQueueOf, ComesOutAsASortedSetDoes) {
  const int items = GetParam();
  test::Random random(static_cast<std::uint64_t>(items));
  DueQueue queue(items);
  EXPECT_EQ(queue.firstDue(), kNever);
  std::set<std::pair<double, int>> sorted;
  std::vector<double> due(static_cast<std::size_t>(items), kNever);
  std::set<int> seen;          // by the one stage that looks ahead here, and not given a new time since
  std::set<int> setWhileSoon;  // need not be seen
  const auto isSoon = [&](const std::pair<double, int>& entry) {
    int before = 0;
    for (auto one = sorted.begin(); one != sorted.end() && *one < entry && before < DueQueue::kMostSoon;
         ++one)
      ++before;
    return before < DueQueue::kMostSoon;
  };
  const auto set = [&](int item, double time) {
    seen.erase(item), setWhileSoon.erase(item);
    if (isSoon({time, item})) setWhileSoon.insert(item);
    double& before = due[static_cast<std::size_t>(item)];
    if (before != kNever) sorted.erase({before, item});
    if (time != kNever) sorted.insert({time, item});
    queue.setDue(item, before = time);
  };
  for (int item = 0; item < items; ++item) set(item, std::floor(random.in(0.0, 2.0 * items)));
  int visits = 0, again = 0;  // again: those that had to make room for sooner ones in between
  for (int step = 0; step < 20000; ++step) {
    CASE(random, step);
    if (!sorted.empty() && random.in(0.0, 1.0) < 0.5) {  // the first has its turn
      const double now = sorted.begin()->first;
      set(sorted.begin()->second,
          random.in(0.0, 1.0) < 0.1 ? kNever : now + std::floor(random.in(0.0, 50.0)));
    } else {
      const double time = random.in(0.0, 1.0) < 0.2 ? kNever : std::floor(random.in(0.0, 3.0 * items));
      set(static_cast<int>(random.in(0.0, items)), time);
    }
    ASSERT_EQ(queue.firstDue(), sorted.empty() ? kNever : sorted.begin()->first) << "step " << step;
    if (sorted.empty()) continue;
    ASSERT_EQ(queue.first(), sorted.begin()->second) << "step " << step;
    ASSERT_EQ(queue.due(queue.first()), sorted.begin()->first);
    queue.lookAhead(1, DueQueue::kSoon, [&](int item) {
      ++visits;
      again += seen.insert(item).second ? 0 : 1;
      EXPECT_TRUE(isSoon({due[static_cast<std::size_t>(item)], item})) << "step " << step << ": " << item;
    });
    ASSERT_TRUE(seen.contains(queue.first()) || setWhileSoon.contains(queue.first())) << "step " << step;
  }
  EXPECT_LE(20 * again, visits);
  while (!sorted.empty()) {
    ASSERT_EQ(queue.firstDue(), sorted.begin()->first);
    ASSERT_EQ(queue.first(), sorted.begin()->second);
    set(sorted.begin()->second, kNever);
  }
  EXPECT_EQ(queue.firstDue(), kNever);
}

INSTANTIATE_TEST_SUITE_P(Sizes, DueQueueOf, testing::Values(1, 5, 300, 9000, 20000));

// Each item in its turn gets a later time, of which some lie beyond the calendar, until several calendars are
// over and nothing is due any more.
TEST(DueQueue, GoesOnForManyCalendars) {
  constexpr int kItems = 1000, kTurns = 60000;
  test::Random random(7);
  DueQueue queue(kItems);
  std::set<std::pair<double, int>> sorted;
  const auto set = [&](int item, double time) {
    if (time != kNever) sorted.insert({time, item});
    queue.setDue(item, time);
  };
  for (int item = 0; item < kItems; ++item) set(item, random.in(0.0, 1.0));
  for (int turn = 0; !sorted.empty(); ++turn) {
    CASE(random, turn);
    const auto [now, item] = *sorted.begin();
    ASSERT_EQ(queue.firstDue(), now);
    ASSERT_EQ(queue.first(), item);
    sorted.erase(sorted.begin());
    const double after = item % 10 < 3 ? 40.0 : 1.0;
    set(item, turn < kTurns ? now + random.in(0.0, after) : kNever);
  }
  EXPECT_EQ(queue.firstDue(), kNever);
  set(3, 1.0);
  EXPECT_EQ(queue.first(), 3) << "which is sooner than all that were";
}

}  // namespace
}  // namespace carom
