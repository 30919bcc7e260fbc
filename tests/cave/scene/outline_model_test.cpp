// The prisms over outlines that are drawn as pucks with corners.
#include "cave/scene/outline_model.h"

#include <gtest/gtest.h>
#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkTriangleFilter.h>

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/polygons/outline.h"

namespace carom {
namespace {

using Corners = std::vector<glm::dvec2>;

vtkSmartPointer<vtkPolyData> trianglesOf(const vtkSmartPointer<vtkPolyData>& prism) {
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(prism);
  triangles->Update();
  return triangles->GetOutput();
}

/// By the Gauss theorem from the surface, which therefore has to look outwards, against the area of the
/// outline.
TEST(OutlineModel, PrismsHaveTheVolumeOfTheirOutlines) {
  constexpr double kHeight_m = 0.03;
  const std::vector<Corners> outlines{{{-0.06, -0.01}, {0.06, -0.01}, {0.06, 0.01}, {-0.06, 0.01}},
                                      {{0.05, -0.04},
                                       {0.05, 0.04},
                                       {0.03, 0.04},
                                       {0.03, -0.02},
                                       {-0.03, -0.02},
                                       {-0.03, 0.04},
                                       {-0.05, 0.04},
                                       {-0.05, -0.04}},
                                      {{-0.03, -0.02}, {0.03, -0.02}, {0.0, 0.04}}};
  for (const Corners& outline : outlines) {
    const auto surface = trianglesOf(prismOver(outline, kHeight_m));
    const double volume_m3 = momentsOf(outline).area * kHeight_m;
    double signed_m3 = 0.0;
    for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell) {
      std::array<glm::dvec3, 3> p;
      for (vtkIdType k = 0; k < 3; ++k)
        surface->GetPoint(surface->GetCell(cell)->GetPointId(static_cast<int>(k)), &p[k].x);
      signed_m3 += glm::dot(p[0], glm::cross(p[1], p[2])) / 6.0;
    }
    EXPECT_NEAR(signed_m3, volume_m3, 1e-12 * volume_m3) << outline.size() << " corners";
    vtkNew<vtkFeatureEdges> open;
    open->SetInputData(surface);
    open->FeatureEdgesOff();
    open->NonManifoldEdgesOn();
    open->ManifoldEdgesOff();
    open->BoundaryEdgesOn();
    open->Update();
    EXPECT_EQ(open->GetOutput()->GetNumberOfCells(), 0) << "it is closed";
    std::array<double, 6> box{};
    surface->GetBounds(box.data());
    EXPECT_EQ(box[4], -0.5 * kHeight_m);
    EXPECT_EQ(box[5], 0.5 * kHeight_m);
  }
}

}  // namespace
}  // namespace carom
