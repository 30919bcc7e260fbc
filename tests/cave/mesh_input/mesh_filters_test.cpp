// What VTK's filters and writers make of meshes, in the library that is loaded for it.
#include "cave/mesh_input/mesh_filters.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "cave/mesh_input/mesh_library.h"

namespace carom {
namespace {

vtkSmartPointer<vtkPolyData> meshOf(const std::vector<std::array<double, 3>>& places,
                                    const std::vector<std::vector<vtkIdType>>& faces) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& place : places) points->InsertNextPoint(place.data());
  vtkNew<vtkCellArray> polygons;
  for (const auto& face : faces) polygons->InsertNextCell(static_cast<vtkIdType>(face.size()), face.data());
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polygons);
  return mesh;
}

/// A plate of 2 m by 0.9 m with a triangle beside it.
vtkSmartPointer<vtkPolyData> plate() {
  return meshOf({{0, 0, 0}, {2, 0, 0}, {2, 0.9, 0}, {0, 0.9, 0}, {3, 0, 0}}, {{0, 1, 2, 3}, {1, 4, 2}});
}

double areaOf(vtkPolyData& triangles) {
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(&triangles);
  return mass->GetSurfaceArea();
}

std::string complaint(vtkPolyData& mesh) {
  try {
    meshLibrary().triangleBytes(mesh);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing is wrong";
}

TEST(MeshFilters, BytesHoldThePointsAndTheTriangles) {
  const auto mesh = plate();
  const std::string bytes = meshLibrary().triangleBytes(*mesh);
  ASSERT_EQ(bytes.size(), 8U + 5U * 12U + 3U * 12U);
  std::uint64_t points = 0;
  std::array<float, 15> places{};
  std::array<std::int32_t, 9> corners{};
  std::memcpy(&points, bytes.data(), 8);
  std::memcpy(places.data(), bytes.data() + 8, 60);
  std::memcpy(corners.data(), bytes.data() + 68, 36);
  EXPECT_EQ(points, 5U);
  EXPECT_EQ(places[6], 2.0F);
  EXPECT_EQ(places[7], 0.9F);
  double area = 0.0;  // half the cross product of two sides: above 0 as the triangles keep their sense
  for (std::size_t i = 0; i < 9; i += 3) {
    const auto part = [&](std::size_t corner, std::size_t axis) {
      const std::int32_t at = corners.at(i + corner);
      return static_cast<double>(places.at(3 * static_cast<std::size_t>(at) + axis));
    };
    const double twice = (part(1, 0) - part(0, 0)) * (part(2, 1) - part(0, 1)) -
                         (part(1, 1) - part(0, 1)) * (part(2, 0) - part(0, 0));
    EXPECT_GT(twice, 0.0);
    area += 0.5 * twice;
  }
  EXPECT_NEAR(area, 2.25, 1e-6);
}

TEST(MeshFilters, WrongMeshesAreRefused) {
  EXPECT_NE(complaint(*meshOf({{0, 0, 0}}, {})).find("expected polygons"), std::string::npos);
  EXPECT_EQ(complaint(*meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}})),
            "a polygon has corner 3, expected one of the 3 points");
  for (const double far : {1.1e9, std::numeric_limits<double>::quiet_NaN()}) {
    const std::string heard = complaint(*meshOf({{0, 0, 0}, {1, 0, far}, {0, 1, 0}}, {{0, 1, 2}}));
    EXPECT_TRUE(heard.starts_with("point 1 is at (1, 0, ")) << heard;
  }
}

TEST(MeshFilters, DividedMeshesCoverTheSameArea) {
  const auto triangles = meshLibrary().cutToTriangles(*plate());
  EXPECT_EQ(triangles->GetNumberOfPolys(), 3);
  EXPECT_NEAR(areaOf(*triangles), 2.25, 1e-6);
  const auto halved = meshLibrary().longEdgesHalved(*triangles, 1.5);
  EXPECT_NEAR(areaOf(*halved), 2.25, 1e-6);
  EXPECT_GT(halved->GetNumberOfPolys(), 3);
  EXPECT_EQ(meshLibrary().longEdgesHalved(*triangles, 3.0)->GetNumberOfPolys(), 3);
}

TEST(MeshFilters, PointsAreMoved) {
  vtkNew<vtkTransform> quarter;
  quarter->Translate(0.0, 0.0, 4.0);
  quarter->RotateZ(90.0);
  const auto moved = meshLibrary().transformed(*plate(), *quarter);
  std::array<double, 3> place{};
  moved->GetPoint(2, place.data());
  EXPECT_NEAR(place[0], -0.9, 1e-6);
  EXPECT_NEAR(place[1], 2.0, 1e-6);
  EXPECT_NEAR(place[2], 4.0, 1e-6);
}

}  // namespace
}  // namespace carom
