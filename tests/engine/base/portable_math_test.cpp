#include "engine/base/portable_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace carom {
namespace {

/// The error in units in the last place of the result.
double ulps(double value, long double exact) {
  const double nearest = std::abs(static_cast<double>(exact));
  return std::abs(static_cast<double>(value - exact)) / (std::nextafter(nearest, 1e300) - nearest);
}

// Against long double, in units in the last place of the double result.
TEST(PortableMath, isAsGoodAsTheCLibrary) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200000; ++i) {
    const double exponent = -40.0 + 80.0 * static_cast<double>(random() >> 11) * 0x1.0p-53;
    const double x = std::exp2(exponent);
    if (std::abs(x - 1.0) > 1e-3) {
      EXPECT_TRUE(ulps(portableLog(x), std::log(static_cast<long double>(x))) <= 2.0) << x;
    }
    EXPECT_TRUE(ulps(portableAsinh(x), std::asinh(static_cast<long double>(x))) <= 4.0) << x;
    EXPECT_EQ(portableAsinh(-x), -portableAsinh(x));
  }
  EXPECT_EQ(portableAsinh(0.0), 0.0);
  EXPECT_EQ(portableLog(1.0), 0.0);
}

// Angles near 0, within a turn and far away, those next to multiples of π/2 among them.
TEST(PortableMath, sineAndCosineAreAsGoodAsTheCLibrarys) {
  std::mt19937_64 random(2);
  const auto uniform = [&] { return 2.0 * static_cast<double>(random() >> 11) * 0x1.0p-53 - 1.0; };
  for (int i = 0; i < 400000; ++i) {
    double x = uniform();
    if (i % 4 == 1) x *= std::exp2(-30.0 * std::abs(uniform()));
    if (i % 4 == 2) x *= 1e6;
    if (i % 4 == 3) x = std::round(6e5 * uniform()) * 1.5707963267948966 + (i % 8 == 3 ? 0.0 : 1e-9 * x);
    const auto [sine, cosine] = portableSinCos(x);
    // Half a unit is the rounding of the result. With a term less, or without the tail of the reduced angle,
    // it is more.
    EXPECT_TRUE(ulps(sine, std::sin(static_cast<long double>(x))) <= 0.8) << x;
    EXPECT_TRUE(ulps(cosine, std::cos(static_cast<long double>(x))) <= 0.8) << x;
    EXPECT_EQ(portableSinCos(-x).sin, -sine);
    EXPECT_EQ(portableSinCos(-x).cos, cosine);
  }
  for (int i = 0; i < 1000; ++i) {
    const double x = 1e12 * uniform(), ulp_rad = std::nextafter(std::abs(x), 1e300) - std::abs(x);
    EXPECT_NEAR(portableSinCos(x).sin, std::sin(x), 0.4 * ulp_rad) << x;
    EXPECT_NEAR(portableSinCos(x).cos, std::cos(x), 0.4 * ulp_rad) << x;
  }
  EXPECT_EQ(portableSinCos(0.0).sin, 0.0);
  EXPECT_EQ(portableSinCos(0.0).cos, 1.0);
  EXPECT_TRUE(std::isnan(portableSinCos(INFINITY).sin));
  EXPECT_TRUE(std::isnan(portableSinCos(NAN).cos));
}

TEST(PortableMath, arcSineIsAsGoodAsTheCLibrarys) {
  constexpr int kCases = 400000;
  std::mt19937_64 random(3);
  double sum = 0.0;
  for (int i = 0; i < kCases; ++i) {
    double x = 2.0 * static_cast<double>(random() >> 11) * 0x1.0p-53 - 1.0;
    if (i % 3 == 1) x *= std::exp2(-static_cast<double>(i % 40));
    if (i % 3 == 2) x = 1.0 - std::abs(x) * std::exp2(-static_cast<double>(i % 50));
    const double error = ulps(portableAsin(x), std::asin(static_cast<long double>(x)));
    EXPECT_TRUE(error <= 2.0) << x;
    sum += error;
    EXPECT_EQ(portableAsin(-x), -portableAsin(x));
  }
  EXPECT_LT(sum / kCases, 0.27) << "a quarter of a unit is the rounding of the results";
  EXPECT_EQ(portableAsin(1.0), 1.5707963267948966);
  EXPECT_TRUE(std::isnan(portableAsin(1.0000001)));
  EXPECT_TRUE(std::isnan(portableAsin(NAN)));
}

// Known bits: the same on every machine, or cluster nodes would drift apart.
TEST(PortableMath, hasTheseBits) {
  EXPECT_EQ(portableAsinh(1.0), 0x1.c34366179d426p-1);
  EXPECT_EQ(portableLog(10.0), 0x1.26bb1bbb55516p+1);
  EXPECT_EQ(portableSinCos(1000.5).sin, 0x1.fd948c50a7a0dp-1);
  EXPECT_EQ(portableSinCos(1000.5).cos, 0x1.8dbff75eb664fp-4);
  EXPECT_EQ(portableAsin(0.3), 0x1.380159e14f6ffp-2);
}

}  // namespace
}  // namespace carom
