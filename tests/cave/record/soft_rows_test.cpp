// Rows of soft bodies in frames: what a node keeps of them, and that nodes which differ in them are found
// out.

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "cave/record/frame_digest.h"
#include "cave/record/frame_state.h"

namespace carom {
namespace {

constexpr double kC = 1.42;

World twoBodies() { return {std::vector<WorldLine>(3, WorldLine(Knot{}, kC)), {}, {}}; }

void add(FrameState& state, std::uint64_t body, double time_m, bool wasRigid = false) {
  SoftRow row;
  row.body = body;
  row.time = time_m;
  row.nodes = 2;
  row.wasRigid = wasRigid ? 1 : 0;
  state.rows.push_back(row);
  state.rowNodes.resize(state.rowNodes.size() + 2);
}

TEST(SoftRowsInFrames, AreAddedTakenBackAndForgotten) {
  World world = twoBodies();
  FrameState frame;
  add(frame, 1, 0.0), add(frame, 1, 0.02), add(frame, 2, 0.01, true), add(frame, 1, 0.04);
  applyFrame(frame, world);
  ASSERT_EQ(world.soft.size(), 3U);
  EXPECT_EQ(world.soft[0].rows.rowCount(), 0U);
  EXPECT_EQ(world.soft[1].rows.rowCount(), 3U);
  EXPECT_FALSE(world.soft[1].rigid.has_value());
  ASSERT_TRUE(world.soft[2].rigid.has_value());

  FrameState back;
  back.record.rowsFrom_m = 0.01;
  add(back, 1, 0.03);
  applyFrame(back, world);
  EXPECT_EQ(world.soft[1].rows.rowCount(), 2U);
  EXPECT_EQ(world.soft[1].rows.row(1).time, 0.03);
  EXPECT_EQ(world.soft[2].rows.rowCount(), 0U);
  EXPECT_FALSE(world.soft[2].rigid.has_value());  // it is rigid again

  FrameState later;
  add(later, 1, 0.05), add(later, 1, 0.07);
  later.record.rowsForgottenBefore_m = 0.06;
  applyFrame(later, world);
  EXPECT_EQ(world.soft[1].rows.rowCount(), 2U);
  EXPECT_EQ(world.soft[1].rows.row(0).time, 0.05);
}

TEST(SoftRowsInFrames, RefusesWhatCannotBe) {
  World world = twoBodies();
  FrameState beside, without, late;
  add(beside, 3, 0.0);
  EXPECT_THROW(applyFrame(beside, world), std::out_of_range);
  add(without, 1, 0.0);
  without.rowNodes.pop_back();
  EXPECT_THROW(applyFrame(without, world), std::out_of_range);
  add(late, 1, 0.1), add(late, 1, 0.1);
  EXPECT_THROW(applyFrame(late, world), std::invalid_argument);
}

TEST(SoftRowsInFrames, TheLeastDifferenceOfANodeCounts) {
  FrameState frame;
  add(frame, 1, 0.0);
  const FrameDigest before = digestOf(frame, {});
  frame.rowNodes[1].strain = 1;
  const FrameDigest after = digestOf(frame, {});
  const std::size_t field = FrameDigest::kFields.size() - 1;
  EXPECT_STREQ(FrameDigest::kFields[field], "soft rows");
  for (std::size_t k = 0; k < before.fields.size(); ++k)
    EXPECT_EQ(before.fields[k] != after.fields[k], k == field) << FrameDigest::kFields[k];
  // And of what is kept.
  World one = twoBodies(), other = twoBodies();
  applyFrame(frame, one);
  frame.rowNodes[0].x = 1e-3F;
  applyFrame(frame, other);
  EXPECT_NE(digestOf({}, one).fields[field], digestOf({}, other).fields[field]);
}

}  // namespace
}  // namespace carom
