#include "devices/wire/frame_gaps.h"

#include <gtest/gtest.h>

#include "engine/random_world.h"

namespace carom {
namespace {

TEST(FrameGaps, CountsExactlyThoseThatNeverCame) {
  test::Random random(75);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    FrameGaps gaps;
    std::uint32_t number = 0xffffff00u;  // about to wrap
    EXPECT_EQ(gaps.follow(number), 0u);
    std::uint64_t lost = 0, counted = 0;
    for (int frame = 0; frame < 1000; ++frame) {
      const auto left = static_cast<std::uint32_t>(random.in(0.0, 1.0) < 0.1 ? random.in(1.0, 900.0) : 0.0);
      number += left + 1;
      lost += left;
      counted += gaps.follow(number);
    }
    EXPECT_EQ(counted, lost);
  }
}

TEST(FrameGaps, LateFramesRepeatsAndANewStartCountNothing) {
  FrameGaps gaps;
  EXPECT_EQ(gaps.follow(5000), 0u);
  EXPECT_EQ(gaps.follow(5000), 0u) << "again";
  EXPECT_EQ(gaps.follow(4998), 0u) << "late";
  EXPECT_EQ(gaps.follow(5003), 2u) << "counted from the newest";
  EXPECT_EQ(gaps.follow(1), 0u) << "started anew";
  EXPECT_EQ(gaps.follow(3), 1u);
  EXPECT_EQ(gaps.follow(900000), 0u) << "much later";
  EXPECT_EQ(gaps.follow(900002), 1u);
}

}  // namespace
}  // namespace carom
