// What the searches for contacts of bodies with corners share: from when on a contact counts, the steps of a
// search, and the middle of what touches at one time.
#include "engine/polygons/corner_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/polygons/corner_pairs.h"

namespace carom {
namespace {

using test::flight;
using test::rectangle;

TEST(CornerSearch, AWindowBeginsAtTheEarlierContactInTheFrameOfEqualSpeeds) {
  const Outline square(rectangle(0.08, 0.08));
  const PersistentContact earlier{
      {flight({-0.5, 0.0}, {0.6, 0.0}, square), flight({0.5, 0.0}, {0.0, 0.0}, square)},
      {0.75, -0.05, 0.02},
      {0.0, 1.0, 0.0}};
  ContactWindow window = windowAt(earlier);
  // 0.6 c and rest are ±1/3 c in the frame between them: γ = 3/√8, and t′ = γ (t − x/3) from the start on.
  const double expected = 3.0 / std::sqrt(8.0) * (0.75 - (-0.05 + 0.5) / 3.0);
  EXPECT_NEAR(window.from, expected, 1e-14);
  EXPECT_EQ(window.timeOf(earlier.event), window.from);
  EXPECT_TRUE(window.holds(window.from));
  EXPECT_FALSE(window.holds(std::nextafter(window.from, 0.0)));
  window.strictly = true;
  EXPECT_FALSE(window.holds(window.from));
}

// What is far is stepped to at once; near it steps begin with the least and grow by a hundredth each, up to
// those of what slides; farther away they begin anew.
TEST(CornerSearch, StepsNearABodyGrowAndBeginAnew) {
  constexpr double kSize = 0.1, kFastest = 2.0, kFine = kLeastStep * kSize / kFastest,
                   kCoarse = kSlideStep * kSize / kFastest;
  AdvancingSteps steps(kSize, kFastest);
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(steps.next(0.5), 0.25);
    for (int n = 1; n <= 1000; ++n) {
      const double step = steps.next(1e-12), expected = std::min(kCoarse, kFine * std::pow(1.01, n));
      ASSERT_NEAR(step, expected, 1e-9 * expected) << round << ", " << n;
    }
    EXPECT_EQ(steps.next(0.0), kCoarse);
    EXPECT_EQ(steps.next(-0.01), kCoarse);
  }
}

TEST(CornerSearch, WhatTouchesAtOneTimeIsMovedToItsMiddle) {
  const Outline low(rectangle(0.08, 0.08)), high(rectangle(0.04, 0.2));
  const MovingShape first = flight({-0.04, 0.0}, {0.0, 0.0}, low);
  const MovingShape second = flight({0.02, 0.09}, {0.0, 0.0}, high);
  // The sides at x = 0 lie on each other from y = −0.01 to 0.04.
  FoundContact found;
  found.event = {0.0, 0.0, 0.04};
  found.normal = {0.0, 1.0, 0.0};
  settleSimultaneous(first, second, {1.0, 0.0, 0.0}, found);
  EXPECT_TRUE(found.sideOnSide);
  EXPECT_NEAR(found.event.x, 0.0, 1e-15);
  EXPECT_NEAR(found.event.y, 0.015, 1e-15);
  // On another side only a corner touches.
  FoundContact corner;
  corner.event = {0.0, 0.0, 0.04};
  corner.normal = {0.0, 0.0, 1.0};
  settleSimultaneous(first, second, {1.0, 0.0, 0.0}, corner);
  EXPECT_FALSE(corner.sideOnSide);
  EXPECT_EQ(corner.event.y, 0.04);
}

}  // namespace
}  // namespace carom
