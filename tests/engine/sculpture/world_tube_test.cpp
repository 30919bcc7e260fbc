// World tubes: their events are the rims' by closed forms that know no histories, their surfaces are closed,
// and another frame changes no interval.
#include "engine/sculpture/world_tube.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/billiard/billiard.h"
#include "engine/light_speed.h"
#include "engine/random_game.h"
#include "engine/random_world.h"
#include "engine/sculpture/closed.h"

namespace carom {
namespace {

using test::kC_m_s;
constexpr double kRounding_m = 1e-9;

SpacetimeFrame boardOf(double c_m_s) { return {Lorentz(c_m_s), Event{}}; }

Puck discOf(double radius_m) {
  Puck puck;
  puck.radius_m = radius_m;
  puck.height_m = 0.04;
  return puck;
}

/// Returns the distance of an event from an inertial world line, as its rest frame has it: ρ² = d² + (d·U)²,
/// with d = e − x and the metric (−1, 1, 1, 1).
double distanceInRestFrame_m(const Event& event, const Event& onLine, const Vec3& u, double c_m_s) {
  const Displacement d = event - onLine;
  const double dt_m = c_m_s * d.dt_s, alongU = glm::dot(u, d.dr_m) - gammaFromU(u) * dt_m;
  return std::sqrt(glm::dot(d.dr_m, d.dr_m) - dt_m * dt_m + alongU * alongU);
}

// The volume of a straight tube is that of its sections, which are thinner by γ, times c Δt.
TEST(WorldTube, AStraightOneIsContracted) {
  test::Random random(3601);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.01, 0.1), beta = random.in(0.0, 0.99), angle = random.in(0.0, 6.0);
    const Vec3 u = uFromBeta({beta * std::cos(angle), beta * std::sin(angle), 0.0});
    Knot knot;
    knot.turn = Event{random.in(-1.0, 1.0), Vec3(random.in(-1.0, 1.0), random.in(-1.0, 1.0), 0.0)};
    knot.u = u;
    const WorldLine line(knot, kC_m_s, radius_m);
    const Span span{random.in(-3.0, 0.0), random.in(0.5, 3.0)};
    const WorldTube tube = worldTube(discOf(radius_m), line, span);
    const SolidMesh solid = solidOf(tube, boardOf(kC_m_s));
    ASSERT_EQ(test::openEdges(solid), 0);
    const auto n = static_cast<double>(tube.generators.size());
    const double area_m2 = 0.5 * n * radius_m * radius_m * std::sin(2.0 * std::numbers::pi / n);
    EXPECT_NEAR(volume_m3(solid),
                area_m2 * std::sqrt(1.0 - beta * beta) * kC_m_s * (span.until_s - span.from_s),
                1e-9 * area_m2);
  }
}

// Pucks that turn, without friction: until the first news of a turn and long after it each event of the rim
// has the radius as its distance, in the rest frame of its leg; between, consecutive events can be attended.
TEST(WorldTube, EventsOfARimAreThoseOfItsLegs) {
  test::Random random(3602);
  int onFirst = 0, onLast = 0;
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    const double radius_m = 0.08;
    const WorldLine line = randomWorldLine(random, kC_m_s, radius_m, 1, 1.0, 0.9);
    const Knot first = line.knots()[0], second = line.knots()[1];
    const double turn_s = second.turn.t_s;
    const WorldTube tube = worldTube(discOf(radius_m), line, {turn_s - 2.0, turn_s + 2.0});
    for (const auto& generator : tube.generators) {
      const std::vector<Event> events = eventsAlong(generator, tube.span, kC_m_s);
      ASSERT_DOUBLE_EQ(events.front().t_s, turn_s - 2.0);
      ASSERT_DOUBLE_EQ(events.back().t_s, turn_s + 2.0);
      for (std::size_t k = 1; k < events.size(); ++k)
        ASSERT_GT(interval_m2(events[k] - events[k - 1], kC_m_s), 0.0) << "faster than light";
      // The rim's height over the centre's plane is the puck's half.
      const double expected_m = std::hypot(radius_m, 0.02);
      ASSERT_NEAR(distanceInRestFrame_m(events.front(), first.turn, first.u, kC_m_s), expected_m,
                  kRounding_m);
      ++onFirst;
      const Displacement since = events.back() - second.turn;
      const double own_s = gammaFromU(second.u) * since.dt_s - glm::dot(second.u, since.dr_m) / kC_m_s;
      if (own_s < line.settled_s(1) + 2.0 * radius_m / kC_m_s) continue;
      ASSERT_NEAR(distanceInRestFrame_m(events.back(), second.turn, second.u, kC_m_s), expected_m,
                  kRounding_m);
      ++onLast;
    }
  }
  EXPECT_GT(onFirst, 4000);
  EXPECT_GT(onLast, 2000);
}

// Whatever is played, with spin, friction and corners too: closed, with the same intervals in any frame, and
// its chords near what they stand for.
TEST(WorldTube, TubesOfGamesAreClosedInEveryFrame) {
  int tubes = 0, curved = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const test::RandomGame game = test::randomGame(seed, {.events = 60, .packed = 8});
    const BilliardSetup& setup = game.setup;
    if (setup.pucks.size() > 12 || game.until_s > 60.0) continue;
    SCOPED_TRACE(testing::Message() << "game " << seed << ", " << game.kind);
    Billiard billiard(setup);
    billiard.advanceTo(game.until_s);
    const double c_m_s = setup.lightSpeed_m_s;
    const Span span{0.0, std::min(game.until_s, 10.0)};
    test::Random random(seed);
    const Vec3 beta(random.in(-0.6, 0.6), random.in(-0.6, 0.6), 0.0);
    const SpacetimeFrame moving{Lorentz::boost(uFromBeta(beta), c_m_s).inverse(), {1.0, Vec3(0.1, 0.2, 0.0)}};
    for (std::size_t puck = 0; puck < setup.pucks.size(); ++puck, ++tubes) {
      const WorldTube tube = worldTube(setup.pucks[puck], billiard.worldLines()[puck], span);
      const SolidMesh solid = solidOf(tube, boardOf(c_m_s)), boosted = solidOf(tube, moving);
      ASSERT_EQ(test::openEdges(solid), 0);
      ASSERT_EQ(solid.triangles, boosted.triangles);
      ASSERT_GT(volume_m3(solid), 0.0);
      ASSERT_NEAR(volume_m3(boosted) / volume_m3(solid), 1.0, 1e-6) << "a boost keeps volumes";
      const auto square = [](const Vec3& d) { return d.x * d.x + d.y * d.y - d.z * d.z; };
      const std::size_t ends = solid.points.size() - 2;  // the lids' middles are no events
      for (std::size_t k = 1; k < ends; k += 7) {
        const Vec3 d = solid.points[k] - solid.points[0], boostedD = boosted.points[k] - boosted.points[0];
        ASSERT_NEAR(square(d), square(boostedD), 1e-9 * (1.0 + glm::dot(d, d)));
      }
      for (const auto& generator : tube.generators) {
        const std::vector<Event> events = eventsAlong(generator, span, c_m_s);
        for (std::size_t k = 1; k < events.size(); k += 5) {
          const double t_s = 0.5 * (events[k - 1].t_s + events[k].t_s);
          const Vec3 place_m = placeAt(pieceAt(generator, t_s), t_s, c_m_s);
          const double off_m = glm::distance(place_m, 0.5 * (events[k - 1].r_m + events[k].r_m));
          ASSERT_LT(off_m, 2e-4);
          curved += off_m > 1e-6;
        }
      }
    }
  }
  EXPECT_GT(tubes, 40);
  EXPECT_GT(curved, 10);
}

}  // namespace
}  // namespace carom
