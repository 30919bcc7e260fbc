#include "cave/frame/body_colour.h"
#include "cave/scene/scene_builder.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "cave/mesh/mesh_file.h"
#include "cave/scene/puck_model.h"
#include "engine/light/light_cone.h"

namespace carom {
namespace {

const std::vector<BodyLooks> kPucks{
    {"white", "", 0.0305, 0.02}, {"yellow", "", 0.0305, 0.02}, {"red", "", 0.0305, 0.02}};

BilliardSetup boardOf(double length_m, double width_m) {
  BilliardSetup setup;
  setup.board = Board{length_m, width_m};
  return setup;
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

/// Every edge of these parts with how many triangles it has: ends as places, so that seams between patches
/// count as one edge.
std::map<std::array<float, 6>, int> edgesOf(std::span<const ScenePart> parts) {
  std::map<std::array<float, 6>, int> edges;
  for (const ScenePart& part : parts) {
    for (vtkIdType cell = 0; cell < part.mesh->GetNumberOfCells(); ++cell) {
      vtkNew<vtkIdList> ids;
      part.mesh->GetCellPoints(cell, ids);
      std::array<std::array<float, 3>, 3> corners{};
      for (int i = 0; i < 3; ++i) {
        std::array<double, 3> place{};
        part.mesh->GetPoint(ids->GetId(i), place.data());
        for (std::size_t k = 0; k < 3; ++k)
          corners[i][k] = static_cast<float>(std::round(place[k] * 1e6));  // µm
      }
      for (int i = 0; i < 3; ++i) {
        const auto& [a, b] = std::minmax(corners[i], corners[(i + 1) % 3]);
        if (a != b) ++edges[{a[0], a[1], a[2], b[0], b[1], b[2]}];
      }
    }
  }
  return edges;
}

double longestOf(const std::map<std::array<float, 6>, int>& edges) {
  double longest_m = 0.0;
  for (const auto& [ends, count] : edges) {
    longest_m =
        std::max(longest_m, 1e-6 * std::hypot(ends[0] - ends[3], ends[1] - ends[4], ends[2] - ends[5]));
  }
  return longest_m;
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

// Floor, walls and ceiling close the hall: where their cells differed, slow light would open cracks.
TEST(Scene, TheHallHasNoCracks) {
  for (const std::size_t most : {std::size_t{1}, std::size_t{80000}}) {
    Tessellation tessellation;
    tessellation.mostVertices = most;
    std::vector<ScenePart> shell;
    for (const ScenePart& part : buildScene(boardOf(2.84, 1.42), {}, {}, {}, tessellation).parts) {
      if (part.paint == Paint::floor || part.paint == Paint::panels) shell.push_back(part);
    }
    ASSERT_EQ(shell.size(), 6U);
    for (const auto& [ends, count] : edgesOf(shell)) {
      ASSERT_EQ(count, 2) << ends[0] << ", " << ends[1] << ", " << ends[2] << " µm";
    }
  }
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

// After a bounce the old leg may be forgotten once every point has joined the new one; a tall mesh's top
// joins later than the puck's own points.
TEST(Scene, ATallMeshJoinsItsLegsInItsOwnTime) {
  constexpr double kC_m_s = 1.42;
  Knot first;
  first.u = {1.0, 0.0, 0.0};
  WorldLine puck(first, kC_m_s, 0.0305);
  Knot second;
  second.u = {-1.0, 0.0, 0.0};
  puck.append(second);
  const std::vector<WorldLine> told{puck};
  const std::vector<double> reach_m{0.8};
  const WorldLine tall = reachingTo(told, reach_m)[0];
  EXPECT_EQ(tall.radius_m(), 0.8);
  ASSERT_EQ(tall.knots().size(), 2U);
  int joining = 0;
  for (double t_s = 0.0; t_s < 12.0; t_s += 0.05) {
    const Event eye{t_s, {0.3, -1.0, 0.2}};
    const Lorentz headFromBoard(kC_m_s);
    BodyView view;
    viewBody(tall, eye, headFromBoard, view);
    for (const Vec3 d : {Vec3(0.0, 0.0, 0.8), {0.0, 0.0, -0.8}, {0.03, 0.0, 0.0}}) {
      const auto solved = kernel::solveEmission(view.legs.data(), static_cast<int>(view.legs.size()), d);
      const Vec3 seen = kernel::seenFromEye(view.legs[static_cast<std::size_t>(solved.leg)], solved.event);
      // Rounding of metres through two boosts.
      ASSERT_LT(glm::distance(seen, emission(tall, d, eye, headFromBoard)->seen.dr_m), 1e-12)
          << "at " << t_s << " s";
      joining += solved.catchingUp ? 1 : 0;
    }
  }
  EXPECT_GT(joining, 10) << "nothing was seen catching up";
}

TEST(Scene, NamesGiveColoursAndOthersDiffer) {
  EXPECT_GT(colourOf("white", 0).g, 0.5F);
  EXPECT_GT(colourOf("red", 0).r, 10.0F * colourOf("red", 0).g);
  EXPECT_NE(colourOf("Ada", 0), colourOf("Bob", 1));
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

// What rests is divided for each eye, by 128 at most: for tiny pixels that holds only from farther on. A puck
// is divided once, up to its share of the vertices.
TEST(Scene, TheReportNamesTheLimit) {
  const Tessellation tessellation{1e-6, 3000};
  const std::vector<BodyLooks> looks{{"white", "", 0.03, 0.02}};
  const Scene scene = buildScene(boardOf(2.84, 1.42), looks, {}, {}, tessellation);
  const std::string report = tessellationReport(scene, tessellation);
  const std::string from = "exact to half a pixel up to 0.95 c from ";
  const std::size_t at = report.find(from, report.find("The hall: "));
  ASSERT_NE(at, std::string::npos) << report;
  const double nearest_m = std::stod(report.substr(at + from.size()));
  EXPECT_NEAR(nearest_m, kNearestEye_m * scene.notes[1].longestEdge_m / tessellation.edge_m(), 0.01)
      << report;
  EXPECT_GT(nearest_m, kNearestToSurface_m) << report;
  EXPECT_NE(report.find("since 3000 vertices are the limit"), std::string::npos) << report;
}

TEST(Scene, TheReportNamesTheFirstOfManyAlike) {
  const std::vector<BodyLooks> looks(25, {"red", "", 0.03, 0.02});
  const Tessellation tessellation{0.001, 3000};
  const std::string report = tessellationReport(buildScene({}, looks, {}, {}, tessellation), tessellation);
  EXPECT_NE(report.find("Puck red and 24 more: "), std::string::npos) << report;
}

}  // namespace
}  // namespace carom
