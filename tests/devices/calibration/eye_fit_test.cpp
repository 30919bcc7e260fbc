// Eyes behind lines of sight: simulated ones, found again.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "devices/calibration/eye_fit.h"
#include "devices/normal_vector.h"

namespace carom {
namespace {

using test::normal3;
using test::Random;
using test::turned;

/// A head at any place whose eye is on the line of two marks, behind the near one.
Sighting sighting(Random& random, const glm::dvec3& eyeInSensor_m, double sigma_m) {
  const glm::dvec3 near_m(0.0, 1.5, 0.0);
  const glm::dvec3 far_m = glm::dvec3(0.0, 1.5, -2.0) + normal3(random, 1.0);
  const double behind_m = std::uniform_real_distribution<double>(0.2, 0.6)(random);
  const glm::dvec3 eye_m = near_m + behind_m * glm::normalize(near_m - far_m) + normal3(random, sigma_m);
  const glm::dquat turn = turned(normal3(random, 0.3));
  return {{eye_m - turn * eyeInSensor_m, turn}, near_m, far_m};
}

TEST(EyeFit, FindsTheEyeExactly) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 eye_m = normal3(random, 0.1);
    std::vector<Sighting> sightings;
    for (int k = 0; k < 4; ++k) sightings.push_back(sighting(random, eye_m, 0.0));
    const EyeFit fit = fitEye(sightings);
    EXPECT_LT(glm::distance(fit.eye_m, eye_m), 1e-8) << "case " << i;
    EXPECT_LT(fit.rms_m, 1e-9) << "case " << i;
  }
}

TEST(EyeFit, ItsErrorShrinksWithTheSightings) {
  Random random(5);
  const glm::dvec3 eye_m(0.03, -0.08, -0.1);
  double few_m = 0.0, many_m = 0.0, off_m2 = 0.0, stated_m2 = 0.0;
  for (int i = 0; i < 300; ++i) {
    std::vector<Sighting> sightings;
    for (int k = 0; k < 32; ++k) sightings.push_back(sighting(random, eye_m, 0.002));
    const EyeFit many = fitEye(sightings);
    many_m += many.eyeError_m;
    few_m += fitEye({sightings.data(), 8}).eyeError_m;
    off_m2 += glm::dot(many.eye_m - eye_m, many.eye_m - eye_m);
    stated_m2 += 3.0 * many.eyeError_m * many.eyeError_m;
  }
  EXPECT_NEAR(few_m / many_m, 2.0, 0.4);  // √(32/8)
  EXPECT_LT(off_m2, 1.2 * stated_m2);     // stated along the worst direction, for all three
  EXPECT_GT(off_m2, 0.2 * stated_m2);
}

TEST(EyeFit, ParallelLinesLeaveTheEyeOpen) {
  std::vector<Sighting> sightings;
  for (int k = 0; k < 5; ++k) {
    sightings.push_back(
        {{glm::dvec3(0.1 * k, 1.5, 0.5), {1, 0, 0, 0}}, {0.1 * k, 1.5, 0}, {0.1 * k, 1.5, -2}});
  }
  EXPECT_TRUE(std::isinf(fitEye(sightings).eyeError_m));
  EXPECT_TRUE(std::isinf(fitEye({sightings.data(), 1}).eyeError_m));
}

}  // namespace
}  // namespace carom
