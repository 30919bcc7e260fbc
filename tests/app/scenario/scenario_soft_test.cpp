// The soft pucks of a scenario file: their matter, the bodies that hold their sides, and what is refused.
#include "app/scenario/scenario_soft.h"

#include <gtest/gtest.h>

#include <string>

#include "app/scenario/scenario_text.h"

namespace carom {
namespace {

using test::Fault;
using test::kHead;
using test::nameOfFault;
using test::read;
using test::ScenarioFaults;

const std::string kRest = "mass_kg = 1\nposition_m = [0, 0]\nbeta = [0.5, 0]\n";
const std::string kBar =
    "[[puck]]\nname = 'bar'\noutline_m = [[-0.3, -0.1], [0.3, -0.1], [0.3, 0.1], [-0.3, 0.1]]\n" + kRest;
const std::string kDisc = "[[puck]]\nname = 'disc'\nradius_m = 0.1\n" + kRest;

/// A body that moves with the puck until it turns; its lines are as many for all of these.
std::string body(const std::string& beta, const std::string& from_s, const std::string& turned) {
  return "[[body]]\nname = 'hand'\nat = { t_s = 0, r_m = [0, 0, 0] }\n[[body.leg]]\nbeta = " + beta +
         "\n[[body.leg]]\nfrom_s = " + from_s + "\nbeta = " + turned + "\n";
}

const std::string kHeld = "[puck.soft]\nheld = [{ side = '+x', by = 'hand' }]\n";

TEST(Scenario, ReadsSoftMatterAndWhatHoldsIt) {
  const Puck bar = read(kHead + kBar + "[puck.soft]\nsound_speed = 0.5\ncells = 6\nviscosity = 0.2\nheld = " +
                        "[{ side = '-x', by = 'hand' }]\n" + body("[0.5, 0, 0]", "2", "[0, 0.25, 0]"))
                       .billiard.pucks.at(0);
  ASSERT_TRUE(bar.soft);
  EXPECT_EQ(bar.soft->soundSpeed, 0.5);
  EXPECT_EQ(bar.soft->cells, 6);
  EXPECT_EQ(bar.soft->viscosity, 0.2);
  ASSERT_EQ(bar.soft->held.size(), 1u);
  EXPECT_FALSE(bar.soft->held[0].isPlusX);
  ASSERT_EQ(bar.soft->held[0].turns.size(), 1u);
  EXPECT_FALSE(read(kHead + kBar).billiard.pucks.at(0).soft);
}

// Seen from a disc at -0.5 c, one at 0.5 c comes with 0.8 c; at 0.7 c both, with 1.4/1.49 c.
TEST(Scenario, WarnsOfSoftPucksThatMayBeCrushed) {
  const auto oddOf = [](const std::string& beta) {
    return read(kHead + "[[puck]]\nname = 'a'\nradius_m = 0.1\nmass_kg = 1\nposition_m = [-1, 0]\nbeta = [" +
                beta + ", 0]\n[puck.soft]\n[[puck]]\nname = 'b'\nradius_m = 0.1\nmass_kg = 1\n" +
                "position_m = [1, 0]\nbeta = [-" + beta + ", 0]\n")
        .odd;
  };
  EXPECT_TRUE(oddOf("0.5").empty());
  const std::vector<Finding> odd = oddOf("0.7");
  ASSERT_EQ(odd.size(), 2u);
  EXPECT_EQ(odd[0].at.line, 7);
  EXPECT_NE(odd[0].text.find("puck 'a' can close at 0.9396 c"), std::string::npos) << odd[0].text;
}

TEST(Scenario, WarnsOfABarThatBuckles) {
  const auto oddOf = [](const std::string& half) {
    return read(kHead + "[[puck]]\nname = 'bar'\noutline_m = [[-0.4, -" + half + "], [0.4, -" + half +
                "], [0.4, " + half + "], [-0.4, " + half + "]]\n" + kRest + "[puck.soft]\n")
        .odd;
  };
  EXPECT_TRUE(oddOf("0.1").empty());
  const std::vector<Finding> odd = oddOf("0.08");
  ASSERT_EQ(odd.size(), 1u);
  EXPECT_NE(odd[0].text.find("is 5 times as long as wide"), std::string::npos) << odd[0].text;
}

INSTANTIATE_TEST_SUITE_P(
    SoftPucks, ScenarioFaults,
    ::testing::Values(
        Fault{"spin of soft matter", kHead + kDisc + "spin_rad_s = 1\n[puck.soft]\n", 8, 14,
              "stands beside soft"},
        Fault{"soft triangle",
              kHead + "[[puck]]\nname = 'a'\noutline_m = [[-0.1, -0.1], [0.2, -0.1], [-0.1, 0.2]]\n" + kRest +
                  "[puck.soft]\n",
              4, 13, "neither a disc nor a rectangle"},
        Fault{"a side of a disc", kHead + kDisc + kHeld + body("[0.5, 0, 0]", "1", "[0, 0, 0]"), 9, 8,
              "is a disc and has no sides"},
        Fault{"held by nothing", kHead + kBar + kHeld, 9, 29, "there is no body 'hand'"},
        Fault{"held by a body of another speed", kHead + kBar + kHeld + body("[0.4, 0, 0]", "1", "[0, 0, 0]"),
              9, 29, "expected as puck 'bar' does, with (0.5, 0) c"},
        Fault{"held from above", kHead + kBar + kHeld + body("[0.5, 0, 0]", "1", "[0, 0, 0.1]"), 9, 29,
              "leaves the plane of the board"},
        Fault{"held before the game", kHead + kBar + kHeld + body("[0.5, 0, 0]", "-1", "[0, 0, 0]"), 9, 29,
              "turns at -1 s, expected 0 or later"},
        Fault{"held twice",
              kHead + kBar +
                  "[puck.soft]\nheld = [{ side = '+x', by = 'hand' }, { side = '+x', by = 'hand' }]\n" +
                  body("[0.5, 0, 0]", "1", "[0, 0, 0]"),
              9, 48, "side '+x' of puck 'bar' is held twice"},
        Fault{"friction of soft matter", kHead + "[physics]\npuck_friction = 0.1\n" + kDisc + "[puck.soft]\n",
              3, 17, "expected 0 in a game with soft pucks"},
        Fault{"rigid corners beside it",
              kHead + kDisc + "[puck.soft]\n[[puck]]\nname = 'b'\noutline_m = [[2, 0], [3, 0], [2, 1]]\n" +
                  kRest,
              11, 13, "has corners and is rigid beside soft pucks"}),
    nameOfFault);

}  // namespace
}  // namespace carom
