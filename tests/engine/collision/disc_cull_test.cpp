#include "engine/collision/disc_cull.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/random_world.h"

namespace carom {
namespace {

// Discs that fly towards a common place, more or less well aimed, at speeds from 1e-4 to 0.9999 c; some began
// long ago.
Disc randomDisc(test::Random& random, double now, double slowest) {
  const double away = 2.0 * std::numbers::pi * random.in(0.0, 1.0);
  const double ahead = away + std::numbers::pi + random.in(-0.5, 0.5);
  const double rapidity = std::exp(random.in(std::log(slowest), std::log(5.0)));
  const double u = std::sinh(rapidity);
  Disc disc;
  disc.radius = random.in(0.005, 0.01);
  disc.u = fourVelocity(u * std::cos(ahead), u * std::sin(ahead));
  const double distance = random.in(0.0, 0.1);
  const double age = random.in(0.0, 1.0) < 0.5 ? 0.0 : std::exp(random.in(-5.0, 4.0));
  disc.start = {now - age, 3.0 + distance * std::cos(away) - age * disc.u.x / disc.u.t,
                -7.0 + distance * std::sin(away) - age * disc.u.y / disc.u.t};
  return disc;
}

struct Share {
  int meet = 0, mayMeet = 0, coarselyMayMeet = 0;
};

Share shareOfPairs(TurnConvention convention, double slowest) {
  test::Random random(7);
  Share share;
  for (int i = 0; i < 100000; ++i) {
    if (!random.begin(static_cast<std::uint64_t>(i))) continue;
    const double now = 1000.0 * random.in(0.0, 1.0), epoch = now - random.in(0.0, 4.0);
    const Disc first = randomDisc(random, now, slowest), second = randomDisc(random, now, slowest);
    const CoarseFlight other = coarseFlight(second, epoch);
    const bool coarsely =
        DiscCull(first, 0.01, convention, epoch).mayMeet(other.x, other.y, other.vx, other.vy);
    const bool meet = findMeeting(first, second, convention).has_value();
    EXPECT_TRUE(coarsely || !meet) << testing::PrintToString(random);
    share.meet += meet ? 1 : 0;
    share.mayMeet += mayMeet(first, second, convention) ? 1 : 0;
    share.coarselyMayMeet += coarsely ? 1 : 0;
  }
  return share;
}

// The coarse test never excludes a pair that meets, and excludes most of what the exact one does: besides
// what rounding leaves open, the pairs that have passed one another since the first's flight began, and those
// that the largest radius would let touch.
TEST(DiscCull, ExcludesNoPairThatMeets) {
  for (const TurnConvention convention :
       {TurnConvention::simultaneousWithContact, TurnConvention::signalAtCentre}) {
    for (const double slowest : {1e-4, 0.1}) {
      const Share share = shareOfPairs(convention, slowest);
      EXPECT_GT(share.meet, 5000);
      EXPECT_LT(share.coarselyMayMeet, 60000);
      EXPECT_LT(share.coarselyMayMeet, 2 * share.mayMeet)
          << share.meet << " meet, " << share.mayMeet << " may meet";
    }
  }
}

// A board of metres, the radius a centimetre: what is sure to pass at a distance of a few radii is excluded.
TEST(DiscCull, ExcludesFlightsSideBySide) {
  const Disc first{{5.0, 1.0, 2.0}, fourVelocity(0.5, 0.0), 0.01, 0.0};
  for (const double aside : {0.0, 0.0199, 0.0201, 0.03, -0.0201, -0.0199}) {
    const Disc second{{6.0, 2.0, 2.0 + aside}, fourVelocity(-2.0, 0.0), 0.01, 0.0};
    const CoarseFlight other = coarseFlight(second, 3.0);
    const DiscCull coarse(first, 0.01, TurnConvention::simultaneousWithContact, 3.0);
    EXPECT_EQ(coarse.mayMeet(other.x, other.y, other.vx, other.vy), std::abs(aside) < 0.02) << aside;
  }
}

}  // namespace
}  // namespace carom
