// The scripted bodies of a scenario file, and those that move as a table says.
#include "app/scenario/scenario_bodies.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "app/scenario/scenario_text.h"

namespace carom {
namespace {

using test::Fault;
using test::kHead;
using test::kRounding;
using test::numberText;
using test::read;
using test::ScenarioFaults;
using test::TemporaryFolder;

// A scripted body: where it was is compared with a walk along its legs from the told event in small steps.
class ScriptedBodyTest : public ::testing::TestWithParam<double> {
 protected:
  static constexpr double kC_m_s = 1.3;
  const std::vector<double> froms_s{-1e300, -2.0, 1.5, 3.0};
  const std::vector<Vec3> betas{{0.5, 0, 0}, {0, -0.7, 0.1}, {-0.3, 0.3, 0.3}, {0, 0, 0}};

  Vec3 betaAt(double t_s) const {
    std::size_t leg = 0;
    while (leg + 1 < betas.size() && froms_s[leg + 1] <= t_s) ++leg;
    return betas[leg];
  }
  /// Place change and proper time from a to b; no turn falls inside a step.
  std::pair<Vec3, double> walk(double a_s, double b_s) const {
    constexpr int kSteps = 1 << 14;
    const double h_s = (b_s - a_s) / kSteps;
    Vec3 way_m(0.0);
    double clock_s = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const Vec3 beta = betaAt(a_s + (i + 0.5) * h_s);
      way_m += beta * (kC_m_s * h_s);
      clock_s += std::sqrt(1.0 - glm::dot(beta, beta)) * h_s;
    }
    return {way_m, clock_s};
  }
};

TEST_P(ScriptedBodyTest, PassesItsEventOnWhicheverLegHoldsIt) {
  const double at_s = GetParam();
  for (const bool appears : {false, true}) {
    const std::string text =
        "light_speed_m_s = 1.3\n[[body]]\nname = 'rod'\nat = { t_s = " + numberText(at_s) +
        ", r_m = [0.1, 0.2, 0.3] }\n" + (appears ? "appears_s = -1.0\n" : "") +
        "[[body.leg]]\nbeta = [0.5, 0, 0]\n[[body.leg]]\nfrom_s = -2\nbeta = [0, -0.7, 0.1]\n"
        "[[body.leg]]\nfrom_s = 1.5\nbeta = [-0.3, 0.3, 0.3]\n[[body.leg]]\nfrom_s = 3\nbeta = [0, 0, 0]\n";
    const WorldLine line = read(text).bodies.at(0).worldLine;
    ASSERT_EQ(line.knots().size(), 4u);
    const double kStepError = 8.0 / (1 << 14);  // a turn may fall inside one step of the walk
    for (const double t_s : {-4.0, -2.0, -0.5, 0.0, 1.5, 2.5, 4.0}) {
      const Motion motion = line.at(t_s);
      EXPECT_NEAR(glm::distance(motion.event.r_m, Vec3(0.1, 0.2, 0.3) + walk(at_s, t_s).first), 0.0,
                  kStepError)
          << t_s;
      EXPECT_NEAR(motion.properTime_s, walk(appears ? -1.0 : 0.0, t_s).second, kStepError) << t_s;
    }
    EXPECT_NEAR(glm::distance(line.at(at_s).event.r_m, Vec3(0.1, 0.2, 0.3)), 0.0, kRounding);
    for (std::size_t i = 1; i < 4; ++i) {
      EXPECT_EQ(line.knots()[i].turn.t_s, froms_s[i]);
      EXPECT_EQ(line.knots()[i].signal.t_s, froms_s[i]) << "the news starts at the centre's turn";
      EXPECT_EQ(line.knots()[i].signal.r_m, line.knots()[i].turn.r_m);
    }
    EXPECT_EQ(line.appears_s(), appears ? -1.0 : -std::numeric_limits<double>::infinity());
  }
}

INSTANTIATE_TEST_SUITE_P(OnEveryLeg, ScriptedBodyTest,
                         ::testing::Values(-3.5, -2.0, 0.7, 1.5, 2.0, 3.0, 5.0));

// A body whose vertices are given row by row: a mesh of as many vertices has triangles, polygons are fans.
TEST(Scenario, ReadsABodyThatMovesAsToldByATable) {
  const TemporaryFolder folder;
  folder.file("way.csv",
              "t_s,x0_m,y0_m,z0_m,x1_m,y1_m,z1_m,x2_m,y2_m,z2_m,x3_m,y3_m,z3_m\n"
              "0,0,0,0,1,0,0,1,1,0,0,1,0\n2,0.5,0,0,1.5,0,0,1.5,1,0,0.5,1,0\n");
  folder.file("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1 2 -2 4\n");
  folder.file("two.obj", "v 0 0 0\nv 1 0 0\n");
  const auto with = [&](const std::string& lines) {
    return readScenario(folder.file("given.toml", kHead + "[[body]]\nname = 'b'\n" + lines));
  };
  const Scenario scenario = with("history = 'way.csv'\nmesh = 'quad.obj'\n");
  ASSERT_EQ(scenario.told.size(), 1u);
  EXPECT_TRUE(scenario.bodies.empty());
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  EXPECT_EQ(scenario.told[0].triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_TRUE(with("history = 'way.csv'\n").told.at(0).triangles.empty());
  test::expectExplained({"two vertices", "history = 'way.csv'\nmesh = 'two.obj'\n", 5, 8,
                         "the mesh has 2 vertices and the history of 'b' 4, expected as many"},
                        with);
  test::expectExplained(
      {"spin beside it", "history = 'way.csv'\nspin_rad_s = 1\n", 5, 14, "stands beside history"}, with);
}

// The faults of the table stand at their own rows and columns.
TEST(Scenario, NamesTheFaultsOfATableOfPlaces) {
  const TemporaryFolder folder;
  const std::string columns = "t_s,x0_m,y0_m,z0_m\n";
  const auto readTable = [&](const std::string& table) {
    folder.file("way.csv", table);
    return readScenario(folder.file("given.toml", kHead + "[[body]]\nname = 'b'\nhistory = 'way.csv'\n"));
  };
  EXPECT_NO_THROW(readTable(columns + "0,0,0,0\r\n1,0.999,0,0\r\n"));
  for (const Fault& fault :
       {Fault{"columns", "t_s,x0_m,z0_m,y0_m\n", 1, 10, "does not name the columns"},
        Fault{"no number", columns + "0,0,zero,0\n", 2, 5, "'zero' is no number"},
        Fault{"too few", columns + "0,0,0\n1,0,0,0\n2,0,0,0\n", 2, 1, "has 3 numbers, expected 4"},
        Fault{"too many", columns + "0,0,0,0,0\n1,0,0,0\n2,0,0,0\n", 2, 1, "has more than 4 numbers"},
        Fault{"order", columns + "0,0,0,0\n0,0,0,0\n1,0,0,0\n", 3, 1, "t_s is 0 after 0"},
        Fault{"light", columns + "0,0,0,0\n1,0,0,1\n", 3, 3, "vertex 0 moves at 1 c"},
        Fault{"one row", columns + "0,0,0,0\n", 3, 1, "has one row, expected two rows"}}) {
    SCOPED_TRACE(fault.what);
    test::expectExplained(fault, readTable);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Bodies, ScenarioFaults,
    ::testing::Values(
        Fault{"no legs", kHead + "[[body]]\nname = 'r'\nat = { t_s = 0, r_m = [0, 0, 0] }\n", 2, 1,
              "[[body.leg]]"},
        Fault{"empty legs", kHead + "[[body]]\nname = 'r'\nat = { t_s = 0, r_m = [0, 0, 0] }\nleg = []\n", 5,
              7, "[[body.leg]]"},
        Fault{"no event", kHead + "[[body]]\nname = 'r'\n[[body.leg]]\nbeta = [0, 0, 0]\n", 2, 1,
              "at is missing"},
        Fault{"legs out of order",
              kHead +
                  "[[body]]\nname = 'r'\nat = { t_s = 0, r_m = [0, 0, 0] }\n[[body.leg]]\nbeta = [0, 0, 0]\n"
                  "[[body.leg]]\nfrom_s = 2\nbeta = [0, 0, 0]\n[[body.leg]]\nfrom_s = 2\nbeta = [0, 0, 0]\n",
              11, 10, "after the leg before it"},
        Fault{"first leg from",
              kHead + "[[body]]\nname = 'r'\nat = { t_s = 0, r_m = [0, 0, 0] }\n[[body.leg]]\nfrom_s = "
                      "2\nbeta = [0, 0, 0]\n",
              6, 10, "first leg"}),
    test::nameOfFault);

}  // namespace
}  // namespace carom
