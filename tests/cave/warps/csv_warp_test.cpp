// Meshes of projectors as domeprojection writes them.
#include "cave/warps/warp_formats.h"

#include <gtest/gtest.h>

#include <string>

#include "cave/mesh_files/measured_faults.h"
#include "cave/warps/warp_file.h"

namespace carom {
namespace {

using test::complaint;
using test::expectSaid;
using test::kMeshes;

TEST(WarpFiles, WrongOnesOfDomeprojectionAreRefusedWithTheirPlace) {
  const std::string head = "x;y;u;v;column;row\n0;0;0;0;0;0\n1;0;1;0;1;0\n";
  expectSaid(complaint([] {
               readWarp(kMeshes + "channel1_warp_frustum.csv", {1, 1});
             }),
             "1:1: this is the frustum of a projector, expected a mesh");
  expectSaid(complaint([] { parseCsvWarp(""); }), "1:1: there is no line");
  expectSaid(complaint([&] { parseCsvWarp(head); }), "4:1: there are 2 points in rows of 2");
  expectSaid(complaint([&] { parseCsvWarp(head + "0;nan;0;1;0;1\n"); }), "4:3: 'nan' is wrong");
  expectSaid(complaint([&] { parseCsvWarp(head + "0;1;0;1;1;1\n"); }),
             "4:1: the point is of column 1, row 1, expected column 0, row 1");
}

// Rows go down the window and the picture: the first point of the file is in the upper left of both.
TEST(WarpFiles, ACsvCountsFromTheUpperLeft) {
  const Warp warp = parseCsvWarp(
      "x;y;u;v;column;row\n0.25;0.125;0;0;0;0\n1;0;0.5;0;1;0\n1;0;1;0;2;0\n"
      "0;1;0;1;0;1\n0.5;1;0.5;1;1;1\n1;1;1;0.75;2;1\n");
  ASSERT_EQ(warp.left.points.size(), 6U);
  EXPECT_EQ(warp.left.points[0].inWindow, glm::vec2(0.25F, 0.875F));
  EXPECT_EQ(warp.left.points[0].inPicture, glm::vec2(0.0F, 1.0F));
  EXPECT_EQ(warp.left.points[5].inWindow, glm::vec2(1.0F, 0.0F));
  EXPECT_EQ(warp.left.points[5].inPicture, glm::vec2(1.0F, 0.25F));
  EXPECT_EQ(warp.left.triangles.size(), 4U);
  EXPECT_EQ(warp.right.triangles, warp.left.triangles);
}

}  // namespace
}  // namespace carom
