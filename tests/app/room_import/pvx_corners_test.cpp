// The corners of ParaView's machines: what is wrong with them, and the view of a machine without any.
#include "app/room_import/pvx_corners.h"

#include <gtest/gtest.h>

#include "app/import_faults.h"
#include "app/room_import/pvx_text.h"

namespace carom {
namespace {

namespace pvx = test::pvx;
using test::pvx::changed;
using test::pvx::kGood;
using test::pvx::machine;
using test::pvx::PvxFaults;

using Fault = test::ImportFault;

// The corner that is not given is opposite to LowerRight.
TEST(PvxCorners, TheFourthCornerFollowsFromThree) {
  const Room room = pvx::read(
      machine("Name='w' Geometry='400x300+0+0' LowerLeft='-2 0 -1' LowerRight='2 0 -1' UpperRight='2 3 -1'"));
  ASSERT_EQ(room.walls.size(), 1u);
  EXPECT_EQ(room.walls[0].wall.lowerLeft_m, glm::dvec3(-2, 0, -1));
  EXPECT_EQ(room.walls[0].wall.lowerRight_m, glm::dvec3(2, 0, -1));
  EXPECT_EQ(room.walls[0].wall.upperLeft_m, glm::dvec3(-2, 3, -1));
}

INSTANTIATE_TEST_SUITE_P(
    Corners, PvxFaults,
    ::testing::Values(
        // The corner at z = 0 instead of 0.05, against an edge of 1.22 m: atan(0.05 / 2.26) = 1.27 degrees.
        Fault{"junk in the middle corner",
              changed(kGood, "'1.13 -0.635 0.05'", "'1.13 -0.635  0/05'"),
              3,
              28,
              {"'0/05'", "takes it for 0", "50 mm off", "27 mm (1.27 degrees) out of square"}},
        // The wall is a rectangle whatever its depth is here: no harm to be told.
        Fault{"junk in an end",
              changed(kGood, "0.635 -1.22", "0.635 -1,22"),
              3,
              57,
              {"'-1,22'", "is no number"}},
        Fault{"junk in another end",
              changed(kGood, "'-1.13 -0.635 0.05'", "'-1.13 -0.635 O.05'"),
              2,
              75,
              {"'O.05'", "takes it for 0", "50 mm off"}},
        Fault{"a number too few",
              changed(kGood, "'1.13 -0.635 0.05'", "'1.13 -0.635'"),
              3,
              15,
              {"has 2 values"}},
        Fault{"not finite", changed(kGood, "'1.13 -0.635 0.05'", "'1.13 -0.635 nan'"), 3, 27, {"'nan'"}},
        Fault{"too far",
              changed(kGood, "'1.13 -0.635 0.05'", "'1.13 -0.635 1e10'"),
              3,
              27,
              {"out of range", "1e+09"}},
        Fault{"a corner missing",
              changed(kGood, "LowerRight='1.13 -0.635 0.05'", ""),
              2,
              1,
              {"LowerRight is missing"}},
        // As once found in the file of a room in use: -1.5 for -1.524.
        Fault{"askew",
              machine("Name='LTL' Geometry='2560x1600+0+0' LowerLeft='-1.524 -0.381 1.524'\n"
                      "LowerRight='-1.524 -0.381 -1.524' UpperRight='-1.524 1.524 -1.5'"),
              3,
              47,
              {"UpperRight of wall 'LTL' misses the right angle at LowerRight by 24.0 mm", "89.28 degrees"}},
        Fault{"no width", changed(kGood, "'-1.13 -0.635 0.05'", "'1.13 -0.635 0.05'"), 2, 62, {"no width"}},
        Fault{"no corners",
              machine("Name='localhost' Geometry='300x300+300+0'"),
              2,
              1,
              {"no corners", "1000 mm ahead", "536 × 536 mm"},
              false}),
    test::nameOfFault);

}  // namespace
}  // namespace carom
