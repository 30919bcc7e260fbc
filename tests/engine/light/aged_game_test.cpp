// What an eye is shown does not depend on how long the game has run: neither what the shader is given nor
// what it makes of it in float.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/light/light_cone.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;
constexpr double kHour_s = 3600.0, kDay_s = 86400.0;

WorldLine movedBy(const WorldLine& line, double later_s) {
  const auto moved = [&](Knot knot) {
    knot.turn.t_s += later_s, knot.signal.t_s += later_s;
    return knot;
  };
  WorldLine result(moved(line.knots().front()), kC_m_s, line.radius_m());
  for (const Knot& knot : line.knots().subspan(1)) result.append(moved(knot));
  return result;
}

/// As the shader computes it.
glm::vec3 seenInFloat(const BodyView& view, const Vec3& offset_m) {
  std::vector<kernel_float::LegView> legs;
  for (const LegView& leg : view.legs) legs.push_back(toFloat(leg));
  const auto emission = kernel_float::solveEmission(legs.data(), static_cast<int>(legs.size()),
                                                    glm::vec3(offset_m), view.retarded, view.contracted);
  return kernel_float::seenFromEye(legs[static_cast<std::size_t>(emission.leg)], emission.event);
}

Vec3 seenInDouble(const BodyView& view, const Vec3& offset_m) {
  const auto emission = emissionIn(view, offset_m);
  return seenFromEye(view, emission);
}

float largestNumber(const BodyView& view) {
  float largest = 0.0F;
  for (const LegView& leg : view.legs) {
    const kernel_float::LegView rough = toFloat(leg);
    const auto* numbers = reinterpret_cast<const float*>(&rough);
    for (std::size_t i = 0; i < sizeof(rough) / sizeof(float); ++i)
      largest = std::max(largest, std::abs(numbers[i]));
  }
  return largest;
}

struct View {
  Switches switches;
  ViewTime moment = ViewTime::seen;
};
constexpr View kViews[] = {{{}, ViewTime::seen},
                           {{}, ViewTime::boardNow},
                           {{}, ViewTime::myNow},
                           {{1, 0, 1, 0, 0}, ViewTime::seen},
                           {{0, 1, 1, 0, 0}, ViewTime::seen}};

// From when the eye has seen it stop on every point, no vertex moves by more than 1e-6 of its distance from
// one frame to the next, for a person who rests.
TEST(AgedGame, AStoppedPuckStandsStillForADay) {
  test::Random random(1);
  for (int i = 0; i < 60; ++i) {
    CASE(random, i);
    const double friction_m_s2 = std::pow(10.0, random.in(-2.0, 0.0)), radius_m = random.in(0.02, 0.1);
    Knot knot;
    knot.turn = {random.in(0.0, 100.0), random.inBox(0.5)};
    knot.u = uFromBeta({random.in(0.0, 0.7), random.in(0.0, 0.7), 0.0});
    knot.signal = knot.turn;
    knot.deceleration_m_s2 = friction_m_s2;
    const WorldLine line(knot, kC_m_s, radius_m);
    const double rests_s = knot.turn.t_s + glm::length(knot.u) * kC_m_s / friction_m_s2;
    const Vec3 rest_m = line.at(rests_s).event.r_m;
    const Vec3 eye_m = rest_m + random.direction() * random.in(0.3, 3.0);
    const double stopSeen_s = rests_s + (glm::length(eye_m - rest_m) + 1.001 * radius_m) / kC_m_s;
    const Vec3 offset_m = random.direction() * radius_m;
    const Lorentz head = Lorentz::rotation(glm::normalize(glm::dquat(1.0, random.inBox(1.0))), kC_m_s);
    SCOPED_TRACE(testing::Message() << "case " << i << ": friction " << friction_m_s2 << ", u "
                                    << glm::length(knot.u) << ", offset " << offset_m.x << " " << offset_m.y
                                    << " " << offset_m.z);
    BodyView view;
    for (const View& of : kViews) {
      for (const double age_s : {0.0, 1.0, 60.0, 600.0, kHour_s, 4 * kHour_s, kDay_s}) {
        glm::vec3 before(NAN);
        for (int frame = 0; frame < 30; ++frame) {
          viewBody(line, {stopSeen_s + age_s + frame / 60.0, eye_m}, head, view, of.switches, of.moment);
          const glm::vec3 seen = seenInFloat(view, offset_m);
          if (frame > 0) {
            ASSERT_TRUE(glm::length(seen - before) <= 1e-6F * glm::length(seen))
                << age_s << " s after the stop, frame " << frame << ": " << glm::length(seen - before);
          }
          before = seen;
        }
      }
    }
  }
}

// A game of bounces, with and without friction, and the same an hour and a day later: the shader is given the
// same numbers but for rounding, and what it makes of them is as exact.
TEST(AgedGame, BouncesLookTheSameAfterADay) {
  test::Random random(2);
  double worst[3] = {0.0, 0.0, 0.0};
  for (int i = 0; i < 3000; ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.02, 0.1), friction_m_s2 = i % 2 == 0 ? 0.0 : random.in(0.02, 2.0);
    const WorldLine line =
        randomWorldLine(random, kC_m_s, radius_m, i % 4, random.in(0.1, 3.0), 0.9, friction_m_s2);
    const Event eye{random.in(-1.0, line.knots().back().turn.t_s + 8.0), random.inBox(2.0)};
    const Lorentz head = Lorentz::boost(random.u(0.95), kC_m_s);
    const Vec3 offset_m = random.inBall(radius_m);
    const View& of = kViews[i % std::size(kViews)];
    BodyView view;
    viewBody(line, eye, head, view, of.switches, of.moment);
    const Vec3 young = seenInDouble(view, offset_m);
    for (int age = 0; age < 3; ++age) {
      const double later_s = age == 0 ? 0.0 : age == 1 ? kHour_s : kDay_s;
      SCOPED_TRACE(testing::Message() << "case " << i << ", " << later_s << " s later");
      BodyView old;
      viewBody(movedBy(line, later_s), eye + Displacement{later_s, Vec3(0.0)}, head, old, of.switches,
               of.moment);
      ASSERT_EQ(old.legs.size(), view.legs.size());
      // A day's time is exact to 1.5e-11 s; what is seen of something that moves at 0.9 c, at 0.95 c, to
      // 1e-7.
      ASSERT_TRUE(glm::length(seenInDouble(old, offset_m) - young) <= 1e-7);
      const double error =
          glm::length(Vec3(seenInFloat(old, offset_m)) - young) / (glm::length(young) + radius_m);
      ASSERT_FALSE(std::isnan(error));
      worst[age] = std::max(worst[age], error);
    }
  }
  for (int age = 0; age < 3; ++age) EXPECT_TRUE(worst[age] <= 1e-4) << age << ": " << worst[age];
}

// After the last bounce, too: the longer ago, the less is there to say.
TEST(AgedGame, NoNumberGrowsAfterTheLastBounce) {
  test::Random random(3);
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    const double friction_m_s2 = i % 2 == 0 ? 0.0 : random.in(0.05, 2.0), radius_m = random.in(0.02, 0.1);
    WorldLine line = randomWorldLine(random, kC_m_s, radius_m, 3, random.in(0.1, 2.0), 0.9, friction_m_s2);
    const Knot& last = line.knots().back();
    const Lorentz head = Lorentz::boost(random.u(0.9), kC_m_s);
    const View& of = kViews[i % std::size(kViews)];
    BodyView view;
    for (const double age_s : {100.0, kHour_s, kDay_s}) {
      // An eye goes with it.
      const Motion there = motionOnLeg(last, last.turn.t_s + age_s, kC_m_s);
      const Event eye{there.event.t_s, there.event.r_m + random.inBox(2.0)};
      viewBody(line, eye, head, view, of.switches, of.moment);
      const double gammas = 2.0 * gammaFromU(head.u()) * 2.0 * gammaFromU(last.u);
      // While it glides, times to the turn and to the stop.
      const double glide_m = friction_m_s2 > 0.0 && view.legs.back().glide.w > 0.0
                                 ? glm::length(last.u) * kC_m_s * kC_m_s / friction_m_s2
                                 : 0.0;
      ASSERT_EQ(view.legs.size(), 1u) << "case " << i << " after " << age_s << " s";
      ASSERT_TRUE(largestNumber(view) <= gammas * gammas * 4.0 + glide_m)
          << "case " << i << " after " << age_s << " s: " << largestNumber(view);
    }
  }
}

}  // namespace
}  // namespace carom
