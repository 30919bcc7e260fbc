// What a measured screen may not be, and its rim.
#include "cave/screen/mesh_faults.h"

#include <gtest/gtest.h>

#include <string>

#include "cave/screen/true_screens.h"

namespace carom {
namespace {

using namespace test;

TEST(MeshFaults, AreNamedWithTheirPlace) {
  const TrueScreen whole = ofCells(cylinder(3.0, -60.0, 60.0, {970, 330}), 20, 8);
  EXPECT_EQ(largeCellIn(whole.mesh), "");
  EXPECT_EQ(foldIn(whole.mesh), "");
  EXPECT_NE(largeCellIn(ofCells(cylinder(3.0, -60.0, 60.0, {970, 330}), 4, 8).mesh).find("an edge of 1.5"),
            std::string::npos);
  EXPECT_NE(largeCellIn(gridOf(whole, 4, 8)).find("a cell of the mesh has an edge of 1.5"),
            std::string::npos);
  // A point of the window beyond its neighbour.
  TrueScreen folded = whole;
  for (ScreenTriangle& triangle : folded.mesh) {
    for (ScreenPoint& point : triangle)
      if (glm::distance(point.inWindow, glm::dvec2(0.5, 0.5)) < 1e-9) point.inWindow.x = 0.58;
  }
  EXPECT_NE(foldIn(folded.mesh).find("folds over itself in the window"), std::string::npos)
      << foldIn(folded.mesh);
  TrueScreen bent = whole;
  for (ScreenTriangle& triangle : bent.mesh) {
    for (ScreenPoint& point : triangle)
      if (point.inWindow.x > 0.51) point.inRoom_m.x *= -1.0;  // back over its left half
  }
  EXPECT_NE(foldIn(bent.mesh).find("folds over itself in the room"), std::string::npos) << foldIn(bent.mesh);
  // Two sheets that share no edge.
  TrueScreen twice = whole;
  for (const ScreenTriangle& triangle : whole.mesh) {
    ScreenTriangle& other = twice.mesh.emplace_back(triangle);
    for (ScreenPoint& point : other) point.inRoom_m.y += 5.0;
  }
  EXPECT_NE(foldIn(twice.mesh).find("two parts of the mesh are at the same place of the window"),
            std::string::npos);
  double rim_m = 0.0;
  for (const auto& [from, to] : rimOf(whole.mesh)) rim_m += glm::distance(from.inRoom_m, to.inRoom_m);
  EXPECT_NEAR(rim_m, 2.0 * (2.5 + 3.0 * 120.0 * kDegree), 2e-2);
}

TEST(MeshFaults, PlacesAreWords) {
  EXPECT_EQ(wordsFor({{0.3132, 0.721}, {-1.5214, 0.7, -3.096}}),
            "0.313, 0.721 of the window (-1.521, 0.700, -3.096 m of the room)");
}

}  // namespace
}  // namespace carom
