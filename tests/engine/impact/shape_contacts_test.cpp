// What pairs of all shapes share: the sum of several kicks, and which bodies may touch a cushion.
#include "engine/impact/shape_contacts.h"

#include <gtest/gtest.h>

#include <array>

#include "engine/impact/contact_finder.h"

namespace carom {
namespace {

// Each kick radiates its heat with the velocity after it; the last one's velocities and spins hold.
TEST(PairOutcome, IsTheSumOfItsKicks) {
  const Vec21 slow = fourVelocity(0.25, 0.0), fast = fourVelocity(-0.5, 1.0), rest{1.0, 0.0, 0.0};
  SpinningPairKick first, second;
  first.centres.u = {slow, fast};
  first.centres.heat = {0.125, 0.0};
  first.j = {0.5, -0.25};
  second.centres.u = {fast, rest};
  second.centres.heat = {0.25, 0.5};
  second.j = {0.75, 0.0};
  PairOutcome outcome(first, 0.8);
  outcome.add(second);
  EXPECT_EQ(outcome.restitution, 0.8);
  EXPECT_EQ(outcome.kick.j, second.j);
  EXPECT_EQ(outcome.kick.centres.heat, (std::array{0.375, 0.5}));
  EXPECT_EQ(outcome.kick.centres.u[0].x, fast.x);
  EXPECT_EQ(outcome.kick.centres.u[1].t, rest.t);
  const Vec21 radiated = 0.125 * slow + 0.25 * fast;
  EXPECT_NEAR(outcome.radiated[0].t, radiated.t, 1e-15);
  EXPECT_NEAR(outcome.radiated[0].x, radiated.x, 1e-15);
  EXPECT_NEAR(outcome.radiated[0].y, radiated.y, 1e-15);
  EXPECT_NEAR(outcome.radiated[1].t, 0.5, 1e-15);
  EXPECT_EQ(outcome.radiated[1].x, 0.0);
}

// A disc touches only what it moves towards; a corner can turn into a cushion from which its body recedes.
TEST(CushionContacts, ADiscMovesTowardsWhatItTouches) {
  for (const int axis : {0, 1}) {
    for (const double sign : {1.0, -1.0}) {
      const CushionPlane plane{axis, sign, 0.5};
      const Vec21 towards = axis == 0 ? fourVelocity(0.3 * sign, 0.9) : fourVelocity(0.9, 0.3 * sign);
      const Vec21 away = axis == 0 ? fourVelocity(-0.3 * sign, 0.9) : fourVelocity(0.9, -0.3 * sign);
      EXPECT_TRUE(kDiscAtCushion.mayTouch(plane, towards));
      EXPECT_FALSE(kDiscAtCushion.mayTouch(plane, away));
      EXPECT_TRUE(kPolygonAtCushion.mayTouch(plane, away));
    }
  }
  EXPECT_FALSE(kDiscAtCushion.canLie());
  EXPECT_TRUE(kPolygonAtCushion.canLie());
}

}  // namespace
}  // namespace carom
