#include "engine/light/mesh_emission.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/light/point_history.h"
#include "engine/meshes.h"

namespace carom {
namespace {

using test::kC_m_s, test::placeAt;
constexpr double kOneLegError = 1e-6;  // of the distance: a few float roundings through γ up to 3
constexpr double kBounceError = 2e-5;  // of the distance: through the frames of two legs, γ up to 2.3 each

/// One random body as one random eye sees it.
struct SeenBody {
  WorldLine line;
  Event eye;
  Lorentz headFromBoard;
  BodyView view;
};

SeenBody randomSeenBody(test::Random& random, double radius_m, int bounces, double maxBeta) {
  const WorldLine line =
      test::randomWorldLine(random, kC_m_s, radius_m, bounces, random.in(0.02, 0.5), maxBeta);
  const Event eye{random.in(-0.5, line.knots().back().turn.t_s + 1.5), random.inBox(2.0)};
  SeenBody made{line, eye, Lorentz::boost(random.u(0.95), kC_m_s), {}};
  viewBody(made.line, made.eye, made.headFromBoard, made.view);
  return made;
}

TEST(MeshEmission, MatchesTheKernelInDouble) {
  test::Random random(21);
  double worst[2]{};
  int bodies[4]{};
  for (int i = 0; i < 6000; ++i) {
    CASE(random, i);
    const SeenBody made = randomSeenBody(random, 0.1, i % 8, 0.9);
    const test::Cloud cloud = test::randomCloud(random, 37, 0.1);
    test::SeenCloud seen(37);
    EXPECT_EQ(seePoints(made.view, cloud.points(), seen.points()), 0U);
    const int legs = static_cast<int>(made.view.legs.size());
    ++bodies[std::min(legs, 3)];
    for (std::size_t k = 0; k < 37; ++k) {
      const auto exact = emissionIn(made.view, cloud.at(k));
      const LegView& leg = made.view.legs[exact.leg];
      const Vec3 expected = kernel::seenFromEye(leg, exact.event);
      const double error = glm::length(seen.at(k) - expected) / glm::length(expected);
      ASSERT_LT(error, legs == 1 ? kOneLegError : kBounceError) << "case " << i << ", legs " << legs;
      worst[legs == 1 ? 0 : 1] = std::max(worst[legs == 1 ? 0 : 1], error);
      const double boardTime_m = kernel::boardTimeOf(leg, exact.event);
      ASSERT_NEAR(seen.boardTime[k] / boardTime_m, 1.0, kBounceError) << "case " << i;
      if (exact.catchingUp) continue;
      const double doppler = glm::length(expected) / kernel::distanceInBody(leg, exact.event);
      ASSERT_NEAR(seen.doppler[k] / doppler, 1.0, kBounceError) << "case " << i;
    }
  }
  RecordProperty("worst_relative_error_one_leg", testing::PrintToString(worst[0]));
  RecordProperty("worst_relative_error_bounces", testing::PrintToString(worst[1]));
  for (int legs = 1; legs <= 3; ++legs) EXPECT_GT(bodies[legs], 300) << legs << " legs";
}

TEST(MeshEmission, AtNinetyNinePercentOnAStraightLeg) {
  test::Random random(22);
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const Knot flight{{random.in(-1, 1), random.inBox(1.0)}, uFromBeta(random.direction() * 0.99), 0, {}, 0};
    const WorldLine line(flight, kC_m_s, 0.1);
    BodyView view;
    viewBody(line, {random.in(-2, 2), random.inBox(2.0)}, Lorentz(kC_m_s), view);
    const test::Cloud cloud = test::randomCloud(random, 8, 0.1);
    test::SeenCloud seen(8);
    seePoints(view, cloud.points(), seen.points());
    for (std::size_t k = 0; k < 8; ++k) {
      const auto exact = emissionIn(view, cloud.at(k));
      const Vec3 expected = kernel::seenFromEye(view.legs[0], exact.event);
      ASSERT_LT(glm::length(seen.at(k) - expected) / glm::length(expected), 2e-6) << "case " << i;
    }
  }
}

// A vertex on its way between two legs has the colour of the leg it comes from.
TEST(MeshEmission, CatchingUpVerticesKeepTheDopplerFactorOfTheirIncomingLeg) {
  test::Random random(23);
  int catchingUp = 0;
  for (int i = 0; i < 4000; ++i) {
    CASE(random, i);
    const SeenBody made = randomSeenBody(random, 0.1, 1 + i % 3, 0.9);
    const test::Cloud cloud = test::randomCloud(random, 8, 0.1);
    test::SeenCloud seen(8);
    seePoints(made.view, cloud.points(), seen.points());
    for (std::size_t k = 0; k < 8; ++k) {
      const auto exact = emissionIn(made.view, cloud.at(k));
      if (!exact.catchingUp) continue;
      ++catchingUp;
      // ν_seen/ν_emitted = (k·u_head)/(k·u_source), in the board frame.
      const Vec3 seenInHead = kernel::seenFromEye(made.view.legs[exact.leg], exact.event);
      const Displacement fromEye =
          made.headFromBoard.inverse() * Displacement{-glm::length(seenInHead) / kC_m_s, seenInHead};
      const Vec3& u = made.line.knots()[made.view.firstLeg + exact.leg - 1].u;
      const double inBody_m = (Lorentz::boost(-u, kC_m_s) * fromEye).dt_s * -kC_m_s;
      ASSERT_NEAR(seen.doppler[k] * inBody_m / glm::length(seenInHead), 1.0, 1e-4) << "case " << i;
    }
  }
  EXPECT_GT(catchingUp, 500);
}

// f(t) = c (t_o − t) − |r_o − r(t)| falls strictly along every vertex, through every bounce: it changes sign
// once, and the mesh solve finds that place. Bisection of the same vertices' world lines, in double.
TEST(MeshEmission, OneRootThroughChainsOfBouncesForHundredThousandVertices) {
  constexpr std::size_t kVertices = 50;
  test::Random random(24);
  std::size_t throughBounces = 0;
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.02, 0.3);
    const int bounces = static_cast<int>(random.in(1, 21));
    const SeenBody made = randomSeenBody(random, radius_m, bounces, 0.9);
    const test::Cloud cloud = test::randomCloud(random, kVertices, radius_m);
    test::SeenCloud seen(kVertices);
    seePoints(made.view, cloud.points(), seen.points());
    SCOPED_TRACE(testing::Message() << "case " << i << ": " << bounces << " bounces, eye at "
                                    << made.eye.t_s);
    for (std::size_t k = 0; k < kVertices; ++k) {
      const auto history = vertexHistory(made.line, cloud.at(k));
      const auto f = [&](double t_s) {
        return kC_m_s * (made.eye.t_s - t_s) - glm::length(made.eye.r_m - placeAt(history, t_s));
      };
      int roots = 0;
      double last = f(made.eye.t_s - 100.0);
      ASSERT_GT(last, 0.0);
      for (std::size_t p = 1; p < history.size(); ++p) {
        if (history[p].start.t_s - history[p - 1].start.t_s < 1e-9) continue;  // shorter than rounding
        ASSERT_LT(glm::length(betaFromU(history[p].u)), 1.0);
        const double value = f(history[p].start.t_s);
        ASSERT_LT(value, last) << "vertex " << k << ", piece " << p;
        roots += last > 0.0 && value <= 0.0 ? 1 : 0;
        last = value;
      }
      roots += last > 0.0 ? 1 : 0;  // on the last piece, which has no end
      ASSERT_EQ(roots, 1) << "vertex " << k;

      double early_s = made.eye.t_s - 100.0;
      double late_s = made.eye.t_s;
      for (int step = 0; step < 60; ++step) {
        const double middle_s = 0.5 * (early_s + late_s);
        (f(middle_s) > 0.0 ? early_s : late_s) = middle_s;
      }
      const Displacement fromEye = Event{early_s, placeAt(history, early_s)} - made.eye;
      const Vec3 expected = (made.headFromBoard * fromEye).dr_m;
      ASSERT_LT(glm::length(seen.at(k) - expected), kBounceError * glm::length(expected) + 1e-9)
          << "vertex " << k;
      if (early_s > made.line.knots()[0].turn.t_s && made.view.legs.size() > 1) ++throughBounces;
    }
  }
  EXPECT_GT(throughBounces, 20000U);
}

TEST(MeshEmission, SameBitsForSlicesThreadsAndInstructionSets) {
  test::Random random(25);
  int bodies[4]{};
  for (int i = 0; i < 60; ++i) {
    CASE(random, i);
    const SeenBody made = randomSeenBody(random, 0.1, i % 6, 0.9);
    ++bodies[std::min<std::size_t>(made.view.legs.size(), 3)];
    const std::size_t count = 3 * MeshView::kSlice + 77;
    const test::Cloud cloud = test::randomCloud(random, count, 0.1);
    test::SeenCloud whole(count);
    seePoints(made.view, cloud.points(), whole.points(), InstructionSet::baseline);
    for (const InstructionSet wide : {InstructionSet::avx2, InstructionSet::avx512}) {
      if (wide > bestInstructionSet()) continue;
      test::SeenCloud seen(count);
      seePoints(made.view, cloud.points(), seen.points(), wide);
      ASSERT_TRUE(seen == whole) << "case " << i << ", instruction set " << static_cast<int>(wide);
    }
    test::SeenCloud sliced(count);
    for (std::size_t first = 0; first < count;) {
      const std::size_t size = std::min(count - first, static_cast<std::size_t>(random.in(1.0, 700.0)));
      seePoints(made.view, cloud.points().slice(first, size), sliced.points().slice(first, size));
      first += size;
    }
    ASSERT_TRUE(sliced == whole) << "case " << i;
    RigidMeshView view(made.line, cloud.points());
    view.look(made.eye, made.headFromBoard);
    for (const int threads : {1, 2, 8}) {
      ASSERT_TRUE(test::seeOnThreads(view, threads) == whole)
          << "case " << i << ", " << threads << " threads";
    }
  }
  for (int legs = 1; legs <= 3; ++legs) EXPECT_GT(bodies[legs], 2) << legs << " legs";
}

TEST(MeshEmission, PlacesDoNotDependOnWhatElseIsAsked) {
  test::Random random(26);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    const SeenBody made = randomSeenBody(random, 0.1, i % 6, 0.9);
    const test::Cloud cloud = test::randomCloud(random, 100, 0.1);
    test::SeenCloud all(100);
    test::SeenCloud places(100);
    seePoints(made.view, cloud.points(), all.points());
    seePoints(made.view, cloud.points(), {places.x, places.y, places.z, {}, {}});
    ASSERT_EQ(places.x, all.x);
    ASSERT_EQ(places.y, all.y);
    ASSERT_EQ(places.z, all.z);
  }
}

TEST(MeshEmission, CountsAndHidesWhatIsNotThereYet) {
  test::Random random(27);
  const WorldLine line({{0.0, Vec3(0.0)}, uFromBeta({0.3, 0, 0}), 0.0, {}, 0.0}, kC_m_s, 0.3, 2.0);
  const test::Cloud cloud = test::randomCloud(random, 1500, 0.3);
  const Lorentz headFromBoard(kC_m_s);
  std::size_t between = 0;
  for (double t_s = 2.0; t_s < 5.0; t_s += 0.05) {
    const Event eye{t_s, {2.0, 0.0, 0.0}};
    RigidMeshView view(line, cloud.points());
    view.look(eye, headFromBoard);
    test::SeenCloud seen(1500);
    const std::size_t unseen = view.see(0, seen.points());
    std::size_t expected = 0;
    for (std::size_t k = 0; k < 1500; ++k) {
      const bool there = view.emission(k).has_value();
      expected += there ? 0 : 1;
      ASSERT_EQ(there, !std::isnan(seen.x[k]));
    }
    ASSERT_EQ(unseen, expected) << t_s;
    between += unseen > 0 && unseen < 1500 ? 1 : 0;
  }
  EXPECT_GT(between, 2U);
}

// Under friction: against the single point, and the Doppler factor against ν_seen/ν_emitted = |seen|/ℓ in the
// rest frame of the vertex's own motion.
TEST(MeshEmission, UnderFriction) {
  test::Random random(29);
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    Knot glide{{0.0, random.inBox(0.5)}, random.u(0.8), 0.0, {}, random.in(0.1, 3.0)};
    glide.signal = glide.turn;
    const WorldLine line(glide, kC_m_s, 0.1);
    const test::Cloud cloud = test::randomCloud(random, 10, 0.1);
    RigidMeshView view(line, cloud.points());
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.9), kC_m_s);
    view.look({random.in(0.0, 4.0), random.inBox(2.0)}, headFromBoard);
    test::SeenCloud seen(10);
    view.see(0, seen.points());
    for (std::size_t k = 0; k < 10; ++k) {
      const auto exact = view.emission(k);
      const double distance_m = glm::length(exact->seen.dr_m);
      ASSERT_LT(glm::length(seen.at(k) - exact->seen.dr_m), kOneLegError * distance_m) << "case " << i;
      ASSERT_NEAR(seen.doppler[k] / exact->doppler, 1.0, 1e-5) << "case " << i;
    }
  }
}

TEST(MeshEmission, OwnClocksAreThoseOfTheSinglePoint) {
  test::Random random(28);
  for (int i = 0; i < 300; ++i) {
    CASE(random, i);
    const SeenBody made = randomSeenBody(random, 0.1, i % 5, 0.9);
    const test::Cloud cloud = test::randomCloud(random, 10, 0.1);
    RigidMeshView view(made.line, cloud.points());
    view.look(made.eye, made.headFromBoard);
    test::SeenCloud seen(10);
    view.see(0, seen.points());
    std::vector<double> own_s(10);
    view.properTimes(0, seen.boardTime, own_s);
    for (std::size_t k = 0; k < 10; ++k) {
      // Within the rounding of the emission time: 1e-5 of some metres of light.
      ASSERT_NEAR(own_s[k], view.emission(k)->properTime_s, 2e-4) << "case " << i;
    }
  }
}

}  // namespace
}  // namespace carom
