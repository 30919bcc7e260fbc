#include "engine/colour/exposure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/colour/doppler_colour.h"

namespace carom {
namespace {

double onScreen(const Exposure& exposure, double light) {
  const double x = light * exposure.gain;
  return x * (1.0 + exposure.rise * x) / (1.0 + exposure.fall * x);
}

/// Brightness of white that rests on the board, after the laws.
double brightness(double doppler, bool colour, bool searchlight) {
  const double power = searchlight ? 1.0 : std::pow(doppler, -4);
  if (!colour) return searchlight ? std::pow(doppler, 4) : 1.0;
  return power * luminanceOf(colourResponse(doppler, 1.0) * Vec3(1.0));
}

TEST(Exposure, OfAHeadAtRestIsOne) {
  for (const bool colour : {false, true}) {
    for (const bool searchlight : {false, true}) {
      const Exposure exposure = exposureFor(0.0, colour, searchlight);
      EXPECT_NEAR(exposure.gain, 1.0, 1e-4);
      EXPECT_NEAR(onScreen(exposure, 1.57), 1.0, 1e-4);
    }
  }
}

TEST(Exposure, WithoutTheSwitchesIsTheSameAtEverySpeed) {
  const Exposure rest = exposureFor(0.0, false, false);
  const Exposure fast = exposureFor(0.95, false, false);
  EXPECT_EQ(fast.gain, rest.gain);
  EXPECT_EQ(fast.rise, rest.rise);
  EXPECT_EQ(fast.fall, rest.fall);
}

TEST(Exposure, OfSearchlightIsTheEnergyDensityOfTheSky) {
  for (const double beta : {0.1, 0.5, 0.8, 0.95}) {
    const double density = (1.0 + beta * beta / 3.0) / (1.0 - beta * beta);
    EXPECT_NEAR(exposureFor(beta, false, true).gain * density, 1.0, 0.01) << beta;
  }
}

TEST(Exposure, MakesTheSkyOneOnAverage) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> inStep(0.0, 2.0);
  for (const double beta : {0.3, 0.7, 0.95}) {
    for (const bool searchlight : {false, true}) {
      double sum = 0.0;
      const int count = 4000;
      for (int i = 0; i < count; ++i) {
        const double cosine = (2.0 * i + inStep(random)) / count - 1.0;
        const double doppler = std::sqrt(1.0 - beta * beta) / (1.0 - beta * cosine);
        sum += brightness(doppler, true, searchlight);
      }
      EXPECT_NEAR(exposureFor(beta, true, searchlight).gain * sum / count, 1.0, 0.01)
          << beta << ' ' << searchlight;
    }
  }
}

TEST(Exposure, CurveRisesToTheBrightestAndNoFurther) {
  for (const double beta : {0.0, 0.2, 0.7, 0.95, 0.999}) {
    for (const bool colour : {false, true}) {
      for (const bool searchlight : {false, true}) {
        const Exposure exposure = exposureFor(beta, colour, searchlight);
        const double ahead = std::sqrt((1.0 + beta) / (1.0 - beta));
        double before = 0.0;
        for (double doppler = 1.0 / ahead; doppler <= ahead; doppler *= 1.02) {
          const double light = brightness(doppler, colour, searchlight);
          const double shown = onScreen(exposure, light);
          EXPECT_TRUE(shown >= 0.0 && shown <= 1.0) << beta << ' ' << colour << searchlight << ' ' << doppler;
          if (searchlight) {
            EXPECT_GE(shown, before) << beta << ' ' << doppler;
          }
          before = shown;
        }
      }
    }
  }
}

TEST(Exposure, KeepsTheBoardInSightAtHighSpeed) {
  const Exposure exposure = exposureFor(0.95, true, true);
  EXPECT_GT(onScreen(exposure, 0.5), 0.005);  // grey at D = 1 is no black
  EXPECT_GT(onScreen(exposure, 0.5 * brightness(6.2, true, true)) -
                onScreen(exposure, 0.5 * brightness(3.0, true, true)),
            0.02);  // and what lies ahead is no single white
}

}  // namespace
}  // namespace carom
