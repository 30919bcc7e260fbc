#pragma once
// Colour by the book, for comparison: the integrals in steps of a nanometre, and the screen's curve.

#include <algorithm>
#include <cmath>
#include <functional>

#include <glm/mat3x3.hpp>

#include "engine/colour/spectrum.h"

namespace carom::test {

// The half-width Gaussians are that far from the tabulated observer (a just noticeable step is about 0.003).
inline constexpr double kObserverTolerance = 0.005;  // in x, y
inline constexpr double kOneScreenStep = 1.0;

/// ∫ s(λ) L(λ) dλ in linear sRGB, of radiance L.
inline Vec3 seenOf(const std::function<double(double)>& radiance) {
  Vec3 sum(0.0);
  for (double wavelength_nm = 360.0; wavelength_nm <= 830.0; wavelength_nm += 1.0) {
    sum += seenPerRadiance(wavelength_nm) * radiance(wavelength_nm);
  }
  return sum;
}

/// Chromaticity (x, y) of a spectrum for the observer as it is, without adaptation.
inline glm::dvec2 chromaticityOf(const std::function<double(double)>& radiance) {
  Vec3 sum(0.0);
  for (double wavelength_nm = 360.0; wavelength_nm <= 830.0; wavelength_nm += 1.0) {
    sum += matchingFunctions(wavelength_nm) * radiance(wavelength_nm);
  }
  return glm::dvec2(sum) / (sum.x + sum.y + sum.z);
}

/// Chromaticity of a black body of 1667 to 25000 K after the tabulated CIE 1931 observer: the cubics of Kim
/// et al., US patent 7024034 (2002), within 0.0005 of it.
inline glm::dvec2 planckianLocus(double temperature_K) {
  const double m = 1000.0 / temperature_K;
  const double x = temperature_K < 4000.0 ? ((-0.2661239 * m - 0.2343589) * m + 0.8776956) * m + 0.179910
                                          : ((-3.0258469 * m + 2.1070379) * m + 0.2226347) * m + 0.240390;
  const double y = temperature_K < 2222.0 ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
                   : temperature_K < 4000.0
                       ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
                       : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
  return {x, y};
}

/// Linear light to what the screen is told, 0 … 1: IEC 61966-2-1.
inline double encoded(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

/// Largest difference of two linear colours on the screen, in its steps of 1/255. NaN stays NaN.
inline double screenSteps(const Vec3& a, const Vec3& b) {
  double largest = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double steps = 255.0 * std::abs(encoded(a[i]) - encoded(b[i]));
    if (!(steps <= largest)) largest = steps;
    if (std::isnan(largest)) break;
  }
  return largest;
}

}  // namespace carom::test
