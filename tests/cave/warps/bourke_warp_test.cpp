// Paul Bourke's meshes of projectors.
#include "cave/warps/warp_formats.h"

#include <gtest/gtest.h>

#include <string>

#include "cave/mesh_files/measured_faults.h"

namespace carom {
namespace {

using test::complaint;
using test::expectSaid;

TEST(WarpFiles, WrongOnesOfBourkeAreRefusedWithTheirPlace) {
  expectSaid(complaint([] {
               parseBourkeWarp("2\n2 2\n-1 -1 0 0 1\n", {1, 1});
             }),
             "4:1: the file ends early, expected 2 × 2 points, of which there are 1");
  expectSaid(complaint([] { parseBourkeWarp("2\n1 2\n", {1, 1}); }), "2:1: '1' is wrong, expected columns");
}

TEST(WarpFiles, BourkesMeshHasTheWindowsAspectAndLight) {
  const std::string text =
      "2\n3 2\n-2 -1 0 0 1\n0 -1 0.5 0 0.5\n2 -1 1 0 1\n-2 1 0 1 1\n0 1 0.5 1 0.5\n2 1 1 1 -1\n";
  const Warp warp = parseBourkeWarp(text, {1600, 800});
  ASSERT_EQ(warp.left.points.size(), 6U);
  EXPECT_EQ(warp.left.points[0].inWindow, glm::vec2(0.0F));
  EXPECT_EQ(warp.left.points[4].inWindow, glm::vec2(0.5F, 1.0F));
  EXPECT_EQ(warp.left.points[1].light, 0.5F);
  EXPECT_EQ(warp.left.triangles.size(), 2U) << "the cell with the point below 0 is not drawn";
}

}  // namespace
}  // namespace carom
