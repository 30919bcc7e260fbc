// Normals of triangles against closed forms, and against VTK's filter on a mesh with all sorts of faults.
#include "cave/mesh/smooth_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>
#include <glm/geometric.hpp>

#include "engine/random_world.h"

namespace carom {
namespace {

using test::Random;
using Corners = std::array<Vec3, 3>;

/// A mesh in which each triangle has points of its own.
vtkSmartPointer<vtkPolyData> soupOf(const std::vector<Corners>& triangles) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const Corners& triangle : triangles) {
    std::array<vtkIdType, 3> ids{};
    for (std::size_t k = 0; k < 3; ++k)
      ids[k] = points->InsertNextPoint(triangle[k].x, triangle[k].y, triangle[k].z);
    cells->InsertNextCell(3, ids.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

/// A corner of a triangle: where it is and its normal.
struct Corner {
  Vec3 place{0.0}, normal{0.0};
};

std::vector<std::array<Corner, 3>> cornersOf(vtkPolyData& mesh) {
  std::vector<std::array<Corner, 3>> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh.GetNumberOfPolys(); ++i) {
    mesh.GetCellPoints(i, ids);
    auto& triangle = triangles.emplace_back();
    for (vtkIdType k = 0; k < 3; ++k) {
      Corner& corner = triangle[static_cast<std::size_t>(k)];
      mesh.GetPoint(ids->GetId(k), &corner.place.x);
      mesh.GetPointData()->GetNormals()->GetTuple(ids->GetId(k), &corner.normal.x);
    }
  }
  return triangles;
}

/// The sphere of radius 1 in two triangles for each of rings × sectors cells, those at the poles with two
/// equal corners.
std::vector<Corners> sphere(int rings, int sectors) {
  const auto at = [&](int i, int j) {
    const double polar = M_PI * i / rings, azimuth = 2.0 * M_PI * (j % sectors) / sectors;
    if (i == 0 || i == rings) return Vec3(0.0, 0.0, i == 0 ? 1.0 : -1.0);
    return Vec3(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
  };
  std::vector<Corners> triangles;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sectors; ++j) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return triangles;
}

TEST(SmoothSurface, ACubeHasItsSidesNormalsThoughSomeFacesAreTurned) {
  std::vector<Corners> triangles;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vec3 out(0.0), u(0.0), v(0.0);
      out[axis] = side;
      u[(axis + 1) % 3] = side;
      v[(axis + 2) % 3] = 1.0;
      triangles.push_back({out - u - v, out + u - v, out + u + v});
      triangles.push_back({out - u - v, out + u + v, out - u + v});
    }
  }
  for (const std::size_t i : {3U, 4U, 9U}) std::swap(triangles[i][0], triangles[i][1]);
  const auto mesh = withNormals(*withPointsMerged(*soupOf(triangles)));
  EXPECT_EQ(mesh->GetNumberOfPoints(), 24);
  for (const auto& [a, b, c] : cornersOf(*mesh)) {
    const Vec3 out = glm::normalize(glm::cross(b.place - a.place, c.place - a.place));
    EXPECT_GT(glm::dot(out, a.place), 0.9) << "turned outwards";
    for (const Corner& corner : {a, b, c}) EXPECT_LT(glm::distance(corner.normal, out), 1e-6);
  }
}

TEST(SmoothSurface, ASphereIsSmoothAndLosesWhatHasNoArea) {
  constexpr int kRings = 24, kSectors = 40;
  const auto mesh = withNormals(*withPointsMerged(*soupOf(sphere(kRings, kSectors))));
  EXPECT_EQ(mesh->GetNumberOfPoints(), (kRings - 1) * kSectors + 2);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2 * (kRings - 1) * kSectors);
  for (const auto& triangle : cornersOf(*mesh)) {
    // The mean over unevenly large triangles lies off the radius by a part of the angle of one.
    for (const Corner& corner : triangle)
      EXPECT_GT(glm::dot(corner.normal, corner.place), std::cos(M_PI / kRings));
  }
}

TEST(SmoothSurface, AgreesWithVtkOnBumpyTurnedAndTornMeshes) {
  Random random(165);
  for (int i = 0; i < 20; ++i) {
    CASE(random, i);
    std::vector<Corners> triangles;
    std::map<std::array<double, 3>, double> bump;
    for (Corners corners : sphere(12, 17)) {
      for (Vec3& corner : corners)
        corner *= bump.try_emplace({corner.x, corner.y, corner.z}, random.in(0.7, 1.3)).first->second;
      const double fate = random.in(0.0, 1.0);
      if (fate < 0.05) continue;                       // a hole
      if (fate < 0.1) corners[0] = random.inBox(1.5);  // torn off
      if (fate > 0.8 && !triangles.empty()) std::swap(corners[0], corners[1]);
      triangles.push_back(corners);
    }
    const auto soup = soupOf(triangles);
    const auto ours = cornersOf(*withNormals(*withPointsMerged(*soup)));
    vtkNew<vtkCleanPolyData> cleaned;
    cleaned->SetInputData(soup);
    cleaned->ConvertPolysToLinesOff();
    cleaned->ConvertLinesToPointsOff();
    cleaned->Update();
    vtkNew<vtkPolyDataNormals> filter;
    vtkNew<vtkPolyData> bare;
    bare->SetPoints(cleaned->GetOutput()->GetPoints());
    vtkNew<vtkCellArray> proper;  // VTK keeps what has lost a corner
    vtkNew<vtkIdList> ids;
    for (vtkIdType k = 0; k < cleaned->GetOutput()->GetNumberOfPolys(); ++k) {
      cleaned->GetOutput()->GetCellPoints(k, ids);
      const vtkIdType a = ids->GetId(0), b = ids->GetId(1), c = ids->GetId(2);
      if (a != b && b != c && c != a) proper->InsertNextCell(ids);
    }
    bare->SetPolys(proper);
    filter->SetInputData(bare);
    filter->SetFeatureAngle(40.0);
    filter->NonManifoldTraversalOff();
    filter->Update();
    const auto theirs = cornersOf(*filter->GetOutput());
    ASSERT_EQ(ours.size(), theirs.size());
    for (std::size_t t = 0; t < ours.size(); ++t) {
      for (const Corner& corner : ours[t]) {
        const auto same = std::find_if(theirs[t].begin(), theirs[t].end(), [&](const Corner& other) {
          return glm::distance(other.place, corner.place) < 1e-6;
        });
        ASSERT_NE(same, theirs[t].end()) << "triangle " << t;
        ASSERT_LT(glm::distance(same->normal, corner.normal), 1e-4) << "triangle " << t;
      }
    }
  }
}

}  // namespace
}  // namespace carom
