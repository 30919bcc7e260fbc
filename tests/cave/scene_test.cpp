#include "cave/scene.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "cave/puck_model.h"

namespace carom {
namespace {

const std::vector<BodyLooks> kPucks{
    {"white", "", 0.0305, 0.02}, {"yellow", "", 0.0305, 0.02}, {"red", "", 0.0305, 0.02}};

BilliardSetup boardOf(double length_m, double width_m) {
  BilliardSetup setup;
  setup.board = Board{length_m, width_m};
  return setup;
}

std::string failureOf(const std::string& meshPath) {
  try {
    meshPart(meshPath, 0.03, 1, {});
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(Scene, EveryPointIsFiniteAndHasAUnitNormalAndPaint) {
  const Scene scene = buildScene(boardOf(2.84, 1.42), kPucks);
  EXPECT_EQ(scene.bodyCount, 4U);
  vtkIdType points = 0;
  for (const ScenePart& part : scene.parts) {
    ASSERT_LT(part.body, scene.bodyCount);
    ASSERT_GT(part.mesh->GetNumberOfPolys(), 0);
    vtkDataArray* normals = part.mesh->GetPointData()->GetNormals();
    ASSERT_NE(normals, nullptr);
    ASSERT_NE(part.mesh->GetPointData()->GetArray("surface"), nullptr);
    points += part.mesh->GetNumberOfPoints();
    for (vtkIdType i = 0; i < part.mesh->GetNumberOfPoints(); ++i) {
      const double* n = normals->GetTuple3(i);
      ASSERT_NEAR(std::hypot(n[0], n[1], n[2]), 1.0, 1e-5)
          << "part " << &part - scene.parts.data() << " point " << i;
      const double* p = part.mesh->GetPoint(i);
      ASSERT_TRUE(std::abs(p[0]) < 20 && std::abs(p[1]) < 20 && std::abs(p[2]) < 20);
    }
  }
  EXPECT_GT(points, 30000);
  EXPECT_LT(points, 60000);
}

TEST(Scene, AnOpenPlaneHasAHallTooAndToldBodiesAreRods) {
  const std::vector<BodyLooks> told{{"rod", "", 0.0, 0.0}};
  const Scene scene = buildScene({}, kPucks, told);
  EXPECT_EQ(scene.bodyCount, 5U);
  const ScenePart* rod = nullptr;
  for (const ScenePart& part : scene.parts) rod = part.body == 4 ? &part : rod;
  ASSERT_NE(rod, nullptr);
  EXPECT_NEAR(rod->mesh->GetBounds()[0], -0.5, 1e-6);
  EXPECT_NEAR(rod->mesh->GetBounds()[1], 0.5, 1e-6);
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

TEST(Scene, ALargeBoardGetsALargerHall) {
  double widest = 0.0;
  for (const ScenePart& part : buildScene(boardOf(10.0, 10.0), kPucks).parts)
    widest = std::max(widest, part.mesh->GetBounds()[1]);
  EXPECT_NEAR(widest, 10.0, 1e-6);
}

TEST(Scene, AMeshFileIsScaledToTheRadiusAndDivided) {
  const auto path =
      std::filesystem::temp_directory_path() / ("carom_scene_test_" + std::to_string(getpid()) + ".obj");
  std::ofstream(path) << "v 10 0 0\nv 14 0 0\nv 14 4 0\nv 10 4 0\nv 12 2 3\n"
                         "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
  const ScenePart part = meshPart(path.string(), 0.05, 1, {1, 1, 1});
  std::filesystem::remove(path);
  const double* box = part.mesh->GetBounds();
  const double side_m = 0.05 / std::sqrt(2.0);  // the square's corners lie on the radius
  EXPECT_NEAR(box[0], -side_m, 1e-6);
  EXPECT_NEAR(box[1], side_m, 1e-6);
  EXPECT_NEAR(box[4] + box[5], 0.0, 1e-6);
  EXPECT_GT(part.mesh->GetNumberOfPolys(), 200);
}

TEST(Scene, MeshFilesThatCannotBeReadAreNamed) {
  EXPECT_NE(failureOf("/no/such.obj").find("/no/such.obj"), std::string::npos);
  EXPECT_NE(failureOf("/etc/hostname").find("expected a .obj"), std::string::npos)
      << failureOf("/etc/hostname");
  const auto path =
      std::filesystem::temp_directory_path() / ("carom_scene_bad_" + std::to_string(getpid()) + ".obj");
  std::ofstream(path) << "this is no mesh\n";
  EXPECT_NE(failureOf(path.string()).find("no surface"), std::string::npos) << failureOf(path.string());
  std::filesystem::remove(path);
}

TEST(Scene, NamesGiveColoursAndOthersDiffer) {
  EXPECT_GT(colourOf("white", 0).g, 0.5F);
  EXPECT_GT(colourOf("red", 0).r, 10.0F * colourOf("red", 0).g);
  EXPECT_NE(colourOf("Ada", 0), colourOf("Bob", 1));
}

}  // namespace
}  // namespace carom
