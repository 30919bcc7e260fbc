// Checks of two walls together: edges, planes, eyes and windows.
#include "app/room_checks/wall_pair_checks.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <glm/vec3.hpp>
#include <random>
#include <string>
#include <vector>

#include "app/fault_names.h"
#include "app/room_checks/judged_room.h"
#include "app/room_checks/room_check.h"

namespace carom {
namespace {

using test::allOf;
using test::kRoom;
using test::Mistake;
using test::Mistakes;
using test::roomWith;
using test::secondWall;
using test::with;

TEST(RoomCheck, SaysHowFarAMovedWallIsFromItsNeighbours) {
  const unsigned seed = 11;
  std::mt19937 random(seed);
  for (int i = 0; i < 50; ++i) {
    // The front wall moved off by more than may be and less than is on purpose.
    const double moved_m = std::uniform_real_distribution(0.0022, 0.098)(random);
    Room room = roomWith({});
    for (glm::dvec3* corner : {&room.walls[0].wall.lowerLeft_m, &room.walls[0].wall.lowerRight_m,
                               &room.walls[0].wall.upperLeft_m}) {
      corner->z -= moved_m;
    }
    char expected[32];
    std::snprintf(expected, sizeof expected, "by %.1f mm", moved_m * 1e3);
    const std::vector<Finding> findings = judgeRoom(room);
    ASSERT_EQ(findings.size(), 2u) << "seed " << seed << ", moved by " << moved_m << '\n' << allOf(findings);
    for (const Finding& finding : findings) {
      EXPECT_NE(finding.text.find(expected), std::string::npos) << "seed " << seed << ": " << finding.text;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Pairs, Mistakes,
    ::testing::Values(Mistake{"an edge apart",
                              {{11, "lower_left = [-1.5, 0, -1.524]"},
                               {12, "lower_right = [1.5, 0, -1.524]"},
                               {13, "upper_left = [-1.5, 3, -1.524]"}},
                              21,
                              14,
                              {"'front' and 'left' miss each other by 24.0 mm"},
                              2},
                      Mistake{
                          "ends apart",
                          secondWall("left", "[-1.5, 0.02, 1.5]", "[-1.5, 0.02, -1.5]", "[-1.5, 3.02, 1.5]"),
                          21,
                          14,
                          {"'front' and 'left' miss each other by 20.0 mm"},
                          2},
                      Mistake{"a floor too high",
                              {{27, "lower_left = [-1.5, 0.01, 1.5]"},
                               {28, "lower_right = [1.5, 0.01, 1.5]"},
                               {29, "upper_left = [-1.5, 0.01, -1.5]"}},
                              29,
                              14,
                              {"'left' and 'floor' miss each other by 10.0 mm"},
                              2},
                      Mistake{"a tile off the plane",
                              secondWall("front-b", "[1.5, 0, -1.51]", "[4.5, 0, -1.51]", "[1.5, 3, -1.51]"),
                              21,
                              14,
                              {"tiles 'front' and 'front-b' are 10.0 mm off one plane"}},
                      Mistake{"eyes' walls apart",
                              with(secondWall("front-r", "[-1.495, 0, -1.5]", "[1.505, 0, -1.5]",
                                              "[-1.495, 3, -1.5]", kRoom[23] + " \nstereo = 'right'"),
                                   {{16, kRoom[15] + " # left\nstereo = 'left'"}}),
                              22,
                              14,
                              {"the two eyes' walls 'front' and 'front-r' differ by 5.0 mm at a corner"},
                              2},
                      Mistake{"one wall twice",
                              secondWall("screen", "[-1.5, 0, -1.5]", "[1.5, 0, -1.5]", "[-1.5, 3, -1.5]"),
                              17,
                              1,
                              {"'front' and 'screen' are on the same place and show the same eyes"}},
                      Mistake{"walls that cut",
                              with(secondWall("screen", "[-1, 0.5, -2]", "[1, 0.5, -1]", "[-1, 2.5, -2]",
                                              "window = { size = [671, 600] }"),
                                   {{22, "pixels = [671, 600]"}}),
                              17,
                              1,
                              {"cut through each other, 500 mm inside the edge"}},
                      Mistake{"windows on each other",
                              {{23, "node = 0"},
                               {24, "window = { size = [600, 600], position = [500, 100] }"},
                               {31, "node = 1"}},
                              24,
                              10,
                              {"overlap by 100 × 500 pixels on monitor 0 of rank 0"}}),
    test::nameOfFault);

}  // namespace
}  // namespace carom
