// Files of measured screens: OBJ and PFM.
#include "cave/mesh_files/screen_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include <glm/geometric.hpp>

#include "cave/mesh_files/measured_bytes.h"
#include "cave/mesh_files/measured_faults.h"

namespace carom {
namespace {

using test::complaint;
using test::expectSaid;
using test::kNaN;
using test::onPlane;

TEST(ScreenFiles, AnObjHasPlacesOfTheRoomAndOfTheWindow) {
  const ScreenMesh mesh = parseObjScreen(test::objText(3, 2, onPlane));
  ASSERT_EQ(mesh.size(), 12U);
  for (const glm::dvec2& place : {glm::dvec2(0.1, 0.9), glm::dvec2(0.5, 0.5), glm::dvec2(1.0, 0.0)}) {
    const auto at_m = inRoom_m(mesh, place);
    ASSERT_TRUE(at_m);
    EXPECT_LT(glm::distance(*at_m, onPlane(place)), 1e-8);
  }
}

TEST(ScreenFiles, APfmCountsFromItsRowsEdge) {
  const std::string bytes = test::pfmBytes(
      4, 3, [](const glm::dvec2& at) { return at.x < 0.2 && at.y > 0.8 ? glm::dvec3(kNaN) : onPlane(at); });
  const ScreenGrid fromBottom = parsePfmScreen(bytes, GridRows::fromBottom),
                   fromTop = parsePfmScreen(bytes, GridRows::fromTop);
  EXPECT_LT(glm::distance(glm::dvec3(fromBottom.at(1, 0)), onPlane({1.5 / 4, 0.5 / 3})), 1e-6);
  EXPECT_LT(glm::distance(glm::dvec3(fromTop.at(1, 2)), onPlane({1.5 / 4, 0.5 / 3})), 1e-6);
  EXPECT_TRUE(std::isnan(fromBottom.at(0, 2).x));
  EXPECT_TRUE(std::isnan(fromTop.at(0, 0).x));
}

TEST(ScreenFiles, WrongOnesAreRefusedWithTheirPlace) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
  expectSaid(complaint([&] { parseObjScreen(triangle); }), "1:1: the window shows 1 triangle, expected two");
  expectSaid(complaint([] { parseObjScreen("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"); }),
             "4:3: '1' is wrong, expected both v and vt");
  expectSaid(complaint([] { parseObjScreen("v 0 nan 0\n"); }), "1:5: 'nan' is wrong");
  expectSaid(complaint([] { parseObjScreen("vt 0 -0.5\n" + test::objText(1, 1, onPlane)); }),
             "vt 1 is 0 -0.5, outside");
  std::string many;
  for (std::size_t i = 0; i <= kMostMeshPoints; ++i) many += "v 0 0 0\n";
  expectSaid(complaint([&] { parseObjScreen(many); }), "1000001:1: there are more than 1000000 v");
  expectSaid(complaint([] { parsePfmScreen("PF\n1 1\n-1\n" + std::string(12, '\0'), GridRows::fromBottom); }),
             "2:1: '1' is wrong, expected a number of columns from 2");
  expectSaid(complaint([] {
               parsePfmScreen(test::pfmBytes(4, 4, [](const glm::dvec2&) { return glm::dvec3(kNaN); }),
                              GridRows::fromBottom);
             }),
             "no four neighbours of the 4 × 4 points are on a screen");
  expectSaid(complaint([] {
               parsePfmScreen(test::pfmBytes(2, 2, [](const glm::dvec2&) { return glm::dvec3(1e10); }),
                              GridRows::fromBottom);
             }),
             "point (0, 0) has 1e+10, at byte 12");
}

}  // namespace
}  // namespace carom
