// The rim of a soft puck: its events by a motion that is known in closed form, its cuts by bisection along
// the rows, and its tube as it grows row by row.
#include "engine/sculpture/soft_rim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/game/soft_puck_mesh.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"
#include "engine/sculpture/growing_tube.h"

namespace carom {
namespace {

using test::kC_m_s;
constexpr double kStep_m = 0.02;

/// A soft disc that glides evenly while it breathes: its nodes are away from the centre by 1 + a sin(ω t) of
/// their relaxed places.
struct Breathing {
  Puck puck;
  glm::dvec2 from_m{0.0}, velocity{0.0};
  double depth = 0.0, omega = 0.0;  // 1/m of light
  SoftHull hull;
  SoftMesh mesh;
  SoftHistory rows;

  static Puck puckOf() {
    Puck puck;
    puck.radius_m = 0.08;
    puck.height_m = 0.04;
    puck.soft.emplace();
    return puck;
  }
  explicit Breathing(test::Random& random) : puck(puckOf()), hull(softHullOf(puck)), mesh(softMeshOf(puck)) {
    from_m = {random.in(-0.5, 0.5), random.in(-0.5, 0.5)};
    const double speed = random.in(0.0, 0.6), angle = random.in(0.0, 6.3);
    velocity = speed * glm::dvec2(std::cos(angle), std::sin(angle));
    depth = random.in(0.05, 0.2);
    omega = random.in(2.0, 8.0);
  }
  glm::dvec2 placeAt(std::size_t node, double time) const {
    return from_m + velocity * time + mesh.places()[node] * (1.0 + depth * std::sin(omega * time));
  }
  void append(double time) {
    SoftRow row;
    row.time = time;
    const glm::dvec2 centre = from_m + velocity * time;
    row.centreX = centre.x, row.centreY = centre.y;
    row.velocityX = velocity.x, row.velocityY = velocity.y;
    row.nodes = static_cast<std::uint32_t>(mesh.places().size());
    std::vector<SoftNode> nodes(mesh.places().size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const glm::dvec2 arm = placeAt(i, time) - centre;
      const glm::dvec2 v = velocity + mesh.places()[i] * (depth * omega * std::cos(omega * time));
      nodes[i].x = static_cast<float>(arm.x), nodes[i].y = static_cast<float>(arm.y);
      nodes[i].velocity = {static_cast<std::int16_t>(std::lround(v.x / SoftNode::kVelocityUnit)),
                           static_cast<std::int16_t>(std::lround(v.y / SoftNode::kVelocityUnit))};
    }
    rows.append(row, nodes);
  }
  SoftRim rim() const { return {rows, nullptr, hull.nodes, hull.relaxed, kC_m_s}; }
};

TEST(SoftRim, ItsEventsAreThoseOfTheMotionAndItsCutsLieOnTheSurfaces) {
  test::Random random(3660);
  BodyView view;
  std::vector<Event> cut;
  int cuts = 0;
  for (int i = 0; i < 60; ++i) {
    CASE(random, i);
    Breathing body(random);
    for (int k = 0; k <= 300; ++k) body.append(kStep_m * k);
    const SoftRim rim = body.rim();
    ASSERT_GE(rim.nodes.size(), 12U);
    const Span span{random.in(0.1, 1.0), random.in(1.5, 4.0)};
    const double between_m = 0.125 * 0.2 * 0.08 * 64.0 * kStep_m * kStep_m + 1e-6;  // |a| Δt²/8, and floats
    for (std::size_t node = 0; node < rim.nodes.size(); ++node) {
      const std::vector<Event> events = softEventsAlong(rim, node, span);
      ASSERT_EQ(events.front().t_s, span.from_s);
      ASSERT_EQ(events.back().t_s, span.until_s);
      for (const Event& event : events) {
        ASSERT_LT(glm::distance(glm::dvec2(event.r_m), body.placeAt(rim.nodes[node], kC_m_s * event.t_s)),
                  between_m);
        ASSERT_EQ(event.r_m.z, 0.04);
      }
    }
    const Event eye{random.in(2.0, 4.0), {random.in(-1.0, 1.0), random.in(-1.5, 1.0), 0.8}};
    const Vec3 u = random.u(0.9);
    const Lorentz headFromBoard = Lorentz::boost(u, kC_m_s).inverse();
    const Vec3 beta = betaFromU(u);
    for (const ViewTime moment : {ViewTime::seen, ViewTime::myNow, ViewTime::boardNow}) {
      cutSoftRim(rim, eye, headFromBoard, moment, view, cut);
      ASSERT_EQ(cut.size(), rim.nodes.size());
      for (std::size_t node = 0; node < cut.size(); ++node) {
        // By bisection: how much later than the surface's the moment is there, metres of light.
        const auto late = [&](double time) {
          const Vec3 way = Vec3(body.placeAt(rim.nodes[node], time), 0.04) - eye.r_m;
          const double since = time - kC_m_s * eye.t_s;
          return moment == ViewTime::seen    ? since + glm::length(way)
                 : moment == ViewTime::myNow ? since - glm::dot(beta, way)
                                             : since;
        };
        double low = -50.0, high = 50.0;
        for (int step = 0; step < 80; ++step)
          (late(0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
        if (low < 0.0 || low > 5.9) continue;  // beside the rows
        // A node of 0.6 c and more along the surface turns an error of place into one of time.
        ASSERT_LT(std::abs(kC_m_s * cut[node].t_s - low), 40.0 * between_m)
            << "moment " << static_cast<int>(moment);
        ASSERT_LT(glm::distance(glm::dvec2(cut[node].r_m), body.placeAt(rim.nodes[node], low)),
                  40.0 * between_m);
        ++cuts;
      }
    }
  }
  EXPECT_GT(cuts, 2000);
}

TEST(SoftRim, ItsTubeGrownRowByRowIsTheSameAsMadeAtOnce) {
  test::Random random(3661);
  for (int i = 0; i < 6; ++i) {
    CASE(random, i);
    Breathing body(random);
    GrowingTube tube;
    double now_m = 0.0;
    int kept = 0;
    for (int k = 0; k <= 400; ++k) {
      body.append(now_m = kStep_m * k);
      const std::size_t had = tube.points().size();
      ASSERT_TRUE(tube.follow(body.rim(), 3.0, now_m / kC_m_s, 0.0, 1e-3)) << "a new row";
      ASSERT_FALSE(tube.follow(body.rim(), 3.0, now_m / kC_m_s, 0.0, 1e-3)) << "nothing new";
      kept += tube.points().size() >= had;
    }
    GrowingTube atOnce;
    atOnce.follow(body.rim(), 3.0, now_m / kC_m_s, 0.0, 1e-3);
    ASSERT_TRUE(std::ranges::equal(tube.points(), atOnce.points()));
    ASSERT_TRUE(std::ranges::equal(tube.triangles(), atOnce.triangles()));
    EXPECT_GT(kept, 300);
    for (const glm::vec3& point : tube.points()) {
      if (point.z > now_m || point.z < 0.0F) continue;
      double least_m = 1e9;
      for (const std::size_t node : body.hull.nodes)
        least_m = std::min(least_m, glm::distance(glm::dvec2(point), body.placeAt(node, double{point.z})));
      ASSERT_LT(least_m, 1e-3);
    }
    // A stroke makes the body go another way.
    body.rows.truncateFrom(now_m - 1.0);
    body.velocity *= -0.5;
    body.from_m = glm::dvec2(0.2, 0.1);
    ASSERT_TRUE(tube.follow(body.rim(), 3.0, now_m / kC_m_s, 0.0, 1e-3));
    GrowingTube other;
    other.follow(body.rim(), 3.0, now_m / kC_m_s, 0.0, 1e-3);
    ASSERT_TRUE(std::ranges::equal(tube.points(), other.points()));
  }
}

}  // namespace
}  // namespace carom
