// What a cylinder is like for somebody in its axis, behind it, and where its picture is mirrored.
#include "cave/screen/screen_facts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cave/screen/true_screens.h"

namespace carom {
namespace {

using namespace test;

constexpr double kRadius_m = 3.0, kArc_m = kRadius_m * 120.0 * kDegree, kHeight_m = 2.5;

TrueScreen screen() { return cylinder(kRadius_m, -60.0, 60.0, {1940, 660}); }

TEST(ScreenFacts, AreThoseOfACylinderFromItsAxis) {
  const TrueScreen shape = screen();
  const ScreenFacts facts = factsOf(curved(shape), shape.window_px, {0.0, 1.35, 0.0});
  EXPECT_NEAR(facts.width_m, kArc_m, 0.01);
  EXPECT_NEAR(facts.height_m, kHeight_m, 1e-6);
  EXPECT_NEAR(facts.turns_rad, 120.0 * kDegree, 0.06);
  const double perMetre = std::sqrt(1940.0 / kArc_m * 660.0 / kHeight_m);
  EXPECT_NEAR(facts.leastPerMetre, perMetre, 1e-3 * perMetre);
  EXPECT_NEAR(facts.mostPerMetre, perMetre, 1e-3 * perMetre);
  // By the middles of the cells' halves, a sixth of the height above or below the eyes.
  const double away_m = std::hypot(kRadius_m, kHeight_m / 6.0);
  EXPECT_NEAR(facts.nearest_m, away_m, 0.01);
  EXPECT_NEAR(facts.farthest_m, away_m, 0.01);
  EXPECT_NEAR(facts.mostIncidence_rad, std::atan(kHeight_m / 6.0 / kRadius_m), 0.02);
  EXPECT_NEAR(facts.covered, 1.0, 1e-9);
  EXPECT_GE(facts.texelsPerPixel, 1.25 * 1.25);
  EXPECT_FALSE(facts.isBehind);
  EXPECT_FALSE(facts.isMirrored);
}

TEST(ScreenFacts, TellWhatIsBehindFromWhatIsMirrored) {
  CurvedScreen made;
  made.mesh = screen().mesh;
  const ScreenFacts behind = factsOf(made, {1940, 660}, {0.0, 1.35, -20.0});
  EXPECT_TRUE(behind.isBehind);
  EXPECT_FALSE(behind.isMirrored);
  for (ScreenTriangle& triangle : made.mesh) {
    for (ScreenPoint& point : triangle) point.inWindow.x = 1.0 - point.inWindow.x;
  }
  const ScreenFacts mirrored = factsOf(made, {1940, 660}, {0.0, 1.35, 0.0});
  EXPECT_TRUE(mirrored.isMirrored);
  EXPECT_FALSE(mirrored.isBehind);
  EXPECT_NEAR(mirrored.mostIncidence_rad, std::atan(kHeight_m / 6.0 / kRadius_m), 0.02);
}

// Half of the window without a screen: as wide as the rest.
TEST(ScreenFacts, CountWhatShowsScreen) {
  CurvedScreen made;
  made.mesh = cutAt(screen().mesh, 0, 0.5, true);
  const ScreenFacts facts = factsOf(made, {1940, 660}, {0.0, 1.35, 0.0});
  EXPECT_NEAR(facts.covered, 0.5, 1e-9);
  EXPECT_NEAR(facts.width_m, 0.5 * kArc_m, 0.03);
}

}  // namespace
}  // namespace carom
