#include "engine/light/vertex_history.h"

#include <gtest/gtest.h>

#include <numbers>

#include <cmath>

#include "engine/billiard/billiard.h"
#include "engine/light/light_cone.h"
#include "engine/light/point_history.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s, test::kHistoryRounding_m;

TEST(VertexHistory, ContinuousAndSlowerThanLightThroughChainsOfBounces) {
  test::Random random(5);
  int pieces = 0;
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const int bounces = static_cast<int>(random.in(1, 21));
    const WorldLine line = randomWorldLine(random, kC_m_s, 0.1, bounces, random.in(0.02, 2.0), 0.9);
    const Vec3 offset_m = random.inBall(0.1);
    const auto history = vertexHistory(line, offset_m);
    SCOPED_TRACE(testing::Message() << "world line " << i << " with " << bounces << " bounces");
    for (std::size_t k = 0; k + 1 < history.size(); ++k, ++pieces) {
      const Displacement d = history[k + 1].start - history[k].start;
      const Vec3 expected_m = betaFromU(history[k].u) * (kC_m_s * d.dt_s);
      if (k > 0) {  // the first piece has no beginning
        ASSERT_GE(d.dt_s, -1e-12);
      }
      ASSERT_LT(glm::length(d.dr_m - expected_m), kHistoryRounding_m);
      ASSERT_LT(glm::length(betaFromU(history[k].u)), 1.0);
      if (k > 0) {
        ASSERT_GE(history[k + 1].properTime_s, history[k].properTime_s - 1e-12);
      }
    }
  }
  EXPECT_GT(pieces, 20000);
}

// Under friction: u and the clock of a gliding point are those of its places.
TEST(VertexHistory, GlidingPointsMoveAsTheirPlacesDo) {
  test::Random random(12);
  const double h_s = 1e-4;
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    const WorldLine line = randomWorldLine(random, kC_m_s, 0.1, 4, 2.0, 0.9, random.in(0.05, 4.0));
    const auto history = vertexHistory(line, random.inBall(0.1));
    SCOPED_TRACE(testing::Message() << "world line " << i);
    for (std::size_t k = 1; k + 1 < history.size(); ++k) {
      const VertexPiece& piece = history[k];
      const double end_s = history[k + 1].start.t_s;
      ASSERT_LT(glm::length(placeAt(piece, end_s, kC_m_s) - history[k + 1].start.r_m), kHistoryRounding_m);
      ASSERT_NEAR(properTimeAt(piece, end_s, kC_m_s), history[k + 1].properTime_s, 1e-9);
      const double t_s = random.in(piece.start.t_s, end_s);
      if (end_s - piece.start.t_s < 10 * h_s) continue;
      const Vec3 step_m = placeAt(piece, t_s + h_s, kC_m_s) - placeAt(piece, t_s - h_s, kC_m_s);
      const Vec3 beta = step_m / (2.0 * h_s * kC_m_s);
      ASSERT_LT(glm::length(beta - betaFromU(uAt(piece, t_s, kC_m_s))),
                1e-3);  // a kink may lie within the step
      const double tick_s = properTimeAt(piece, t_s + h_s, kC_m_s) - properTimeAt(piece, t_s - h_s, kC_m_s);
      ASSERT_NEAR(tick_s / (2.0 * h_s), std::sqrt(1.0 - glm::dot(beta, beta)), 1e-3);
    }
  }
}

// The same where the cloth slows the spin, at times the body as well. The Doppler factor for an eye at rest
// on the board is how fast it sees the point's clock go.
TEST(VertexHistory, PointsWhoseSpinTheClothSlowsMoveAsTheirPlacesDo) {
  test::Random random(13);
  const double h_s = 1e-4;
  int slowed = 0;
  for (int i = 0; i < 80; ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.05, 0.2), friction_m_s2 = i % 3 == 0 ? random.in(0.01, 0.5) : 0.0;
    const WorldLine straight = randomWorldLine(random, kC_m_s, radius_m, 1, 1.0, 0.8, friction_m_s2);
    const WorldLine line = spun(random, straight, 0.95, random.in(0.2, 3.0), 0.3);
    const Vec3 offset_m = random.inBall(radius_m);
    const VertexPiece piece = vertexHistory(line, offset_m).back();
    const double t_s = piece.start.t_s + random.in(0.05, 1.5);
    const auto placeIn = [&](double after_s) { return placeAt(piece, t_s + after_s, kC_m_s); };
    const auto clockIn = [&](double after_s) { return properTimeAt(piece, t_s + after_s, kC_m_s); };
    const Vec3 beta = (placeIn(h_s) - placeIn(-h_s)) / (2.0 * h_s * kC_m_s);
    EXPECT_LT(glm::length(beta - betaFromU(uAt(piece, t_s, kC_m_s))),
              1e-3);  // a kink may lie within the step
    EXPECT_NEAR((clockIn(h_s) - clockIn(-h_s)) / (2.0 * h_s), std::sqrt(1.0 - glm::dot(beta, beta)), 1e-3);

    const Event place{t_s, placeIn(0.0)};
    const Vec3 way_m = random.direction() * random.in(0.5, 3.0);
    const auto seenAt = [&](double after_s) {
      const Event eye{t_s + glm::length(way_m) / kC_m_s + after_s, place.r_m + way_m};
      return *emission(line, offset_m, eye, Lorentz(kC_m_s));
    };
    const double clock_s = seenAt(h_s).properTime_s - seenAt(-h_s).properTime_s;
    EXPECT_NEAR(clock_s / (2.0 * h_s) / seenAt(0.0).doppler, 1.0, 1e-3);
    const Knot& last = line.knots().back();
    const double own_s = line.at(t_s).properTime_s - last.properTime_s, now = omegaAfter(last.spin, own_s);
    if (now != 0.0 && std::abs(now / last.spin.omega_rad_s) < 0.9) ++slowed;
  }
  EXPECT_GT(slowed, 12);
}

// A rim that goes round at w counts sqrt(1 − w²) of what its centre counts. After whole turns, of which each
// takes γ of its own time on the board, it is where it was aboard.
TEST(VertexHistory, TheClockOfARimGoesSlowerThanTheCentres) {
  constexpr double kRadius_m = 0.1;
  for (const double w : {0.3, 0.95}) {
    Knot knot{{0.0, Vec3(0.0)}, uFromBeta(Vec3(0.6, 0.0, 0.0)), 0.0, {}, 0.0};
    knot.spin.omega_rad_s = w * kC_m_s / kRadius_m;
    knot.spin.rim_u = w / std::sqrt(1.0 - w * w);
    const WorldLine line(knot, kC_m_s, kRadius_m);
    const VertexPiece piece = vertexHistory(line, {0.0, kRadius_m, 0.0}).back();
    const double turns_s = 3.0 * 2.0 * std::numbers::pi / knot.spin.omega_rad_s, from_s = 0.7;
    const double counted_s = properTimeAt(piece, from_s + turns_s * gammaFromU(knot.u), kC_m_s) -
                             properTimeAt(piece, from_s, kC_m_s);
    EXPECT_NEAR(counted_s, turns_s * std::sqrt(1.0 - w * w), 1e-12) << w;
  }
}

// In the rest frame of the turn a point catches up with its place on a rim that goes round at w at (1 + w)/2
// of light speed, so that it comes there however fast that is.
TEST(VertexHistory, PointsCatchUpWithTheFastestRims) {
  test::Random random(14);
  constexpr double kRadius_m = 0.1;
  int led = 0;
  for (int i = 0; i < 300; ++i) {
    CASE(random, i);
    const WorldLine line =
        spun(random, randomWorldLine(random, kC_m_s, kRadius_m, 1, 1.0, 0.9), 0.999, 0.0, 0.95);
    const double at = random.in(-3.0, 3.0);
    const Vec3 offset_m = kRadius_m * Vec3(std::cos(at), std::sin(at), 0.0);
    const auto history = vertexHistory(line, offset_m);
    ASSERT_EQ(history.size(), 3u);
    const VertexPiece &leads = history[1], &onLeg = history[2];
    const Knot& knot = line.knots().back();
    const Displacement way = Lorentz::boost(knot.u, kC_m_s).inverse() * (onLeg.start - leads.start);
    if (!(way.dt_s > 1e-3)) continue;
    ++led;
    const double w = std::abs(knot.spin.omega_rad_s) * kRadius_m / kC_m_s;
    EXPECT_NEAR(glm::length(way.dr_m) / (kC_m_s * way.dt_s), 0.5 + 0.5 * w, 1e-9);
    EXPECT_LT(glm::length(placeAt(onLeg, onLeg.start.t_s, kC_m_s) - onLeg.start.r_m), kHistoryRounding_m);
  }
  EXPECT_GT(led, 200);
}

// The seen event lies on the eye's past light cone within the rounding of the coordinates, however fast the
// body is: c (T − s) = |X − v s|.
TEST(VertexHistory, TheSeenEventLiesOnTheLightConeAtAnySpeed) {
  test::Random random(15);
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const double size = std::pow(10.0, random.in(-1.0, 3.0));  // γβ
    const Knot knot{{random.in(-1.0, 0.0), random.inBox(1.0)}, random.direction() * size, 0.0, {}, 0.0};
    const WorldLine line(knot, kC_m_s, 0.1);
    const Event eye{random.in(0.0, 100.0), random.inBox(10.0)};
    const Event seen = eventOnPastCone(vertexHistory(line, Vec3(0.0)), eye, kC_m_s);
    const double delay_s = eye.t_s - seen.t_s, way_m = glm::length(eye.r_m - seen.r_m);
    EXPECT_GE(delay_s, 0.0);
    EXPECT_NEAR(kC_m_s * delay_s, way_m, 1e-14 * (1.0 + way_m + std::abs(eye.t_s))) << seen.t_s;
  }
}

TEST(VertexHistory, TheCentreFollowsItsKnots) {
  test::Random random(6);
  const WorldLine line = randomWorldLine(random, kC_m_s, 0.1, 12, 0.5, 0.9);
  const auto history = vertexHistory(line, Vec3(0.0));
  for (double t_s = -2.0; t_s < 8.0; t_s += 0.01) {
    const VertexPiece& piece = pieceAt(history, t_s);
    ASSERT_LT(glm::length(placeAt(piece, t_s, kC_m_s) - line.at(t_s).event.r_m), kHistoryRounding_m) << t_s;
  }
}

TEST(VertexHistory, ClockShowsZeroAtBoardTimeZeroOrAtAppearance) {
  const Knot knot{{-3.0, Vec3(0.0)}, uFromBeta({0.6, 0.0, 0.0}), 0.0, {}, 0.0};
  const auto always = vertexHistory(WorldLine(knot, kC_m_s), {0.1, 0.0, 0.0});
  EXPECT_NEAR(properTimeAt(always.front(), 0.0, kC_m_s), 0.0, 1e-15);
  EXPECT_NEAR(properTimeAt(always.front(), 1.0, kC_m_s), 0.8, 1e-15);
  const auto later = vertexHistory(WorldLine(knot, kC_m_s, 0.1, 2.0), {0.1, 0.0, 0.0});
  EXPECT_NEAR(properTimeAt(later.front(), 2.0, kC_m_s), 0.0, 1e-15);
}

// A puck kicked to and fro, often before all of it has heard: every point has joined a leg when the line says
// so, and the line does not say so much too late, however many the turns.
TEST(VertexHistory, AllPointsHaveJoinedWhenTheLineSaysSo) {
  test::Random random(9);
  const double radius_m = 0.05;
  int unsettled = 0;
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const auto inPlane = [&](double maxBeta) {
      const double angle = random.in(0.0, 6.2831853), beta = random.in(0.0, maxBeta);
      return Vec3(beta * std::cos(angle), beta * std::sin(angle), 0.0);
    };
    Knot first;
    first.u = uFromBeta(inPlane(0.8));
    WorldLine line(first, kC_m_s, radius_m);
    for (int turn = 0; turn < 12; ++turn) {
      const Knot& last = line.knots().back();
      const Motion motion = motionOnLeg(last, last.turn.t_s + random.in(0.005, 0.5), kC_m_s);
      const Vec3 rim_m = inPlane(1.0) * radius_m;
      Knot next{motion.event, uFromBeta(inPlane(0.8)), motion.properTime_s, {}, 0.0};
      next.signal =
          motion.event + Lorentz::boost(motion.u, kC_m_s) * Displacement{-glm::length(rim_m) / kC_m_s, rim_m};
      line.append(next);
      if (line.settlesBeforeNext(line.knots().size() - 2)) continue;
      line.settlesAfter(joinedAfter_s(line));
      ++unsettled;
    }
    const Knot& last = line.knots().back();
    const Lorentz bodyFromBoard = Lorentz::boost(-last.u, kC_m_s);
    double longest_s = 0.0;
    for (int point = 0; point < 100; ++point) {
      const Event joined = vertexHistory(line, random.inBall(radius_m)).back().start;
      longest_s = std::max(longest_s, (bodyFromBoard * (joined - last.turn)).dt_s);
    }
    const double said_s = line.settled_s(line.knots().size() - 1);
    EXPECT_LE(longest_s, said_s) << "world line " << i;
    // Fifty times the time in which light crosses the radius: a bound that grew with every turn is far
    // beyond.
    EXPECT_LT(said_s, longest_s + 50.0 * radius_m / kC_m_s) << "world line " << i;
  }
  EXPECT_GT(unsettled, 300);
}

// Games of unequal pucks on small boards, from starts up to 0.999 c: no point of dense ones around a puck
// joins a leg later than said.
TEST(VertexHistory, NoPointJoinsLaterThanSaidInDenseGames) {
  test::Random random(10);
  int unsettled = 0;
  for (int game = 0; game < 36; ++game) {
    CASE(random, game);
    constexpr double kStarts_beta[] = {0.5, 0.8, 0.9, 0.97, 0.99, 0.999};
    BilliardSetup setup;
    setup.lightSpeed_m_s = kC_m_s;
    setup.board = Board{random.in(0.4, 0.8), random.in(0.3, 0.6)};
    if (game % 2 == 1) setup.rules.collisionEvent = CollisionEvent::contact;
    for (int i = 0; i < 6; ++i) {  // each in a field of its own of three by two
      const double angle = random.in(0.0, 6.2831853);
      const double beta = kStarts_beta[game % 6] * std::pow(random.in(0.0, 1.0), 0.2);
      const Vec2 field_m((i % 3 - 1) * setup.board->length_m / 3.0,
                         (i / 3 - 0.5) * setup.board->width_m / 2.0);
      setup.pucks.push_back({std::to_string(i), random.in(0.02, 0.05), 0.02,
                             std::pow(10.0, random.in(-1.0, 1.0)), field_m,
                             beta * Vec2(std::cos(angle), std::sin(angle))});
    }
    Billiard billiard(setup);
    billiard.advanceTo(0.7);
    for (std::size_t puck = 0; puck < setup.pucks.size(); ++puck) {
      const WorldLine& whole = billiard.worldLines()[puck];
      WorldLine line(whole.knots().front(), kC_m_s, whole.radius_m());
      for (std::size_t k = 1; k < std::min<std::size_t>(whole.knots().size(), 16); ++k) {
        line.append(whole.knots()[k]);
        if (line.settlesBeforeNext(line.knots().size() - 2)) continue;
        line.settlesAfter(joinedAfter_s(line));
        ++unsettled;
        const Knot& last = line.knots().back();
        const Lorentz bodyFromBoard = Lorentz::boost(-last.u, kC_m_s);
        for (int point = 0; point < 200; ++point) {
          const double around = 2.0 * std::numbers::pi * point / 200.0;
          const Vec3 offset_m = line.radius_m() * Vec3(std::cos(around), std::sin(around), 0.0);
          const Event joined = vertexHistory(line, offset_m).back().start;
          ASSERT_TRUE((bodyFromBoard * (joined - last.turn)).dt_s <= line.settled_s(line.knots().size() - 1))
              << "game " << game << " puck " << puck << " knot " << k << " point " << point;
        }
      }
    }
  }
  EXPECT_GT(unsettled, 200);
}

}  // namespace
}  // namespace carom
