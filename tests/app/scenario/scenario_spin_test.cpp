// What turns the pucks of a scenario file.
#include "app/scenario/scenario_spin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "app/scenario/scenario_text.h"

namespace carom {
namespace {

using test::Fault;
using test::kHead;
using test::kPuck;
using test::read;
using test::ScenarioFaults;

// The rim of a puck that turns at ω by its own clock moves at β = ωR/c; J = γβ · inertia · mass · R · c.
TEST(Scenario, SpinIsTheAngularMomentumOfTheRim) {
  constexpr double kOmega_rad_s = 8.0, kRadius_m = 0.1, kInertia = 0.4;  // mass 1 kg, c 1 m/s
  const Puck puck = read(kHead + kPuck + "inertia = 0.4\nspin_rad_s = 8\n").billiard.pucks.at(0);
  const double beta = kOmega_rad_s * kRadius_m;
  EXPECT_NEAR(puck.spin_kg_m2_s, beta / std::sqrt(1.0 - beta * beta) * kInertia * kRadius_m, 1e-14);
  const Puck given = read(kHead + kPuck + "spin_kg_m2_s = -0.25\n").billiard.pucks.at(0);
  EXPECT_EQ(given.spin_kg_m2_s, -0.25);
  EXPECT_EQ(read(kHead + kPuck).billiard.pucks.at(0).spin_kg_m2_s, 0.0);
}

TEST(Scenario, FindsUnusualSpinAndFriction) {
  const auto oddOf = [](const std::string& text) {
    std::vector<std::string> texts;
    for (const Finding& odd : read(text).odd) texts.push_back(odd.text);
    return texts;
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(oddOf(kHead + kPuck + "spin_rad_s = 9.89\n"), Texts{});
  EXPECT_EQ(oddOf(kHead + kPuck + "spin_rad_s = -9.95\n"),
            Texts{"the rim of puck 'a' moves at 0.995 c, expected at most 0.99 c"});
  EXPECT_EQ(oddOf(kHead + "[physics]\ntangential_restitution = 0.5\ncushion_friction = 0.1\n"), Texts{});
  EXPECT_EQ(oddOf(kHead + "[physics]\ntangential_restitution = 0.5\n"),
            Texts{"tangential_restitution does nothing without friction, expected puck_friction or "
                  "cushion_friction above 0"});
}

INSTANTIATE_TEST_SUITE_P(
    Spins, ScenarioFaults,
    ::testing::Values(
        Fault{"rim faster than light", kHead + kPuck + "spin_rad_s = -12\n", 8, 14,
              "the rim would move at 1.2 c, expected less than 10 rad/s"},
        Fault{"rim at light speed", kHead + kPuck + "spin_rad_s = 10\n", 8, 14, "at 1 c"},
        Fault{"too much spin", kHead + kPuck + "spin_kg_m2_s = 1e8\n", 8, 16, "as fast as light"},
        Fault{"spin said twice", kHead + kPuck + "spin_rad_s = 1\nspin_kg_m2_s = 0.1\n", 9, 16,
              "one of them"},
        Fault{"stroke beside the puck",
              kHead + kPuck + "[[stroke]]\nat_s = 1\npuck = 'a'\nmomentum_kg_m_s = [1, 0]\noffset_m = 0.11\n",
              12, 12, "beside puck 'a', expected at most its radius, 0.1 m"}),
    test::nameOfFault);

}  // namespace
}  // namespace carom
