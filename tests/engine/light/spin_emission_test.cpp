// What an eye sees of the points of spinning bodies: exact cases, closed forms, and the kernel against the
// world lines of vertex_history.h, which are followed by bisection.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/base/root.h"
#include "engine/light/mesh_emission.h"
#include "engine/light/vertex_history.h"
#include "engine/light_speed.h"
#include "engine/meshes.h"
#include "engine/random_world.h"
#include "exact_cases.h"

namespace carom {
namespace {

using Json = nlohmann::json;

using test::kC_m_s;
constexpr double kOfDistance = 2e-6;  // the error of float that is allowed, as a fraction of the distance

Vec3 vec3(const Json& json) { return {json[0], json[1], json[2]}; }

WorldLine spinningLine(const Event& turn, const Vec3& u, const Spin& spin, double c_m_s, double radius_m) {
  return WorldLine({turn, u, 0.0, turn, 0.0, spin}, c_m_s, radius_m);
}

// Written so that NaN fails.
void expectWithin(double value, double expected, double tolerance, const char* what) {
  EXPECT_TRUE(std::abs(value - expected) <= tolerance) << what << " = " << value << ", expected " << expected;
}

void expectWithin(const Vec3& value, const Json& expected, double tolerance, const char* what) {
  for (int i = 0; i < 3; ++i) expectWithin(value[i], expected[static_cast<std::size_t>(i)], tolerance, what);
}

TEST(SpinEmission, allOfTheOracle) {
  for (const Json& one : test::exactCases("spin_emission.json")) {
    SCOPED_TRACE(one["id"].get<std::string>());
    const Json &input = one["input"], &expected = one["expected"], &tol = one["tol"];
    const double c_m_s = input["c"];
    const Event turn{input["centre"]["t"], vec3(input["centre"]["r"])};
    const Vec3 d_m = vec3(input["xi"]);
    const WorldLine line = spinningLine(turn, uFromBeta(vec3(input["centre"]["v"]) / c_m_s),
                                        {0.0, input["omega"]}, c_m_s, glm::length(d_m));
    const Event eye{input["observer"]["t"], vec3(input["observer"]["r"])};
    const Vec3 uEye = uFromBeta(vec3(input["observer"]["v"]) / c_m_s);
    const auto seen = emission(line, d_m, eye, Lorentz::boost(-uEye, c_m_s));
    ASSERT_TRUE(seen);
    expectWithin(seen->event.t_s, expected["t_e"], tol["t_e"], "t_e");
    expectWithin(seen->event.r_m, expected["r_e"], tol["r_e"], "r_e");
    expectWithin(c_m_s * betaFromU(seen->u), expected["velocity_at_emission"], tol["velocity_at_emission"],
                 "v");
    expectWithin(seen->seen.dr_m, expected["apparent_position_observer"], tol["apparent_position_observer"],
                 "seen");
    expectWithin(seen->doppler, expected["doppler"], tol["doppler"], "doppler");
    // The oracle counts from the anchor event, here time counts from board time 0.
    const auto history = vertexHistory(line, d_m);
    const Displacement anchor = Lorentz::boost(line.knots()[0].u, c_m_s) * Displacement{0.0, d_m};
    const double since_s = seen->properTime_s - properTimeAt(history[0], (turn + anchor).t_s, c_m_s);
    expectWithin(since_s, expected["proper_time_since_anchor"], tol["proper_time_since_anchor"], "own time");
  }
}

// From its axis all points of a rim are seen at one time, and red by the transverse Doppler factor 1/γ.
TEST(SpinEmission, FromTheAxisTheRimIsSeenAtOnce) {
  const double radius_m = 0.3, height_m = 0.7, f = 0.95;
  const WorldLine line = spinningLine({}, Vec3(0.0), {0.3, f * kC_m_s / radius_m}, kC_m_s, radius_m);
  for (int i = 0; i < 12; ++i) {
    const Vec3 d_m = radius_m * Vec3(std::cos(i), std::sin(i), 0.0);
    const auto seen = emission(line, d_m, {2.0, {0.0, 0.0, height_m}}, Lorentz(kC_m_s));
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->event.t_s, 2.0 - std::hypot(radius_m, height_m) / kC_m_s, 1e-14);
    EXPECT_NEAR(seen->doppler, std::sqrt(1.0 - f * f), 1e-14);
  }
}

// From afar in its plane, the edge that approaches has D = sqrt((1+f)/(1−f)), the one that recedes the
// inverse, and a point at the angle φ is seen when E + f sin E = φ_now: Kepler's equation.
TEST(SpinEmission, FromAfarObeysKeplersEquation) {
  const double radius_m = 0.03, f = 0.9, far_m = 1e7, turn_rad_s = f * kC_m_s / radius_m;
  const WorldLine line = spinningLine({}, Vec3(0.0), {0.0, turn_rad_s}, kC_m_s, radius_m);
  double bluest = 0.0, reddest = 10.0;
  for (int i = 0; i < 1000; ++i) {
    const double phase = 0.02 * i;
    const Event eye{far_m / kC_m_s, {far_m, 0.0, 0.0}};
    const auto seen =
        emission(line, radius_m * Vec3(std::cos(phase), std::sin(phase), 0.0), eye, Lorentz(kC_m_s));
    ASSERT_TRUE(seen);
    const double angle =
        phase + turn_rad_s * seen->event.t_s;  // of the point at emission; E = angle + π/2 turned
    EXPECT_NEAR(angle - f * std::cos(angle), phase, 3e-7 * turn_rad_s / kC_m_s);  // rounding of 10⁷ m
    bluest = std::max(bluest, seen->doppler);
    reddest = std::min(reddest, seen->doppler);
  }
  EXPECT_NEAR(bluest, std::sqrt((1.0 + f) / (1.0 - f)), 1e-2);
  EXPECT_NEAR(reddest, std::sqrt((1.0 - f) / (1.0 + f)), 1e-3);
}

// A wheel that rolls along x with β = f, clockwise: its lowest point, at −y, rests on the board for an
// instant, and a turn takes it 2πRγ far.
TEST(SpinEmission, TheLowestPointOfARollingWheelRests) {
  const double radius_m = 0.5, beta = 0.9, turn_rad_s = -beta * kC_m_s / radius_m;
  const Vec3 u = uFromBeta({beta, 0.0, 0.0});
  const WorldLine line = spinningLine({}, u, {0.0, turn_rad_s}, kC_m_s, radius_m);
  const double turn_m = 2.0 * std::numbers::pi * radius_m * u.x / beta;
  for (int turns = 0; turns < 3; ++turns) {
    const auto history = vertexHistory(line, {0.0, -radius_m, 0.0});
    const double t_s = turns * turn_m / (beta * kC_m_s);
    EXPECT_NEAR(glm::length(uAt(history[0], t_s, kC_m_s)), 0.0, 1e-13);
    EXPECT_NEAR(glm::length(placeAt(history[0], t_s, kC_m_s) - Vec3(turns * turn_m, -radius_m, 0.0)), 0.0,
                1e-13);
  }
}

WorldLine spinningAndBouncing(test::Random& random, double radius_m, int bounces, double spacing_s,
                              double maxRim) {
  return test::spun(random, test::randomWorldLine(random, kC_m_s, radius_m, bounces, spacing_s, 0.9), maxRim);
}

Lorentz randomHead(test::Random& random) {
  return Lorentz::boost(random.u(0.95), kC_m_s) *
         Lorentz::rotation(glm::angleAxis(random.in(0.0, 3.0), random.direction()), kC_m_s);
}

/// The larger of the distances in the head frame and in the body's, since a fast observer sees far things
/// near.
double distanceOf(const LegView& leg, const kernel::VertexEmission& emission) {
  return std::max(glm::length(kernel::seenFromEye(leg, emission.event)),
                  kernel::distanceInBody(leg, emission.event));
}

// At board times up to a day, rims up to 0.99 c, bodies up to 0.9 c: the kernel in double and in float, and
// the solve of whole meshes, against the bisected world line.
TEST(SpinEmission, TheKernelFindsWhatBisectionFinds) {
  test::Random random(1);
  double worstFloat = 0.0, worstDouble = 0.0;
  for (int i = 0; i < 10000; ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.02, 0.3), day_s = random.in(0.0, 1.0) < 0.5 ? 86400.0 : 100.0;
    const double rim = (random.in(0.0, 1.0) < 0.5 ? 0.99 : 0.999) * random.in(-1.0, 1.0);
    const Event turn{random.in(0.0, day_s), random.inBox(1.0)};
    const WorldLine line =
        spinningLine(turn, random.u(0.9), {random.in(-3.0, 3.0), rim * kC_m_s / radius_m}, kC_m_s, radius_m);
    // The body passes near the eye some time later.
    const Event centre = line.at(turn.t_s + random.in(0.0, day_s)).event;
    const Vec3 way_m = random.direction() * random.in(0.05, 12.0);
    const Event eye{centre.t_s + glm::length(way_m) / kC_m_s, centre.r_m + way_m};
    const Lorentz head = randomHead(random);
    const Vec3 d_m = random.inBall(radius_m);
    const auto exact = emission(line, d_m, eye, head);
    ASSERT_TRUE(exact);
    BodyView view;
    viewBody(line, eye, head, view);
    ASSERT_EQ(view.legs.size(), 1U);
    const kernel_float::LegView leg = toFloat(view.legs[0]);
    const auto inDouble = emissionIn(view, d_m);
    const auto inFloat = kernel_float::solveEmission(&leg, 1, glm::vec3(d_m));
    const double distance_m = distanceOf(view.legs[0], inDouble);
    const Vec3 byDouble = kernel::seenFromEye(view.legs[0], inDouble.event);
    const Vec3 byFloat = kernel_float::seenFromEye(leg, inFloat.event);
    // Rounding of a place after a day at nearly c: 1e5 m.
    const double rounding_m = 3e-16 * (kC_m_s * eye.t_s + glm::length(eye.r_m)) * 1000.0;
    const double errorDouble = glm::length(byDouble - exact->seen.dr_m) - rounding_m;
    const double errorFloat = glm::length(byFloat - exact->seen.dr_m) - rounding_m;
    EXPECT_TRUE(errorDouble <= 2e-8 * radius_m + 1e-10 * distance_m) << errorDouble;
    EXPECT_TRUE(errorFloat <= kOfDistance * distance_m) << errorFloat / distance_m << " rim " << rim;
    worstDouble = std::max(worstDouble, errorDouble / distance_m);
    worstFloat = std::max(worstFloat, errorFloat / distance_m);

    test::SeenCloud seen(1);
    const std::array<float, 3> d{static_cast<float>(d_m.x), static_cast<float>(d_m.y),
                                 static_cast<float>(d_m.z)};
    seePoints(view, {{&d[0], 1}, {&d[1], 1}, {&d[2], 1}}, seen.points());
    EXPECT_TRUE(glm::length(seen.at(0) - byFloat) <= kOfDistance * distance_m);
    EXPECT_NEAR(seen.doppler[0] / exact->doppler, 1.0, 2e-3);  // steep where a rim comes at nearly c
  }
  RecordProperty("worst_of_distance_double", testing::PrintToString(worstDouble));
  RecordProperty("worst_of_distance_float", testing::PrintToString(worstFloat));
}

// Points of the rim of the fastest bodies. Some one in 400 of these is not found by six steps, nor by twice
// as many, where the rim comes at the eye; by the few steps that are enough up to 0.99 c three times as many
// would be missed.
TEST(SpinEmission, SixStepsFindAllButFewPointsOfTheFastestRims) {
  test::Random random(16);
  int missed = 0;
  constexpr int kCases = 20000;
  for (int i = 0; i < kCases; ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.02, 0.3);
    const double rim = std::copysign(random.in(0.99, 0.999), random.in(-1.0, 1.0));
    const Spin spin{random.in(-3.0, 3.0), rim * kC_m_s / radius_m};
    const WorldLine line = spinningLine({}, Vec3(0.0), spin, kC_m_s, radius_m);
    const double around = random.in(0.0, 2.0 * std::numbers::pi);
    const Vec3 d_m = radius_m * Vec3(std::cos(around), std::sin(around), 0.0);
    const double away_m = radius_m * std::pow(10.0, random.in(0.0, 2.0));
    const Event eye{random.in(0.0, 1.0), random.direction() * away_m};
    const auto exact = emission(line, d_m, eye, Lorentz(kC_m_s));
    ASSERT_TRUE(exact);
    BodyView view;
    viewBody(line, eye, Lorentz(kC_m_s), view);
    const auto found = emissionIn(view, d_m);
    const double error_m = glm::length(kernel::seenFromEye(view.legs[0], found.event) - exact->seen.dr_m);
    if (!(error_m <= 1e-7 * glm::length(exact->seen.dr_m))) ++missed;
  }
  EXPECT_LT(missed, kCases / 250);
}

// Turned the other way and seen in a mirror, a body looks the same.
TEST(SpinEmission, AMirroredSpinIsSeenMirrored) {
  test::Random random(2);
  const auto mirrored = [](const Vec3& v) { return Vec3(v.x, -v.y, v.z); };
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    const Event turn{random.in(-1.0, 1.0), random.inBox(1.0)}, eye{random.in(1.0, 9.0), random.inBox(2.0)};
    const Vec3 u = random.u(0.95), d_m = random.inBall(0.2);
    const Spin spin{random.in(-3.0, 3.0), random.in(-0.99, 0.99) * kC_m_s / 0.2};
    const auto seen = emission(spinningLine(turn, u, spin, kC_m_s, 0.2), d_m, eye, Lorentz(kC_m_s));
    const Event turnThere{turn.t_s, mirrored(turn.r_m)};
    const WorldLine there =
        spinningLine(turnThere, mirrored(u), {-spin.angle_rad, -spin.omega_rad_s}, kC_m_s, 0.2);
    const auto mirror = emission(there, mirrored(d_m), {eye.t_s, mirrored(eye.r_m)}, Lorentz(kC_m_s));
    ASSERT_TRUE(seen && mirror);
    EXPECT_NEAR(seen->event.t_s, mirror->event.t_s, 1e-11);
    EXPECT_NEAR(glm::length(seen->event.r_m - mirrored(mirror->event.r_m)), 0.0, 1e-11);
    EXPECT_NEAR(seen->doppler / mirror->doppler, 1.0, 1e-9);
  }
}

// Through bounces every point has one continuous world line slower than light, and its clock runs on.
TEST(SpinEmission, PointsGoContinuouslyAndSlowerThanLightThroughBounces) {
  test::Random random(3);
  for (int i = 0; i < 1000; ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.02, 0.2);
    const WorldLine line = spinningAndBouncing(random, radius_m, 3, random.in(0.02, 0.5), 0.99);
    const auto history = vertexHistory(line, random.inBall(radius_m));
    for (std::size_t k = 1; k < history.size(); ++k) {
      const Event& start = history[k].start;
      EXPECT_NEAR(glm::length(placeAt(history[k - 1], start.t_s, kC_m_s) - start.r_m), 0.0, 1e-10);
      EXPECT_NEAR(glm::length(placeAt(history[k], start.t_s, kC_m_s) - start.r_m), 0.0, 1e-10);
      EXPECT_NEAR(properTimeAt(history[k - 1], start.t_s, kC_m_s), history[k].properTime_s, 1e-9);
      EXPECT_TRUE(k == 1 || start.t_s >= history[k - 1].start.t_s);  // the first reaches back
    }
    const double from_s = history.front().start.t_s - 1.0, until_s = history.back().start.t_s + 1.0;
    Event before{from_s, placeAt(history[0], from_s, kC_m_s)};
    for (int k = 1; k <= 300; ++k) {
      const double t_s = from_s + (until_s - from_s) * k / 300.0;
      const Event now{t_s, placeAt(pieceAt(history, t_s), t_s, kC_m_s)};
      EXPECT_GT(interval_m2(now - before, kC_m_s), -1e-12);
      before = now;
    }
  }
}

// The kernel against the bisected world lines where an eye sees a body in its bounces, also where the signal
// of a later bounce comes before that of an earlier one.
TEST(SpinEmission, TheKernelFollowsPointsThroughBounces) {
  test::Random random(4);
  int bouncing = 0;
  double worst = 0.0;
  for (int i = 0; i < 10000; ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.02, 0.2);
    const WorldLine line =
        spinningAndBouncing(random, radius_m, 1 + i % 3, random.in(0.1, 0.6), i % 2 == 0 ? 0.8 : 0.99);
    const Event eye{random.in(-0.5, line.knots().back().turn.t_s + 1.5), random.inBox(2.0)};
    const Lorentz head = randomHead(random);
    const Vec3 d_m = random.inBall(radius_m);
    BodyView view;
    viewBody(line, eye, head, view);
    const auto exact = emission(line, d_m, eye, head);
    const int legs = static_cast<int>(view.legs.size());
    const auto found = emissionIn(view, d_m);
    const LegView& leg = view.legs[static_cast<std::size_t>(found.leg)];
    const double distance_m = distanceOf(leg, found);
    const double error = glm::length(kernel::seenFromEye(leg, found.event) - exact->seen.dr_m) / distance_m;
    bouncing += legs > 1;
    EXPECT_TRUE(error <= 1e-6) << error << ", legs " << legs;
    std::vector<kernel_float::LegView> inFloat;
    for (const LegView& each : view.legs) inFloat.push_back(toFloat(each));
    const auto rough = kernel_float::solveEmission(inFloat.data(), legs, glm::vec3(d_m));
    const Vec3 seen = kernel_float::seenFromEye(inFloat[static_cast<std::size_t>(rough.leg)], rough.event);
    const double roughError = glm::length(seen - exact->seen.dr_m) / distance_m;
    EXPECT_TRUE(roughError <= 2e-5) << roughError << ", legs " << legs;  // through the frames of two legs
    worst = std::max(worst, roughError);
  }
  EXPECT_GT(bouncing, 1500);
  RecordProperty("worst_of_distance_float", testing::PrintToString(worst));
}

// Where the cloth slows a body, or its spin, or both: continuous and slower than light, and the kernel in
// double is where bisection is, seen by light and at moments.
TEST(SpinEmission, TheKernelFollowsPointsThatTheClothSlows) {
  test::Random random(6);
  for (int i = 0; i < 1500; ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.02, 0.2);
    const double friction_m_s2 = i % 3 == 0 ? 0.0 : random.in(0.01, 0.5);
    const double slowing_1_s = i % 3 == 1 ? 0.0 : random.in(0.1, 3.0);
    const WorldLine line = test::spun(
        random, randomWorldLine(random, kC_m_s, radius_m, i % 2, random.in(0.1, 0.6), 0.8, friction_m_s2),
        0.9, slowing_1_s);
    const Event eye{random.in(-0.5, line.knots().back().turn.t_s + 2.0), random.inBox(2.0)};
    const Lorentz head = randomHead(random);
    const Vec3 d_m = random.inBall(radius_m);
    const auto exact = emission(line, d_m, eye, head);
    ASSERT_TRUE(exact);
    EXPECT_LT(glm::length(betaFromU(exact->u)), 1.0);
    BodyView view;
    viewBody(line, eye, head, view);
    const int legs = static_cast<int>(view.legs.size());
    const auto found = emissionIn(view, d_m);
    const LegView& leg = view.legs[static_cast<std::size_t>(found.leg)];
    const double error =
        glm::length(kernel::seenFromEye(leg, found.event) - exact->seen.dr_m) / distanceOf(leg, found);
    EXPECT_TRUE(error <= 1e-7) << error << ", legs " << legs << ", friction " << friction_m_s2 << ", slowing "
                               << slowing_1_s;
    const auto history = vertexHistory(line, d_m);
    viewBody(line, eye, head, view, {}, ViewTime::boardNow);
    const auto now = emissionIn(view, d_m);
    const Vec3 place_m = placeAt(pieceAt(history, eye.t_s), eye.t_s, kC_m_s);
    const Vec3 expected =
        (ViewFrame(head, {}, ViewTime::boardNow).seenFromBoard * (Event{eye.t_s, place_m} - eye)).dr_m;
    EXPECT_NEAR(glm::length(seenFromEye(view, now) - expected), 0.0, 1e-6);
  }
}

// At a moment of the board's or the head's, a point is where its world line crosses that plane.
TEST(SpinEmission, AtAMomentPointsAreWhereTheirWorldLinesAre) {
  test::Random random(5);
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.02, 0.2);
    const WorldLine line = spinningAndBouncing(random, radius_m, i % 2, random.in(0.1, 0.6), 0.95);
    const Event eye{random.in(-0.5, line.knots().back().turn.t_s + 1.0), random.inBox(2.0)};
    const Lorentz head = randomHead(random);
    const Vec3 d_m = random.inBall(radius_m);
    const auto history = vertexHistory(line, d_m);
    for (const ViewTime moment : {ViewTime::boardNow, ViewTime::myNow}) {
      BodyView view;
      viewBody(line, eye, head, view, {}, moment);
      const auto found = emissionIn(view, d_m);
      const LegView& leg = view.legs[static_cast<std::size_t>(found.leg)];
      const auto eventAt = [&](double t_s) {
        return Event{t_s, placeAt(pieceAt(history, t_s), t_s, kC_m_s)};
      };
      const Event exact = eventAt(
          moment == ViewTime::boardNow
              ? eye.t_s
              : rootOfIncreasing([&](double t_s) { return (head * (eventAt(t_s) - eye)).dt_s; }, eye.t_s));
      const Lorentz seenFromBoard = ViewFrame(head, {}, moment).seenFromBoard;
      const Vec3 expected = (seenFromBoard * (exact - eye)).dr_m;
      const double error_m = glm::length(kernel::seenFromEye(leg, found.event) - expected);
      EXPECT_NEAR(error_m, 0.0, 1e-6);
    }
  }
}

}  // namespace
}  // namespace carom
