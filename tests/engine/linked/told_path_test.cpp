#include "engine/linked/told_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "engine/light_speed.h"
#include "engine/linked/promise.h"

namespace carom {
namespace {

using test::kC_m_s;

ToldMoment momentAt(double t_s, const Vec3& head_m, const Vec3& hand_m) {
  ToldMoment moment;
  moment.head = {t_s, head_m};
  moment.hand = {t_s, hand_m};
  moment.properTime_s = t_s - 0.25;
  moment.hasHand = 1;
  return moment;
}

auto seenFrom(const Event& eye) {
  return [eye](const Event& event) { return afterLightOf_s(event, eye, kC_m_s); };
}

/// A person who walks to and fro at up to a third of c, and moves a hand as fast as light; told of at 60 Hz
/// with presents lost.
ToldPath walk(std::mt19937_64& random, double until_s) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  ToldPath path(kC_m_s);
  Vec3 head_m(unit(random), unit(random), 0.9), pace(0.0);
  bool isFirst = true;
  for (double t_s = 0.0; t_s < until_s; t_s += 1.0 / 60.0) {
    head_m += pace / 60.0;
    if (std::abs(unit(random)) < 0.1) pace = Vec3(unit(random), unit(random), 0.0) * (kC_m_s / 3.0 / 1.5);
    if (unit(random) < -0.8) continue;
    ToldMoment moment = momentAt(t_s, head_m, head_m + Vec3(0.4 * unit(random), 0.3, -0.5));
    moment.kind = isFirst ? ToldKind::begins : ToldKind::goesOn;
    isFirst = false;
    path.add(moment);
  }
  return path;
}

// The event that is seen of somebody who goes straight: with t the time of emission, c² (T − t)² = |R − r0 −
// v t|², a quadratic equation.
TEST(ToldPath, WhoGoesStraightIsSeenWhereTheQuadraticEquationSays) {
  const Vec3 from_m(0.3, -1.0, 0.9), v_m_s(0.4, 0.5, 0.0);
  ToldPath path(kC_m_s);
  for (int i = 0; i < 200; ++i) {
    const double t_s = i / 30.0;
    path.add(momentAt(t_s, from_m + v_m_s * t_s, from_m));
  }
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const Event eye{5.0 + unit(random), {2.0 * unit(random), 2.0 * unit(random), unit(random)}};
    const Vec3 d_m = eye.r_m - from_m;
    const double a = kC_m_s * kC_m_s - glm::dot(v_m_s, v_m_s);
    const double b = kC_m_s * kC_m_s * eye.t_s - glm::dot(d_m, v_m_s);
    const double c = kC_m_s * kC_m_s * eye.t_s * eye.t_s - glm::dot(d_m, d_m);
    const double t_s = (b - std::sqrt(b * b - a * c)) / a;
    const auto seen = path.at(seenFrom(eye));
    ASSERT_TRUE(seen) << i;
    EXPECT_NEAR(seen->head.t_s, t_s, 1e-12) << i;
    EXPECT_NEAR(glm::distance(seen->head.r_m, from_m + v_m_s * t_s), 0.0, 1e-12) << i;
    EXPECT_NEAR(seen->properTime_s, t_s - 0.25, 1e-12) << i;
    const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(v_m_s, v_m_s) / (kC_m_s * kC_m_s));
    EXPECT_NEAR(glm::distance(seen->u, gamma * v_m_s / kC_m_s), 0.0, 1e-9) << i;
  }
}

TEST(ToldPath, HeadAndHandLieOnThePastLightConeOfTheEye) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int hands = 0;
  for (int game = 0; game < 20; ++game) {
    const ToldPath path = walk(random, 12.0);
    double before_s = -1.0;
    for (double t_s = 4.0; t_s < 10.0; t_s += 1.0 / 60.0) {
      const Event eye{t_s, {2.5, 0.1 * std::sin(t_s), 0.8}};
      const auto seen = path.at(seenFrom(eye));
      ASSERT_TRUE(seen) << game;
      EXPECT_NEAR(afterLightOf_s(seen->head, eye, kC_m_s), 0.0, 1e-12) << game << " at " << t_s;
      EXPECT_GT(seen->head.t_s, before_s);
      before_s = seen->head.t_s;
      const double late_s = afterLightOf_s(seen->hand, eye, kC_m_s);
      EXPECT_GE(late_s, 0.0) << game << " at " << t_s;
      hands += late_s < 1e-12 ? 1 : 0;
      EXPECT_LT(glm::length(seen->u), 0.5);
    }
  }
  EXPECT_GT(hands, 6000);
}

TEST(ToldPath, NothingIsGuessedBeyondTheLastMoment) {
  ToldPath path(kC_m_s);
  path.add(momentAt(0.0, {0.0, 0.0, 0.9}, {0.2, 0.0, 0.5}));
  path.add(momentAt(1.0, {0.5, 0.0, 0.9}, {0.7, 0.0, 0.5}));
  const auto seen = path.at(seenFrom({30.0, {2.0, 0.0, 0.9}}));
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->head.r_m, Vec3(0.5, 0.0, 0.9));
  EXPECT_EQ(seen->head.t_s, 1.0);
  EXPECT_EQ(seen->hand.r_m, Vec3(0.7, 0.0, 0.5));
  EXPECT_EQ(seen->u, Vec3(0.0));
}

TEST(ToldPath, WhatIsSeenHasToDoWithNothingLaterThanTheNextMoment) {
  std::mt19937_64 random(7);
  for (int game = 0; game < 20; ++game) {
    const ToldPath whole = walk(random, 12.0);
    const Event eye{8.0, {1.5, 0.4, 0.8}};
    const auto seen = whole.at(seenFrom(eye));
    ASSERT_TRUE(seen);
    ToldPath part(kC_m_s);
    for (const ToldMoment& moment : whole.moments()) {
      part.add(moment);
      if (moment.head.t_s > seen->head.t_s) break;
    }
    const auto again = part.at(seenFrom(eye));
    ASSERT_TRUE(again);
    EXPECT_EQ(again->head.t_s, seen->head.t_s) << game;
    EXPECT_EQ(again->u, seen->u) << game;
    EXPECT_EQ(again->properTime_s, seen->properTime_s) << game;
  }
}

TEST(ToldPath, APersonAppearsWithTheLightOfTheFirstMomentAndVanishesWithThatOfTheLast) {
  ToldPath path(kC_m_s);
  const Vec3 head_m(0.0, 0.0, 0.9), eye_m(1.42, 0.0, 0.9);  // one second of light away
  path.add(momentAt(2.0, head_m, head_m));
  ToldMoment last = momentAt(5.0, head_m, head_m);
  last.kind = ToldKind::ends;
  path.add(last);
  EXPECT_FALSE(path.at(seenFrom({2.999, eye_m})));
  EXPECT_TRUE(path.at(seenFrom({3.001, eye_m})));
  EXPECT_TRUE(path.at(seenFrom({5.999, eye_m})));
  EXPECT_FALSE(path.at(seenFrom({6.001, eye_m})));
  ToldMoment another = momentAt(9.0, head_m, head_m);
  another.kind = ToldKind::begins;
  path.add(another);
  EXPECT_FALSE(path.at(seenFrom({9.999, eye_m})));
  EXPECT_TRUE(path.at(seenFrom({10.001, eye_m})));
}

TEST(ToldPath, MomentsToWhichNobodyCouldHaveComeAreLeftOut) {
  ToldPath path(kC_m_s);
  const Vec3 any_m(0.0);
  path.add(momentAt(1.0, any_m, any_m));
  path.add(momentAt(1.0, any_m, any_m));            // whoever waits tells of the same moment again
  path.add(momentAt(0.5, any_m, any_m));            // earlier
  path.add(momentAt(1.1, {0.2, 0.0, 0.0}, any_m));  // faster than light
  path.add(momentAt(NAN, any_m, any_m));
  EXPECT_EQ(path.moments().size(), 1U);
}

TEST(ToldPath, ForgettingKeepsWhatIsStillSeen) {
  std::mt19937_64 random(11);
  ToldPath path = walk(random, 12.0);
  const std::size_t before = path.moments().size();
  const Event eye{8.0, {1.5, 0.4, 0.8}};
  const auto seen = path.at(seenFrom(eye));
  ASSERT_TRUE(seen);
  const Event head = seen->head;
  path.forgetBefore(5.0);
  EXPECT_LT(path.moments().size(), before);
  EXPECT_LE(path.moments().front().head.t_s, 5.0);
  const auto again = path.at(seenFrom(eye));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->head.t_s, head.t_s);
}

}  // namespace
}  // namespace carom
