#include "engine/light/vertex_ring.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "engine/light/ring_view.h"
#include "engine/light_speed.h"
#include "engine/meshes.h"

namespace carom {
namespace {

using test::kC_m_s;
constexpr double kSampleHz = 60.0;
constexpr double kFloat = 1e-5;  // of the distance: float roundings in the board frame, γ up to 2

/// Something soft: every vertex circles at its own radius and pace, at most 0.5 c, around a place of its own.
class Swarm {
 public:
  Swarm(test::Random& random, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const double radius_m = random.in(0.01, 0.1);
      swirls_.push_back(
          {random.inBall(0.2), radius_m, random.in(0.1, 0.5) * kC_m_s / radius_m, random.in(0, 6)});
    }
  }
  std::size_t size() const { return swirls_.size(); }
  Vec3 at(std::size_t i, double t_s) const {
    const Swirl& s = swirls_[i];
    const double angle = s.rate_rad_s * t_s + s.phase_rad;
    return s.middle_m + s.radius_m * Vec3(std::cos(angle), std::sin(angle), 0.0);
  }
  double speed_m_s(std::size_t i) const { return swirls_[i].radius_m * swirls_[i].rate_rad_s; }
  double sagitta_m(std::size_t i, double dt_s) const {  // of a chord of duration dt
    const double half_rad = std::min(0.5 * swirls_[i].rate_rad_s * dt_s, 1.5);
    return swirls_[i].radius_m * (1.0 - std::cos(half_rad));
  }
  /// The vertices' events at t_s; those of odd vertices a little later, as nothing says they are
  /// simultaneous.
  void sample(double t_s, VertexRing& ring) {
    ct_.resize(size());
    x_.resize(size());
    y_.resize(size());
    z_.resize(size());
    const Event anchor{t_s, {0.01, -0.02, 0.03}};
    for (std::size_t i = 0; i < size(); ++i) {
      const double later_s = i % 2 == 0 ? 0.0 : 0.004;
      const Vec3 r_m = at(i, t_s + later_s) - anchor.r_m;
      ct_[i] = static_cast<float>(kC_m_s * later_s);
      x_[i] = static_cast<float>(r_m.x);
      y_[i] = static_cast<float>(r_m.y);
      z_[i] = static_cast<float>(r_m.z);
    }
    ring.append({anchor, ct_, x_, y_, z_});
  }

 private:
  struct Swirl {
    Vec3 middle_m;
    double radius_m, rate_rad_s, phase_rad;
  };
  std::vector<Swirl> swirls_;
  std::vector<float> ct_, x_, y_, z_;
};

VertexRing sampled(Swarm& swarm, double from_s, double until_s, std::size_t capacity) {
  VertexRing ring(swarm.size(), capacity, kC_m_s);
  for (double t_s = from_s; t_s < until_s; t_s += 1.0 / kSampleHz) swarm.sample(t_s, ring);
  return ring;
}

/// Emission time of a vertex on its own true path, by bisection.
double emissionByBisection(const Swarm& swarm, std::size_t i, const Event& eye) {
  double early_s = eye.t_s - 100.0;
  double late_s = eye.t_s;
  for (int step = 0; step < 80; ++step) {
    const double t_s = 0.5 * (early_s + late_s);
    const double f = kC_m_s * (eye.t_s - t_s) - glm::length(eye.r_m - swarm.at(i, t_s));
    (f > 0.0 ? early_s : late_s) = t_s;
  }
  return early_s;
}

TEST(VertexRing, SinglePointsMatchBisectionOfTheTruePath) {
  test::Random random(41);
  Swarm swarm(random, 200);
  const VertexRing ring = sampled(swarm, 0.0, 4.0, 300);
  RingView view(ring);
  for (int n = 0; n < 50; ++n) {
    CASE(random, n);
    const Event eye{random.in(3.0, 4.0), random.direction() * random.in(0.4, 1.0)};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.9), kC_m_s);
    view.look(eye, headFromBoard);
    for (std::size_t i = 0; i < swarm.size(); ++i) {
      const auto seen = view.emission(i);
      ASSERT_TRUE(seen);
      const double t_s = emissionByBisection(swarm, i, eye);
      // Off the true path by the sagitta of a chord, and so in time by that over c − v.
      const double tolerance_m = swarm.sagitta_m(i, 1.0 / kSampleHz) * 1.01 + 1e-6;
      ASSERT_NEAR(seen->event.t_s, t_s, tolerance_m / (kC_m_s - swarm.speed_m_s(i))) << "vertex " << i;
      ASSERT_NEAR(kC_m_s * seen->seen.dt_s, -glm::length(seen->seen.dr_m), 1e-9);
      const double gamma = 1.0 / std::sqrt(1.0 - std::pow(swarm.speed_m_s(i) / kC_m_s, 2));
      ASSERT_NEAR(gammaFromU(seen->u), gamma, 0.02 * gamma);
    }
  }
}

TEST(VertexRing, WholeMeshMatchesSinglePoints) {
  test::Random random(42);
  Swarm swarm(random, 333);
  const VertexRing ring = sampled(swarm, 0.0, 4.0, 300);
  RingView view(ring);
  for (int n = 0; n < 200; ++n) {
    CASE(random, n);
    view.look({random.in(0.0, 5.5), random.direction() * random.in(0.4, 1.5)},
              Lorentz::boost(random.u(0.9), kC_m_s));
    test::SeenCloud seen(swarm.size());
    const std::size_t unseen = view.see(0, seen.points());
    std::vector<double> own_s(swarm.size());
    view.properTimes(0, seen.boardTime, own_s);
    std::size_t expectedUnseen = 0;
    for (std::size_t i = 0; i < swarm.size(); ++i) {
      const auto exact = view.emission(i);
      ASSERT_EQ(exact.has_value(), !std::isnan(seen.x[i])) << "vertex " << i;
      expectedUnseen += exact ? 0 : 1;
      if (!exact) continue;
      const double distance_m = glm::length(exact->seen.dr_m);
      ASSERT_LT(glm::length(seen.at(i) - exact->seen.dr_m), kFloat * (distance_m + 1.0)) << "vertex " << i;
      ASSERT_NEAR(seen.doppler[i] / exact->doppler, 1.0, 1e-3);
      ASSERT_NEAR(own_s[i], exact->properTime_s, kFloat);
    }
    ASSERT_EQ(unseen, expectedUnseen);
  }
}

// The two histories, asked through the one interface, about the same straight flight.
TEST(VertexRing, AgreesWithTheKnotsOfTheSameFlight) {
  test::Random random(43);
  for (int n = 0; n < 20; ++n) {
    CASE(random, n);
    const test::Cloud cloud = test::randomCloud(random, 150, 0.1);
    const WorldLine line({{0.0, random.inBox(0.2)}, random.u(0.8), 0.0, {}, 0.0}, kC_m_s, 0.1);
    const Vec3& u = line.knots().front().u;
    VertexRing ring(cloud.points().size(), 200, kC_m_s);
    // Samples simultaneous in the body's own frame.
    for (double own_s = -1.0; own_s < 1.5; own_s += 1.0 / kSampleHz) {
      const Lorentz boardFromBody = Lorentz::boost(u, kC_m_s);
      const Event anchor = line.knots().front().turn + boardFromBody * Displacement{own_s, Vec3(0.0)};
      test::SeenCloud sample(cloud.points().size());
      for (std::size_t i = 0; i < sample.x.size(); ++i) {
        const Displacement d = boardFromBody * Displacement{0.0, cloud.at(i)};
        sample.boardTime[i] = static_cast<float>(kC_m_s * d.dt_s);
        sample.x[i] = static_cast<float>(d.dr_m.x);
        sample.y[i] = static_cast<float>(d.dr_m.y);
        sample.z[i] = static_cast<float>(d.dr_m.z);
      }
      ring.append({anchor, sample.boardTime, sample.x, sample.y, sample.z});
    }
    RigidMeshView rigid(line, cloud.points());
    RingView soft(ring);
    const Event eye = line.knots().front().turn + Displacement{random.in(0.9, 1.2), random.direction() * 0.8};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.9), kC_m_s);
    test::SeenCloud seen[2]{test::SeenCloud(150), test::SeenCloud(150)};
    MeshView* const views[2]{&rigid, &soft};
    for (int k = 0; k < 2; ++k) {
      views[k]->look(eye, headFromBoard);
      ASSERT_EQ(views[k]->see(0, seen[k].points()), 0U);
    }
    for (std::size_t i = 0; i < 150; ++i) {
      ASSERT_LT(glm::length(seen[0].at(i) - seen[1].at(i)), 2 * kFloat * (1.0 + glm::length(seen[0].at(i))));
      ASSERT_NEAR(seen[1].doppler[i] / seen[0].doppler[i], 1.0, 1e-3);
    }
  }
}

// An eye may step back in time, far or near: what it sees does not depend on what it saw before.
TEST(VertexRing, CursorsStepBack) {
  test::Random random(44);
  Swarm swarm(random, 3000);
  const VertexRing ring = sampled(swarm, 0.0, 4.0, 300);
  RingView kept(ring);
  double t_s = 3.0;
  for (int n = 0; n < 300; ++n) {
    CASE(random, n);
    t_s = n % 20 == 0 ? random.in(0.0, 5.0) : t_s + random.in(-0.12, 0.12);
    const Event eye{t_s, random.direction() * 0.8};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.9), kC_m_s);
    RingView fresh(ring);
    kept.look(eye, headFromBoard);
    fresh.look(eye, headFromBoard);
    ASSERT_TRUE(test::seeOnThreads(kept, 1) == test::seeOnThreads(fresh, 1)) << "look " << n << " at " << t_s;
  }
}

TEST(VertexRing, SameBitsForThreadsAndInstructionSets) {
  test::Random random(45);
  Swarm swarm(random, 5 * MeshView::kSlice + 321);
  const VertexRing ring = sampled(swarm, 0.0, 2.0, 150);
  RingView views[3]{RingView(ring), RingView(ring), RingView(ring)};
  RingView baseline(ring, InstructionSet::baseline);
  for (int n = 0; n < 10; ++n) {
    CASE(random, n);
    const Event eye{random.in(1.0, 2.5), random.direction() * 0.8};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.9), kC_m_s);
    baseline.look(eye, headFromBoard);
    const test::SeenCloud expected = test::seeOnThreads(baseline, 1);
    const int threads[3]{1, 2, 8};
    for (int k = 0; k < 3; ++k) {
      views[k].look(eye, headFromBoard);
      ASSERT_TRUE(test::seeOnThreads(views[k], threads[k]) == expected) << threads[k] << " threads";
    }
  }
}

// Two eyes and a ring that is trimmed for them see the same as with a ring that keeps everything.
TEST(VertexRing, TrimsOnlyWhatNoEyeWillLookAtAgain) {
  test::Random random(46);
  Swarm swarm(random, 100);
  VertexRing all(swarm.size(), 1000, kC_m_s);
  VertexRing trimmed(swarm.size(), 400, kC_m_s);
  RingView fromAll(all);
  RingView fromTrimmed(trimmed);
  std::size_t most = 0;
  for (int n = 0; n < 900; ++n) {
    CASE(random, n);
    const double t_s = n / kSampleHz;
    swarm.sample(t_s, all);
    swarm.sample(t_s, trimmed);
    const Event eyes[2]{{t_s, {0.6, 0.1 * std::sin(t_s), 0.2}}, {t_s - 0.05, {2.0, 0.0, 0.3}}};
    trimmed.trim(eyes);
    for (const Event& eye : eyes) {
      // The eye may be a little earlier than it was.
      const Event back = eye - Displacement{random.in(0.0, 0.3 * kEyeStepsBack_m / kC_m_s), Vec3(0.0)};
      fromAll.look(back, Lorentz(kC_m_s));
      fromTrimmed.look(back, Lorentz(kC_m_s));
      ASSERT_TRUE(test::seeOnThreads(fromAll, 1) == test::seeOnThreads(fromTrimmed, 1)) << "frame " << n;
      // What is left begins with a sample that the eye sees of every vertex, however far it steps back.
      for (std::size_t vertex = 0; vertex < swarm.size() && trimmed.sampleCount() < all.sampleCount();
           ++vertex) {
        const Displacement way = eye - trimmed.eventOf(0, vertex);
        ASSERT_GE(kC_m_s * way.dt_s - glm::length(way.dr_m), kEyeStepsBack_m - 1e-6) << "frame " << n;
      }
    }
    most = std::max(most, trimmed.sampleCount());
  }
  EXPECT_EQ(all.sampleCount(), 900U);
  EXPECT_LT(most, 200U);
}

// No eye moves on, so nothing may be forgotten: the ring stays within its capacity, without gaps.
TEST(VertexRing, AFullRingGrowsCoarserWithAge) {
  test::Random random(47);
  Swarm swarm(random, 50);
  VertexRing ring(swarm.size(), 100, kC_m_s);
  for (int n = 0; n < 5000; ++n) swarm.sample(n / kSampleHz, ring);
  EXPECT_EQ(ring.sampleCount(), 100U);
  EXPECT_NEAR(ring.eventOf(0, 0).t_s, 0.0, 1e-6);
  EXPECT_NEAR(ring.eventOf(99, 0).t_s, 4999 / kSampleHz, 1e-6);
  double lastOwn_s = -1.0;
  for (std::size_t k = 0; k < 100; ++k) {
    CASE(random, k);
    EXPECT_GT(ring.properTime_s(k, 7), lastOwn_s);
    lastOwn_s = ring.properTime_s(k, 7);
    if (k == 0) continue;
    const Displacement d = ring.eventOf(k, 7) - ring.eventOf(k - 1, 7);
    EXPECT_GT(interval_m2(d, kC_m_s), 0.0);
    const double age_s = 4999 / kSampleHz - ring.eventOf(k, 7).t_s;
    EXPECT_LT(d.dt_s, 0.3 * age_s + 3 / kSampleHz) << "sample " << k;  // fine where it matters
  }
}

TEST(VertexRing, KeepsItsPrecisionAfterADay) {
  for (const double begin_s : {0.0, 3600.0, 86400.0}) {
    test::Random random(48);
    Swarm swarm(random, 100);
    VertexRing ring(swarm.size(), 300, kC_m_s);
    for (int n = 0; n < 200; ++n) swarm.sample(begin_s + n / kSampleHz, ring);
    RingView view(ring);
    const Event eye{begin_s + 3.0, {0.8, 0.1, 0.2}};
    view.look(eye, Lorentz(kC_m_s));
    test::SeenCloud seen(swarm.size());
    ASSERT_EQ(view.see(0, seen.points()), 0U);
    for (std::size_t i = 0; i < swarm.size(); ++i) {
      CASE(random, i);
      ASSERT_LT(glm::length(seen.at(i) - view.emission(i)->seen.dr_m), kFloat) << begin_s << " s";
    }
  }
}

TEST(VertexRing, RefusesWhatIsNotSlowerThanLightAndKeepsNothingOfIt) {
  VertexRing ring(2, 10, kC_m_s);
  const float zero[2]{};
  const float moved[2]{0.0F, 0.1F};
  ring.append({{0.0, Vec3(0.0)}, zero, zero, zero, zero});
  EXPECT_THROW(ring.append({{0.05, Vec3(0.0)}, zero, moved, zero, zero}), std::invalid_argument);  // 1.4 c
  EXPECT_THROW(ring.append({{0.0, Vec3(0.0)}, zero, zero, zero, zero}), std::invalid_argument);
  EXPECT_THROW(ring.append({{NAN, Vec3(0.0)}, zero, zero, zero, zero}), std::invalid_argument);
  EXPECT_THROW(ring.append({{1.0, Vec3(0.0)}, {zero, 1}, zero, zero, zero}), std::invalid_argument);
  EXPECT_EQ(ring.sampleCount(), 1U);
  ring.append({{0.1, Vec3(0.0)}, zero, moved, zero, zero});  // 0.7 c
  EXPECT_NEAR(ring.properTime_s(1, 0), 0.1, 1e-8);
  EXPECT_NEAR(ring.properTime_s(1, 1), 0.1 * std::sqrt(1.0 - std::pow(1.0 / kC_m_s, 2)), 1e-6);
  EXPECT_THROW(VertexRing(0, 10, kC_m_s), std::invalid_argument);
  EXPECT_THROW(VertexRing(10, 2, kC_m_s), std::invalid_argument);
}

TEST(VertexRing, UnseenBeforeTheFirstSampleAndOnwardAfterTheLast) {
  VertexRing ring(1, 10, kC_m_s);
  RingView view(ring);
  test::SeenCloud seen(1);
  view.look({0.0, Vec3(0.0)}, Lorentz(kC_m_s));
  EXPECT_EQ(view.see(0, seen.points()), 1U);
  EXPECT_FALSE(view.emission(0));
  const float zero[1]{};
  const float moved[1]{0.071F};
  ring.append({{0.0, Vec3(0.0)}, zero, zero, zero, zero});
  view.look({1.0, {0.71, 0.0, 0.0}}, Lorentz(kC_m_s));  // a single sample: at rest
  EXPECT_EQ(view.see(0, seen.points()), 0U);
  EXPECT_NEAR(seen.x[0], -0.71, 1e-6);
  EXPECT_NEAR(seen.boardTime[0], -0.71, 1e-6);
  EXPECT_NEAR(view.emission(0)->properTime_s, 0.5, 1e-9);
  view.look({0.4, {0.71, 0.0, 0.0}}, Lorentz(kC_m_s));
  EXPECT_EQ(view.see(0, seen.points()), 1U);
  EXPECT_TRUE(std::isnan(seen.x[0]));
  ring.append({{0.1, Vec3(0.0)}, zero, moved, zero, zero});  // half the speed of light, towards the eye
  view.look({1.0, {1.42, 0.0, 0.0}},
            Lorentz(kC_m_s));  // seen as it left: x = 0.71 t, 1.42 − x = 1.42 (1 − t)
  EXPECT_EQ(view.see(0, seen.points()), 0U);
  EXPECT_NEAR(seen.x[0], -1.42, 1e-6);
  view.look({1.5, {1.42, 0.0, 0.0}}, Lorentz(kC_m_s));  // 1.42 − 0.71 t = 1.42 (1.5 − t): t = 1
  EXPECT_EQ(view.see(0, seen.points()), 0U);
  EXPECT_NEAR(seen.x[0], -0.71, 1e-6);
  EXPECT_NEAR(seen.doppler[0], std::sqrt(3.0), 1e-5);
}

}  // namespace
}  // namespace carom
