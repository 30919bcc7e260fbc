// Scenes as they are built: every part is whole, fine enough and within its reach.
#include "cave/scene/scene_builder.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "cave/scene/scene_edges.h"

namespace carom {
namespace {

using test::boardOf;
using test::edgesOf;
using test::kPucks;
using test::longestOf;

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
  EXPECT_LT(points, 64000);
}

TEST(Scene, AnOpenPlaneHasAHallTooAndScriptedBodiesAreRods) {
  const std::vector<BodyLooks> told{{"rod", "", 0.0, 0.0}};
  const Scene scene = buildScene({}, kPucks, told);
  EXPECT_EQ(scene.bodyCount, 5U);
  const ScenePart* rod = nullptr;
  for (const ScenePart& part : scene.parts) rod = part.body == 4 ? &part : rod;
  ASSERT_NE(rod, nullptr);
  EXPECT_NEAR(rod->mesh->GetBounds()[0], -0.5, 1e-6);
  EXPECT_NEAR(rod->mesh->GetBounds()[1], 0.5, 1e-6);
}

TEST(Scene, NothingIsDrawnOfABodyThatIsNot) {
  BodyLooks push{"push", "", 0.0, 0.0};
  push.isDrawn = false;
  const Scene scene = buildScene({}, kPucks, std::vector<BodyLooks>{push, {"rod", "", 0.0, 0.0}});
  EXPECT_EQ(scene.bodyCount, 6U);
  EXPECT_EQ(scene.reach_m.size(), 6U);
  std::vector<int> parts(6, 0);
  for (const ScenePart& part : scene.parts) ++parts[part.body];
  EXPECT_EQ(parts[4], 0);
  EXPECT_GT(parts[5], 0);
}

TEST(Scene, EveryBodyIsFineEnoughAndSaysSo) {
  Tessellation tessellation;
  tessellation.pixel_rad = 0.004;
  const std::vector<BodyLooks> told{{"rod", "", 0.0, 0.0}};
  const std::vector<BodyLooks> pucks{
      {"white", "", 0.0305, 0.02}, {"red", "", 0.0305, 0.02}, {"large", "", 0.15, 0.1}};
  const Scene scene = buildScene({}, pucks, told, {}, tessellation);
  for (std::size_t body = 1; body < scene.bodyCount; ++body) {
    std::vector<ScenePart> parts;
    for (const ScenePart& part : scene.parts) {
      if (part.body == body) parts.push_back(part);
    }
    constexpr double kRounding_m = 3e-6;
    EXPECT_LE(longestOf(edgesOf(parts)), tessellation.edge_m() + kRounding_m) << "body " << body;
  }
  const std::string report = tessellationReport(scene, tessellation);
  EXPECT_NE(report.find("Puck white, red: 3078 vertices each"), std::string::npos) << report;
  EXPECT_NE(report.find("The hall: "), std::string::npos) << report;
  EXPECT_NE(report.find("exact to half a pixel up to 0.95 c from 0.10 m on"), std::string::npos) << report;
}

TEST(Scene, ManyBodiesShareTheVertices) {
  const Tessellation tessellation;
  const std::vector<BodyLooks> pucks(30, {"red", "", 0.3, 0.2});
  std::size_t vertices = 0, plain = 0;
  for (const MeshNote& note : buildScene({}, pucks, {}, {}, tessellation).notes) {
    vertices += note.kind == "Puck" ? note.divided : 0;
    plain += note.kind == "Puck" ? note.vertices : 0;
  }
  ASSERT_GT(plain, tessellation.mostVertices) << "they are too many even undivided";
  EXPECT_EQ(vertices, plain);
}

TEST(Scene, WithMoreVerticesTheTableIsFineEnough) {
  Tessellation many;
  many.mostVertices = 3000000;
  const Scene scene = buildScene(boardOf(2.84, 1.42), {}, {}, {}, many);
  EXPECT_EQ(scene.notes[0].name, "table");
  EXPECT_LE(scene.notes[0].longestEdge_m, many.edge_m() * (1.0 + 1e-5));
  EXPECT_LE(scene.notes[0].divided + scene.notes[1].divided, many.mostVertices);
}

// The radius of a body's world line must hold all that is drawn of it.
TEST(Scene, TheReachHoldsEveryPoint) {
  const std::vector<BodyLooks> pucks{{"white", "", 0.03, 0.5}};
  const Scene scene = buildScene({}, pucks);
  ASSERT_EQ(scene.reach_m.size(), 2U);
  double farthest_m = 0.0;
  for (const ScenePart& part : scene.parts) {
    for (vtkIdType i = 0; part.body == 1 && i < part.mesh->GetNumberOfPoints(); ++i) {
      const double* p = part.mesh->GetPoint(i);
      farthest_m = std::max(farthest_m, std::hypot(p[0], p[1], p[2]));
    }
  }
  EXPECT_DOUBLE_EQ(scene.reach_m[1], farthest_m);
  EXPECT_GT(farthest_m, 0.25);
}

TEST(Scene, PucksThatLookAlikeShareTheirMeshesButNotTheirColours) {
  const std::vector<BodyLooks> looks{
      {"white", "", 0.03, 0.02}, {"red", "", 0.03, 0.02}, {"yellow", "", 0.05, 0.02}};
  const Scene scene = buildScene({}, looks, {}, {}, {0.001, 3000});
  std::vector<const ScenePart*> pucks;
  for (const ScenePart& part : scene.parts)
    if (part.paint == Paint::puck) pucks.push_back(&part);
  ASSERT_EQ(pucks.size(), 3U);
  EXPECT_EQ(pucks[0]->mesh, pucks[1]->mesh);
  EXPECT_NE(pucks[0]->mesh, pucks[2]->mesh);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(pucks[i]->body, i + 1);
    EXPECT_NE(pucks[i]->colour, pucks[(i + 1) % 3]->colour);
  }
  EXPECT_EQ(scene.reach_m[1], scene.reach_m[2]);
  EXPECT_LT(scene.reach_m[1], scene.reach_m[3]);
}

}  // namespace
}  // namespace carom
