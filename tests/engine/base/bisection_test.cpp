#include "engine/base/bisection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/random_world.h"

namespace carom {
namespace {

TEST(Bisection, NarrowsToThePlaceWhereTheConditionEnds) {
  test::Random random(53);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const double low = random.in(-10.0, 0.0), high = random.in(0.1, 10.0), place = random.in(low, high);
    int calls = 0;
    const Bracket found = bisect({low, high}, 200, [&](double x) { return ++calls, x < place; });
    EXPECT_LT(found.low, place);
    EXPECT_GE(found.high, place);
    EXPECT_EQ(std::nextafter(found.low, high), found.high) << "no number lies between";
    EXPECT_LT(calls, 120);
    const Bracket few = bisect({low, high}, 10, [&](double x) { return x < place; });
    EXPECT_NEAR(few.high - few.low, (high - low) / 1024.0, 1e-12);
    EXPECT_TRUE(few.low < place && few.high >= place);
  }
}

TEST(Bisection, AnEmptyIntervalStays) {
  const Bracket found = bisect({2.0, 2.0}, 100, [](double) { return true; });
  EXPECT_EQ(found.low, 2.0);
  EXPECT_EQ(found.high, 2.0);
}

}  // namespace
}  // namespace carom
