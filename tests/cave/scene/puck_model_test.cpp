// Pucks that are built, and meshes from files.
#include "cave/scene/puck_model.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "cave/mesh_input/mesh_file.h"
#include "cave/scene/scene_edges.h"

namespace carom {
namespace {

using test::edgesOf;
using test::longestOf;

/// A pyramid 4 wide and 3 high, closed.
vtkSmartPointer<vtkPolyData> pyramid() {
  const auto path =
      std::filesystem::temp_directory_path() / ("carom_scene_test_" + std::to_string(getpid()) + ".obj");
  std::ofstream(path) << "v 10 0 0\nv 14 0 0\nv 14 4 0\nv 10 4 0\nv 12 2 3\n"
                         "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
  const auto mesh = readMeshFile(path.string());
  std::filesystem::remove(path);
  return mesh;
}

TEST(Scene, APuckFillsItsRadiusAndHeight) {
  for (const ScenePart& part : puckParts(0.0305, 0.02, 1, {})) {
    if (part.paint != Paint::puck) continue;
    const double* box = part.mesh->GetBounds();
    EXPECT_NEAR(box[1], 0.0305, 1e-6);
    EXPECT_NEAR(box[2], -0.0305, 1e-4);
    EXPECT_NEAR(box[4], -0.01, 1e-7);
    EXPECT_NEAR(box[5], 0.01, 1e-7);
  }
}

TEST(Scene, AMeshFileIsScaledToTheRadiusAndDividedWithoutCracks) {
  Tessellation fine;
  fine.pixel_rad = 2e-4;
  const ScenePart part = meshPart(pyramid(), 0.05, 1, {1, 1, 1}, fine);
  const double* box = part.mesh->GetBounds();
  const double side_m = 0.05 / std::sqrt(2.0);  // the square's corners lie on the radius
  EXPECT_NEAR(box[0], -side_m, 1e-6);
  EXPECT_NEAR(box[1], side_m, 1e-6);
  EXPECT_NEAR(box[4] + box[5], 0.0, 1e-6);
  const auto edges = edgesOf({&part, 1});
  EXPECT_GT(edges.size(), 500U);
  constexpr double kRounding_m = 3e-6;  // of places to micrometres
  EXPECT_LE(longestOf(edges), fine.edge_m() + kRounding_m);
  EXPECT_GT(longestOf(edges), 0.4 * fine.edge_m()) << "divided finer than needed";
  for (const auto& [ends, count] : edges) ASSERT_EQ(count, 2) << "a crack at " << ends[0] << ", " << ends[1];
}

TEST(Scene, AMeshIsNotDividedPastTheMostVertices) {
  Tessellation fine;
  fine.pixel_rad = 1e-7;
  fine.mostVertices = 3000;
  const ScenePart part = meshPart(pyramid(), 0.05, 1, {1, 1, 1}, fine);
  const auto edges = edgesOf({&part, 1});
  EXPECT_LT(part.mesh->GetNumberOfPoints(), 4000) << "corners doubled where the surface bends";
  EXPECT_GT(part.mesh->GetNumberOfPoints(), 700);
  EXPECT_GT(longestOf(edges), fine.edge_m());
  for (const auto& [ends, count] : edges) ASSERT_EQ(count, 2);
}

}  // namespace
}  // namespace carom
