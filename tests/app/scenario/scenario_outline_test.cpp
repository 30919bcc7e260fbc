// The corners of a puck in a scenario file: what follows from them, and which outlines are refused or
// unusual.
#include "app/scenario/scenario_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "app/scenario/scenario_text.h"

namespace carom {
namespace {

using test::Fault;
using test::kHead;
using test::nameOfFault;
using test::read;
using test::ScenarioFaults;

/// A puck with these lines for its shape, which begin in line 3 of the file.
std::string shaped(const std::string& lines) {
  return kHead + "[[puck]]\n" + lines + "name = 'a'\nmass_kg = 2\nposition_m = [0, 0]\nbeta = [0, 0]\n";
}

const std::string kBarOutline = "outline_m = [[-0.3, -0.1], [0.3, -0.1], [0.3, 0.1], [-0.3, 0.1]]\n";

// An even rectangle of half sides a and b has the moment m (a² + b²)/3, which is a third of m times the
// square of its farthest corner's distance.
TEST(Scenario, AnOutlineGivesItsRadiusAndTheInertiaOfAnEvenPlate) {
  const Puck bar = read(shaped(kBarOutline)).billiard.pucks.at(0);
  ASSERT_EQ(bar.outline_m.size(), 4u);
  EXPECT_EQ(bar.outline_m[1], Vec2(0.3, -0.1));
  EXPECT_NEAR(bar.radius_m, std::sqrt(0.1), 1e-12);
  EXPECT_NEAR(bar.inertia, 1.0 / 3.0, 1e-12);
  EXPECT_EQ(read(shaped(kBarOutline + "inertia = 0.7\n")).billiard.pucks.at(0).inertia, 0.7)
      << "what the file says stands";
  EXPECT_TRUE(read(shaped("radius_m = 0.2\n")).billiard.pucks.at(0).outline_m.empty());
}

TEST(Scenario, FindsAnOutlineWhoseCentreOfMassIsElsewhere) {
  const Scenario odd = read(shaped("outline_m = [[-0.2, -0.1], [0.4, -0.1], [0.4, 0.1], [-0.2, 0.1]]\n"));
  ASSERT_EQ(odd.odd.size(), 1u);
  EXPECT_EQ(odd.odd[0].at.line, 3);
  EXPECT_NE(odd.odd[0].text.find("of puck 'a' is at (0.1, "), std::string::npos) << odd.odd[0].text;
  EXPECT_TRUE(read(shaped(kBarOutline)).odd.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Outlines, ScenarioFaults,
    ::testing::Values(Fault{"radius beside corners", shaped(kBarOutline + "radius_m = 1\n"), 4, 12,
                            "stands beside outline_m"},
                      Fault{"outline beside corners", shaped(kBarOutline + "outline = 'mesh'\n"), 4, 11,
                            "stands beside outline_m"},
                      Fault{"outline without a mesh", shaped("outline = 'mesh'\nradius_m = 1\n"), 3, 11,
                            "puck 'a' has no mesh, expected mesh = a file"},
                      Fault{"clockwise corners",
                            shaped("outline_m = [[-0.3, 0.1], [0.3, 0.1], [0.3, -0.1], [-0.3, -0.1]]\n"), 3,
                            14, "outline_m of puck 'a'"},
                      Fault{"no shape", shaped(""), 2, 1, "radius_m is missing"}),
    nameOfFault);

}  // namespace
}  // namespace carom
