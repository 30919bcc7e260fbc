// A rig whose nodes are left out: the walls that stay, and the nodes that cannot be left out.
#include "app/nodes/rig_without.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/nodes/mpirun_line.h"
#include "places.h"

namespace carom {
namespace {

Rig fourWalls() {
  Rig rig = readRig(std::filesystem::path(CAROM_CONFIG_DIR) / "rigs/four-walls-cluster.toml");
  rig.nodes = {{.rank = 0, .display = ":0", .host = "localhost"},
               {.rank = 1, .display = ":1", .host = "sides", .slots = 2},
               {.rank = 3, .display = ":3", .host = "floor"}};
  return rig;
}

TEST(RigWithout, LeavesOutTheWallsOfNodesAndMovesTheOthersUp) {
  const Rig whole = fourWalls();
  const Rig rig = rigWithout(whole, {2, 1});
  ASSERT_EQ(rig.walls.size(), 2u);
  EXPECT_EQ(rig.walls[0].node, 0);
  EXPECT_EQ(rig.walls[1].node, 1);
  EXPECT_EQ(rig.walls[1].name, whole.walls[3].name);
  EXPECT_EQ(hostsOf(rig), (std::vector<std::string>{"localhost", "floor"}));
  EXPECT_EQ(displayOf(rig, 1), ":3");
  ASSERT_EQ(rig.missing.size(), 1u);
  EXPECT_EQ(rig.missing[0].name, "sides");
  EXPECT_EQ(rig.missing[0].walls, (std::vector<std::string>{whole.walls[1].name, whole.walls[2].name}));
  EXPECT_EQ(hostsOf(rigWithout(whole, {})), hostsOf(whole));
  EXPECT_EQ(hostsOf(rigWithout(whole, {3})), (std::vector<std::string>{"localhost", "sides", "sides"}));
}

TEST(RigWithout, RefusesNodesThatCannotBeLeftOut) {
  EXPECT_THROW(rigWithout(fourWalls(), {0}), std::runtime_error);
  EXPECT_THROW(rigWithout(fourWalls(), {4}), std::runtime_error);
  Rig console = fourWalls();  // node 0 draws no wall
  console.walls.erase(console.walls.begin());
  EXPECT_NO_THROW(rigWithout(console, {1, 2}));
  EXPECT_THROW(rigWithout(console, {1, 2, 3}), std::runtime_error);
}

}  // namespace
}  // namespace carom
