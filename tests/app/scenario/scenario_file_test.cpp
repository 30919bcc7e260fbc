// A whole scenario file: flashes, strokes, and faults with their places.
#include "app/scenario/scenario.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/scenario/scenario_text.h"

namespace carom {
namespace {

using test::Fault;
using test::kHead;
using test::kPuck;
using test::puckText;
using test::read;
using test::ScenarioFaults;

TEST(Scenario, TakesFlashes) {
  const Scenario scenario = read(
      "light_speed_m_s = 2\n[[flash]]\nat_s = 3\nr_m = [0, -0.9, 0.3]\n"
      "[[flash]]\nname = 'lamp'\nat_s = 0\nr_m = [1, 2, 3]\n");
  const std::vector<Flash>& flashes = scenario.billiard.flashes;
  ASSERT_EQ(flashes.size(), 2u);
  EXPECT_EQ(flashes[0].name, "flash 1");
  EXPECT_EQ(flashes[0].at.t_s, 3.0);
  EXPECT_EQ(flashes[0].at.r_m, Vec3(0, -0.9, 0.3));
  EXPECT_EQ(flashes[1].name, "lamp");
}

TEST(Scenario, TakesStrokes) {
  const Scenario scenario =
      read("light_speed_m_s = 2\n" + puckText("a", 1.0, {0, 0}, {0, 0}) +
           "[[stroke]]\nat_s = 3\nfrom_m = [0, -0.9, 0.3]\npuck = 'a'\nmomentum_kg_m_s = [0.1, 0]\n");
  ASSERT_EQ(scenario.billiard.strokes.size(), 1u);
  EXPECT_EQ(scenario.billiard.strokes[0].puck, 0u);
  EXPECT_EQ(scenario.billiard.strokes[0].at_s, 3.0);
  EXPECT_EQ(scenario.billiard.strokes[0].from_m, Vec3(0, -0.9, 0.3));
  EXPECT_EQ(scenario.billiard.strokes[0].momentum_kg_m_s, Vec2(0.1, 0.0));
}

TEST_P(ScenarioFaults, ArePlacedAndExplained) { test::expectExplained(GetParam(), read); }

INSTANTIATE_TEST_SUITE_P(
    All, ScenarioFaults,
    ::testing::Values(
        Fault{"no light", "title = 'x'\n", 1, 1, "light_speed_m_s is missing"},
        Fault{"light stands still", "light_speed_m_s = 0\n", 1, 19, "above 0"},
        Fault{"light runs back", "light_speed_m_s = -1.42\n", 1, 19, "above 0"},
        Fault{"endless", "light_speed_m_s = inf\n", 1, 19, "is inf"},
        Fault{"junk after a number", "light_speed_m_s = 1\n[board]\nlength_m = 0/05\nwidth_m = 1\n", 3, 13,
              "expected digit"},
        Fault{"unknown table", kHead + "[bord]\nx = 1\n", 2, 2, "expected 'board'?"},
        Fault{"board without width", kHead + "[board]\nlength_m = 1\n", 2, 1, "width_m is missing"},
        Fault{"restitution", kHead + "[physics]\npuck_restitution = 1.5\n", 3, 20, "from 0 to 1"},
        Fault{"collision event", kHead + "[physics]\ncollision_event = \"center\"\n", 3, 19,
              "'centre' or 'contact'"},
        Fault{
            "faster than light",
            kHead +
                "[[puck]]\nname = 'a'\nradius_m = 0.1\nmass_kg = 1\nposition_m = [0, 0]\nbeta = [0.8, 0.6]\n",
            7, 8, "below light"},
        Fault{
            "text for a number",
            kHead + "[[puck]]\nname = 'a'\nradius_m = '1'\nmass_kg = 1\nposition_m = [0, 0]\nbeta = [0, 0]\n",
            4, 12, "is a text"},
        Fault{"mesh",
              kHead + "[[puck]]\nname = 'a'\nradius_m = 1\nmass_kg = 1\nposition_m = [0, 0]\nbeta = [0, "
                      "0]\nmesh = 'no.obj'\n",
              8, 8, "no.obj"},
        Fault{"empty mesh",
              kHead + "[[puck]]\nname = 'a'\nradius_m = 1\nmass_kg = 1\nposition_m = [0, 0]\nbeta = [0, "
                      "0]\nmesh = ''\n",
              8, 8, "empty"},
        Fault{"stroke of nobody",
              kHead + kPuck + "[[stroke]]\nat_s = 1\npuck = 'c'\nmomentum_kg_m_s = [1, 0]\n", 10, 8,
              "no puck 'c'"},
        Fault{"stroke before the game",
              kHead + kPuck + "[[stroke]]\nat_s = -1\npuck = 'a'\nmomentum_kg_m_s = [1, 0]\n", 9, 8,
              "from 0"},
        Fault{"flash before the game", kHead + "[[flash]]\nat_s = -1\nr_m = [0, 0, 0]\n", 3, 8, "from 0"},
        Fault{"flash nowhere", kHead + "[[flash]]\nat_s = 1\n", 2, 1, "r_m is missing"},
        Fault{"friction below 0", kHead + "[physics]\npuck_friction = -1\n", 3, 17, "from 0"},
        Fault{"friction of no number", kHead + "[physics]\ncushion_friction = nan\n", 3, 20, "is nan"},
        Fault{"tangential restitution", kHead + "[physics]\ntangential_restitution = 2\n", 3, 26,
              "from 0 to 1"},
        Fault{"endless spin deceleration", kHead + "[physics]\nspin_deceleration_m_s2 = inf\n", 3, 26,
              "is inf"},
        Fault{"inertia of nothing", kHead + kPuck + "inertia = 0\n", 8, 11, "above 0"},
        Fault{"inertia too small for numbers", kHead + kPuck + "inertia = 1e-12\n", 8, 11, "at least 1e-06"},
        Fault{"inertia above a hoop's", kHead + kPuck + "inertia = 1.5\n", 8, 11, "to 1"},
        Fault{"observer at light speed", kHead + "[observer]\nbeta = [1, 0, 0]\n", 3, 8, "below light"}),
    test::nameOfFault);

}  // namespace
}  // namespace carom
