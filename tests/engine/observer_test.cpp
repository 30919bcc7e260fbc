#include "engine/spacetime/observer.h"

#include <gtest/gtest.h>

#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;
const Event kOrigin{0.0, Vec3(0.0)};

Head headAt(const Vec3& position_m, const Vec3& celerity_m_s = Vec3(0.0)) {
  return {{position_m, glm::dquat(1.0, 0.0, 0.0, 0.0)}, celerity_m_s};
}

TEST(Observer, StandingStillOnTheBoardBothClocksAgree) {
  Observer observer(Lorentz(kC_m_s), kOrigin, headAt({0.0, 1.7, 0.0}));
  for (int i = 0; i < 600; ++i) observer.step(1.0 / 60.0, headAt({0.0, 1.7, 0.0}));
  EXPECT_NEAR(observer.headEvent().t_s, 10.0, 1e-12);
  EXPECT_NEAR(observer.properTime_s(), 10.0, 1e-12);
}

// Walking at celerity w: β = w/sqrt(c² + w²), board time = γ τ. Never faster than light, at any w.
TEST(Observer, WalkingIsTimelikeAtAnyPace) {
  for (const double celerity_m_s : {0.5, 1.42, 5.0, 11.9}) {
    Observer observer(Lorentz(kC_m_s), kOrigin, headAt(Vec3(0.0)));
    for (int i = 1; i <= 60; ++i) observer.step(1.0 / 60.0, headAt({celerity_m_s * i / 60.0, 0.0, 0.0}));
    const double gamma = std::hypot(1.0, celerity_m_s / kC_m_s);
    EXPECT_NEAR(observer.headEvent().t_s, gamma, 1e-12);
    EXPECT_NEAR(observer.headEvent().r_m.x, celerity_m_s, 1e-12);
    EXPECT_LT(observer.headEvent().r_m.x, kC_m_s * observer.headEvent().t_s);
  }
}

TEST(Observer, AGlitchOfTheTrackerIsNotTravel) {
  Observer observer(Lorentz(kC_m_s), kOrigin, headAt(Vec3(0.0)));
  observer.step(1.0 / 60.0, headAt({1.0, 0.0, 0.0}));  // 60 m/s
  EXPECT_NEAR(observer.headEvent().t_s, 1.0 / 60.0, 1e-15);
  EXPECT_EQ(observer.headEvent().r_m.x, 0.0);
  observer.step(1.0 / 60.0, headAt({NAN, 0.0, 0.0}));
  EXPECT_FALSE(std::isnan(observer.headEvent().t_s));
}

// Eyes simultaneous in the head frame differ on the board by γβ d/c: 93 ms at β = 0.9, 64 mm, c = 1.42 m/s.
TEST(Observer, EyesAreSimultaneousForTheHead) {
  const Lorentz boardFromRoom = Lorentz::boost(uFromBeta({0.9, 0.0, 0.0}), kC_m_s);
  const Observer observer(boardFromRoom, kOrigin, headAt(Vec3(0.0)));
  const ObserverView view = observer.view(0.064);
  const double apart_s = view.right.observation.t_s - view.left.observation.t_s;
  EXPECT_NEAR(apart_s, 0.9 / std::sqrt(1 - 0.81) * 0.064 / kC_m_s, 1e-12);
  EXPECT_NEAR(apart_s, 0.093, 0.0005);
  const Displacement inHead = view.headFromBoard * (view.right.observation - view.left.observation);
  EXPECT_NEAR(inHead.dt_s, 0.0, 1e-14);
  EXPECT_NEAR(inHead.dr_m.x, 0.064, 1e-14);
}

// The walk in the room, boosted by the platform: velocities add as relativity says, w' = γ_w γ_V (…).
TEST(Observer, CelerityOfHeadAndPlatformCompose) {
  const Vec3 platformU = uFromBeta({0.0, 0.6, 0.0});
  const Vec3 celerity_m_s{0.8, 0.0, 0.3};
  const Observer observer(Lorentz::boost(platformU, kC_m_s), kOrigin, headAt(Vec3(0.0), celerity_m_s));
  const Vec3 u = observer.view(0.064).headFromBoard.inverse().u();
  const Vec3 walk = celerity_m_s / kC_m_s;
  EXPECT_NEAR(gammaFromU(u), gammaFromU(platformU) * gammaFromU(walk), 1e-12);  // perpendicular
  EXPECT_NEAR(u.x, walk.x, 1e-12);
  EXPECT_NEAR(u.z, walk.z, 1e-12);
}

// Thrust never moves the head's present event; there and back again the person is younger.
TEST(Observer, ThrustKeepsThePresentEventAndComposesRapidities) {
  Observer observer(Lorentz(kC_m_s), kOrigin, headAt({0.4, 1.7, -1.0}));
  const Event before = observer.headEvent();
  const double tiny_s = 1e-9;  // of a thrust so strong that it is a kick
  for (int i = 0; i < 100; ++i)
    observer.step(tiny_s, headAt({0.4, 1.7, -1.0}), 1.0, {0.01 * kC_m_s / tiny_s, 0.0, 0.0});
  EXPECT_NEAR(observer.headEvent().t_s, before.t_s, 2e-7);
  EXPECT_NEAR(observer.boardFromRoom().u().x, std::sinh(1.0), 1e-12);
}

// A constant proper acceleration a for the time τ leads to t = (c/a) sinh(aτ/c), x = (c²/a)(cosh(aτ/c) − 1),
// in however many steps.
TEST(Observer, ConstantThrustIsHyperbolicMotion) {
  const double a_m_s2 = 0.5, tau_s = 4.0, eta = a_m_s2 * tau_s / kC_m_s;
  for (const int steps : {1, 7, 240}) {
    Observer observer(Lorentz(kC_m_s), kOrigin, headAt(Vec3(0.0)));
    for (int i = 0; i < steps; ++i) observer.step(tau_s / steps, headAt(Vec3(0.0)), 1.0, {a_m_s2, 0.0, 0.0});
    EXPECT_NEAR(observer.headEvent().t_s, kC_m_s / a_m_s2 * std::sinh(eta), 1e-12) << steps;
    EXPECT_NEAR(observer.headEvent().r_m.x, kC_m_s * kC_m_s / a_m_s2 * (std::cosh(eta) - 1), 1e-12) << steps;
    EXPECT_NEAR(observer.properTime_s(), tau_s, 1e-12);
  }
}

}  // namespace
}  // namespace carom
