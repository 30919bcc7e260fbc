// Shadows on the cloth: how large they are, and where they fade.
#include "cave/scene/shadow_model.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "cave/mesh/mesh_builder.h"

namespace carom {
namespace {

constexpr double kPuckHeight_m = 0.02;

/// The area of each light's shadow, of triangles that face up.
std::array<double, kShadowLights> areasOf(vtkPolyData& mesh) {
  std::array<double, kShadowLights> areas{};
  vtkDataArray* const surface = mesh.GetPointData()->GetArray("surface");
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell) {
    vtkNew<vtkIdList> ids;
    mesh.GetCellPoints(cell, ids);
    std::array<std::array<double, 3>, 3> at{};
    for (int i = 0; i < 3; ++i) mesh.GetPoint(ids->GetId(i), at[static_cast<std::size_t>(i)].data());
    const double twice =
        (at[1][0] - at[0][0]) * (at[2][1] - at[0][1]) - (at[1][1] - at[0][1]) * (at[2][0] - at[0][0]);
    EXPECT_GT(twice, -1e-9) << "a triangle faces down";
    areas.at(static_cast<std::size_t>(surface->GetComponent(ids->GetId(0), 1))) += 0.5 * twice;
  }
  return areas;
}

TEST(ShadowModel, ADiscsShadowFadesAcrossItsRim) {
  constexpr double kRadius_m = 0.03;
  const ScenePart part = discShadow(kRadius_m, kPuckHeight_m, 5, kAnyCell_m);
  EXPECT_EQ(part.body, 5U);
  EXPECT_EQ(part.paint, Paint::shadow);
  EXPECT_TRUE(part.isRound);
  const double soft_m = shadowSoftOf_m(kPuckHeight_m), hall_m = hallShadowReachOf_m(kPuckHeight_m);
  vtkDataArray* const surface = part.mesh->GetPointData()->GetArray("surface");
  ASSERT_NE(surface, nullptr);
  for (vtkIdType i = 0; i < part.mesh->GetNumberOfPoints(); ++i) {
    const double* const place_m = part.mesh->GetPoint(i);
    EXPECT_NEAR(place_m[2], kShadowAboveCloth_m - 0.5 * kPuckHeight_m, 1e-8);
    EXPECT_NEAR(surface->GetComponent(i, 2), kPuckHeight_m, 1e-8);
    // From 0 within the ring to 1 at its border.
    const bool isHall = surface->GetComponent(i, 1) == kShadowOfHall;
    const double inner_m = isHall ? 0.95 * kRadius_m : kRadius_m - soft_m,
                 outer_m = kRadius_m + (isHall ? hall_m : soft_m);
    const double expected =
        std::max(0.0, (std::hypot(place_m[0], place_m[1]) - inner_m) / (outer_m - inner_m));
    EXPECT_NEAR(surface->GetComponent(i, 0), expected, 1e-5) << i;
  }
  const auto areas = areasOf(*part.mesh);
  for (int light = 0; light < kShadowLights; ++light) {
    const double outer_m = kRadius_m + (light == kShadowOfHall ? hall_m : soft_m),
                 circle_m2 = std::numbers::pi * outer_m * outer_m;
    EXPECT_LT(areas[static_cast<std::size_t>(light)], circle_m2) << light;
    EXPECT_GT(areas[static_cast<std::size_t>(light)], 0.99 * circle_m2) << light;  // 36 sides at least
  }
}

// Each coarser one has fewer points, and is off by more.
TEST(ShadowModel, CoarserOnesHaveFewerPoints) {
  constexpr double kRadius_m = 0.03;
  const ScenePart part = discShadow(kRadius_m, kPuckHeight_m, 1, kAnyCell_m);
  ASSERT_FALSE(part.coarser.empty());
  double before_m = 0.0;
  vtkIdType points = part.mesh->GetNumberOfPoints();
  for (const CoarserMesh& coarser : part.coarser) {
    EXPECT_GT(coarser.off_m, before_m);
    EXPECT_LT(coarser.mesh->GetNumberOfPoints(), points);
    before_m = coarser.off_m;
    points = coarser.mesh->GetNumberOfPoints();
  }
}

// The shadow of a square is the square and a border around it, bevelled at the corners: a² + 4 a s + 2 s².
TEST(ShadowModel, APrismsShadowIsItsOutlineAndABorder) {
  constexpr double kSide_m = 0.06;
  const std::vector<glm::dvec2> square{{-0.03, -0.03}, {0.03, -0.03}, {0.03, 0.03}, {-0.03, 0.03}};
  const ScenePart part = outlineShadow(square, kPuckHeight_m, 2, kAnyCell_m);
  const auto areas = areasOf(*part.mesh);
  for (int light = 0; light < kShadowLights; ++light) {
    const double border_m =
        light == kShadowOfHall ? hallShadowReachOf_m(kPuckHeight_m) : shadowSoftOf_m(kPuckHeight_m);
    const double area_m2 = kSide_m * kSide_m + 4.0 * kSide_m * border_m + 2.0 * border_m * border_m;
    EXPECT_NEAR(areas[static_cast<std::size_t>(light)], area_m2, 1e-4 * area_m2) << light;
  }
}

}  // namespace
}  // namespace carom
