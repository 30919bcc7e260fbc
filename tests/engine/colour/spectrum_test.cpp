#include "engine/colour/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/colour_reference.h"

namespace carom {
namespace {

using test::chromaticityOf, test::kObserverTolerance, test::kOneScreenStep, test::planckianLocus,
    test::screenSteps, test::seenOf;

TEST(BlackBody, RadiatesAsStefanAndBoltzmann) {
  for (const double temperature_K : {300.0, 3200.0, 6500.0, 20000.0}) {
    double sum = 0.0;
    const double step = 0.001;
    for (double logarithm = std::log(10.0); logarithm < std::log(1e8); logarithm += step) {
      const double wavelength_nm = std::exp(logarithm);
      sum += blackBodyRadiance(wavelength_nm, temperature_K) * wavelength_nm * step;
    }
    EXPECT_NEAR(sum / (5.670374419e-8 * std::pow(temperature_K, 4) / 3.14159265358979), 1.0, 1e-6)
        << temperature_K;
  }
}

TEST(BlackBody, PeaksWhereWienSays) {
  const double peak_nm = 2.897771955e6 / 6500.0;
  EXPECT_GT(blackBodyRadiance(peak_nm, 6500.0), blackBodyRadiance(peak_nm * 1.001, 6500.0));
  EXPECT_GT(blackBodyRadiance(peak_nm, 6500.0), blackBodyRadiance(peak_nm / 1.001, 6500.0));
}

TEST(MatchingFunctions, SeeBlackBodiesWhereTheTabulatedObserverDoes) {
  for (const double temperature_K : {1700.0, 2000.0, 2856.0, 4000.0, 5000.0, 6500.0, 10000.0, 25000.0}) {
    const auto light = [&](double wavelength_nm) { return blackBodyRadiance(wavelength_nm, temperature_K); };
    EXPECT_LT(glm::length(chromaticityOf(light) - planckianLocus(temperature_K)), kObserverTolerance)
        << temperature_K;
  }
}

TEST(MatchingFunctions, SeeEqualEnergyAsEqual) {
  const glm::dvec2 seen = chromaticityOf([](double) { return 1.0; });
  EXPECT_LT(glm::length(seen - glm::dvec2(1.0 / 3.0)), kObserverTolerance);
}

TEST(ReflectanceBasis, IsAPartitionOfUnityAtEveryWavelength) {
  for (double wavelength_nm = 1.0; wavelength_nm < 1e9; wavelength_nm *= 1.01) {
    const Vec3 share = reflectanceBasis(wavelength_nm);
    EXPECT_NEAR(share.x + share.y + share.z, 1.0, 1e-14) << wavelength_nm;
    EXPECT_TRUE(share.x >= 0.0 && share.y >= 0.0 && share.z >= 0.0) << wavelength_nm;
  }
}

TEST(ReflectanceBasis, IsSmoothAndAtRestFarFromTheVisible) {
  // Steepest is the edge of red, as steep as its saturation makes it: 10 to 90 % within 20 nm.
  const double step = 1e-3;  // of ln λ
  for (double wavelength_nm = 20.0; wavelength_nm < 1e5; wavelength_nm *= 1.0 + step) {
    const Vec3 change = reflectanceBasis(wavelength_nm * (1.0 + step)) - reflectanceBasis(wavelength_nm);
    const bool far = wavelength_nm < 250.0 || wavelength_nm > 1000.0;
    EXPECT_LT(glm::length(change) / step, far ? 0.01 : 45.0) << wavelength_nm;
  }
}

TEST(ReflectanceBasis, PrimariesAreSeenAsThemselves) {
  glm::dmat3 seen(0.0);
  for (int i = 0; i < kVisibleCount; ++i) {
    const double wavelength_nm = visibleWavelength_nm(i);
    const Vec3 light = seenPerRadiance(wavelength_nm) * kVisibleStep_nm *
                       blackBodyRadiance(wavelength_nm, kReferenceTemperature_K);
    seen += glm::outerProduct(light, reflectanceBasis(wavelength_nm));
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(seen[i][j], i == j ? 1.0 : 0.0, 1e-12) << i << ' ' << j;
  }
}

TEST(ReflectanceBasis, ColoursOfAGridAreSeenAsThemselvesInFineSteps) {
  for (int code = 0; code < 6 * 6 * 6; ++code) {
    const Vec3 colour = Vec3(code % 6, code / 6 % 6, code / 36) / 5.0;
    const Vec3 seen = seenOf([&](double wavelength_nm) {
      return glm::dot(reflectanceBasis(wavelength_nm), colour) *
             blackBodyRadiance(wavelength_nm, kReferenceTemperature_K);
    });
    EXPECT_LT(screenSteps(seen, colour), kOneScreenStep) << colour.x << ' ' << colour.y << ' ' << colour.z;
  }
}

}  // namespace
}  // namespace carom
