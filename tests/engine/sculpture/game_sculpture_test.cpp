// The whole sculpture: as large as told, printable, and its beads in the order that a frame gives the events.
#include "engine/sculpture/game_sculpture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "engine/billiard/billiard.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"
#include "engine/sculpture/closed.h"

namespace carom {
namespace {

BilliardSetup setupOf() {
  BilliardSetup setup;
  setup.lightSpeed_m_s = test::kC_m_s;
  setup.board = Board{2.84, 1.42};
  const auto puck = [](const char* name, double x_m, double y_m, double bx, double by) {
    Puck made;
    made.name = name;
    made.radius_m = 0.0305;
    made.height_m = 0.04;
    made.mass_kg = 0.2;
    made.position_m = {x_m, y_m};
    made.beta = {bx, by};
    return made;
  };
  setup.pucks = {puck("white", -1.0, 0.1, 0.6, 0.05), puck("red", 0.3, 0.12, 0.0, 0.0),
                 puck("yellow", 0.5, -0.4, -0.2, 0.5)};
  setup.strokes = {{2, 1.0, Vec3(0.2, -0.6, 0.3), {0.05, 0.05}}};
  setup.flashes = {{"lamp", {0.5, Vec3(0.0, 0.3, 0.2)}}};
  return setup;
}

struct Game {
  Game() : setup(setupOf()), billiard(setup) { billiard.advanceTo(6.0); }
  SculptureSource source() const { return {setup, billiard.worldLines(), billiard.events()}; }
  BilliardSetup setup;
  Billiard billiard;
};

TEST(GameSculpture, HasTheSizeAndTheWallThatWereAskedFor) {
  const Game game;
  for (const double bx : {0.0, 0.6}) {
    const GameSculpture made = sculptureOf(game.source(), {{0.0, 5.0}, {bx, 0.0, 0.0}, 0.15, 1.2e-3, false});
    Vec3 low(1e9), high(-1e9);
    for (const SculpturePart& part : made.parts) {
      EXPECT_EQ(test::openEdges(part.solid), 0) << part.name;
      EXPECT_GT(volume_m3(part.solid), 0.0) << part.name;
      if (part.kind != SculpturePartKind::tube) continue;
      for (const Vec3& point : part.solid.points) low = glm::min(low, point), high = glm::max(high, point);
    }
    const Vec3 size_m = (high - low) * made.scale;
    EXPECT_LE(std::max({size_m.x, size_m.y, size_m.z}), 0.151);
    EXPECT_NEAR(made.leastWall_m, 1.2e-3, 1e-9);
    EXPECT_EQ(made.withoutTube, 0u);
  }
  // In 30 cm and without a least wall: a puck of 61 mm on a table of 2.84 m is 6 mm wide, the rods are 1.2
  // mm.
  const GameSculpture wide = sculptureOf(game.source(), {{0.0, 1.0}, Vec3(0.0), 0.30, 0.0, false});
  EXPECT_EQ(wide.thickened, 0u);
  EXPECT_NEAR(wide.scale, (0.30 - 4.6e-3) / 2.84, 1e-9) << "less the base and the rods";
}

TEST(GameSculpture, ThinTubesAreThickened) {
  const Game game;
  const GameSculpture made = sculptureOf(game.source(), {{0.0, 1.0}, Vec3(0.0), 0.03, 1.2e-3, false});
  EXPECT_EQ(made.thickened, 3u);
  // Red rests up to its first news: its tube is as wide as the least wall, measured on its first lid.
  const auto red =
      std::find_if(made.parts.begin(), made.parts.end(), [](const auto& part) { return part.name == "red"; });
  ASSERT_NE(red, made.parts.end());
  double lowest = 1e9, left = 1e9, right = -1e9;
  for (const Vec3& point : red->solid.points) lowest = std::min(lowest, point.z);
  for (const Vec3& point : red->solid.points) {
    if (point.z > lowest + 1e-9) continue;
    left = std::min(left, point.x);
    right = std::max(right, point.x);
  }
  EXPECT_GE((right - left) * made.scale, 1.2e-3 - 1e-9);
}

// A bead for each event between the two moments, and in any frame the order of two of them as the Lorentz
// transform of their displacement has it.
TEST(GameSculpture, BeadsStandInTheOrderOfTheFrame) {
  const Game game;
  test::Random random(36);
  int flipped = 0;
  std::map<std::string, Event> at;
  for (const GameEvent& event : game.billiard.events()) {
    const bool isBead = event.kind == EventKind::puckPuck || event.kind == EventKind::puckCushion;
    if (isBead && event.at.t_s >= 0.0 && event.at.t_s <= 5.0)
      at["event " + std::to_string(event.number) + " " + std::string(nameOf(event.kind))] = event.at;
  }
  ASSERT_GT(at.size(), 4u);
  for (int i = 0; i < 50; ++i) {
    CASE(random, i);
    const double speed = random.in(0.0, 0.95), angle = random.in(0.0, 6.3);
    const Vec3 beta(speed * std::cos(angle), speed * std::sin(angle), 0.0);
    const GameSculpture made = sculptureOf(game.source(), {{0.0, 5.0}, beta, 0.15, 0.0, true});
    std::map<std::string, double> heights;
    for (const SculpturePart& part : made.parts) {
      if (part.kind != SculpturePartKind::bead || !at.contains(part.name)) continue;
      Vec3 sum(0.0);
      for (const Vec3& point : part.solid.points) sum += point;
      heights[part.name] = sum.z / static_cast<double>(part.solid.points.size());
    }
    ASSERT_EQ(heights.size(), at.size());
    for (const auto& [one, onBoard] : at) {
      for (const auto& [other, there] : at) {
        const double dt_m = test::kC_m_s * (there.t_s - onBoard.t_s);
        const double later = dt_m - glm::dot(Vec2(beta), Vec2(there.r_m - onBoard.r_m));
        if (std::abs(later) < 1e-6) continue;
        ASSERT_EQ(heights[other] > heights[one], later > 0.0) << one << ", " << other;
        flipped += later * dt_m < 0.0;
      }
    }
  }
  EXPECT_GT(flipped, 10);
}

// The light of a stroke goes straight from the hand to the puck, and so rises by 45 degrees or more. That of
// a flash above the board meets the plane in a circle: ρ after √(h² + ρ²)/c, at first faster than light.
TEST(GameSculpture, LightLiesOnTheConesOfItsEvents) {
  const Game game;
  const GameSculpture made = sculptureOf(game.source(), {{0.0, 5.0}, Vec3(0.0), 0.15, 0.0, true});
  int strokes = 0, flashes = 0;
  for (const SculpturePart& part : made.parts) {
    if (part.kind != SculpturePartKind::light) continue;
    Vec3 low(0.0), high(0.0);
    for (std::size_t k = 0; k < 8; ++k) {
      low += part.solid.points[k] / 8.0;
      high += part.solid.points[part.solid.points.size() - 1 - k] / 8.0;
    }
    const Vec3 way = high - low;
    if (part.name.find("flash") == std::string::npos) {
      ++strokes;
      EXPECT_GE(way.z, glm::length(Vec2(way)) - 1e-9) << part.name;
      continue;
    }
    ++flashes;
    // The flash is at 0.2 m, the tops at 0.04 m, and the middle of the span is at 2.5 s.
    const double rho_m = glm::length(Vec2(high) - Vec2(0.0, 0.3));
    EXPECT_NEAR(rho_m, 0.3, 1e-3);
    EXPECT_NEAR(high.z, (0.5 - 2.5) * test::kC_m_s + std::hypot(0.16, rho_m), 1e-3) << part.name;
  }
  EXPECT_EQ(strokes, 1);
  EXPECT_EQ(flashes, 8);
}

TEST(GameSculpture, NothingToShowIsSaid) {
  Game game;
  game.setup.pucks[0].soft = game.setup.pucks[1].soft = game.setup.pucks[2].soft = SoftMatter{};
  EXPECT_THROW(sculptureOf(game.source(), {{0.0, 5.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace carom
