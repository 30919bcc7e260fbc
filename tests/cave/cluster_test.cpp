// Run under mpirun with several ranks (see CMakeLists.txt): each rank is one process of the test.
#include "cave/cluster.h"

#include <gtest/gtest.h>

#include <cmath>

namespace carom {
namespace {

Cluster* cluster = nullptr;

WorldLine history() { return WorldLine({{0.0, Vec3(0.0)}, Vec3(0.0), 0.0, {}, 0.0}, 1.42, 0.1); }

/// A frame as rank 0 makes it: `number` knots of a body that stands still.
FrameState frameWithKnots(std::uint64_t number) {
  FrameState state;
  state.record.number = number;
  state.record.display_s = static_cast<double>(number) / 60.0;
  state.record.observer.headFromBoard = Lorentz::boost({0.1 * static_cast<double>(number), 0.0, 0.3}, 1.42);
  for (std::uint64_t i = 0; i < number; ++i) {
    const double t_s = 100.0 * static_cast<double>(number) + static_cast<double>(i);
    state.knots.push_back({0, {{t_s, Vec3(0.0)}, Vec3(0.0), t_s, {}, 0.0}});
  }
  return state;
}

TEST(Cluster, EveryRankHoldsRankZerosRecordAndKnots) {
  std::vector<WorldLine> histories{history()};
  std::size_t expectedKnots = 1;
  for (std::uint64_t number = 0; number < 40; ++number) {
    FrameState state = cluster->rank() == 0 ? frameWithKnots(number) : FrameState{};
    cluster->share(state);
    const FrameState expected = frameWithKnots(number);
    expectedKnots += number;
    ASSERT_EQ(state.record.number, number);
    ASSERT_EQ(state.record.observer.headFromBoard.matrix(), expected.record.observer.headFromBoard.matrix());
    applyFrame(state, histories);
    ASSERT_EQ(histories[0].knots().size(), expectedKnots);
    ASSERT_NO_THROW(EXPECT_FALSE(cluster->swapTogether(state, histories, false)));
  }
}

TEST(Cluster, ARankThatDiffersIsNamed) {
  if (cluster->size() < 2) GTEST_SKIP() << "needs two ranks";
  FrameState state = cluster->rank() == 0 ? frameWithKnots(3) : FrameState{};
  cluster->share(state);
  std::vector<WorldLine> histories{history()};
  applyFrame(state, histories);
  Wall front{}, left{};
  front.name = "front";
  left.name = "left";
  left.node = 1;
  cluster->nameNodes(std::vector<Wall>{front, left});
  if (cluster->rank() == 1) histories[0].truncateFrom(302.0);  // this node lost a knot
  try {
    cluster->swapTogether(state, histories, false);
    FAIL() << "the difference went unnoticed";
  } catch (const NodesDiffer& error) {
    EXPECT_STREQ(
        error.what(),
        "frame 3: node 1 (left) drew from other numbers than node 0: histories, body 0, number of knots");
  }
}

TEST(Cluster, TheFirstNodeWithOtherContentIsNamed) {
  EXPECT_NO_THROW(cluster->agree("rig", "walls"));
  if (cluster->size() < 2) return;
  try {
    cluster->agree("rig", cluster->rank() == cluster->size() - 1 ? "other walls" : "walls");
    FAIL() << "the difference went unnoticed";
  } catch (const NodesDiffer& error) {
    EXPECT_EQ(error.what(), "node " + std::to_string(cluster->size() - 1) +
                                " has another rig than node 0, expected the same on every node");
  }
}

TEST(Cluster, OneRankThatWantsToEndEndsAll) {
  std::vector<WorldLine> histories{history()};
  FrameState state = cluster->rank() == 0 ? frameWithKnots(0) : FrameState{};
  cluster->share(state);
  EXPECT_FALSE(cluster->swapTogether(state, histories, false));
  cluster->share(state);
  EXPECT_TRUE(cluster->swapTogether(state, histories, cluster->rank() == cluster->size() - 1));
}

TEST(Cluster, TheLowestFailedRankIsKnownToAll) {
  EXPECT_EQ(cluster->firstFailed(false), -1);
  EXPECT_EQ(cluster->firstFailed(cluster->rank() == cluster->size() - 1), cluster->size() - 1);
  EXPECT_EQ(cluster->firstFailed(true), 0);
}

TEST(Cluster, TruncationComesBeforeTheNewKnots) {
  std::vector<WorldLine> histories{history(), history(), history()};  // the board, a puck, a told body
  FrameState first = frameWithKnots(3);                               // turns at 300, 301, 302
  for (BodyKnot& knot : first.knots) knot.body = 1;
  applyFrame(first, histories);
  for (BodyKnot& knot : first.knots) knot.body = 2;
  applyFrame(first, histories);
  FrameState rewound = frameWithKnots(4);  // 400 … 403
  for (BodyKnot& knot : rewound.knots) knot.body = 1;
  rewound.record.truncateFrom_s = 301.0;
  rewound.record.pucks = 1;
  applyFrame(rewound, histories);
  ASSERT_EQ(histories[1].knots().size(), 6U);
  EXPECT_EQ(histories[1].knots()[1].turn.t_s, 300.0);
  EXPECT_EQ(histories[1].knots()[2].turn.t_s, 400.0);
  EXPECT_EQ(histories[2].knots().size(), 4U) << "a told body lost its turns";
}

}  // namespace
}  // namespace carom

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  carom::Cluster theCluster;
  carom::cluster = &theCluster;
  return RUN_ALL_TESTS();
}
