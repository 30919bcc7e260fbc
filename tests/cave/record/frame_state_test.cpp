// How a node's copy of the game follows the frames: knots and events that come, are taken back and forgotten.
#include "cave/record/frame_state.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;

World twoPucks() { return {std::vector<WorldLine>(3, WorldLine(Knot{}, kC_m_s)), {}, {}}; }

GameEvent eventAt(std::uint64_t number, double t_s) {
  GameEvent event;
  event.number = number;
  event.at.t_s = t_s;
  return event;
}

/// A puck at rest in the origin begins to move there.
BodyKnot knotAt(std::uint64_t body, double t_s) {
  BodyKnot added;
  added.body = body;
  added.knot.turn.t_s = t_s;
  added.knot.properTime_s = t_s;
  added.knot.signal.t_s = t_s;
  added.knot.u = {0.5, 0.0, 0.0};
  return added;
}

std::vector<std::uint64_t> numbersOf(const World& world) {
  std::vector<std::uint64_t> numbers;
  for (const GameEvent& event : world.events) numbers.push_back(event.number);
  return numbers;
}

TEST(FrameState, EventsAreAddedTakenBackAndForgotten) {
  using Numbers = std::vector<std::uint64_t>;
  World world = twoPucks();
  FrameState first;
  for (std::uint64_t number = 0; number < 4; ++number)
    first.events.push_back(eventAt(number, 1.0 + static_cast<double>(number)));
  applyFrame(first, world);
  EXPECT_EQ(numbersOf(world), (Numbers{0, 1, 2, 3}));
  FrameState back;
  back.record.eventsKept = 2;
  back.events.push_back(eventAt(2, 9.0));
  applyFrame(back, world);
  EXPECT_EQ(numbersOf(world), (Numbers{0, 1, 2}));
  EXPECT_EQ(world.events.back().at.t_s, 9.0) << "the new one of that number";
  // An event is over when its turns are, too.
  world.events[1].turns.push_back({});
  world.events[1].turns[0].event.t_s = 7.0;
  FrameState later;
  later.record.forgetBefore_s = 6.0;
  applyFrame(later, world);
  EXPECT_EQ(numbersOf(world), (Numbers{1, 2}));
}

TEST(FrameState, KnotsAreAddedToTheirBodiesAndTakenBackOfPucks) {
  World world = twoPucks();
  FrameState first;
  first.record.pucks = 1;
  first.knots = {knotAt(1, 1.0), knotAt(2, 1.5)};
  applyFrame(first, world);
  EXPECT_EQ(world.histories[0].knots().size(), 1U);
  ASSERT_EQ(world.histories[1].knots().size(), 2U);
  ASSERT_EQ(world.histories[2].knots().size(), 2U);
  EXPECT_EQ(world.histories[1].knots()[1].turn.t_s, 1.0);
  FrameState back;
  back.record.pucks = 1;
  back.record.truncateFrom_s = 0.5;
  back.knots = {knotAt(1, 0.75)};
  applyFrame(back, world);
  ASSERT_EQ(world.histories[1].knots().size(), 2U);
  EXPECT_EQ(world.histories[1].knots()[1].turn.t_s, 0.75);
  EXPECT_EQ(world.histories[2].knots().size(), 2U) << "it is no puck";
}

TEST(FrameState, RefusesBodiesThatAreNotThere) {
  World world = twoPucks();
  FrameState beside, many;
  beside.knots = {knotAt(3, 1.0)};
  many.record.pucks = 3;
  EXPECT_THROW(applyFrame(beside, world), std::out_of_range);
  EXPECT_THROW(applyFrame(many, world), std::out_of_range);
}

// Each viewer is there once in the order of one who sees, who comes first; and likewise of the room's.
TEST(FrameState, ViewersChangePlacesWithTheFirst) {
  FrameRecord record;
  record.viewerCount = kMostViewers;
  for (std::size_t viewer = 0; viewer < kMostViewers; ++viewer) record.viewers[viewer].score.strokes = viewer;
  for (std::size_t seer = 0; seer < kMostViewers; ++seer) {
    const SeenFrame seen(record, seer);
    record.firstOfRoom = seer;
    for (std::size_t index = 0; index < kMostViewers; ++index) {
      const std::size_t expected = index == 0 ? seer : index == seer ? 0 : index;
      EXPECT_EQ(seen.inOrder(index).score.strokes, expected) << seer;
      EXPECT_EQ(record.ofRoom(record.ofRoom(index)), index) << seer;
      EXPECT_EQ(record.ofRoom(index), expected) << seer;
    }
  }
}

}  // namespace
}  // namespace carom
