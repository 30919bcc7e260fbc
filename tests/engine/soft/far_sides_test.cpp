// When the far side of a soft body hears of a push: a closed form for a flat wall, causality, and that of
// several pushes each is heard.

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "engine/soft/soft_play.h"

namespace carom {
namespace {

constexpr double kBlockHalf = 0.04;

SoftEntry block(double beta, int cells) {
  const double gamma = 1.0 / std::sqrt(1.0 - beta * beta);
  return {"block",     std::make_shared<SoftMesh>(softRectangle({kBlockHalf, 0.5 * kBlockHalf}, cells)),
          {0.5, 0.15}, 0.2,
          {0.0, 0.0},  {gamma, gamma * beta, 0.0},
          0.0,         {}};
}

// The time until the far side of a block that comes to a wall with the speed V turns: the shock's, in lengths
// at rest over c, with energy and momentum kept across it.
TEST(FarSides, HearWhenTheShockArrives) {
  struct Case {
    double speed, needs;
  };
  for (const Case& one : {Case{0.3, 1.2562}, Case{0.6, 0.7709}, Case{0.8, 0.4884}}) {
    SCOPED_TRACE(one.speed);
    SoftPlay play({{{1.0, 0.0}, kBlockHalf}});
    play.add(block(one.speed, 24));
    while (play.heard().empty() && play.time() < 0.5) play.playSlice();
    ASSERT_EQ(play.heard().size(), 1u);
    const FarSides::Heard& heard = play.heard()[0];
    EXPECT_EQ(heard.body, 0u);
    EXPECT_NEAR((heard.event.t - play.collisions()[0].contact.t) / (2.0 * kBlockHalf), one.needs, 0.04);
    EXPECT_NEAR(heard.event.y, 0.0, 1e-3 * kBlockHalf) << "the middle of the side";
    EXPECT_LT(heard.event.x, kBlockHalf - 0.3 * kBlockHalf);
  }
}

TEST(FarSides, HearOfAStrokeAndOfWhatHoldsThemLaterThanLight) {
  SoftPlay play({});
  play.add(block(0.0, 10));
  SoftStroke stroke;
  stroke.hand.t = 0.1;
  stroke.momentum = {0.06, 0.0};
  play.addStroke(stroke);
  SoftEntry rod = block(0.0, 10);
  rod.name = "rod", rod.centre = {0.0, 1.0};
  rod.holds = {{false, {{0.1, {0.3, 0.0}}}}};
  play.add(rod);
  while (play.time() < 0.4) play.playSlice();
  ASSERT_EQ(play.heard().size(), 2u);
  EXPECT_NE(play.heard()[0].body, play.heard()[1].body);
  for (const FarSides::Heard& heard : play.heard()) {
    const double needs = heard.event.t - 0.1;
    EXPECT_NEAR(heard.event.x, kBlockHalf, 0.02 * kBlockHalf) << "the far side, hardly moved";
    // A stroke pushes the whole near half, so it is the half's width that news has to cross.
    EXPECT_GT(needs, heard.body == 1 ? 2.0 * kBlockHalf : 0.5 * kBlockHalf);
    EXPECT_LT(needs, heard.body == 1 ? 3.2 * kBlockHalf : 4.0 * kBlockHalf);
  }
}

TEST(FarSides, AreHeardAgainAfterAReturn) {
  SoftPlay play({{{1.0, 0.0}, kBlockHalf}});
  play.add(block(0.6, 6));
  while (play.collisions().empty()) play.playSlice();
  const auto snapshot = play.snapshot();
  const auto hears = [&] {
    while (play.heard().empty()) play.playSlice();
    return play.heard()[0].event.t;
  };
  const double first = hears();
  play.restore(*snapshot);
  EXPECT_TRUE(play.heard().empty());
  EXPECT_EQ(hears(), first);
}

}  // namespace
}  // namespace carom
