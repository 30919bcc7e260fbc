// What a scene says of its division, and how far its bodies reach.
#include "cave/scene/scene.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "cave/frame/body_colour.h"
#include "cave/scene/scene_edges.h"
#include "engine/light/light_cone.h"

namespace carom {
namespace {

using test::boardOf;

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
      const auto solved = emissionIn(view, d);
      const Vec3 seen = seenFromEye(view, solved);
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
