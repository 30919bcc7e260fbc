// Tubes that grow with their games: what has grown is the same as what is made at once, its points are those
// of the rim's whole histories, and a knot costs no more than what follows from it.
#include "engine/sculpture/growing_tube.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/billiard/billiard.h"
#include "engine/light_speed.h"
#include "engine/random_game.h"
#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kPast_s = 12.0, kFine_m = 1e-3;

/// Returns how far a point is from the nearest of the rim's points at its time.
double offRim_m(const glm::vec3& point, const std::vector<std::vector<VertexPiece>>& rim, double c_m_s) {
  const double t_s = point.z / c_m_s;
  double least_m = 1e9;
  for (const auto& history : rim) {
    const Vec3 place_m = placeAt(pieceAt(history, t_s), t_s, c_m_s);
    least_m = std::min(least_m, std::hypot(place_m.x - point.x, place_m.y - point.y));
  }
  return least_m;
}

TEST(GrowingTube, GrownStepByStepItIsTheSameAsMadeAtOnce) {
  int points = 0, grown = 0, games = 0;
  for (std::uint64_t seed = 1; seed <= 14; ++seed) {
    const test::RandomGame game = test::randomGame(seed, {.events = 60, .packed = 8});
    const BilliardSetup& setup = game.setup;
    if (setup.pucks.size() > 12 || game.until_s > 60.0) continue;
    SCOPED_TRACE(testing::Message() << "game " << seed << ", " << game.kind);
    ++games;
    const double c_m_s = setup.lightSpeed_m_s, until_s = std::min(game.until_s, 6.0);
    std::vector<GrowingTube> tubes(setup.pucks.size());
    Billiard billiard(setup);
    for (int step = 1; step <= 30; ++step) {
      const double now_s = until_s * step / 30.0;
      billiard.advanceTo(now_s);
      for (std::size_t puck = 0; puck < tubes.size(); ++puck)
        grown +=
            tubes[puck].follow(setup.pucks[puck], billiard.worldLines()[puck], kPast_s, now_s, 0.0, kFine_m);
    }
    for (std::size_t puck = 0; puck < tubes.size(); ++puck) {
      const WorldLine& line = billiard.worldLines()[puck];
      GrowingTube atOnce;
      atOnce.follow(setup.pucks[puck], line, kPast_s, until_s, 0.0, kFine_m);
      ASSERT_EQ(tubes[puck].points().size(), atOnce.points().size()) << "puck " << puck;
      for (std::size_t i = 0; i < atOnce.points().size(); ++i) {
        const glm::vec3 a = tubes[puck].points()[i], b = atOnce.points()[i];
        ASSERT_EQ(a, b) << "puck " << puck << ", point " << i << ": " << a.x << ' ' << a.y << ' ' << a.z
                        << ", expected " << b.x << ' ' << b.y << ' ' << b.z << "; now " << until_s * c_m_s;
      }
      ASSERT_TRUE(std::ranges::equal(tubes[puck].triangles(), atOnce.triangles()));
      std::vector<std::vector<VertexPiece>> rim;
      for (const Vec2& point_m : rimOf(setup.pucks[puck]))
        rim.push_back(vertexHistory(line, Vec3(point_m, 0.5 * setup.pucks[puck].height_m)));
      const auto made = atOnce.points();
      for (std::size_t i = puck; i < made.size(); i += 11) {
        if (std::abs(made[i].z) > 8.0F || glm::length(glm::vec2(made[i])) > 8.0F)
          continue;  // single precision
        ASSERT_LT(offRim_m(made[i], rim, c_m_s), 1e-6) << made[i].x << ' ' << made[i].y << ' ' << made[i].z;
        ++points;
      }
    }
  }
  EXPECT_GT(points, 1000);
  EXPECT_GT(grown, 100);
  EXPECT_GT(games, 3);
}

TEST(GrowingTube, AGameWithoutAPastBeginsWithIt) {
  Puck puck;
  puck.radius_m = 0.03;
  puck.height_m = 0.02;
  constexpr double kBegins_s = 3.0;
  const WorldLine line({{kBegins_s, {0.1, 0.2, 0.01}}, uFromBeta({0.5, 0.0, 0.0}), 0.0, {}, 0.0},
                       test::kC_m_s, 0.04, kBegins_s);
  GrowingTube tube;
  for (const double now_s : {kBegins_s, kBegins_s + 0.5}) {
    tube.follow(puck, line, kPast_s, now_s, 0.0, kFine_m);
    ASSERT_FALSE(tube.points().empty());
    for (const glm::vec3& point : tube.points()) ASSERT_GE(point.z, test::kC_m_s * kBegins_s - 1e-5);
  }
  GrowingTube before;
  before.follow(puck, line, kPast_s, kBegins_s - 20.0, 0.0, kFine_m);
  EXPECT_TRUE(before.points().empty()) << "the puck is not there yet";
}

// A stroke makes a game take another course: what the old one had after it is gone.
TEST(GrowingTube, TakesBackWhatDoesNotHappen) {
  test::Random random(3610);
  for (int i = 0; i < 50; ++i) {
    CASE(random, i);
    Puck puck;
    puck.radius_m = 0.03;
    puck.height_m = 0.04;
    const WorldLine whole = randomWorldLine(random, 1.42, puck.radius_m, 4, 0.5, 0.85);
    WorldLine other = whole;
    other.keepFirst(3);
    const double now_s = whole.knots().back().turn.t_s;
    GrowingTube tube, fresh;
    tube.follow(puck, whole, kPast_s, now_s, 0.0, kFine_m);
    EXPECT_TRUE(tube.follow(puck, other, kPast_s, now_s, 0.0, kFine_m));
    EXPECT_FALSE(tube.follow(puck, other, kPast_s, now_s, 0.0, kFine_m));
    fresh.follow(puck, other, kPast_s, now_s, 0.0, kFine_m);
    ASSERT_TRUE(std::ranges::equal(tube.points(), fresh.points()));
    ASSERT_TRUE(std::ranges::equal(tube.triangles(), fresh.triangles()));
  }
}

// Events that are left out lie near the line over them; the first and the last stay.
TEST(GrowingTube, ThinsOnlyWhatLiesOnALine) {
  test::Random random(3611);
  std::size_t left = 0, had = 0;
  for (int i = 0; i < 300; ++i) {
    CASE(random, i);
    std::vector<Event> events{{random.in(-1.0, 1.0), random.inBox(1.0)}};
    const int count = static_cast<int>(random.in(0.0, 12.0));
    for (int k = 0; k < count; ++k)
      events.push_back({events.back().t_s + random.in(0.01, 0.5),
                        events.back().r_m + Vec3(0.1, 0.0, 0.0) + random.inBox(0.02)});
    std::vector<Event> thinned = events;
    const double off_m = random.in(0.0, 0.05);
    thin(thinned, off_m);
    had += events.size(), left += thinned.size();
    ASSERT_EQ(thinned.front().t_s, events.front().t_s);
    ASSERT_EQ(thinned.back().t_s, events.back().t_s);
    std::size_t at = 0;
    for (const Event& event : events) {
      while (at + 1 < thinned.size() && thinned[at + 1].t_s < event.t_s) ++at;
      if (at + 1 == thinned.size()) break;  // the only event
      const Event &a = thinned[at], &b = thinned[at + 1];
      const Vec3 place_m = a.r_m + (b.r_m - a.r_m) * ((event.t_s - a.t_s) / (b.t_s - a.t_s));
      ASSERT_LE(glm::distance(place_m, event.r_m), off_m + 1e-12);
    }
  }
  EXPECT_LT(left, had * 9 / 10);
  EXPECT_GT(left, had / 10);
}

// What is drawn of a tube for a span of times is all that reaches into it, and not much more.
TEST(GrowingTube, ChoosesTheTrianglesOfASpan) {
  test::Random random(3612);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    Puck puck;
    puck.radius_m = 0.03;
    puck.height_m = 0.04;
    const WorldLine line = randomWorldLine(random, 1.42, puck.radius_m, 8, 0.5, 0.85);
    const double now_s = line.knots().back().turn.t_s;
    GrowingTube tube;
    tube.follow(puck, line, kPast_s, now_s, 0.0, kFine_m);
    const double from_s = now_s + random.in(-14.0, 10.0);
    const Span span{from_s, from_s + random.in(0.0, 5.0)};
    const TriangleRange range = tube.trianglesIn(span);
    ASSERT_LE(range.first + range.count, tube.triangles().size());
    for (std::size_t k = 0; k < tube.triangles().size(); ++k) {
      double first_s = 1e9, last_s = -1e9;
      for (const std::uint32_t corner : tube.triangles()[k]) {
        first_s = std::min(first_s, double{tube.points()[corner].z} / 1.42);
        last_s = std::max(last_s, double{tube.points()[corner].z} / 1.42);
      }
      const bool isIn = k >= range.first && k < range.first + range.count;
      if (last_s > span.from_s + 1e-5 && first_s < span.until_s - 1e-5) {
        ASSERT_TRUE(isIn) << k;
      }
      if (isIn) {
        ASSERT_GT(last_s, span.from_s - GrowingTube::kSlice_s - 1e-5);
        ASSERT_LT(first_s, span.until_s + GrowingTube::kSlice_s + 1e-5);
      }
    }
  }
}

}  // namespace
}  // namespace carom
