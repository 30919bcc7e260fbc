// Soft pucks as an eye sees them, against the steps of the simulation itself, solved by bisection: during and
// after bounces, from leg to rows to leg, and as the eye moves on.

#include "cave/bodies/seen_rows.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "cave/soft_steps.h"
#include "engine/light/emission_kernel.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using namespace test;

constexpr double kC = kSoftC;

// Show 10: silhouettes and printed marks, which lie on the mesh's rings and spokes, to a pixel.
TEST(SeenRows, VerticesAreWithinAPixelOfTheSteps) {
  for (const double speed : {0.3, 0.6, 0.8}) {
    SCOPED_TRACE(speed);
    const BilliardSetup setup = bounceAt(speed, 10);
    Played played(setup, 0.75);
    const Steps steps(setup, 1.1);
    const Vec3 eye_m(0.35, -0.3, 0.4);
    double worst_rad = 0.0, worstTurn = 0.0;
    for (const double headSpeed : {0.0, 0.7}) {
      const Lorentz headFromBoard = Lorentz::boost(uFromBeta({0.0, -headSpeed, 0.0}), kC);
      for (double t_s = 0.32; t_s < 0.75; t_s += 0.03) {
        const Event eye{t_s, eye_m};
        const std::vector<SeenVertex> seen = played.seen({eye, headFromBoard});
        for (std::size_t i = 0; i < seen.size(); ++i) {
          const SoftModel::Vertex& vertex = played.model.vertices[i];
          if (vertex.reach != 1.0F) continue;
          const glm::dvec3 expected = (headFromBoard * steps.seen(eye, played.model, vertex.point)).dr_m;
          const glm::dvec3 found(seen[i].drawn);
          worst_rad = std::max(worst_rad, glm::length(found - expected) / glm::length(expected));
          worstTurn = std::max(worstTurn, std::abs(glm::length(glm::dvec3(seen[i].normal)) - 1.0));
        }
      }
    }
    EXPECT_LT(worst_rad, 0.5 * kPixel_rad);
    EXPECT_GT(worst_rad, 1e-7);  // rows are no steps
    EXPECT_LT(worstTurn, 1e-5);
  }
}

// A sleeper is drawn as the rigid body on its leg: the same places, and the same for every switch and moment.
TEST(SeenRows, ASleeperIsDrawnAsARigidBody) {
  const BilliardSetup setup = bounceAt(0.6, 6);
  Played played(setup, 0.0);
  const WorldLine line(played.lines[0].knots().front(), kC, kSoftRadius);
  Random random(3);
  for (int run = 0; run < 40; ++run) {
    CASE(random, run);
    Switches switches;
    switches.retardation = random.in(0.0, 1.0) < 0.5;
    switches.contraction = random.in(0.0, 1.0) < 0.5;
    switches.aberration = random.in(0.0, 1.0) < 0.5;
    const auto moment = static_cast<ViewTime>(static_cast<int>(random.in(0.0, 3.0)));
    const Event eye{random.in(-0.5, 0.1), random.inBox(0.6) + Vec3(0.0, 0.0, 0.7)};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.9), kC);
    const std::vector<SeenVertex> seen = played.seen({eye, headFromBoard, switches, moment});
    BodyView view;
    viewBody(line, eye, headFromBoard, view, switches, moment);
    const RowEye drawing(eye, headFromBoard, switches, moment);
    for (std::size_t i = 0; i < seen.size(); i += 7) {
      const SoftModel::Vertex& vertex = played.model.vertices[i];
      if (vertex.reach != 1.0F) continue;
      const SoftModel::Point& point = played.model.points[vertex.point];
      const kernel::VertexEmission emission =
          emissionIn(view, Vec3(played.model.relaxed_m[point.node], point.z_m));
      const Vec3 expected = drawing.drawnAtSeen(kernel::seenFromEye(view.legs[0], emission.event));
      ASSERT_NEAR(glm::length(Vec3(seen[i].drawn) - expected), 0.0, 1e-6 * (1.0 + glm::length(expected)));
      EXPECT_NEAR(glm::length(Vec3(seen[i].u) - line.knots().front().u), 0.0, 1e-4);
      // Seen from its own frame a disc's side looks away from its middle.
      if (vertex.faces == 0) {
        EXPECT_GT(
            glm::dot(glm::normalize(Vec3(played.model.relaxed_m[point.node], 0.0)), Vec3(seen[i].normal)),
            0.99);
      }
    }
  }
}

// Swept through waking, contact with a cushion and with another one, and sleep, and with a rigid puck that
// becomes soft while its rim has not heard of a bounce: no point's seen event goes back, and none moves by
// more than its speed lets it.
TEST(SeenRows, ASweptEyeSeesNoJump) {
  BilliardSetup becoming;
  becoming.lightSpeed_m_s = kC;
  becoming.board = Board{1.2, 0.8};
  becoming.pucks = {disc("rigid", {0.5, 0.0}, {0.6, 0.0}), disc("jelly", {0.455, 0.06}, {0.3, 0.0})};
  becoming.pucks[1].soft = SoftMatter{0.5, 6, 0.3, {}};
  for (const BilliardSetup& setup : {bounceAt(0.3, 6), bounceAt(0.6, 6), pairAt(0.4, 6), becoming}) {
    SCOPED_TRACE(setup.pucks[0].name);
    Played played(setup, 1.3);
    const Vec3 eye_m(0.3, -0.2, 0.3);
    constexpr double kStep_s = 0.001;
    std::vector<SeenVertex> before;
    for (double t_s = 0.02; t_s < 1.3; t_s += kStep_s) {
      const std::vector<SeenVertex> now = played.seen({{t_s, eye_m}, Lorentz(kC)});
      for (std::size_t i = 0; i < now.size() && !before.empty(); ++i) {
        if (played.model.vertices[i].reach != 1.0F) continue;
        const double later_m = now[i].boardTime_m - before[i].boardTime_m + kStep_s * kC;
        ASSERT_GT(later_m, -2e-7) << t_s;
        // |dr| ≤ 0.999 dt_e. In float, so to a micrometre.
        ASSERT_LE(glm::length(now[i].drawn - before[i].drawn), 0.9995 * later_m + 1e-6)
            << "vertex " << i << " at " << t_s;
      }
      before = now;
    }
  }
}

// What the views tell: pressed where the wave is, warm after it.
TEST(SeenRows, StrainAndHeatAreTold) {
  const BilliardSetup setup = bounceAt(0.6, 8);
  Played played(setup, 1.3);
  std::vector<SeenVertex> vertices(played.model.vertices.size());
  SeenRows rows;
  const auto least = [&](double t_s, Told told) {
    rows.see(played.model, played.world.soft[1], {{t_s, {0.4, -0.3, 0.3}}, Lorentz(kC)}, told, vertices);
    double found = 1e9, sum = 0.0;
    for (const SeenVertex& vertex : vertices)
      found = std::min<double>(found, vertex.told), sum += vertex.told;
    return std::pair(found, sum / static_cast<double>(vertices.size()));
  };
  EXPECT_NEAR(least(0.2, Told::strain).first, 0.0, 1e-3);
  double pressed = 0.0;
  for (double t_s = 0.3; t_s < 0.8; t_s += 0.02) pressed = std::min(pressed, least(t_s, Told::strain).first);
  EXPECT_LT(pressed, -0.4);  // behind the shock own lengths are a third at least
  EXPECT_NEAR(least(0.2, Told::heat).second, 0.0, 1e-3);
  EXPECT_GT(least(1.25, Told::heat).second, 0.02);
  EXPECT_EQ(least(1.25, Told::nothing).second, least(1.25, Told::heat).second) << "which makes it glow";
}

// A told body that deforms: its vertices as SampledHistory has them, clipped before their first light, and
// the normals of a sheet that is bent while it moves.
TEST(SeenRows, AToldBodyIsSeenFromItsRows) {
  constexpr double kSpeed = 0.5;
  std::vector<double> times_s;
  std::vector<Vec3> places_m;
  const std::array<Vec3, 4> corners{Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0.1, 0.1, 0), Vec3(0, 0.1, 0)};
  for (int row = 0; row < 20; ++row) {
    const double t_s = 0.05 * row;
    times_s.push_back(t_s);
    // A square that moves along x, aslant: 45 degrees up in its own frame, so steeper on the board.
    for (const Vec3& corner : corners)
      places_m.push_back(Vec3(kSpeed * kC * t_s, 0.0, 0.1) +
                         Vec3(corner.x * std::sqrt(1.0 - kSpeed * kSpeed), corner.y, corner.x));
  }
  const SampledHistory history(kC, times_s, places_m);
  const auto shape = std::make_shared<const ToldShape>(ToldShape{history, {{{0, 1, 2}}, {{0, 2, 3}}}});
  const SoftModel model = toldModel(shape, glm::vec3(1.0F));
  ASSERT_EQ(model.vertices.size(), 4U);
  std::vector<SeenVertex> vertices(4);
  SeenRows rows;
  const Lorentz headFromBoard = Lorentz::boost(uFromBeta({0.2, -0.5, 0.0}), kC);
  for (double t_s = 0.05; t_s < 2.0; t_s += 0.11) {
    const Event eye{t_s, {0.2, -0.3, 0.4}};
    rows.see(model, {eye, headFromBoard}, vertices);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::optional<Emission> expected = history.seenAt(i, eye, headFromBoard);
      ASSERT_EQ(vertices[i].boardTime_m < SeenRows::kUnseen_m, !expected);
      if (!expected) continue;
      EXPECT_NEAR(glm::length(Vec3(vertices[i].drawn) - expected->seen.dr_m), 0.0, 2e-7);
      EXPECT_NEAR(glm::length(Vec3(vertices[i].u) - expected->u), 0.0, 1e-6);
      EXPECT_NEAR(glm::length(Vec3(vertices[i].normal) - glm::normalize(Vec3(-1, 0, 1))), 0.0, 1e-5);
    }
  }
  // Without triangles each vertex is a small solid of eight faces.
  const SoftModel points =
      toldModel(std::make_shared<const ToldShape>(ToldShape{history, {}}), glm::vec3(1.0F));
  EXPECT_EQ(points.vertices.size(), 24U);
  EXPECT_EQ(points.surface.size(), 4U * 24U);
}

}  // namespace
}  // namespace carom
