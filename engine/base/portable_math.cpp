#include "engine/base/portable_math.h"

#include <cmath>

namespace carom {

namespace {

// 2 atanh(s) = ln((1+s)/(1−s)) = 2 s (1 + s²/3 + s⁴/5 + …), for |s| < 0.1716: 10 terms reach 1e-17.
double twiceAtanh(double s) {
  const double z = s * s;
  double sum = 0.0;
  for (int odd = 25; odd >= 3; odd -= 2) sum = (sum + 1.0 / odd) * z;
  return 2.0 * s + 2.0 * s * sum;
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

}  // namespace carom
