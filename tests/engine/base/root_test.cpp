#include "engine/base/root.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A function whose root is known without solving: it compares with it. The answer is that very number.
TEST(Root, IsFoundToTheLastBitFromAnyGuess) {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const double root = random.in(-1.0, 1.0) * std::pow(10.0, random.in(-6.0, 9.0));
    const double guess = root + random.in(-1.0, 1.0) * std::pow(10.0, random.in(-9.0, 9.0));
    const double step = std::pow(10.0, random.in(-6.0, 2.0));
    EXPECT_EQ(rootOfIncreasing([&](double x) { return x > root ? 1.0 : -1.0; }, guess, step), root);
  }
}

// The change of sign lies between the answer and the next number, however the function rounds.
TEST(Root, LiesWhereTheSignChanges) {
  test::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const double b = random.in(-5.0, 5.0), a = random.in(0.0, 3.0);
    const auto f = [&](double x) { return x * x * x + a * x - b; };
    const double root = rootOfIncreasing(f, random.in(-10.0, 10.0));
    EXPECT_LE(f(root), 0.0);
    EXPECT_GT(f(std::nextafter(root, kInfinity)), 0.0);
    // Cardano's formula.
    const double D = std::sqrt(b * b / 4.0 + a * a * a / 27.0);
    EXPECT_NEAR(root, std::cbrt(b / 2.0 + D) + std::cbrt(b / 2.0 - D), 1e-7);
  }
}

TEST(Root, OfAFlatPieceIsItsLateEnd) {
  const auto f = [](double x) { return x < 2.0 ? -1.0 : x <= 3.0 ? 0.0 : 1.0; };
  EXPECT_EQ(rootOfIncreasing(f, 0.0), 3.0);
  EXPECT_EQ(rootOfIncreasing(f, 50.0), 3.0);
}

}  // namespace
}  // namespace carom
