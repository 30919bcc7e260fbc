// The same bits on every run, at every optimisation and with every instruction set: digests of whole games,
// recorded once. This file is compiled several times, together with the physics: see CMakeLists.txt.

#include <gtest/gtest.h>

#include <ostream>

#include "engine/billiard/billiard.h"
#include "engine/game_digest.h"
#include "engine/soft/soft_history.h"

namespace carom {
namespace {

constexpr CollisionEvent kCentre = CollisionEvent::centre, kContact = CollisionEvent::contact;

struct Game {
  const char* name;
  CollisionEvent collisionEvent;
  double restitution, friction_m_s2;
  bool mixed;  // sizes and masses
  int pucks;
  bool strokes;
  double until_s;
  std::uint64_t digest;
};

void PrintTo(const Game& game, std::ostream* out) { *out << game.name; }

BilliardSetup setupOf(const Game& game) {
  BilliardSetup setup = test::exactGas(game.pucks, 0.1, 0.9, game.mixed, 1);
  setup.rules.collisionEvent = game.collisionEvent;
  setup.rules.puckRestitution = setup.rules.cushionRestitution = game.restitution;
  setup.rules.friction_m_s2 = game.friction_m_s2;
  if (game.strokes) {
    setup.strokes.push_back({2, 0.5, std::nullopt, {0.5, 0.2}});
    setup.strokes.push_back({4, 0.2, Vec3{0.0, 0.0, 0.1}, {-0.5, 1.2}});
  }
  return setup;
}

class BilliardBits : public testing::TestWithParam<Game> {};

TEST_P(BilliardBits, areTheRecordedOnes) {
  const Game& game = GetParam();
  Billiard billiard(setupOf(game));
  billiard.advanceTo(game.until_s);
  EXPECT_GT(billiard.events().size(), 200u);
  EXPECT_EQ(test::digestOf(billiard), game.digest) << std::hex << "0x" << test::digestOf(billiard);
}

INSTANTIATE_TEST_SUITE_P(
    , BilliardBits,
    testing::Values(Game{"few", kCentre, 1.0, 0.0, true, 9, false, 20.0, 0x51bbe80176e4d345},
                    Game{"struck", kCentre, 0.9, 0.0, true, 9, true, 20.0, 0x50ee66199fa969ac},
                    Game{"centre", kCentre, 0.9, 0.0, true, 200, false, 1.0, 0x1dd65694291f964d},
                    Game{"contact", kContact, 1.0, 0.0, false, 1000, false, 0.5, 0x6aec5bf522e3a734},
                    Game{"many", kContact, 1.0, 0.0, true, 5000, false, 0.1, 0x8b11f9acd751ff47},
                    Game{"gliding", kCentre, 0.9, 0.05, true, 60, true, 3.0, 0x45af05ee2bb26a48}),
    [](const auto& game) { return std::string(game.param.name); });

Puck disc(const char* name, const Vec2& position_m, const Vec2& beta) {
  Puck puck;
  puck.name = name;
  puck.radius_m = 0.03;
  puck.height_m = 0.02;
  puck.mass_kg = 0.2;
  puck.position_m = position_m;
  puck.beta = beta;
  return puck;
}

// A soft puck meets a rigid one, which becomes soft, a cushion and a stroke; with the rows by which they are
// seen.
TEST(SoftBits, AreTheRecordedOnes) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.0;
  setup.board = Board{0.4, 0.3};
  setup.pucks = {disc("jelly", {0.0, 0.0}, {0.4, 0.1}), disc("rigid", {0.12, 0.02}, {-0.3, 0.0})};
  setup.pucks[0].soft = SoftMatter{0.5, 4, 0.3, {}};
  setup.strokes.push_back({0, 0.3, Vec3{0.1, 0.0, 0.1}, {-0.05, 0.02}});
  Billiard billiard(setup);
  billiard.advanceTo(0.6);
  int soft = 0;
  for (const GameEvent& event : billiard.events()) {
    if (event.kind == EventKind::softSoft || event.kind == EventKind::softCushion) ++soft;
  }
  EXPECT_GE(soft, 2);
  test::Digest digest;
  digest.add(test::digestOf(billiard));
  SoftRows rows;
  billiard.takeSoftRows(rows);
  EXPECT_GT(rows.rows.size(), 50u);
  for (const SoftRow& row : rows.rows) digest.add(row.time);
  for (const SoftNode& node : rows.nodes) {
    digest.add(double{node.x}), digest.add(double{node.y});
    for (const std::int16_t part : {node.velocity[0], node.velocity[1], node.strain, node.heat})
      digest.add(static_cast<double>(part));
  }
  EXPECT_EQ(digest.value(), 0xe89294c2880191d5u) << std::hex << "0x" << digest.value();
}

}  // namespace
}  // namespace carom
