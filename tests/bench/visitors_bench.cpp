// Thirty visitors in one or two hours of simulated time: visitors_bench [SEED [VISITORS]]. Not a test; it
// prints what each finds and fails if one finds another's state, or if memory, open files or lists grow.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "app/simulated_visitors.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

unsigned long seed = 1, visitors = 30;
constexpr double kEach_s = 900.0;  // at most; some discuss for minutes

TEST(Visitors, AnHour) {
  log::replaceSink([](log::Level, std::string_view) {});
  const test::TemporaryFolder folder;
  test::SimulatedVisitors room(seed, folder / "");
  const std::vector<test::Found> found = room.run(visitors, kEach_s * static_cast<double>(visitors));
  fmt::print("visitor     at s  allocated kB  files  knots  events\n");
  for (std::size_t i = 0; i < found.size(); ++i) {
    fmt::print("{:7} {:8.1f} {:13} {:6} {:6} {:7}\n", i + 1, found[i].at_s, found[i].bytes / 1000,
               found[i].handles, found[i].knots, found[i].events);
    SCOPED_TRACE(fmt::format("visitor {}", i + 1));
    test::expectNothingOfOthers(found[i], found.front());
  }
  fmt::print("{} games, {} strokes, {} games to attract people, {:.0f} s\n", room.games(), room.strokes(),
             room.attractions(), room.now_s());
  fmt::print("{} presses of Escape or Q, {} ends; {} discussions, {} thrown out of one; {} s counted down\n",
             room.escapes(), room.ends(), room.discussions(), room.thrownOut(), room.countdowns());
  EXPECT_EQ(room.ends(), 0U);
  EXPECT_EQ(room.thrownOut(), 0U);
  ASSERT_EQ(found.size(), visitors + 1);
  // The first few visitors fill what is kept: the parser's tables, the allocator's lists.
  const std::size_t settled = visitors / 3;
  constexpr std::size_t kRoom_bytes = 500'000;
  EXPECT_LE(found.back().bytes, found[settled].bytes + kRoom_bytes);
  EXPECT_LE(found.back().handles, found[settled].handles);
}

}  // namespace
}  // namespace carom

int main(int count, char** arguments) {
  testing::InitGoogleTest(&count, arguments);
  if (count > 1) carom::seed = std::strtoul(arguments[1], nullptr, 10);
  if (count > 2) carom::visitors = std::strtoul(arguments[2], nullptr, 10);
  return RUN_ALL_TESTS();
}
