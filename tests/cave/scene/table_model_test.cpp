// The table and its clocks.
#include "cave/scene/table_model.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <glm/vec3.hpp>

namespace carom {
namespace {

TEST(TableModel, StandsOnTheFloorAndHasItsClothAtHeightZero) {
  constexpr double kFloor_m = -0.8;
  double lowest_m = 0.0;
  int cloths = 0;
  for (const ScenePart& part : tableParts({2.84, 1.42}, kFloor_m)) {
    const double* const box = part.mesh->GetBounds();
    lowest_m = std::min(lowest_m, box[4]);
    EXPECT_GE(box[5], 0.0);
    if (part.paint != Paint::cloth) continue;
    ++cloths;
    const std::array<double, 6> expected{-1.42, 1.42, -0.71, 0.71, 0.0, 0.0};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(box[i], expected.at(i), 1e-6) << i;
  }
  EXPECT_EQ(cloths, 1);
  EXPECT_NEAR(lowest_m, kFloor_m, 1e-6);
}

// A clock has two faces, before and behind, that look both ways; its digits run to the right of whoever reads
// them.
TEST(ClockMaker, AClockIsReadFromBothSides) {
  constexpr double kWidth_m = 0.2;
  const glm::dvec3 foot_m(1.0, 2.0, 0.5);
  ClockMaker clocks;
  clocks.add(foot_m, {0.0, -1.0, 0.0}, kWidth_m, kAnyCell_m);
  int faces = 0;
  for (const ScenePart& part : clocks.parts()) {
    if (part.paint != Paint::clock) continue;
    ++faces;
    vtkDataArray* const surface = part.mesh->GetPointData()->GetArray("surface");
    vtkDataArray* const normals = part.mesh->GetPointData()->GetNormals();
    ASSERT_TRUE(surface && normals);
    double forwards = 0.0;
    for (vtkIdType i = 0; i < part.mesh->GetNumberOfPoints(); ++i) {
      const double* const place_m = part.mesh->GetPoint(i);
      const double aside_m = place_m[0] - foot_m.x, out = normals->GetComponent(i, 1);
      EXPECT_NEAR(std::abs(out), 1.0, 1e-6);
      EXPECT_GT((place_m[1] - foot_m.y) * out, 0.0) << "each face looks away from the clock";
      EXPECT_NEAR(place_m[2] - foot_m.z, 0.5 * 0.46 * kWidth_m, 0.5 * 0.46 * kWidth_m + 1e-6);
      EXPECT_LE(std::abs(aside_m), 0.5 * kWidth_m + 1e-6);
      // Whoever looks along y has x at the right; 2 is the middle of the field's four digits.
      const double right_m = out < 0.0 ? aside_m : -aside_m;
      EXPECT_NEAR(surface->GetComponent(i, 0), 2.0 + 4.0 * right_m / (0.9 * kWidth_m), 1e-5);
      forwards += out;
    }
    EXPECT_NEAR(forwards, 0.0, 1e-6) << "as much of it on either side";
  }
  EXPECT_EQ(faces, 1);
}

}  // namespace
}  // namespace carom
