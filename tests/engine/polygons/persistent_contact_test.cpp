// Two bars that have touched, followed on the flights that they are told: on which side they come out of each
// other.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/polygons/corner_contact.h"
#include "engine/sampled_body.h"

namespace carom {
namespace {

using test::fourVelocityOf;
using Vec2 = glm::dvec2;

/// Two upright bars that meet face to face at x = 0 at board time 0, the second one beside the first by some
/// way.
struct TouchedBars {
  static constexpr double kThick = 0.01, kLong = 0.12, kBeta = 0.5;
  Outline outline{std::vector<Vec2>{{-0.5 * kThick, -0.5 * kLong},
                                    {0.5 * kThick, -0.5 * kLong},
                                    {0.5 * kThick, 0.5 * kLong},
                                    {-0.5 * kThick, 0.5 * kLong}}};
  double half = 0.5 * kThick * std::sqrt(1.0 - kBeta * kBeta);
  MovingShape first = barAt({0.0, -half, 0.0}, kBeta), second;
  PersistentContact touched;

  explicit TouchedBars(double beside) {
    second = barAt({0.0, half, beside}, -kBeta);
    touched = {{first, second}, {0.0, 0.0, 0.5 * beside}, {0.0, 1.0, 0.0}};
  }
  MovingShape barAt(const Vec21& start, double beta, double turning = 0.0) const {
    return {start, fourVelocityOf(Vec2{beta, 0.0}), outline.radius(), &outline, 0.0, turning};
  }
  /// Both turn at board time `t`, to ∓beta.
  bool partElsewhereIfTurned(double t, double beta, double turning = 0.0) const {
    const MovingShape one = barAt({t, -half + kBeta * t, 0.0}, -beta, turning);
    const MovingShape other = barAt({t, half - kBeta * t, second.start.y}, beta, turning);
    return partElsewhere({std::vector{first, one}, std::vector{second, other}}, touched);
  }
};

TEST(PersistentContact, BarsThatNeverTurnPass) {
  for (const double beside : {0.0, 0.1, -0.05}) {
    const TouchedBars bars(beside);
    EXPECT_TRUE(partElsewhere({std::vector{bars.first}, std::vector{bars.second}}, bars.touched)) << beside;
  }
}

TEST(PersistentContact, BarsThatAreTurnedBackPartWhereTheyTouched) {
  for (const double beside : {0.0, 0.1}) {
    const TouchedBars bars(beside);
    // In each other, and when they are through: 2 half/kBeta of light until then.
    for (const double t : {0.5 * bars.half, bars.half / bars.kBeta, 8.0 * bars.half})
      EXPECT_FALSE(bars.partElsewhereIfTurned(t, 0.3)) << beside << ", " << t;
  }
}

TEST(PersistentContact, BarsThatAreSlowedBehindEachOtherPartThere) {
  const TouchedBars bars(0.1);
  EXPECT_TRUE(bars.partElsewhereIfTurned(8.0 * bars.half, -0.3));
}

// They are 15 cm behind each other when they are told, and have turned by a quarter when their centres come
// back: they pass beside each other.
TEST(PersistentContact, BarsThatTurnAwayWhileTheyComeBackDoNotMeetAgain) {
  const TouchedBars bars(0.1);
  const double t = 0.15, back_m = 0.3 / std::sqrt(1.0 - 0.3 * 0.3);
  EXPECT_TRUE(bars.partElsewhereIfTurned(t, 0.3, -0.5 * M_PI / (0.075 / back_m)));
  EXPECT_FALSE(bars.partElsewhereIfTurned(t, 0.3));
}

}  // namespace
}  // namespace carom
