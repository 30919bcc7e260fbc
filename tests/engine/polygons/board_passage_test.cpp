// Bars that have touched and go past each other on the board: on which side they part.
#include "engine/polygons/board_passage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "engine/polygons/corner_pairs.h"

namespace carom {
namespace {

using test::flight;
using test::rectangle;

constexpr double kBeta = 0.5, kLong = 0.12;

/// Two upright bars that come towards each other along x, with the contact that they have had: its impulse
/// goes from the first to the second, along x.
struct TwoBars {
  Outline outline{rectangle(0.01, kLong)};
  MovingShape first, second;

  TwoBars(double apart, double beside)
      : first(flight({-0.5 * apart, 0.0}, {kBeta, 0.0}, outline)),
        second(flight({0.5 * apart, beside}, {-kBeta, 0.0}, outline)) {}
  bool pass() const {
    const TwoBars then(0.0, 0.0);
    return passEachOther(first, second, {{then.first, then.second}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}});
  }
};

TEST(BoardPassage, BarsPassWhereTheyComeThroughEachOtherAndNotBeside) {
  for (const double beside : {-1.01, -0.99, -0.5, 0.0, 0.5, 0.99, 1.01})
    EXPECT_EQ(TwoBars(0.1, beside * kLong).pass(), std::abs(beside) < 1.0) << beside;
}

TEST(BoardPassage, BarsThatTurnBackInEachOtherDoNotPass) {
  TwoBars bars(0.002, 0.0);
  EXPECT_TRUE(bars.pass()) << "in each other, they come out behind each other";
  std::swap(bars.first.u, bars.second.u);
  EXPECT_FALSE(bars.pass());
}

// Behind each other they have passed, but for an impulse that has turned by more than a quarter with one of
// them since.
TEST(BoardPassage, TheImpulseTurnsWithEitherBody) {
  for (const double degrees : {-100.0, -80.0, 0.0, 80.0, 100.0}) {
    for (const bool ofFirst : {true, false}) {
      TwoBars bars(-0.5, 0.0);
      (ofFirst ? bars.first : bars.second).angle = degrees * M_PI / 180.0;
      EXPECT_EQ(bars.pass(), std::abs(degrees) < 90.0) << degrees << ", " << ofFirst;
    }
  }
}

}  // namespace
}  // namespace carom
