#include "engine/colour/doppler_colour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <random>

#include "engine/colour_reference.h"

namespace carom {
namespace {

using colour_kernel::blackBody;
using colour_kernel::seenColour;
using test::kObserverTolerance, test::kOneScreenStep, test::screenSteps, test::seenOf;

constexpr double kSlowest = 0.15;  // Doppler factors of these tests
constexpr double kFastest = 6.5;

/// The light that a body reflects, followed from the lamp to the head as the laws are written.
Vec3 seenByTheBook(const Vec3& colour, double lampTemperature_K, double lampToBody, double bodyToHead) {
  const auto lamp = [&](double wavelength_nm) { return blackBodyRadiance(wavelength_nm, lampTemperature_K); };
  const auto atBody = [&](double wavelength_nm) {
    return std::pow(lampToBody, 5) * lamp(lampToBody * wavelength_nm);
  };
  const auto reflected = [&](double wavelength_nm) {
    return glm::dot(reflectanceBasis(wavelength_nm), colour) * atBody(wavelength_nm);
  };
  return seenOf(
      [&](double wavelength_nm) { return std::pow(bodyToHead, 5) * reflected(bodyToHead * wavelength_nm); });
}

/// The exposure in which white is just white, so that nothing hides in the dark. Light colder than 750 K is
/// black under any exposure that a person can bear beside a lamp.
double exposureOfWhite(double heat) {
  const Vec3 white = colourResponse(std::max(heat, 0.115), 1.0) * Vec3(1.0);
  return 1.0 / std::max({white.x, white.y, white.z});
}

struct Case {
  Vec3 colour;
  double lampTemperature_K;
  double lampToBody;
  double bodyToHead;
  double heat() const { return lampToBody * bodyToHead * lampTemperature_K / kReferenceTemperature_K; }
};

Case randomCase(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::uniform_real_distribution<double> logarithm(std::log(kSlowest), std::log(kFastest));
  const auto factor = [&] { return std::exp(logarithm(random)); };
  Vec3 colour(unit(random), unit(random), unit(random));
  if (unit(random) < 0.3) colour = glm::round(colour);  // the corners are the hardest
  return {colour, unit(random) < 0.5 ? 3200.0 : kReferenceTemperature_K, factor(), factor()};
}

std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << "colour " << c.colour.x << ' ' << c.colour.y << ' ' << c.colour.z << ", lamp "
             << c.lampTemperature_K << " K, D " << c.lampToBody << " then " << c.bodyToHead;
}

TEST(ColourResponse, FollowsTheLightFromLampToHead) {
  std::mt19937_64 random(1905);
  for (int i = 0; i < 300; ++i) {
    const Case c = randomCase(random);
    const Vec3 expected = seenByTheBook(c.colour, c.lampTemperature_K, c.lampToBody, c.bodyToHead);
    const Vec3 seen = colourResponse(c.heat(), c.bodyToHead) * c.colour;
    const double scale = exposureOfWhite(c.heat());
    EXPECT_LT(screenSteps(seen * scale, expected * scale), 0.2) << c;
  }
}

TEST(ColourResponse, OfBodiesAtRestIsTheirColour) {
  const glm::dmat3 response = colourResponse(1.0, 1.0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(response[i][j], i == j ? 1.0 : 0.0, 1e-12);
  }
}

// The key to it all: white lit by a black body of temperature T shows one of temperature D T.
TEST(ColourResponse, WhiteShowsAHotterBlackBody) {
  const glm::dmat3 bradford =
      glm::transpose(glm::dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
  const glm::dmat3 xyzFromSrgb =
      glm::transpose(glm::dmat3(0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505));
  const glm::dvec2 reference = test::planckianLocus(kReferenceTemperature_K);
  const Vec3 lampWhite(reference.x / reference.y, 1.0, (1.0 - reference.x - reference.y) / reference.y);
  for (const double doppler : {0.27, 0.4, 0.7, 1.0, 1.5, 2.5, 3.8}) {
    const Vec3 seen = colourResponse(doppler, 1.3 * doppler) * Vec3(1.0);
    // Back from the screen's white to the lamp's.
    Vec3 cone = bradford * (xyzFromSrgb * seen);
    cone *= (bradford * lampWhite) / (bradford * (xyzFromSrgb * Vec3(1.0)));
    const Vec3 xyz = glm::inverse(bradford) * cone;
    const glm::dvec2 chromaticity = glm::dvec2(xyz) / (xyz.x + xyz.y + xyz.z);
    const glm::dvec2 expected = test::planckianLocus(doppler * kReferenceTemperature_K);
    EXPECT_LT(glm::length(chromaticity - expected), kObserverTolerance)
        << doppler << ": " << chromaticity.x << ' ' << chromaticity.y << ", expected " << expected.x << ' '
        << expected.y;
  }
}

TEST(ColourResponse, ApproachMakesBluerAndRecessionRedder) {
  const Vec3 green(0.0, 1.0, 0.0);
  const Vec3 approaching = colourResponse(1.15, 1.15) * green;
  const Vec3 receding = colourResponse(1.0 / 1.15, 1.0 / 1.15) * green;
  EXPECT_GT(approaching.z, approaching.x);
  EXPECT_GT(receding.x, receding.z);
}

/// ∫ L dλ of a black body over all wavelengths.
double power(double temperature_K) {
  double sum = 0.0;
  const double step = 0.002;
  for (double logarithm = 0.0; logarithm < std::log(1e9); logarithm += step) {
    const double wavelength_nm = std::exp(logarithm);
    sum += blackBodyRadiance(wavelength_nm, temperature_K) * wavelength_nm * step;
  }
  return sum;
}

TEST(ColourSwitches, ScaleThePowerAsSaid) {
  for (const float doppler : {0.2F, 0.6F, 1.0F, 1.7F, 6.0F}) {
    const double rest = power(kReferenceTemperature_K);
    const double shifted = power(kReferenceTemperature_K * static_cast<double>(doppler));
    for (const bool searchlight : {false, true}) {
      const double radiance = searchlight ? std::pow(doppler, 4) : 1.0;
      const double fromLamp = searchlight ? std::pow(doppler, 2) : 1.0;
      const auto factor = [&](float of) { return static_cast<double>(of); };
      EXPECT_NEAR(factor(colour_kernel::radiancePower(doppler, false, searchlight)) / radiance, 1.0, 1e-5);
      EXPECT_NEAR(
          factor(colour_kernel::radiancePower(doppler, true, searchlight)) * shifted / (rest * radiance), 1.0,
          1e-5);
      EXPECT_NEAR(factor(colour_kernel::lampPower(doppler, false, searchlight)) / fromLamp, 1.0, 1e-5);
      EXPECT_NEAR(factor(colour_kernel::lampPower(doppler, true, searchlight)) * shifted / (rest * fromLamp),
                  1.0, 1e-5);
    }
  }
}

/// Luminance of a black body (cd/m²): 683 lm/W ∫ ȳ B dλ.
double candelas(double temperature_K) {
  double sum = 0.0;
  for (double wavelength_nm = 360.0; wavelength_nm <= 830.0; wavelength_nm += 1.0)
    sum += matchingFunctions(wavelength_nm).y * blackBodyRadiance(wavelength_nm, temperature_K);
  return 683.002 * sum;
}

// What hot matter sends, by Planck's law in its own frame and D⁵ L(Dλ) summed over the wavelengths, in the
// unit of white in the hall; and that this is a black body of D times the temperature.
TEST(Glow, IsABlackBodyOfDTimesItsTemperature) {
  const double reference = candelas(kReferenceTemperature_K) / 2000.0;
  int bright = 0;
  for (const double heat : {0.02, 0.1, 0.16, 0.25, 0.5, 1.0, 2.3, 2.375, 9.0}) {
    const double temperature_K = std::min(800.0 + 2400.0 * heat, 6500.0);
    for (const double doppler : {0.3, 0.6, 0.9, 1.0, 1.2, 1.8, 3.0}) {
      if (doppler * temperature_K < 750.0) continue;  // dark
      for (const bool colour : {false, true}) {
        for (const bool searchlight : {false, true}) {
          SCOPED_TRACE(testing::Message() << heat << ", D " << doppler << ", colour " << colour
                                          << ", searchlight " << searchlight);
          const double d = colour ? doppler : 1.0;
          const double power = std::pow(doppler, searchlight ? 4.0 : 0.0) / std::pow(d, 4.0);
          const Vec3 expected = reference * power * seenOf([&](double wavelength_nm) {
                                  return std::pow(d, 5) * blackBodyRadiance(d * wavelength_nm, temperature_K);
                                });
          const Vec3 hotter = reference * power * seenOf([&](double wavelength_nm) {
                                return blackBodyRadiance(wavelength_nm, d * temperature_K);
                              });
          const Vec3 seen(colour_kernel::seenGlow(static_cast<float>(heat), static_cast<float>(doppler),
                                                  colour, searchlight));
          const double scale = 1.0 / std::max({expected.x, expected.y, expected.z});
          EXPECT_LT(screenSteps(seen * scale, expected * scale), kOneScreenStep);
          EXPECT_LT(screenSteps(hotter * scale, expected * scale), 0.01);
          EXPECT_NEAR(luminanceOf(seen) / luminanceOf(expected), 1.0, 0.01);
          bright += luminanceOf(seen) > 1.0;
        }
      }
    }
  }
  EXPECT_GT(bright, 50);
}

TEST(Glow, OnFilmKeepsItsColourAndNeverExceedsTwice) {
  for (const float luminance : {1e-6F, 0.1F, 1.0F, 30.0F, 1e6F}) {
    const glm::vec3 light = luminance * glm::vec3(2.5F, 0.65F, 0.05F);
    const Vec3 seen(colour_kernel::onFilm(light, 0.5F));
    EXPECT_LT(glm::length(glm::cross(glm::normalize(seen), glm::normalize(Vec3(light)))), 1e-6);
    const double y = luminanceOf(Vec3(light));
    EXPECT_NEAR(1.0 / luminanceOf(seen), 1.0 / y + 0.5 / 2.0, 1e-5 * (1.0 / y + 1.0));
  }
}

class TableTest : public ::testing::Test {
 protected:
  static Vec3 seen(double heat, double bodyToHead, const Vec3& colour) {
    return Vec3(seenColour(table(), blackBody(static_cast<float>(heat)), static_cast<float>(bodyToHead)) *
                glm::vec3(colour));
  }
  static const ColourTable& table() {
    static const ColourTable kTable;
    return kTable;
  }
};

TEST_F(TableTest, ColoursOfAGridAtRestAreThemselves) {
  for (int code = 0; code < 6 * 6 * 6; ++code) {
    const Vec3 colour = Vec3(code % 6, code / 6 % 6, code / 36) / 5.0;
    EXPECT_LT(screenSteps(seen(1.0, 1.0, colour), colour), kOneScreenStep)
        << colour.x << ' ' << colour.y << ' ' << colour.z;
  }
}

TEST_F(TableTest, AgreesWithTheSpectrumOnTheScreen) {
  std::mt19937_64 random(2013);
  double worst = 0.0;
  for (int i = 0; i < 5000; ++i) {
    const Case c = randomCase(random);
    const Vec3 expected = seenByTheBook(c.colour, c.lampTemperature_K, c.lampToBody, c.bodyToHead);
    const double scale = exposureOfWhite(c.heat());
    const double steps = screenSteps(seen(c.heat(), c.bodyToHead, c.colour) * scale, expected * scale);
    EXPECT_LT(steps, kOneScreenStep) << c;
    worst = std::max(worst, steps);
  }
  RecordProperty("worst", std::to_string(worst));
}

TEST_F(TableTest, IsFiniteAtAnyFactor) {
  for (const double heat : {0.0, 1e-30, 1e-3, 1e3, 1e6}) {
    for (const double bodyToHead : {1e-6, 1.0, 1e6}) {
      const Vec3 colour = seen(heat, bodyToHead, Vec3(0.2, 0.5, 0.8));
      EXPECT_TRUE(std::isfinite(colour.x) && std::isfinite(colour.y) && std::isfinite(colour.z))
          << heat << ' ' << bodyToHead;
    }
  }
}

TEST_F(TableTest, LampsAddUp) {
  const colour_kernel::Bands warm = blackBody(0.6F);
  const colour_kernel::Bands cold = blackBody(1.7F);
  const glm::mat3 together = seenColour(table(), colour_kernel::added(warm, 0.3F, cold), 0.9F);
  const glm::mat3 apart = seenColour(table(), warm, 0.9F) + 0.3F * seenColour(table(), cold, 0.9F);
  for (int i = 0; i < 3; ++i) EXPECT_LT(glm::length(together[i] - apart[i]), 1e-5F);
}

TEST_F(TableTest, KernelKnowsTheWhiteOfTheBands) {
  const std::array<Vec3, 6> white = whiteOfBands();
  for (int k = 0; k < 6; ++k) {
    colour_kernel::Bands one{glm::vec4(0.0F), glm::vec2(0.0F)};
    (k < 4 ? one.first[k] : one.last[k - 4]) = 1.0F;
    const Vec3 known(colour_kernel::seenWhite(one));
    EXPECT_LT(glm::length(known - white[k]), 1e-6)
        << "band " << k << ": " << white[k].x << ' ' << white[k].y << ' ' << white[k].z;
  }
}

}  // namespace
}  // namespace carom
