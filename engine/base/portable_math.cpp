#include "engine/base/portable_math.h"

#include <array>
#include <cmath>
#include <numbers>

namespace carom {

namespace {

// 2 atanh(s) = ln((1+s)/(1−s)) = 2 s (1 + s²/3 + s⁴/5 + …), for |s| < 0.1716: 10 terms reach 1e-17.
double twiceAtanh(double s) {
  const double z = s * s;
  double sum = 0.0;
  for (int odd = 25; odd >= 3; odd -= 2) sum = (sum + 1.0 / odd) * z;
  return 2.0 * s + 2.0 * s * sum;
}

// Of an angle r + tail, |r| ≤ π/4, |tail| below a unit in the last place of r: the terms up to r¹⁷ and r¹⁸ of
//   sin r = r − r³/3! + …     cos r = 1 − r²/2! + …
// leave less than 1e-19. The first terms are added last, each with what its own rounding lost.
double sinNearZero(double r, double tail) {
  const double z = r * r;
  double sum = 0.0;
  for (int n = 17; n >= 5; n -= 2) sum = (1.0 - sum) * z * (1.0 / (n * (n - 1)));
  return r + (tail * (1.0 - 0.5 * z) - r * z * (1.0 / 6.0) * (1.0 - sum));
}

double cosNearZero(double r, double tail) {
  const double z = r * r;
  double sum = 0.0;
  for (int n = 18; n >= 4; n -= 2) sum = (1.0 - sum) * z * (1.0 / (n * (n - 1)));
  const double half = 0.5 * z, rough = 1.0 - half;
  return rough + (((1.0 - rough) - half) + (half * sum - r * tail));
}

constexpr int kAsinTerms = 26;

// asin x = x Σ c_k x^2k, c_0 = 1, c_k = c_{k−1} (2k−1)²/(2k (2k+1)); for |x| ≤ 1/2 these terms leave less
// than 1e-18.
constexpr std::array<double, kAsinTerms> asinCoefficients() {
  std::array<double, kAsinTerms> c{1.0};
  double central = 1.0;  // the binomial (2k over k)/4^k
  for (int k = 1; k < kAsinTerms; ++k) {
    central *= (2.0 * k - 1.0) / (2.0 * k);
    c[static_cast<std::size_t>(k)] = central / (2.0 * k + 1.0);
  }
  return c;
}

/// asin x − x of |x| ≤ 1/2.
double asinExcess(double x) {
  static constexpr std::array<double, kAsinTerms> kCoefficients = asinCoefficients();
  const double z = x * x;
  double sum = 0.0;
  for (std::size_t k = kAsinTerms - 1; k > 0; --k) sum = (sum + kCoefficients[k]) * z;
  return x * sum;
}

}  // namespace

double portableLog(double x) {
  constexpr double kLn2High = 6.93147180369123816490e-01;  // ln 2 in two parts (as in fdlibm), so that
  constexpr double kLn2Low = 1.90821492927058770002e-10;   // exponent × high part is exact
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // exact; x = m 2^exponent, 1/2 <= m < 1
  if (m < 0.70710678118654752) {
    m *= 2.0;
    --exponent;
  }
  return exponent * kLn2High + (exponent * kLn2Low + twiceAtanh((m - 1.0) / (m + 1.0)));
}

double portableAsinh(double x) {
  const double a = std::abs(x);
  const double y = a + a * a / (1.0 + std::sqrt(1.0 + a * a));  // asinh a = ln(1 + y)
  const double value = y < 0.4 ? twiceAtanh(y / (2.0 + y)) : portableLog(1.0 + y);
  return std::copysign(value, x);
}

// x = n π/2 + r + tail, |r| ≤ π/4. π/2 is the sum of three parts; n times each of the first two is exact.
SinCos portableSinCos(double x) {
  constexpr double kHigh = 0x1.921fb544p+0;       // 33 bits of π/2
  constexpr double kMiddle = 0x1.0b4611a6p-34;    // the next 33
  constexpr double kLow = 0x1.3198a2e037073p-69;  // the rest
  if (!(std::abs(x) <= 1e6)) x = std::remainder(x, 2.0 * std::numbers::pi);
  const double n = std::floor(x * (2.0 / std::numbers::pi) + 0.5);
  const double high = x - n * kHigh, middle = n * kMiddle;
  const double rough = high - middle;
  const double lost = ((high - rough) - middle) - n * kLow;
  const double r = rough + lost, tail = (rough - r) + lost;
  const double sine = sinNearZero(r, tail), cosine = cosNearZero(r, tail);
  switch (static_cast<int>(n - 4.0 * std::floor(0.25 * n))) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

// Beyond 1/2 through half of the angle that is left: asin x = π/2 − 2 asin sqrt((1 − x)/2).
double portableAsin(double x) {
  constexpr double kHalfPiLow = 6.123233995736766e-17;  // π/2 less the double nearest to it
  const double a = std::abs(x);
  if (a <= 0.5) return x + asinExcess(x);
  const double s = std::sqrt(0.5 * (1.0 - a));
  return std::copysign((std::numbers::pi / 2.0 - 2.0 * s) + (kHalfPiLow - 2.0 * asinExcess(s)), x);
}

}  // namespace carom
