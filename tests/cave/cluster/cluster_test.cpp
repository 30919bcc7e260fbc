// Run under mpirun with several ranks (see CMakeLists.txt): each rank is one process of the test.
#include "cave/cluster/cluster.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace carom {
namespace {

Cluster* cluster = nullptr;

bool swapTogether(const FrameState& state, const World& world, bool wantsToEnd) {
  cluster->gatherDrawn(state, world, wantsToEnd);
  return cluster->releaseSwap(world);
}

WorldLine history() { return WorldLine({{0.0, Vec3(0.0)}, Vec3(0.0), 0.0, {}, 0.0}, 1.42, 0.1); }

/// A frame as rank 0 makes it: `number` knots of a body that stands still, and as many events in the place of
/// those before.
FrameState frameWithKnots(std::uint64_t number) {
  FrameState state;
  state.record.number = number;
  state.record.display_s = static_cast<double>(number) / 60.0;
  state.record.viewers[0].observer.headFromBoard =
      Lorentz::boost({0.1 * static_cast<double>(number), 0.0, 0.3}, 1.42);
  for (std::uint64_t i = 0; i < number; ++i) {
    const double t_s = 100.0 * static_cast<double>(number) + static_cast<double>(i);
    state.knots.push_back({0, {{t_s, Vec3(0.0)}, Vec3(0.0), t_s, {}, 0.0}});
    GameEvent& event = state.events.emplace_back();
    event.number = i;
    event.kind = EventKind::puckCushion;
    event.cushion = Cushion::minusX;
    event.at.t_s = t_s;
    event.turns.push_back({0, {t_s, Vec3(0.0)}, {0.1, 0.2}, {-0.1, 0.2}, t_s});
  }
  state.record.eventsKept = 0;
  return state;
}

TEST(Cluster, EveryRankHoldsRankZerosRecordAndKnots) {
  World world{{history()}, {}};
  std::size_t expectedKnots = 1;
  for (std::uint64_t number = 0; number < 40; ++number) {
    FrameState state = cluster->rank() == 0 ? frameWithKnots(number) : FrameState{};
    cluster->share(state);
    const FrameState expected = frameWithKnots(number);
    expectedKnots += number;
    ASSERT_EQ(state.record.number, number);
    ASSERT_EQ(state.record.viewers[0].observer.headFromBoard.matrix(),
              expected.record.viewers[0].observer.headFromBoard.matrix());
    applyFrame(state, world);
    ASSERT_EQ(world.histories[0].knots().size(), expectedKnots);
    ASSERT_EQ(world.events.size(), number);
    for (std::uint64_t i = 0; i < number; ++i) {
      ASSERT_EQ(world.events[i].at.t_s, expected.events[i].at.t_s);
      ASSERT_EQ(world.events[i].cushion, Cushion::minusX);
    }
    ASSERT_NO_THROW(EXPECT_FALSE(swapTogether(state, world, false)));
  }
}

TEST(Cluster, ARankThatDiffersIsNamed) {
  if (cluster->size() < 2) GTEST_SKIP() << "needs two ranks";
  FrameState state = cluster->rank() == 0 ? frameWithKnots(3) : FrameState{};
  cluster->share(state);
  World world{{history()}, {}};
  applyFrame(state, world);
  Wall front{}, left{};
  front.name = "front";
  left.name = "left";
  left.node = 1;
  cluster->nameNodes(std::vector<Wall>{front, left});
  if (cluster->rank() == 1) world.histories[0].truncateFrom(302.0);  // this node lost a knot
  try {
    swapTogether(state, world, false);
    FAIL() << "the difference went unnoticed";
  } catch (const NodesDiffer& error) {
    EXPECT_STREQ(
        error.what(),
        "frame 3: node 1 (left) drew from other numbers than node 0: histories, body 0, number of knots");
  }
}

/// What one node alone holds otherwise, and where the report says it is.
struct Planted {
  const char* field;
  std::function<void(FrameState&, World&)> plant;
};

/// The smallest change of a number.
void nudge(double& value) { value = std::nextafter(value, 1e300); }

// Every part of a frame that a node draws from: the smallest difference on the last node is found and named.
TEST(Cluster, ADifferenceAnywhereIsNamed) {
  if (cluster->size() < 2) GTEST_SKIP() << "needs two ranks";
  using State = FrameState;
  const std::vector<Planted> all{
      {"frame number", [](State& s, World&) { s.record.number += 1; }},
      {"frame number", [](State& s, World&) { s.record.last = 1; }},
      {"display time", [](State& s, World&) { nudge(s.record.display_s); }},
      {"observer",
       [](State& s, World&) {
         s.record.viewers[0].observer.headFromBoard = Lorentz::boost({0.1, 0.0, 0.3}, 1.42);
       }},
      {"observer", [](State& s, World&) { nudge(s.record.viewers[0].observer.properTime_s); }},
      {"observer", [](State& s, World&) { nudge(s.record.viewers[0].observer.left.observation.t_s); }},
      {"observer", [](State& s, World&) { nudge(s.record.viewers[0].observer.right.observation.r_m.y); }},
      {"observer", [](State& s, World&) { nudge(s.record.viewers[0].observer.middle.positionInRoom_m.z); }},
      {"switches", [](State& s, World&) { s.record.switches.aberration ^= 1; }},
      {"switches", [](State& s, World&) { s.record.controls.blank ^= 1; }},
      {"switches", [](State& s, World&) { nudge(s.record.lightSpeed_m_s); }},
      {"new knots", [](State& s, World&) { s.record.truncateFrom_s = 1e6; }},
      {"new knots", [](State& s, World&) { s.record.forgetBefore_s = -1e6; }},
      {"new knots", [](State& s, World&) { s.record.pucks += 1; }},
      {"new knots", [](State& s, World&) { nudge(s.knots[1].knot.turn.t_s); }},
      {"new knots", [](State& s, World&) { nudge(s.knots[0].knot.u.x); }},
      {"new knots", [](State& s, World&) { s.knots[2].body += 1; }},
      {"new knots", [](State& s, World&) { s.knots.pop_back(); }},
      {"new events", [](State& s, World&) { s.record.eventsKept -= 1; }},
      {"new events", [](State& s, World&) { nudge(s.events[0].at.r_m.z); }},
      {"new events", [](State& s, World&) { s.events[1].kind = EventKind::flash; }},
      {"new events", [](State& s, World&) { s.events[2].cushion = Cushion::plusY; }},
      {"new events", [](State& s, World&) { nudge(s.events[0].turns[0].betaAfter.y); }},
      {"new events", [](State& s, World&) { s.events.pop_back(); }},
      {"events", [](State&, World& w) { w.events.pop_back(); }},
      {"events", [](State&, World& w) { nudge(w.events[2].heat_j); }},
      {"histories, body 1, turns",
       [](State& s, World& w) {
         w.histories[1].truncateFrom(302.0);
         nudge(s.knots[2].knot.turn.r_m.x);
         w.histories[1].append(s.knots[2].knot);
         s.knots[2].knot.turn.r_m.x = 0.0;
       }},
      {"histories, body 1, number of knots", [](State&, World& w) { w.histories[1].truncateFrom(301.0); }}};
  cluster->nameNodes({});
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(testing::Message() << "difference " << i);
    FrameState state = cluster->rank() == 0 ? frameWithKnots(3) : FrameState{};
    cluster->share(state);
    World world{{history(), history()}, {}};
    for (BodyKnot& knot : state.knots) knot.body = 1;
    applyFrame(state, world);
    if (cluster->rank() == cluster->size() - 1) all[i].plant(state, world);
    try {
      swapTogether(state, world, false);
      FAIL() << "the difference went unnoticed";
    } catch (const NodesDiffer& error) {
      const std::string said = error.what();
      const std::string expected =
          fmt::format("node {} drew from other numbers than node 0: {}", cluster->size() - 1, all[i].field);
      EXPECT_TRUE(said.ends_with(expected)) << said << "; expected " << expected;
    }
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
  World world{{history()}, {}};
  FrameState state = cluster->rank() == 0 ? frameWithKnots(0) : FrameState{};
  cluster->share(state);
  EXPECT_FALSE(swapTogether(state, world, false));
  cluster->share(state);
  EXPECT_TRUE(swapTogether(state, world, cluster->rank() == cluster->size() - 1));
}

TEST(Cluster, TheLowestFailedRankIsKnownToAll) {
  EXPECT_EQ(cluster->firstFailed(false), -1);
  EXPECT_EQ(cluster->firstFailed(cluster->rank() == cluster->size() - 1), cluster->size() - 1);
  EXPECT_EQ(cluster->firstFailed(true), 0);
}

TEST(Cluster, RankZeroHoldsWhatEachNodeSaidWithItsLastFrame) {
  World world{{history()}, {}};
  for (std::uint64_t number = 5; number < 9; ++number) {
    FrameState state = cluster->rank() == 0 ? frameWithKnots(0) : FrameState{};
    NodeReport mine;
    mine.stamps.frame = number - 1;
    mine.stamps[FramePart::draw] = static_cast<float>(number) + 0.25F * static_cast<float>(cluster->rank());
    mine.lock = cluster->rank() % 2 == 0 ? LockState::joined : LockState::lost;
    cluster->report(mine);
    cluster->share(state);
    swapTogether(state, world, false);
    for (int rank = 0; cluster->rank() == 0 && rank < cluster->size(); ++rank) {
      const NodeReport& report = cluster->reportOf(rank);
      EXPECT_EQ(report.stamps.frame, number - 1) << "rank " << rank;
      EXPECT_EQ(report.stamps[FramePart::draw],
                static_cast<float>(number) + 0.25F * static_cast<float>(rank));
      EXPECT_EQ(report.lock, rank % 2 == 0 ? LockState::joined : LockState::lost);
    }
  }
}

TEST(Cluster, TruncationComesBeforeTheNewKnots) {
  World world{{history(), history(), history()}, {}};  // the board, a puck, a scripted body
  FrameState first = frameWithKnots(3);                // turns at 300, 301, 302
  for (BodyKnot& knot : first.knots) knot.body = 1;
  applyFrame(first, world);
  for (BodyKnot& knot : first.knots) knot.body = 2;
  applyFrame(first, world);
  FrameState rewound = frameWithKnots(4);  // 400 … 403
  for (BodyKnot& knot : rewound.knots) knot.body = 1;
  rewound.record.truncateFrom_s = 301.0;
  rewound.record.pucks = 1;
  applyFrame(rewound, world);
  ASSERT_EQ(world.histories[1].knots().size(), 6U);
  EXPECT_EQ(world.histories[1].knots()[1].turn.t_s, 300.0);
  EXPECT_EQ(world.histories[1].knots()[2].turn.t_s, 400.0);
  EXPECT_EQ(world.histories[2].knots().size(), 4U) << "a scripted body lost its turns";
}

TEST(Cluster, EventsAreTakenBackFromANumberOnAndForgottenFromTheFirst) {
  World world{{history(), history()}, {}};
  FrameState state = frameWithKnots(5);  // events 0 … 4 at 500 … 504 s
  state.knots.clear();
  applyFrame(state, world);
  state = frameWithKnots(4);  // 0 … 3 at 400 … 403 s
  state.knots.clear();
  state.events.erase(state.events.begin(), state.events.begin() + 2);
  state.record.eventsKept = 2;
  applyFrame(state, world);
  const auto times = [&] {
    std::vector<double> times_s;
    for (const GameEvent& event : world.events) times_s.push_back(event.at.t_s);
    return times_s;
  };
  EXPECT_EQ(times(), (std::vector<double>{500.0, 501.0, 402.0, 403.0}));
  applyFrame(FrameState{}, world);
  EXPECT_EQ(times().size(), 4U) << "a frame without signal";
  FrameState later;
  later.record.forgetBefore_s = 501.0;
  later.record.pucks = 1;
  world.events[1].turns[0].event.t_s = 600.0;  // its signal is still on its way
  applyFrame(later, world);
  EXPECT_EQ(times(), (std::vector<double>{501.0, 402.0, 403.0}));
}

}  // namespace
}  // namespace carom

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  carom::Cluster theCluster;
  carom::cluster = &theCluster;
  return RUN_ALL_TESTS();
}
