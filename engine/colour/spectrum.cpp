#include "engine/colour/spectrum.h"

#include <cmath>

namespace carom {
namespace {

constexpr double kPlanckFirst = 1.191042972e20;  // 2hc², W m⁻² sr⁻¹ nm⁻¹ nm⁵

/// A Gaussian whose width is `below` on the side of short wavelengths and `above` on the other.
double lobe(double wavelength_nm, double peak_nm, double below_nm, double above_nm) {
  const double s = (wavelength_nm - peak_nm) / (wavelength_nm < peak_nm ? below_nm : above_nm);
  return std::exp(-0.5 * s * s);
}

/// Rows as one reads them (GLM's constructor takes columns).
glm::dmat3 rows(const Vec3& a, const Vec3& b, const Vec3& c) { return glm::transpose(glm::dmat3(a, b, c)); }

/// Linear sRGB of CIE XYZ, from XYZ under the reference light: sRGB × Bradford.
glm::dmat3 srgbFromSeen() {
  const glm::dmat3 srgbFromXyz = rows({3.2404542, -1.5371385, -0.4985314}, {-0.9692660, 1.8760108, 0.0415560},
                                      {0.0556434, -0.2040259, 1.0572252});
  const glm::dmat3 bradford =
      rows({0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296});
  Vec3 white(0.0);
  for (int i = 0; i < kVisibleCount; ++i) {
    const double wavelength_nm = visibleWavelength_nm(i);
    white += matchingFunctions(wavelength_nm) * blackBodyRadiance(wavelength_nm, kReferenceTemperature_K) *
             kVisibleStep_nm;
  }
  const Vec3 screenWhite = glm::inverse(srgbFromXyz) * Vec3(1.0);
  const Vec3 gain = (bradford * screenWhite) / (bradford * white);
  const glm::dmat3 adapted = rows({gain.x, 0.0, 0.0}, {0.0, gain.y, 0.0}, {0.0, 0.0, gain.z});
  return srgbFromXyz * glm::inverse(bradford) * adapted * bradford;
}

}  // namespace

double blackBodyRadiance(double wavelength_nm, double temperature_K) {
  return kPlanckFirst / std::pow(wavelength_nm, 5) /
         std::expm1(kPlanckSecond_nm_K / (wavelength_nm * temperature_K));
}

Vec3 matchingFunctions(double wavelength_nm) {
  const double l = wavelength_nm;
  return {1.056 * lobe(l, 599.8, 37.9, 31.0) + 0.362 * lobe(l, 442.0, 16.0, 26.7) -
              0.065 * lobe(l, 501.1, 20.4, 26.2),
          0.821 * lobe(l, 568.8, 46.9, 40.5) + 0.286 * lobe(l, 530.9, 16.3, 31.1),
          1.217 * lobe(l, 437.0, 11.8, 36.0) + 0.681 * lobe(l, 459.0, 26.0, 13.8)};
}

Vec3 seenPerRadiance(double wavelength_nm) {
  static const glm::dmat3 kSrgbFromSeen = srgbFromSeen();
  return kSrgbFromSeen * matchingFunctions(wavelength_nm);
}

Vec3 reflectanceBasis(double wavelength_nm) {
  const double s10 = std::pow(wavelength_nm / 560.0, 10);
  const double x = 1.0 - 2.0 / (s10 + 1.0);
  // The solution of the six equations (by Gauss and Newton, from random starts).
  const double p = -4.724232047413923 + x * (11.629371382388397 + x * 22.19947085954563);
  const double q = -4.312240734009465 + x * (1.0791067480518148 + x * 14.521186136422541);
  const Vec3 share(std::exp(p), 1.0, std::exp(q));
  return share / (share.x + share.y + share.z);
}

}  // namespace carom
