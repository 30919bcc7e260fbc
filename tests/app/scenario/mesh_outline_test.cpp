// The corners of a puck that its mesh gives.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "app/scenario/scenario_text.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

// A mesh is as large as its radius says, whatever its own units, and its footprint is what collides.
TEST(Scenario, AMeshMayBeTheOutline) {
  const test::TemporaryFolder folder;
  folder.file("box.obj",
              "v -30 -10 0\nv 30 -10 0\nv 30 10 0\nv -30 10 0\nv -30 -10 5\nv 30 -10 5\nv 30 10 5\n"
              "v -30 10 5\nf 1 2 3 4\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  const Scenario scenario = readScenario(folder.file(
      "given.toml", test::kHead + "[[puck]]\noutline = 'mesh'\nmesh = 'box.obj'\nradius_m = 0.4\nname = 'a'\n"
                                  "mass_kg = 2\nposition_m = [0, 0]\nbeta = [0, 0]\n"));
  const Puck& puck = scenario.billiard.pucks.at(0);
  EXPECT_NEAR(puck.radius_m, 0.4, 1e-12);
  ASSERT_TRUE(scenario.puckMeshes.at(0)->place);
  EXPECT_NEAR(scenario.puckMeshes[0]->place->scale * std::hypot(30.0, 10.0), 0.4, 0.02 * 0.4)
      << "the footprint lies around the mesh, by a small share of the radius";
  EXPECT_TRUE(scenario.puckMeshes[0]->isInOnePiece);
}

}  // namespace
}  // namespace carom
