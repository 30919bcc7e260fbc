// Every watchdog on a virtual clock: when it fires, the force is gone within 50 ms, and it stays away until
// the button is pressed again.

#include "devices/force/force_loop.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include <glm/geometric.hpp>

namespace carom {
namespace {

/// A loop with a drawn cue, whose clock, poses and posts a test may stop.
class Drawn {
 public:
  Drawn() {
    law_.kind = ForceLaw::Kind::cue;
    law_.cue = {0.403, 0.08, 1.0};
    for (int i = 0; i < 300; ++i) {
      device_.position_m.x = -0.08 * std::min(1.0, i / 200.0);
      tick();
    }
  }

  /// Goes on by `by_s` and ticks.
  void tick(double by_s = 1e-3) {
    now_s += by_s;
    if (posts) law_.posted_s = now_s;
    if (moves) device_.time_s = now_s;
    law_.held = isHeld;
    before_n = force_n;
    const ForceCommand command = loop.tick(now_s, device_, law_);
    device_.held_n = command.force_n;
    force_n = glm::length(command.force_n);
  }

  double now_s = 0.0, force_n = 0.0, before_n = 0.0;
  bool posts = true, moves = true, isHeld = true;
  ForceLoop loop{ForceLimits{}};
  ForceDeviceState device_;

 private:
  ForceLaw law_;
};

/// Ticks until the fall, then until 0 N; returns when it fell and when it was gone, since the beginning.
std::pair<double, double> fallOf(Drawn& drawn, double tick_s = 1e-3) {
  const double from_s = drawn.now_s;
  double fell_s = std::numeric_limits<double>::quiet_NaN();
  const std::uint64_t falls = drawn.loop.report().falls;
  for (int i = 0; i < 2000; ++i) {
    drawn.tick(tick_s);
    if (drawn.loop.report().falls > falls && std::isnan(fell_s)) fell_s = drawn.now_s;
    if (drawn.force_n == 0.0) break;
  }
  return {fell_s - from_s, drawn.now_s - from_s};
}

void expectToStayAway(Drawn& drawn) {
  drawn.posts = drawn.moves = true;
  for (int i = 0; i < 500; ++i) {
    drawn.tick();
    ASSERT_EQ(drawn.force_n, 0.0) << "until the button is released";
  }
  drawn.isHeld = false;
  drawn.tick();
  drawn.isHeld = true;
  drawn.device_.position_m.x += 0.05;
  for (int i = 0; i < 100; ++i) {
    drawn.device_.position_m.x -= 1e-3;
    drawn.tick();
  }
  EXPECT_GT(drawn.force_n, 1.0) << "pressed again, it pushes";
}

TEST(ForceGuard, ADrawnCuePushes) {
  Drawn drawn;
  EXPECT_NEAR(drawn.force_n, CueForce({0.403, 0.08, 1.0}).force_n(0.08), 1e-12);
  EXPECT_EQ(drawn.loop.report().falls, 0u);
}

TEST(ForceGuard, FallsWhereTheGameIsSilent) {
  Drawn drawn;
  drawn.posts = false;
  const auto [fell_s, gone_s] = fallOf(drawn);
  EXPECT_NEAR(fell_s, 0.1, 2e-3);
  EXPECT_LE(gone_s - fell_s, 0.050 + 1e-9);
  EXPECT_EQ(drawn.loop.report().fall, ForceFall::gameSilent);
  EXPECT_EQ(std::string(toString(drawn.loop.report().fall)), "the game said nothing for 100 ms");
  expectToStayAway(drawn);
}

TEST(ForceGuard, FallsWhereThePoseIsOld) {
  Drawn drawn;
  drawn.moves = false;
  const auto [fell_s, gone_s] = fallOf(drawn);
  EXPECT_NEAR(fell_s, 0.02, 2e-3);
  EXPECT_LE(gone_s - fell_s, 0.050 + 1e-9);
  EXPECT_EQ(drawn.loop.report().fall, ForceFall::poseOld);
  expectToStayAway(drawn);
}

TEST(ForceGuard, FallsWhereNoTickComes) {
  Drawn drawn;
  drawn.tick(0.021);
  EXPECT_EQ(drawn.loop.report().fall, ForceFall::tickLate);
  const auto [fell_s, gone_s] = fallOf(drawn);
  EXPECT_LE(gone_s, 0.050 + 1e-9);
  expectToStayAway(drawn);
}

TEST(ForceGuard, FallsWhereTheLoopIsSlow) {
  Drawn drawn;
  const auto [fell_s, gone_s] = fallOf(drawn, 3e-3);  // 333 Hz
  EXPECT_LE(fell_s, 0.21);
  EXPECT_LE(gone_s - fell_s, 0.050 + 3e-3);
  EXPECT_EQ(drawn.loop.report().fall, ForceFall::rateLow);
}

TEST(ForceGuard, FallsWhereTheDeviceSendsNoNumbers) {
  Drawn drawn;
  drawn.device_.position_m.y = std::numeric_limits<double>::quiet_NaN();
  const auto [fell_s, gone_s] = fallOf(drawn);
  EXPECT_LE(gone_s, 0.051 + 1e-9);
  EXPECT_EQ(drawn.loop.report().fall, ForceFall::notFinite);
  drawn.device_.position_m.y = 0.0;
  expectToStayAway(drawn);
}

TEST(ForceGuard, IsAtZeroAtOnceWhereTheDeviceIsGone) {
  Drawn drawn;
  drawn.loop.end(ForceFall::unplugged, drawn.now_s);
  EXPECT_EQ(glm::length(drawn.loop.report().force_n), 0.0);
  EXPECT_EQ(drawn.loop.report().fall, ForceFall::unplugged);
  EXPECT_EQ(drawn.loop.report().falls, 1u);
}

TEST(ForceGuard, AReleasedCueIsGoneWithin30ms) {
  Drawn drawn;
  drawn.isHeld = false;
  const double from_s = drawn.now_s;
  while (drawn.force_n > 0.0) {
    drawn.tick();
    ASSERT_LT(drawn.now_s - from_s, 0.030);
  }
  EXPECT_EQ(drawn.loop.report().falls, 0u) << "that is no fall";
}

TEST(ForceGuard, ABlowHasItsImpulseAndNeedsTheButton) {
  ForceLimits limits;
  ForceLaw law;
  law.blows[0] = blowOf({0.5, 0.0, 0.0}, 0.1, limits.force_n);
  law.blowCount = 1;
  for (const bool isHeld : {true, false}) {
    ForceLoop loop(limits);
    ForceDeviceState device;
    double impulse_ns = 0.0, most_n = 0.0;
    for (int i = 0; i < 300; ++i) {
      const double now_s = i * 1e-3;
      law.posted_s = device.time_s = now_s;
      law.held = isHeld;
      device.held_n = loop.tick(now_s, device, law).force_n;
      impulse_ns += 1e-3 * device.held_n.x;
      most_n = std::max(most_n, device.held_n.x);
    }
    EXPECT_NEAR(impulse_ns, isHeld ? law.blows[0].impulse_ns() : 0.0, 1e-3);
    EXPECT_NEAR(most_n, isHeld ? 0.5 * kBlowShare * limits.force_n : 0.0, 1e-2);
  }
}

TEST(ForceGuard, RumbleIsTheLogarithmOfABlow) {
  EXPECT_EQ(rumbleOf(0.0), 0.0);
  EXPECT_NEAR(rumbleOf(0.1), std::log(2.0) / std::log(31.0), 1e-15);
  EXPECT_EQ(rumbleOf(5.0), 1.0);
}

}  // namespace
}  // namespace carom
