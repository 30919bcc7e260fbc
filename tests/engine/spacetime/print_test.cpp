#include "print.h"

#include <gtest/gtest.h>

#include "engine/random_world.h"

namespace carom {
namespace {

TEST(Print, SaysEveryNumberInFull) {
  EXPECT_EQ(testing::PrintToString(Event{0.1, {1.0, -2.5, 3.0}}),
            "event at 0.10000000000000001 s, (1, -2.5, 3) m");
  EXPECT_EQ(testing::PrintToString(Displacement{2.0, {0.0, 0.0, 1.0}}), "displacement by 2 s, (0, 0, 1) m");
  EXPECT_EQ(testing::PrintToString(Pose{{1.0, 2.0, 3.0}, {1.0, 0.0, 0.0, 0.0}}),
            "pose at (1, 2, 3) m, turned by (w 1, 0, 0, 0)");
  const Knot knot{{1.0, {2.0, 3.0, 4.0}}, {0.5, 0.0, 0.0}, 6.0, {7.0, {8.0, 9.0, 10.0}}, 0.25};
  const std::string words = testing::PrintToString(knot);
  EXPECT_EQ(testing::PrintToString(WorldLine(knot, 1.5, 0.125, -1.0)),
            "world line, c = 1.5 m/s, radius 0.125 m, appears at -1 s, of 1 knots\n  " + words);
  for (const char* part :
       {"at 1 s, (2, 3, 4) m", "u (0.5, 0, 0)", "proper time 6 s", "at 7 s, (8, 9, 10) m", "0.25"}) {
    EXPECT_NE(words.find(part), std::string::npos) << part << " in " << words;
  }
  EXPECT_EQ(testing::PrintToString(Lorentz(1.5)),
            "Lorentz transform, c = 1.5 m/s, rows (ct, x, y, z):\n"
            "  1, 0, 0, 0\n  0, 1, 0, 0\n  0, 0, 1, 0\n  0, 0, 0, 1");
  EXPECT_EQ(testing::PrintToString(EyeView{{1.0, {2.0, 3.0, 4.0}}, {5.0, 6.0, 7.0}, {8.0, 9.0, 10.0}}),
            "eye: event at 1 s, (2, 3, 4) m, in the room at (5, 6, 7) m, seen from (8, 9, 10) m");
}

// The same case is the same numbers, whatever was drawn before; and it says how to run it.
TEST(Print, ACaseIsDrawnAgain) {
  test::Random random(7);
  double first = 0.0;
  for (int i = 0; i < 3; ++i) {
    CASE(random, i);
    if (i == 2) first = random.in(0.0, 1.0);
    random.inBall(1.0);
  }
  ASSERT_TRUE(random.begin(2));
  EXPECT_EQ(random.in(0.0, 1.0), first);
  const std::string words = testing::PrintToString(random);
  EXPECT_NE(words.find("seed 7, case 2; again: CAROM_CASE=2 /"), std::string::npos) << words;
  EXPECT_NE(words.find(" --gtest_filter=Print.ACaseIsDrawnAgain"), std::string::npos) << words;
}

}  // namespace
}  // namespace carom
