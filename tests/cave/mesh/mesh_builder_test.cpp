#include "cave/mesh/mesh_builder.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>

namespace carom {
namespace {

TEST(MeshBuilder, AFlatHasItsAreaAndFacesItsOuterSide) {
  MeshBuilder builder;
  builder.addFlat({1, 2, 3}, {2, 0, 0}, {0, 1.5, 0}, 0.1);
  const auto mesh = builder.build();
  EXPECT_EQ(mesh->GetNumberOfPoints(), 21 * 17) << "16 are tiles of 4, 15 are not";
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2 * 20 * 16);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(mesh);
  EXPECT_NEAR(mass->GetSurfaceArea(), 3.0, 1e-5);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i) {
    EXPECT_NEAR(mesh->GetPointData()->GetNormals()->GetComponent(i, 2), 1.0, 1e-6);
  }
}

// A cylinder with lids, its profile running upwards: area 2πr(r + h), normals outwards.
TEST(MeshBuilder, ATurnedCylinderHasItsAreaAndOutwardNormals) {
  MeshBuilder builder;
  const double r = 0.5;
  const double h = 2.0;
  builder.addTurned({0, 0, 0}, {{0, 0}, {r, 0}, {r, h}, {0, h}}, 400, kAnyCell_m);
  const auto mesh = builder.build();
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(mesh);
  EXPECT_NEAR(mass->GetSurfaceArea(), 2 * std::numbers::pi * r * (r + h), 1e-3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i) {
    const double* normal = mesh->GetPointData()->GetNormals()->GetTuple3(i);
    const glm::dvec3 n(normal[0], normal[1], normal[2]);
    const double* place = mesh->GetPoint(i);
    const glm::dvec3 fromMiddle(place[0], place[1], place[2] - 0.5 * h);
    ASSERT_GT(glm::dot(n, fromMiddle), 0.1) << "point " << i;
  }
}

TEST(MeshBuilder, ATurnedSurfaceIsDividedAroundAndAlong) {
  MeshBuilder builder;
  builder.addTurned({0, 0, 0}, {{0.5, 0}, {0.5, 1}}, 8, 0.1);
  EXPECT_EQ(builder.pointCount(), (32U + 1U) * (12U + 1U)) << "π m around, 1 m up";
}

// Sheared cells are cut by their shorter diagonal, or that would be the longest edge.
TEST(MeshBuilder, ShearedCellsHaveNoLongDiagonals) {
  for (const double shear : {-0.8, 0.8}) {
    MeshBuilder builder;
    builder.addFlat({0, 0, 0}, {1, 0, 0}, {shear, 1, 0}, 2.0);
    const auto mesh = builder.build();
    const std::set<vtkIdType> shorter = shear > 0 ? std::set<vtkIdType>{1, 2} : std::set<vtkIdType>{0, 3};
    for (vtkIdType cell = 0; cell < 2; ++cell) {
      vtkNew<vtkIdList> ids;
      mesh->GetCellPoints(cell, ids);
      const std::set<vtkIdType> corners(ids->begin(), ids->end());
      EXPECT_TRUE(std::includes(corners.begin(), corners.end(), shorter.begin(), shorter.end())) << shear;
    }
    vtkNew<vtkMassProperties> mass;
    mass->SetInputData(mesh);
    EXPECT_NEAR(mass->GetSurfaceArea(), 1.0, 1e-6);
  }
}

TEST(MeshBuilder, CellsAreNoLargerThanAsked) {
  EXPECT_EQ(cellsFor(1.0, 0.25), 4);
  EXPECT_EQ(cellsFor(1.01, 0.25), 5);
  EXPECT_EQ(cellsFor(0.0, 0.25), 1);
}

}  // namespace
}  // namespace carom
