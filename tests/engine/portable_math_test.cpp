#include "engine/base/portable_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace carom {
namespace {

// Against long double, in units in the last place of the double result.
TEST(PortableMath, isAsGoodAsTheCLibrary) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200000; ++i) {
    const double exponent = -40.0 + 80.0 * static_cast<double>(random() >> 11) * 0x1.0p-53;
    const double x = std::exp2(exponent);
    const auto ulps = [](double value, long double exact) {
      const double nearest = static_cast<double>(exact);
      return std::abs(static_cast<double>(value - exact)) /
             (std::nextafter(std::abs(nearest), 1e300) - std::abs(nearest));
    };
    if (std::abs(x - 1.0) > 1e-3) {
      EXPECT_TRUE(ulps(portableLog(x), std::log(static_cast<long double>(x))) <= 2.0) << x;
    }
    EXPECT_TRUE(ulps(portableAsinh(x), std::asinh(static_cast<long double>(x))) <= 4.0) << x;
    EXPECT_EQ(portableAsinh(-x), -portableAsinh(x));
  }
  EXPECT_EQ(portableAsinh(0.0), 0.0);
  EXPECT_EQ(portableLog(1.0), 0.0);
}

// Known bits: the same on every machine, or cluster nodes would drift apart.
TEST(PortableMath, hasTheseBits) {
  EXPECT_EQ(portableAsinh(1.0), 0x1.c34366179d426p-1);
  EXPECT_EQ(portableLog(10.0), 0x1.26bb1bbb55516p+1);
}

}  // namespace
}  // namespace carom
