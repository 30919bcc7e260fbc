// Pucks that press on one another: every game comes to its end with a bounded number of events, whatever the
// restitution, and nothing of energy or momentum is lost.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <ostream>
#include <random>

#include "engine/balance.h"
#include "engine/billiard/billiard.h"
#include "engine/light_speed.h"
#include "engine/random_game.h"
#include "sanitized.h"

namespace carom {
namespace {

constexpr double kPuckRadius_m = 0.0305;

enum class Pile { row, rack, packed, atCushion, inCorner, driven };

struct Game {
  Pile pile = Pile::row;
  int pucks = 10;
  double restitution = 0.0, cushionRestitution = 0.9, friction_m_s2 = 0.0, gap = 1e-3;
  CollisionEvent convention = CollisionEvent::centre;
  bool board = true, mixed = false;
  std::uint64_t seed = 1;
};

std::ostream& operator<<(std::ostream& out, const Game& game) {
  const char* kPiles[] = {"row", "rack", "packed", "at a cushion", "in a corner", "driven into a corner"};
  return out << kPiles[static_cast<int>(game.pile)] << " of " << game.pucks << ", restitution "
             << game.restitution << ", of cushions " << game.cushionRestitution << ", friction "
             << game.friction_m_s2 << ", gap " << game.gap << " R, "
             << (game.convention == CollisionEvent::centre ? "centre" : "contact")
             << (game.board ? "" : ", no board") << (game.mixed ? ", mixed" : "") << ", seed " << game.seed;
}

double massOf(const Game& game, std::mt19937_64& random) {
  const double unit = static_cast<double>(random() >> 11) * 0x1.0p-53;
  return game.mixed ? std::pow(10.0, 2.0 * unit - 2.0) : 0.2;
}

double radiusOf(const Game& game, std::mt19937_64& random) {
  const double unit = static_cast<double>(random() >> 11) * 0x1.0p-53;
  return game.mixed ? kPuckRadius_m * (0.8 + 0.2 * unit) : kPuckRadius_m;
}

// A pile at rest, hit by one at 0.7 c; or all of it driven.
BilliardSetup setupOf(const Game& game) {
  std::mt19937_64 random(game.seed);
  BilliardSetup setup;
  setup.lightSpeed_m_s = test::kC_m_s;
  const double length_m = game.pucks > 60 ? 3.6 : 2.84, width_m = game.pucks > 60 ? 2.0 : 1.42;
  if (game.board) setup.board = Board{length_m, width_m};
  setup.rules = {game.restitution, game.cushionRestitution, game.friction_m_s2, game.convention};
  const auto add = [&](const Vec2& at_m, const Vec2& beta) {
    std::string name = std::to_string(setup.pucks.size());
    name.insert(0, 3 - name.size(), '0');
    setup.pucks.push_back({name, radiusOf(game, random), 0.02, massOf(game, random), at_m, beta});
  };
  const double step_m = kPuckRadius_m * (2.0 + game.gap), up_m = 0.5 * std::sqrt(3.0) * step_m;
  const int columns = static_cast<int>(std::ceil(std::sqrt(game.pucks)));
  const int rows = (game.pucks + columns - 1) / columns;
  if (game.pile == Pile::row) {
    for (int i = 0; i < game.pucks; ++i) add({-0.3 + i * step_m, 0.0}, {0.0, 0.0});
  } else if (game.pile == Pile::rack) {
    for (int row = 1, placed = 0; placed < game.pucks; ++row) {
      for (int k = 0; k < row && placed < game.pucks; ++k, ++placed)
        add({0.2 + (row - 1) * up_m, (k - 0.5 * (row - 1)) * step_m}, {0.0, 0.0});
    }
  } else {
    const double right_m = 0.5 * length_m - 0.5 * step_m, top_m = 0.5 * width_m - 0.5 * step_m;
    for (int i = 0; i < game.pucks; ++i) {
      const double x_m = step_m * (i % columns + 0.5 * (i / columns % 2)), y_m = up_m * (i / columns);
      if (game.pile == Pile::inCorner) {
        add({right_m - x_m, top_m - y_m}, {0.0, 0.0});
      } else if (game.pile == Pile::atCushion) {
        add({right_m - x_m, y_m - 0.5 * rows * up_m}, {0.0, 0.0});
      } else {
        const Vec2 beta = game.pile == Pile::driven ? Vec2(0.5, 0.35) : Vec2(0.0);
        add({x_m - 0.3, y_m - 0.5 * rows * up_m}, beta);
      }
    }
  }
  if (game.pile == Pile::inCorner) {
    add({-0.05, -0.5}, {0.55, 0.43});
  } else if (game.pile != Pile::driven) {
    add({-0.9, 0.003}, {0.7, 0.0});
  }
  return setup;
}

// A puck takes 64 kicks in the time in which light crosses its radius before it is pressed.
std::size_t mostEvents(const Game& game, double until_s) {
  const double crossings = until_s * test::kC_m_s / kPuckRadius_m;
  return static_cast<std::size_t>(64 * (1.0 + crossings)) * static_cast<std::size_t>(game.pucks + 1);
}

void expectStrictlyInside(const Billiard& billiard, const BilliardSetup& setup) {
  if (!setup.board) return;
  for (const WorldLine& line : billiard.worldLines()) {
    for (const Knot& knot : line.knots()) {
      ASSERT_LT(std::abs(knot.turn.r_m.x), 0.5 * setup.board->length_m);
      ASSERT_LT(std::abs(knot.turn.r_m.y), 0.5 * setup.board->width_m);
    }
  }
}

bool isAtCushion(const Turn& turn, const BilliardSetup& setup) {
  if (!setup.board) return false;
  const double away_m = 1.001 * setup.pucks[turn.puck].radius_m;
  return 0.5 * setup.board->length_m - std::abs(turn.event.r_m.x) <= away_m ||
         0.5 * setup.board->width_m - std::abs(turn.event.r_m.y) <= away_m;
}

// Each event's heat is not negative. The momenta after, with the heat's, less those before, over all events
// of one jam, cancel where no cushion is near; solved from the velocities alone. The heat of a jam leaves a
// puck while it comes to its velocity: so its momentum is known but for what this velocity changes.
void expectEventsBalance(const Billiard& billiard, const BilliardSetup& setup) {
  const std::span<const GameEvent> events = billiard.events();
  const double c = setup.lightSpeed_m_s;
  for (std::size_t k = 0; k < events.size();) {
    Vec2 change(0.0);
    double energy = 0.0, scale = 0.0, radiated = 0.0, changed = 0.0;
    bool atCushion = events[k].kind != EventKind::jam;
    std::size_t end = k;
    for (; end < events.size() &&
           (end == k || (events[end].kind == EventKind::jam && events[k].kind == EventKind::jam &&
                         events[end].at.t_s == events[k].at.t_s && events[end].at.r_m == events[k].at.r_m));
         ++end) {
      ASSERT_TRUE(events[end].heat_j >= 0.0) << events[end].heat_j;
      for (const Turn& turn : events[end].turns) {
        const double mass = setup.pucks[turn.puck].mass_kg, heat = events[end].heat_j / (c * c);
        const double before = 1.0 / std::sqrt(1.0 - glm::dot(turn.betaBefore, turn.betaBefore));
        const double after = 1.0 / std::sqrt(1.0 - glm::dot(turn.betaAfter, turn.betaAfter));
        change += (mass + heat) * after * turn.betaAfter - mass * before * turn.betaBefore;
        energy += (mass + heat) * after - mass * before;
        scale += mass * before;
        if (events[end].kind == EventKind::jam) {
          radiated += heat * after;
          changed = std::max(changed, glm::length(after * turn.betaAfter - before * turn.betaBefore));
        }
        atCushion = atCushion || isAtCushion(turn, setup);
      }
    }
    if (!atCushion) {
      const double unknown = 1e-10 * scale + 4.0 * radiated * changed;
      ASSERT_TRUE(glm::length(change) <= unknown)
          << "events from " << k << ": " << glm::length(change) / scale;
      ASSERT_TRUE(std::abs(energy) <= unknown) << "events from " << k << ": " << energy / scale;
    }
    k = end;
  }
}

void playThrough(const Game& game, double until_s, std::size_t mostEvents) {
  SCOPED_TRACE(testing::Message() << game);
  const BilliardSetup setup = setupOf(game);
  Billiard billiard(setup);
  const Ledger start = billiard.ledger();
  for (int step = 1; step * 0.01 <= until_s; ++step) {
    billiard.advanceTo(step * 0.01);
    ASSERT_LE(billiard.events().size(), mostEvents) << "at " << step * 0.01 << " s";
  }
  test::expectBalanced(billiard, start, 1e-11);
  expectStrictlyInside(billiard, setup);
  expectEventsBalance(billiard, setup);
  if (game.restitution == 1.0 && game.cushionRestitution == 1.0) {
    EXPECT_TRUE(billiard.jams().empty());
  }
}

// A rack, a row, fifty packed, four seconds: less than a thousand events for each puck.
TEST(Jam, standsNotStill) {
  for (const double e : {0.0, 0.1, 0.3}) {
    for (const CollisionEvent convention : {CollisionEvent::centre, CollisionEvent::contact}) {
      for (const auto& [pile, pucks] : {std::pair(Pile::rack, 15), {Pile::row, 10}, {Pile::packed, 50}}) {
        Game game;
        game.pile = pile, game.pucks = pucks, game.restitution = e, game.convention = convention;
        playThrough(game, 4.0, 1000 * static_cast<std::size_t>(pucks + 1));
        if (HasFailure()) return;
      }
    }
  }
}

Game randomGame(std::uint64_t seed, int mostPucks) {
  std::mt19937_64 random(seed);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-53; };
  Game game;
  game.seed = seed;
  game.pile = static_cast<Pile>(random() % 6);
  game.pucks = 2 + static_cast<int>(std::pow(unit(), 2.0) * (mostPucks - 1));
  if (game.pile == Pile::row) game.pucks = std::min(game.pucks, 20);
  if (game.pile == Pile::rack) game.pucks = std::min(game.pucks, 36);
  game.restitution = random() % 3 == 0 ? 0.0 : random() % 8 == 0 ? 1.0 : unit();
  game.cushionRestitution = random() % 3 == 0 ? 0.0 : unit();
  game.gap = random() % 3 == 0 ? 0.0 : 0.01 * unit();
  game.convention = random() % 2 == 0 ? CollisionEvent::centre : CollisionEvent::contact;
  game.board = game.pile >= Pile::atCushion || random() % 3 != 0;
  game.mixed = random() % 3 == 0;
  if (game.gap == 0.0) game.gap = 1e-12;  // touching, within the rounding of the places
  return game;
}

TEST(Jam, anyPileComesToAnEnd) {
  for (std::uint64_t seed = 1; seed <= test::casesOf<std::uint64_t>(60); ++seed) {
    const Game game = randomGame(seed, 100);
    playThrough(game, 2.5, mostEvents(game, 2.5));
    if (HasFailure()) return;
  }
}

TEST(Jam, alsoUnderFriction) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Game game = randomGame(1000 + seed, 16);
    game.friction_m_s2 = 0.02 * static_cast<double>(1 + seed % 10);
    playThrough(game, 2.0, mostEvents(game, 2.0));
    if (HasFailure()) return;
  }
}

// No puck turns more often than this while light crosses its radius. It has 64 kicks by others, and bounces
// between them, until it is pressed, and then 80 turns in jams until what is slow is as fast as the hardest
// blow; how many more there can be is not proved. The games below come to 260.
constexpr std::size_t kMostTurns = 512;

void expectProgress(const Billiard& billiard, const BilliardSetup& setup) {
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    const Knots knots = billiard.worldLines()[i].knots();
    const double crossing_s = setup.pucks[i].radius_m / setup.lightSpeed_m_s;
    for (std::size_t k = kMostTurns; k < knots.size(); ++k) {
      ASSERT_TRUE(knots[k].turn.t_s - knots[k - kMostTurns].turn.t_s > crossing_s)
          << setup.pucks[i].name << " turns " << kMostTurns << " times before " << knots[k].turn.t_s << " s";
    }
  }
}

// Pucks of any restitution between inelastic cushions, driven into a corner or hit there.
TEST(Jam, cushionsAlsoPress) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Game game = randomGame(3000 + seed, 60);
    const Pile kPiles[] = {Pile::atCushion, Pile::inCorner, Pile::driven};
    game.pile = kPiles[seed % 3], game.board = true;
    game.restitution = seed % 4 == 0 ? 1.0 : 0.5 + 0.5 * game.restitution;
    game.cushionRestitution *= 0.3;
    SCOPED_TRACE(testing::Message() << game);
    const BilliardSetup setup = setupOf(game);
    Billiard billiard(setup);
    const Ledger start = billiard.ledger();
    for (int step = 1; step <= 60 && !HasFailure(); ++step) {
      billiard.advanceTo(0.05 * step);
      expectProgress(billiard, setup);
    }
    test::expectBalanced(billiard, start, 1e-11);
    expectStrictlyInside(billiard, setup);
    if (HasFailure()) return;
  }
}

// A pile that grows while it is pushed: what one more puck brings is soon part of the one body.
TEST(Jam, manyPacked) {
  Game game;
  game.pile = Pile::packed, game.pucks = 200;
  const BilliardSetup setup = setupOf(game);
  Billiard billiard(setup);
  const Ledger start = billiard.ledger();
  for (int step = 1; step <= 40 && !HasFailure(); ++step) {
    billiard.advanceTo(0.1 * step);
    ASSERT_LE(billiard.jams().size(), 10u * setup.pucks.size());
  }
  expectProgress(billiard, setup);
  test::expectBalanced(billiard, start, 1e-11);
}

// Games drawn from everything that can be played: a sample, and those in which pucks pressed hardest.
TEST(Jam, randomGamesMakeProgress) {
  for (const int seed : test::someOf({1, 7, 31, 53, 54, 95, 103, 113, 114, 150, 21})) {
    const test::RandomGame game = test::randomGame(seed);
    SCOPED_TRACE(testing::Message() << "seed " << seed << " (" << game.kind << "), until " << game.until_s
                                    << " s");
    Billiard billiard(game.setup);
    for (int step = 1; step <= 64 && !HasFailure(); ++step) {
      billiard.advanceTo(game.until_s * step / 64.0);
      expectProgress(billiard, game.setup);
    }
    if (HasFailure()) return;
  }
}

BilliardSetup reversed(BilliardSetup setup) {
  std::reverse(setup.pucks.begin(), setup.pucks.end());
  for (Stroke& stroke : setup.strokes) stroke.puck = setup.pucks.size() - 1 - stroke.puck;
  return setup;
}

constexpr double kKnown_s = 2.0;

void expectSame(const WorldLine& one, const WorldLine& two, double sign = 1.0) {
  const auto known = [](const WorldLine& line) {
    return std::count_if(line.knots().begin(), line.knots().end(),
                         [](const Knot& knot) { return knot.turn.t_s <= kKnown_s; });
  };
  ASSERT_EQ(known(one), known(two));
  for (std::size_t k = 0; k < static_cast<std::size_t>(known(one)); ++k) {
    const Knot &a = one.knots()[k], &b = two.knots()[k];
    ASSERT_TRUE(a.turn.t_s == b.turn.t_s && a.turn.r_m.x == b.turn.r_m.x &&
                a.turn.r_m.y == sign * b.turn.r_m.y && a.u.x == b.u.x && a.u.y == sign * b.u.y &&
                a.properTime_s == b.properTime_s)
        << "knot " << k;
  }
}

// The order in the file, the steps of time and the moment at which a stroke is told change no bit; nor does
// the mirror.
TEST(Jam, isDeterministic) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Game game = randomGame(2000 + seed, 40);
    game.restitution *= 0.5;
    SCOPED_TRACE(testing::Message() << game);
    BilliardSetup setup = setupOf(game);
    const Stroke stroke{setup.pucks.size() / 2, 0.9, std::nullopt, {-0.05, 0.11}};
    Billiard late(setup);
    late.advanceTo(kKnown_s);
    late.strike(stroke);
    setup.strokes.push_back(stroke);
    Billiard told(setup), other(reversed(setup));
    for (double t_s = 0.0; t_s < kKnown_s; t_s += 0.0137) told.advanceTo(t_s);
    told.advanceTo(kKnown_s);
    other.advanceTo(kKnown_s);
    // One may know a little more of what comes after.
    const std::size_t common = std::min(told.events().size(), late.events().size());
    for (std::size_t k = 0; k < common; ++k) {
      const GameEvent &a = told.events()[k], &b = late.events()[k];
      ASSERT_TRUE(a.kind == b.kind && a.at.t_s == b.at.t_s && a.at.r_m == b.at.r_m && a.heat_j == b.heat_j)
          << k;
    }
    BilliardSetup mirror = setup;
    for (Puck& puck : mirror.pucks) puck.position_m.y *= -1.0, puck.beta.y *= -1.0;
    mirror.strokes[0].momentum_kg_m_s.y *= -1.0;
    Billiard mirrored(mirror);
    mirrored.advanceTo(kKnown_s);
    for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
      expectSame(told.worldLines()[i], late.worldLines()[i]);
      if (HasFailure()) return;
      expectSame(told.worldLines()[i], other.worldLines()[setup.pucks.size() - 1 - i]);
      expectSame(told.worldLines()[i], mirrored.worldLines()[i], -1.0);
      if (HasFailure()) return;
    }
  }
}

// A row that is run into comes to where nobody closes on anybody: in a day no gap shrinks by more than a
// micrometre, and those of the last jam have one and the same velocity.
TEST(Jam, aRowMovesOnTogether) {
  for (const CollisionEvent convention : {CollisionEvent::contact, CollisionEvent::centre}) {
    Game game;
    game.board = false;
    game.convention = convention;
    SCOPED_TRACE(testing::Message() << game);
    BilliardSetup setup = setupOf(game);
    setup.pucks.back().position_m.y = 0.0;
    Billiard billiard(setup);
    billiard.advanceTo(20.0);
    ASSERT_FALSE(billiard.jams().empty());
    for (const JamNote& jam : billiard.jams()) EXPECT_TRUE(jam.heat_j >= 0.0);
    const std::size_t events = billiard.events().size();
    billiard.advanceTo(86400.0);
    EXPECT_EQ(billiard.events().size(), events);
    const auto at = [&](std::size_t i, double t_s) {  // the one that ran into them is behind the first
      return billiard.worldLines()[i == 0 ? 10 : i - 1].at(t_s);
    };
    std::size_t together = 1;
    for (std::size_t i = 1; i < 11; ++i) {
      const auto gap_m = [&](double t_s) { return at(i, t_s).event.r_m.x - at(i - 1, t_s).event.r_m.x; };
      EXPECT_TRUE(gap_m(86400.0) >= gap_m(20.0) - 1e-6) << i << " " << gap_m(86400.0) - gap_m(20.0);
      if (at(i, 20.0).u == at(i - 1, 20.0).u) ++together;
    }
    EXPECT_GE(together, 2u);
  }
}

// Two rows beside each other that never touch are jammed at nearly the same time: each as if it were alone.
TEST(Jam, ofOneRowIsNoneOfAnotherBeside) {
  for (const CollisionEvent convention : {CollisionEvent::contact, CollisionEvent::centre}) {
    Game game;
    game.board = false;
    game.convention = convention;
    SCOPED_TRACE(testing::Message() << game);
    BilliardSetup alone = setupOf(game);
    alone.pucks.back().position_m.y = 0.0;
    BilliardSetup both = alone;
    for (Puck puck : alone.pucks) {
      puck.name.insert(0, "beside ");
      puck.position_m += Vec2(0.003, 2.5 * kPuckRadius_m);
      both.pucks.push_back(puck);
    }
    Billiard one(alone), two(both);
    one.advanceTo(20.0);
    two.advanceTo(20.0);
    ASSERT_FALSE(one.jams().empty());
    EXPECT_GT(two.jams().size(), one.jams().size());
    for (std::size_t i = 0; i < alone.pucks.size(); ++i) {
      const Knots expected = one.worldLines()[i].knots(), found = two.worldLines()[i].knots();
      // Of what turns after 20 s each knows as much as it needed.
      for (std::size_t k = 0; k < std::max(found.size(), expected.size()); ++k) {
        if (k >= std::min(found.size(), expected.size())) {
          EXPECT_GT((k < found.size() ? found : expected)[k].turn.t_s, 20.0) << i;
          break;
        }
        EXPECT_EQ(found[k].turn.t_s, expected[k].turn.t_s);
        EXPECT_EQ(found[k].u, expected[k].u);
      }
    }
  }
}

// A light so fast that all is slow: the bound of what is together is then a share of the blow.
TEST(Jam, ofSlowPucks) {
  Game game;
  game.board = false;
  BilliardSetup slow = setupOf(game);
  slow.lightSpeed_m_s = 299792458.0;
  for (Puck& puck : slow.pucks) puck.beta *= 1e-8;
  slow.pucks.back().position_m.y = 0.0;
  Billiard billiard(slow);
  billiard.advanceTo(20.0);
  const double total = slow.pucks.back().beta.x / 11.0;  // Newton
  for (const WorldLine& line : billiard.worldLines())
    EXPECT_TRUE(std::abs(line.at(20.0).u.x / total - 1.0) <= 1e-6) << line.at(20.0).u.x;
}

}  // namespace
}  // namespace carom
