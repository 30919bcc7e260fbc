// The memory of many pucks. Its own program: it looks at what the process holds.

#include <gtest/gtest.h>

#include "engine/billiard/billiard.h"
#include "engine/gas.h"
#include "resident_bytes.h"

namespace carom {
namespace {

// Four collisions a puck are eight turns: eight knots and four events, and what was bought in advance is
// among it.
TEST(GasMemory, APuckTakesLessThanFourKilobytes) {
  constexpr int kPucks = 10000;
  constexpr double kMost_bytes = 4000.0;
  const std::size_t without = test::residentBytes();
  const auto bytesAPuck = [&] { return (double(test::residentBytes()) - double(without)) / kPucks; };
  Billiard billiard(test::gasSetup(kPucks, 0.1, 2.5, 1));
  const double atStart = bytesAPuck();
  EXPECT_GT(atStart, 500.0) << "it is counted";
  EXPECT_LE(atStart, kMost_bytes);
  double t_s = 0.0;
  while (billiard.events().size() < 4 * kPucks) billiard.advanceTo(t_s += 0.01);
  std::size_t knots = 0;
  for (const WorldLine& line : billiard.worldLines()) knots += line.knots().size();
  EXPECT_GT(knots, 8U * kPucks);
  EXPECT_LE(bytesAPuck(), kMost_bytes);
}

}  // namespace
}  // namespace carom
