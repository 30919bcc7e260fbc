#include "engine/linked/promise.h"

#include <gtest/gtest.h>

#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s, test::Random;

Lorentz randomRoom(Random& random) {
  return Lorentz::boost(random.u(0.95), kC_m_s) *
         Lorentz::rotation(glm::angleAxis(random.in(-3.0, 3.0), random.direction()), kC_m_s);
}

// In the room, where a light cone is one, too: whatever is within the reach at the head's moment or later.
TEST(Promise, HoldsAllThatHandsCanDo) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const Lorentz boardFromRoom = randomRoom(random);
    const Event head{random.in(-5.0, 100.0), random.inBox(3.0)};
    const double reach_m = random.in(0.1, 1.2);
    const Promise promise(head, boardFromRoom, reach_m);
    const Displacement later{random.in(0.0, 2.0), random.direction() * random.in(0.0, 0.999 * reach_m)};
    EXPECT_TRUE(isInFutureOf(promise.event(), head + boardFromRoom * later, kC_m_s));
    const Displacement beyond{0.0, random.direction() * random.in(1.001, 2.0) * reach_m};
    EXPECT_FALSE(isInFutureOf(promise.event(), head + boardFromRoom * beyond, kC_m_s));
  }
}

// By bisection along the room's time, in place of the closed form.
TEST(Promise, PutsOffUntilTheEarliestMomentThatKeepsIt) {
  Random random(2);
  int putOff = 0;
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const Lorentz boardFromRoom = randomRoom(random), actor = randomRoom(random);
    const Promise promise({random.in(-5.0, 3600.0), random.inBox(3.0)}, boardFromRoom, random.in(0.1, 1.2));
    const Event act = promise.event() + Displacement{random.in(-2.0, 2.0), random.inBox(2.0)};
    const Event put = promise.putOff(act, actor);
    EXPECT_TRUE(isInFutureOf(promise.event(), put, kC_m_s));
    const auto later = [&](double s) { return act + actor * Displacement{s, Vec3(0.0)}; };
    double early_s = 0.0, late_s = 100.0;
    if (isInFutureOf(promise.event(), act, kC_m_s)) {
      late_s = 0.0;
      EXPECT_EQ(put.t_s, act.t_s);
      EXPECT_EQ(put.r_m, act.r_m);
    } else {
      ++putOff;
    }
    for (int k = 0; k < 80; ++k) {
      const double middle_s = 0.5 * (early_s + late_s);
      if (isInFutureOf(promise.event(), later(middle_s), kC_m_s))
        late_s = middle_s;
      else
        early_s = middle_s;
    }
    const Displacement missed = actor.inverse() * (put - later(late_s));
    EXPECT_NEAR(missed.dt_s, 0.0, 1e-8);
    EXPECT_NEAR(glm::length(missed.dr_m), 0.0, 1e-8);
  }
  EXPECT_GT(putOff, 500);
}

TEST(Promise, IsNeverTakenBack) {
  Random random(3);
  int kept = 0, renewed = 0;
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    Event head{0.0, Vec3(0.0)};
    double reach_m = 0.8;
    Promise promise(head, Lorentz(kC_m_s), reach_m);
    Vec3 u(0.0);
    for (int step = 0; step < 60; ++step) {
      const Event before = promise.event();
      u += random.inBox(0.05);
      reach_m = std::clamp(reach_m + random.in(-0.05, 0.05), 0.1, 1.2);
      const Lorentz boardFromRoom = Lorentz::boost(u, kC_m_s);
      head = head + boardFromRoom * Displacement{1.0 / 60.0, Vec3(0.0)};
      promise.renew(head, boardFromRoom, reach_m);
      EXPECT_TRUE(isInFutureOf(before, promise.event(), kC_m_s));
      EXPECT_TRUE(isInFutureOf(promise.event(), head, kC_m_s));
      const Event hand = promise.drawnHand(head, random.inBox(2.0), boardFromRoom, reach_m);
      EXPECT_TRUE(isInFutureOf(promise.event(), hand, kC_m_s));
      (before.t_s == promise.event().t_s ? kept : renewed) += 1;
    }
  }
  EXPECT_GT(kept, 100);
  EXPECT_GT(renewed, 100);
}

TEST(Promise, DrawsTheHandWithinReach) {
  const Event head{3.0, {1.0, 2.0, 0.0}};
  const Promise promise(head, Lorentz(kC_m_s), 0.5);
  const Event near = promise.drawnHand(head, {0.3, 0.0, 0.0}, Lorentz(kC_m_s), 0.5);
  EXPECT_EQ(near.r_m, Vec3(1.3, 2.0, 0.0));
  EXPECT_EQ(near.t_s, 3.0);
  const Event far = promise.drawnHand(head, {0.0, 0.9, 0.0}, Lorentz(kC_m_s), 0.5);
  EXPECT_NEAR(far.r_m.y, 2.5, 1e-12);
}

TEST(Promise, NumbersThatAreNoneAreInNoFuture) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(isInFutureOf({0.0, Vec3(0.0)}, {nan, Vec3(0.0)}, kC_m_s));
  EXPECT_FALSE(isInFutureOf({nan, Vec3(0.0)}, {1.0, Vec3(0.0)}, kC_m_s));
}

TEST(Promise, ReachesLessFarBesidePeopleOfAnotherRoom) {
  EXPECT_EQ(reachBeside_m(0.8, 10.0), 0.8);
  EXPECT_EQ(reachBeside_m(0.8, 1.0), 0.4);
}

}  // namespace
}  // namespace carom
