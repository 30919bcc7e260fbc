#include "devices/wire/unwrapped_counter.h"

#include <gtest/gtest.h>

#include "engine/random_world.h"

namespace carom {
namespace {

// The counter of a device that counts without end, of which it sends the last bits.
TEST(UnwrappedCounter, FollowsACounterThatWraps) {
  test::Random random(74);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    UnwrappedCounter<std::uint8_t> small;
    UnwrappedCounter<std::uint32_t> large;
    std::int64_t ofSmall = static_cast<std::int64_t>(random.in(0.0, 256.0));
    std::int64_t ofLarge = static_cast<std::int64_t>(random.in(4e9, 4.29e9));
    EXPECT_EQ(small.follow(static_cast<std::uint8_t>(ofSmall)), ofSmall);
    EXPECT_EQ(large.follow(static_cast<std::uint32_t>(ofLarge)), ofLarge);
    for (int step = 0; step < 200; ++step) {
      ofSmall += static_cast<std::int64_t>(random.in(-100.0, 127.0));
      ofLarge += static_cast<std::int64_t>(random.in(-1e9, 2e9));
      EXPECT_EQ(small.follow(static_cast<std::uint8_t>(ofSmall)), ofSmall);
      EXPECT_EQ(large.follow(static_cast<std::uint32_t>(ofLarge)), ofLarge);
    }
  }
}

}  // namespace
}  // namespace carom
