// Bars of 12 cm that meet face to face, or anyhow: they part on the side on which they touched, and slow ones
// end as Newton's rigid bodies do; and bars at any tilt and offset: on which side they end. More pairs, up to
// 0.99 c, as tables: CAROM_PAIRS=200 build/release/bin/engine_billiard_test --gtest_filter='Bars*'

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/billiard/billiard.h"
#include "engine/newton_bodies.h"
#include "engine/two_bars.h"

namespace carom {
namespace {

using test::twoBars;

struct Row {
  int behind = 0;
  std::size_t kicks = 0, most = 0, withoutDelay = 0;
};

Row playRow(const test::BarMeeting& meeting, int pairs) {
  constexpr double kUntil_s = 2000.0;
  Row row;
  for (int n = 0; n < pairs; ++n) {
    Billiard game(twoBars(meeting, static_cast<unsigned>(n)));
    game.advanceTo(kUntil_s);
    const auto x = [&](int i) { return game.worldLines()[i].at(kUntil_s).event.r_m.x; };
    if (!(x(0) < x(1))) ++row.behind;
    row.kicks += game.events().size(), row.most = std::max(row.most, game.events().size());
    for (const GameEvent& event : game.events()) row.withoutDelay += event.withoutDelay;
  }
  return row;
}

TEST(BarsFaceToFace, NoneEndsBehindTheOther) {
  const char* const asked = std::getenv("CAROM_PAIRS");
  const int pairs = asked != nullptr ? std::atoi(asked) : 4;
  std::vector<double> speeds{0.02, 0.1, 0.3, 0.5, 0.7, 0.95, 0.99};
  if (asked != nullptr) speeds = {0.02, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 0.95, 0.97, 0.99};
  for (const double restitution : {1.0, 0.5}) {
    for (const bool atContact : {false, true}) {
      // Some near the speed of light slide along each other in a hundred kicks.
      std::size_t kicks = 0, met = 0;
      for (const double thick_m : {0.001, 0.003, 0.01, 0.03}) {
        for (const double beta : speeds) {
          SCOPED_TRACE(testing::Message() << thick_m << " m at " << beta << " c, e = " << restitution
                                          << (atContact ? ", contact" : ", centre"));
          const Row row = playRow({thick_m, beta, restitution, atContact, 3.0 * M_PI / 180.0, 0.006}, pairs);
          EXPECT_EQ(row.behind, 0);
          kicks += row.kicks, met += static_cast<std::size_t>(pairs);
          if (asked == nullptr) continue;
          std::printf("e %.1f %s %2.0f mm %.2f c: %3d behind, %4.1f kicks, at most %zu, without delay %zu\n",
                      restitution, atContact ? "contact" : "centre", thick_m * 1e3, beta, row.behind,
                      static_cast<double>(row.kicks) / pairs, row.most, row.withoutDelay);
          std::fflush(stdout);
        }
      }
      EXPECT_LE(kicks, 10 * met);
    }
  }
}

// Some fly far through each other near the speed of light, and have turned by a radian when they are back.
// What then comes at a side from behind is no new contact.
TEST(BarsFaceToFace, ThatComeBackFromAfarTouchOnlyTheSidesTheyCameFrom) {
  struct Pair {
    double thick_m, beta, restitution;
    unsigned seed;
  };
  for (const Pair& pair :
       {Pair{0.001, 0.99, 1.0, 180}, Pair{0.001, 0.99, 1.0, 121}, Pair{0.001, 0.99, 1.0, 166},
        Pair{0.003, 0.9, 1.0, 100}, Pair{0.003, 0.9, 1.0, 197}, Pair{0.003, 0.99, 1.0, 155},
        Pair{0.003, 0.99, 1.0, 195}, Pair{0.001, 0.99, 0.5, 156}}) {
    SCOPED_TRACE(testing::Message() << pair.thick_m << " m at " << pair.beta << " c, seed " << pair.seed);
    Billiard game(
        twoBars({pair.thick_m, pair.beta, pair.restitution, false, 3.0 * M_PI / 180.0, 0.006}, pair.seed));
    game.advanceTo(100.0);
    const auto x = [&](int i) { return game.worldLines()[i].at(100.0).event.r_m.x; };
    EXPECT_LT(x(0), x(1));
  }
}

Vec2 lastBeta(const Billiard& game, int i) {
  const Vec2 u = game.worldLines()[i].knots().back().u;
  return u / std::sqrt(1.0 + glm::dot(u, u));
}

// Of bars anyhow tilted, how many touch, and end on another side than Newton's, to 60°, or with another
// velocity, by three tenths of the speed.
struct AsNewtons {
  int touched = 0, otherSide = 0, otherVelocity = 0;
};

AsNewtons playBeside(double beta, bool atContact, int pairs) {
  const double until_m = 0.8 / beta;
  AsNewtons all;
  for (const double thick_m : {0.001, 0.01, 0.03}) {
    for (int n = 0; n < pairs; ++n) {
      SCOPED_TRACE(testing::Message() << thick_m << " m at " << beta << " c, seed " << n
                                      << (atContact ? ", contact" : ", centre"));
      const BilliardSetup setup =
          twoBars({thick_m, beta, 1.0, atContact, M_PI, 0.12}, static_cast<unsigned>(n));
      std::array<test::NewtonBody, 2> bodies;
      for (int i = 0; i < 2; ++i) {
        const Puck& bar = setup.pucks[i];
        bodies[i] = {bar.outline_m, bar.mass_kg, bar.inertia * bar.mass_kg * bar.radius_m * bar.radius_m,
                     bar.position_m, bar.beta};
      }
      const int blows = test::playNewton(bodies, 1.0, until_m);
      Billiard game(setup);
      game.advanceTo(until_m / setup.lightSpeed_m_s);
      EXPECT_EQ(blows == 0, game.events().empty());
      if (blows == 0 || game.events().empty()) continue;
      const Vec2 apart = lastBeta(game, 1) - lastBeta(game, 0);
      const Vec2 newton = bodies[1].velocity - bodies[0].velocity;
      ++all.touched;
      if (!(glm::dot(apart, newton) > 0.5 * glm::length(apart) * glm::length(newton)))
        ++all.otherSide;
      else if (!(glm::length(apart - newton) < 0.3 * beta))
        ++all.otherVelocity;
    }
  }
  return all;
}

// Where turns do not wait for light, on the side on which Newton's bars end; the shapes at each blow differ
// by v²/c², which changes the velocities of ends that graze. Where they wait, bars make a way of v/c of their
// length until their centres know of the blow, 1.2 mm at 0.02 c: an end that grazes by less, or meets long
// after a first blow, ends anyhow, and fewer do so the slower they are.
TEST(BarsFaceToFace, SlowOnesEndAsNewtonsDo) {
  const char* const asked = std::getenv("CAROM_PAIRS");
  const int pairs = asked != nullptr ? std::atoi(asked) : 40;
  const AsNewtons atContact = playBeside(0.02, true, pairs), waiting = playBeside(0.02, false, pairs),
                  slower = playBeside(0.002, false, pairs);
  EXPECT_EQ(atContact.otherSide, 0);
  EXPECT_LE(atContact.otherVelocity, atContact.touched / 200);
  EXPECT_LE(waiting.otherSide, waiting.touched / 100);
  EXPECT_LE(slower.otherSide, slower.touched / 100);
  EXPECT_LE(slower.otherVelocity, slower.touched / 100);
  EXPECT_GT(slower.touched, 2 * pairs);
}

struct Ends {
  int pairs = 0, touched = 0, elsewhere = 0, untouched = 0;
  std::size_t kicks = 0, most = 0;
};

/// Bars that leave each other sideways, slower than kSideways along the impulse, recede from no side.
void addEnd(const BilliardSetup& setup, Ends& ends) {
  constexpr double kForever_s = 2000.0, kStep_m = 0.0004, kClear_m = 0.5, kSideways = 0.02;
  Billiard game(setup);
  game.advanceTo(kForever_s);
  double lastTurn = 0.0;
  for (const GameEvent& event : game.events())
    for (const Turn& turn : event.turns) lastTurn = std::max(lastTurn, turn.event.t_s * setup.lightSpeed_m_s);
  const double until = lastTurn + kClear_m / std::abs(setup.pucks[0].beta.x);
  ++ends.pairs;
  ends.kicks += game.events().size(), ends.most = std::max(ends.most, game.events().size());
  if (game.events().empty()) {
    ends.untouched += !test::BarsOnBoard(game, setup).overlaps(0.0, until, kStep_m, 0.0).empty();
    return;
  }
  ++ends.touched;
  const test::BarsEnd end = test::endOf(game, setup, until, kStep_m);
  ends.elsewhere += end.receding < -kSideways && end.along < 0.0;
}

// Their kick leaves them approaching, through each other, or at an angle about which frames disagree.
TEST(BarsAnyTilt, ThatApproachAfterTheirKickAreSentBack) {
  struct Pair {
    test::BarMeeting meeting;
    unsigned seed;
  };
  const auto pair = [](double thick_m, double beta, double restitution, bool atContact, unsigned seed) {
    return Pair{{thick_m, beta, restitution, atContact, 0.5 * M_PI, 0.12}, seed};
  };
  for (const auto& [meeting, seed] :
       {pair(0.01, 0.5, 1.0, false, 73), pair(0.03, 0.7, 1.0, false, 69), pair(0.01, 0.99, 1.0, false, 14),
        pair(0.03, 0.99, 1.0, false, 59), pair(0.03, 0.99, 1.0, false, 77), pair(0.003, 0.99, 0.8, false, 40),
        pair(0.01, 0.99, 0.8, false, 9), pair(0.03, 0.9, 0.8, true, 53),
        // These come out of each other beside the impulse.
        pair(0.03, 0.99, 0.8, false, 169), pair(0.001, 0.99, 0.8, true, 9),
        // These touch no more, and go past each other on the board; the last one in a jam of their own.
        pair(0.003, 0.95, 1.0, true, 160), pair(0.001, 0.99, 1.0, true, 162),
        pair(0.001, 0.99, 0.8, true, 186), pair(0.003, 0.95, 1.0, false, 34),
        pair(0.003, 0.99, 0.8, false, 15), pair(0.001, 0.99, 0.8, false, 187)}) {
    SCOPED_TRACE(testing::Message() << meeting.thick_m << " m at " << meeting.beta << " c, seed " << seed);
    Ends ends;
    addEnd(twoBars(meeting, seed), ends);
    EXPECT_EQ(ends.touched, 1);
    EXPECT_EQ(ends.elsewhere, 0);
  }
}

TEST(BarsAnyTilt, RecedeFromTheSideThatTheyLastTouched) {
  const char* const asked = std::getenv("CAROM_PAIRS");
  const int pairs = asked != nullptr ? std::atoi(asked) : 3;
  std::vector<double> speeds{0.05, 0.1, 0.5, 0.99};
  if (asked != nullptr) speeds = {0.05, 0.1, 0.3, 0.5, 0.7, 0.9, 0.95, 0.99};
  for (const bool atContact : {false, true}) {
    for (const double beta : speeds) {
      SCOPED_TRACE(testing::Message() << beta << (atContact ? " c, contact" : " c, centre"));
      Ends all;
      for (const double thick_m : {0.001, 0.003, 0.01, 0.03}) {
        Ends ends;
        for (const double restitution : {1.0, 0.8}) {
          for (int n = 0; n < pairs; ++n) {
            const test::BarMeeting meeting{thick_m, beta, restitution, atContact, 0.5 * M_PI, 0.12};
            addEnd(test::twoBars(meeting, static_cast<unsigned>(n)), ends);
          }
        }
        all.pairs += ends.pairs, all.elsewhere += ends.elsewhere, all.untouched += ends.untouched;
        all.kicks += ends.kicks;
        if (asked == nullptr) continue;
        std::printf("%s %2.0f mm %.2f c: %3d of %3d elsewhere, %4.1f kicks, at most %zu\n",
                    atContact ? "contact" : "centre ", thick_m * 1e3, beta, ends.elsewhere, ends.touched,
                    static_cast<double>(ends.kicks) / ends.pairs, ends.most);
        std::fflush(stdout);
      }
      EXPECT_EQ(all.elsewhere, 0);
      EXPECT_EQ(all.untouched, 0);
      EXPECT_LE(all.kicks, 10 * static_cast<std::size_t>(all.pairs));
    }
  }
}

}  // namespace
}  // namespace carom
