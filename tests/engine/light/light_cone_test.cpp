#include "engine/light/light_cone.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/light/point_history.h"
#include "engine/random_world.h"
#include "sanitized.h"

namespace carom {
namespace {

using test::kC_m_s, test::placeAt;
constexpr double kRounding_m = 1e-10;  // metres travelled by light, double rounding through γ up to 7

/// The root of f(t) = c (t_o − t) − |r_o − r(t)| by bisection: f falls strictly, since the point is slower
/// than light.
double emissionByBisection(const std::vector<VertexPiece>& history, const Event& eye) {
  const auto f = [&](double t_s) {
    return kC_m_s * (eye.t_s - t_s) - glm::length(eye.r_m - placeAt(history, t_s));
  };
  double early_s = eye.t_s - 1.0;
  while (!(f(early_s) > 0.0)) early_s -= 2.0 * (eye.t_s - early_s);
  double late_s = eye.t_s;
  for (int i = 0; i < 200; ++i) {
    const double middle_s = 0.5 * (early_s + late_s);
    (f(middle_s) > 0.0 ? early_s : late_s) = middle_s;
  }
  return early_s;
}

TEST(LightCone, EmissionThroughBouncesMatchesBisection) {
  test::Random random(7);
  int bounced = 0;
  for (int i = 0; i < 20000; ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.02, 0.3);
    const int bounces = static_cast<int>(random.in(0, 21));
    const WorldLine line = randomWorldLine(random, kC_m_s, radius_m, bounces, random.in(0.02, 1.0), 0.9);
    const Vec3 offset_m = random.inBall(radius_m);
    const Event eye{random.in(-1.0, line.knots().back().turn.t_s + 3.0), random.inBox(2.0)};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.95), kC_m_s);
    SCOPED_TRACE(testing::Message() << "case " << i << ": " << bounces << " bounces, eye at " << eye.t_s);
    const auto seen = emission(line, offset_m, eye, headFromBoard);
    ASSERT_TRUE(seen);
    const auto history = vertexHistory(line, offset_m);
    const double t_s = emissionByBisection(history, eye);
    ASSERT_LT(std::abs(seen->event.t_s - t_s) * kC_m_s, kRounding_m * 20);
    ASSERT_LT(glm::length(seen->event.r_m - placeAt(history, t_s)), kRounding_m * 20);
    // The seen displacement is light-like and of the head frame.
    ASSERT_NEAR(kC_m_s * seen->seen.dt_s, -glm::length(seen->seen.dr_m), kRounding_m * 20);
    if (pieceAt(history, t_s).start.t_s > line.knots().front().turn.t_s) ++bounced;
  }
  EXPECT_GT(bounced, 5000);  // the cases do reach through bounces
}

/// What the kernel in double makes of it.
Vec3 seenByKernel(const WorldLine& line, const Vec3& offset_m, const Event& eye,
                  const Lorentz& headFromBoard) {
  BodyView view;
  viewBody(line, eye, headFromBoard, view);
  const auto vertex = emissionIn(view, offset_m);
  return seenFromEye(view, vertex);
}

// The kernel works in the legs' rest frames and looks only at the legs that matter; the history knows all.
TEST(LightCone, KernelMatchesTheWholeHistory) {
  test::Random random(10);
  for (int i = 0; i < 20000; ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.02, 0.3);
    const WorldLine line = randomWorldLine(random, kC_m_s, radius_m, i % 21, random.in(0.02, 1.0), 0.9);
    const Vec3 offset_m = random.inBall(radius_m);
    const Event eye{random.in(-1.0, line.knots().back().turn.t_s + 3.0), random.inBox(2.0)};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.95), kC_m_s);
    const auto seen = emission(line, offset_m, eye, headFromBoard);
    ASSERT_TRUE(seen);
    ASSERT_LT(glm::length(seenByKernel(line, offset_m, eye, headFromBoard) - seen->seen.dr_m), 1e-8)
        << "case " << i;
  }
}

// The line knows to the last digit when the last of some points joins its leg. An eye looks just after the
// centre has shown this moment: of the points behind the centre it still sees the earlier leg.
TEST(LightCone, AnEarlierLegIsLookedAtUntilTheLightOfAllItsPointsIsThere) {
  test::Random random(14);
  int early = 0;
  for (int i = 0; i < 400; ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.02, 0.3);
    WorldLine line = randomWorldLine(random, kC_m_s, radius_m, 1, 0.5, 0.8);
    const Knot& last = line.knots().back();
    const Lorentz boardFromBody = Lorentz::boost(last.u, kC_m_s), bodyFromBoard = boardFromBody.inverse();
    std::vector<Vec3> offsets_m;
    std::vector<double> joined_s;
    for (int point = 0; point < 60; ++point) {
      offsets_m.push_back(random.direction() * radius_m);
      const Event joined = vertexHistory(line, offsets_m.back()).back().start;
      joined_s.push_back((bodyFromBoard * (joined - last.turn)).dt_s);
    }
    const double all_s = *std::max_element(joined_s.begin(), joined_s.end()) * (1.0 + 1e-12);
    line.settlesAfter(all_s);
    ASSERT_EQ(line.settled_s(1), all_s);
    // The eye and the centre's emission in the rest frame of the leg.
    const double shown_s = all_s + random.in(0.0, 1.0) * radius_m / kC_m_s;
    const Vec3 way_m = random.direction() * random.in(1.0, 3.0);
    const double sees_s = shown_s + glm::length(way_m) / kC_m_s;
    const Event eye = last.turn + boardFromBody * Displacement{sees_s, way_m};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.9), kC_m_s);
    for (std::size_t point = 0; point < offsets_m.size(); ++point) {
      const auto seen = emission(line, offsets_m[point], eye, headFromBoard);
      ASSERT_TRUE(seen);
      if ((bodyFromBoard * (seen->event - last.turn)).dt_s < joined_s[point]) ++early;
      const Vec3 byKernel = seenByKernel(line, offsets_m[point], eye, headFromBoard);
      ASSERT_LT(glm::length(byKernel - seen->seen.dr_m), 1e-8) << "point " << point;
    }
  }
  EXPECT_GT(early, 300);
}

// Under friction, bounces far enough apart that signal comes in turn; R a < c²/2.
TEST(LightCone, GlidingBodiesToo) {
  test::Random random(11);
  int gliding = 0;
  for (int i = 0; i < test::casesOf(5000); ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.02, 0.1);
    const double friction_m_s2 = random.in(0.05, 4.0);
    const WorldLine line =
        randomWorldLine(random, kC_m_s, radius_m, i % 6, random.in(1.0, 3.0), 0.9, friction_m_s2);
    const Vec3 offset_m = random.inBall(radius_m);
    const Event eye{random.in(-1.0, line.knots().back().turn.t_s + 3.0), random.inBox(2.0)};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.95), kC_m_s);
    SCOPED_TRACE(testing::Message() << "case " << i << ": friction " << friction_m_s2 << " m/s²");
    const auto seen = emission(line, offset_m, eye, headFromBoard);
    ASSERT_TRUE(seen);
    const auto history = vertexHistory(line, offset_m);
    const double t_s = emissionByBisection(history, eye);
    ASSERT_LT(std::abs(seen->event.t_s - t_s) * kC_m_s, kRounding_m * 20);
    ASSERT_LT(glm::length(seenByKernel(line, offset_m, eye, headFromBoard) - seen->seen.dr_m), 1e-8);
    if (pieceAt(history, t_s).onLeg) ++gliding;
  }
  EXPECT_GT(gliding, test::casesOf(2000));
}

// D = |seen|/ℓ, the distance in the head frame over that in the source's rest frame.
TEST(LightCone, DopplerFactorIsTheRatioOfDistances) {
  test::Random random(8);
  for (int i = 0; i < 1000; ++i) {
    CASE(random, i);
    const Vec3 u = random.u(0.99);
    const WorldLine line({{0.0, random.inBox(1.0)}, u, 0.0, {}, 0.0}, kC_m_s, 0.1);
    const Event eye{random.in(-1, 1), random.inBox(3.0)};
    const auto seen = emission(line, random.inBall(0.1), eye, Lorentz::boost(random.u(0.95), kC_m_s));
    const Displacement inBody = Lorentz::boost(-u, kC_m_s) * (eye - seen->event);
    ASSERT_NEAR(seen->doppler / (glm::length(seen->seen.dr_m) / glm::length(inBody.dr_m)), 1.0, 1e-10) << i;
  }
}

// Longitudinal Doppler sqrt((1+β)/(1−β)); a rod seen end-on has length sqrt((1±β)/(1∓β)) L.
TEST(LightCone, RodAndDopplerEndOn) {
  for (const double beta : {-0.9, -0.5, 0.5, 0.9}) {
    const WorldLine rod({{0.0, Vec3(0.0)}, uFromBeta({beta, 0.0, 0.0}), 0.0, {}, 0.0}, kC_m_s, 0.5);
    const Event eye{0.0, {1000.0, 0.0, 0.0}};  // β > 0 approaches
    const Lorentz headFromBoard(kC_m_s);
    const auto front = emission(rod, {0.5, 0.0, 0.0}, eye, headFromBoard);
    const auto back = emission(rod, {-0.5, 0.0, 0.0}, eye, headFromBoard);
    const double factor = std::sqrt((1 + beta) / (1 - beta));
    EXPECT_NEAR(front->doppler, factor, 1e-12);
    EXPECT_NEAR(front->event.r_m.x - back->event.r_m.x, factor, 1e-9);
  }
}

TEST(LightCone, UnseenBeforeItsFirstLightArrives) {
  const WorldLine line({{0.0, Vec3(0.0)}, Vec3(0.0), 0.0, {}, 0.0}, kC_m_s, 0.1, 2.0);
  const Lorentz headFromBoard(kC_m_s);
  const Vec3 place_m{1.42, 0.0, 0.0};  // a second of light away
  EXPECT_FALSE(emission(line, Vec3(0.0), {2.9, place_m}, headFromBoard));
  EXPECT_TRUE(emission(line, Vec3(0.0), {3.1, place_m}, headFromBoard));
}

// The kernel in float, as the GPU computes it, against the same in double.
TEST(LightCone, FloatKernelKeepsWithinAFewUlpsOfTheDistance) {
  test::Random random(9);
  BodyView view;
  double worst = 0.0;
  for (int i = 0; i < 20000; ++i) {
    CASE(random, i);
    const double radius_m = 0.1;
    const WorldLine line = randomWorldLine(random, kC_m_s, radius_m, i % 4, 0.2, 0.9);
    const Event eye{random.in(-1.0, line.knots().back().turn.t_s + 1.0), random.inBox(2.0)};
    viewBody(line, eye, Lorentz::boost(random.u(0.95), kC_m_s), view);
    const Vec3 d = random.inBall(radius_m);
    const int count = static_cast<int>(view.legs.size());
    const auto exact = emissionIn(view, d);
    const auto exactSeen = kernel::seenFromEye(view.legs[exact.leg], exact.event);
    std::vector<kernel_float::LegView> legs;
    for (const LegView& leg : view.legs) legs.push_back(toFloat(leg));
    const auto rough = kernel_float::solveEmission(legs.data(), count, glm::vec3(d));
    const auto roughSeen = kernel_float::seenFromEye(legs[rough.leg], rough.event);
    const double error = glm::length(glm::dvec3(roughSeen) - exactSeen) / glm::length(exactSeen);
    ASSERT_FALSE(std::isnan(error)) << "case " << i;
    worst = std::max(worst, error);
  }
  RecordProperty("worst_relative_error", testing::PrintToString(worst));
  EXPECT_LT(worst, 2e-5);
}

}  // namespace
}  // namespace carom
