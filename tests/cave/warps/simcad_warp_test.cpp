// Meshes of projectors as SimCAD writes them.
#include "cave/warps/warp_formats.h"

#include <gtest/gtest.h>

#include "cave/mesh_files/measured_faults.h"

namespace carom {
namespace {

using test::complaint;
using test::expectSaid;

TEST(WarpFiles, WrongOnesOfSimcadAreRefusedWithTheirPlace) {
  expectSaid(complaint([] { parseSimcadWarp("<GeometryFile/>"); }), "1:1: there is no <X-FlatParameters>");
  expectSaid(complaint([] {
               parseSimcadWarp(
                   "<G>\n<X-FlatParameters range='8'>0 0 0 0</X-FlatParameters>"
                   "<Y-FlatParameters range='8'>0 0 x 0</Y-FlatParameters></G>");
             }),
             "2:55: number 3 of <Y-FlatParameters> is wrong");
  expectSaid(complaint([] {
               parseSimcadWarp(
                   "<G><X-FlatParameters range='8'>0 0 0</X-FlatParameters>"
                   "<Y-FlatParameters range='8'>0 0 0</Y-FlatParameters></G>");
             }),
             "there are 3 numbers for x and 3 for y");
  expectSaid(complaint([] { parseSimcadWarp("<!DOCTYPE a [<!ENTITY b 'c'>]><a/>"); }),
             "declares a document type");
  expectSaid(complaint([] { parseSimcadWarp("<a>"); }), "this is no XML");
}

// The offsets are shares of the range, to the right and down, from a square grid over the picture.
TEST(WarpFiles, SimcadsOffsetsStartAtASquareGrid) {
  const Warp warp = parseSimcadWarp(
      "<GeometryFile><X-FlatParameters range='8'>2 0 0 -1</X-FlatParameters>"
      "<Y-FlatParameters range='4'>1 0 0 -2</Y-FlatParameters></GeometryFile>");
  ASSERT_EQ(warp.left.points.size(), 4U);
  EXPECT_EQ(warp.left.points[0].inPicture, glm::vec2(0.0F, 1.0F));
  EXPECT_EQ(warp.left.points[0].inWindow, glm::vec2(0.25F, 0.75F));
  EXPECT_EQ(warp.left.points[1].inPicture, glm::vec2(1.0F, 1.0F));
  EXPECT_EQ(warp.left.points[1].inWindow, glm::vec2(1.0F, 1.0F));
  EXPECT_EQ(warp.left.points[3].inPicture, glm::vec2(1.0F, 0.0F));
  EXPECT_EQ(warp.left.points[3].inWindow, glm::vec2(0.875F, 0.5F));
  EXPECT_EQ(warp.left.triangles.size(), 2U);
}

}  // namespace
}  // namespace carom
