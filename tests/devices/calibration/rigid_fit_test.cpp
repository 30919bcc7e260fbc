// The rigid motion between points, against another method (singular values), and its errors against chance.

#include "devices/calibration/rigid_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "devices/normal_vector.h"

namespace carom {
namespace {

using test::normal3;
using test::Random;

Pose anyPose(Random& random) {
  const glm::dvec3 v = normal3(random, 1.0);
  const double w = std::normal_distribution<double>()(random);
  return {normal3(random, 3.0), glm::normalize(glm::dquat(w, v.x, v.y, v.z))};
}

double turnBetween_rad(const glm::dquat& a, const glm::dquat& b) {
  const glm::dquat d = a * glm::conjugate(b);
  return 2.0 * std::atan2(glm::length(glm::dvec3(d.x, d.y, d.z)), std::abs(d.w));
}

/// The corners of a room of 3 × 2.5 × 2.8 m.
std::vector<glm::dvec3> roomCorners() {
  std::vector<glm::dvec3> corners_m;
  for (const double x : {-1.5, 1.5}) {
    for (const double y : {0.0, 2.5}) {
      for (const double z : {-1.4, 1.4}) corners_m.emplace_back(x, y, z);
    }
  }
  return corners_m;
}

std::vector<PointPair> pairsOf(const Pose& aFromB, const std::vector<glm::dvec3>& inA_m, double sigma_m,
                               Random& random) {
  std::vector<PointPair> pairs;
  for (const glm::dvec3& a_m : inA_m)
    pairs.push_back({a_m, inverse(aFromB) * a_m + normal3(random, sigma_m)});
  return pairs;
}

TEST(RigidFit, RecoversAnyMotionExactly) {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const Pose truth = anyPose(random);
    std::vector<glm::dvec3> points_m;
    for (int k = 0; k < 3 + i % 6; ++k) points_m.push_back(normal3(random, 1.0));
    const auto pairs = pairsOf(truth, points_m, 0.0, random);
    const RigidFit fit = fitRigid(pairs);
    EXPECT_LT(glm::distance(fit.aFromB.position_m, truth.position_m), 1e-9) << "case " << i;
    EXPECT_LT(turnBetween_rad(fit.aFromB.orientation, truth.orientation), 1e-9) << "case " << i;
    EXPECT_LT(fit.rms_m, 1e-12) << "case " << i;
    EXPECT_NEAR(scaleBetween(pairs), 1.0, 1e-12) << "case " << i;
  }
}

/// Kabsch's method: R = V diag(1, 1, det) Uᵀ from the singular vectors of the correlation.
Eigen::Matrix3d kabsch(const std::vector<PointPair>& pairs) {
  Eigen::Vector3d middleA = Eigen::Vector3d::Zero(), middleB = Eigen::Vector3d::Zero();
  const auto vector = [](const glm::dvec3& v) { return Eigen::Vector3d(v.x, v.y, v.z); };
  for (const PointPair& pair : pairs) {
    middleA += vector(pair.inA_m) / static_cast<double>(pairs.size());
    middleB += vector(pair.inB_m) / static_cast<double>(pairs.size());
  }
  Eigen::Matrix3d correlation = Eigen::Matrix3d::Zero();
  for (const PointPair& pair : pairs) {
    correlation += (vector(pair.inB_m) - middleB) * (vector(pair.inA_m) - middleA).transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(correlation, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d sign = Eigen::Matrix3d::Identity();
  sign(2, 2) = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return svd.matrixV() * sign * svd.matrixU().transpose();
}

TEST(RigidFit, AgreesWithSingularValuesOnNoisyPoints) {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const Pose truth = anyPose(random);
    const auto pairs = pairsOf(truth, roomCorners(), 0.05, random);
    const glm::dmat3 fitted = glm::mat3_cast(fitRigid(pairs).aFromB.orientation);
    const Eigen::Matrix3d expected = kabsch(pairs);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        EXPECT_NEAR(fitted[column][row], expected(row, column), 1e-9) << "case " << i;
      }
    }
  }
}

// Of noisy points no other motion leaves less: any small change of the fit makes it worse.
TEST(RigidFit, IsTheLeastOfSquares) {
  Random random(3);
  const auto pairs = pairsOf(anyPose(random), roomCorners(), 0.02, random);
  const RigidFit fit = fitRigid(pairs);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 turn = normal3(random, 1e-3);
    const Pose changed{fit.aFromB.position_m + normal3(random, 1e-3),
                       glm::normalize(glm::dquat(1.0, turn.x, turn.y, turn.z) * fit.aFromB.orientation)};
    double sum_m2 = 0.0;
    for (const PointPair& pair : pairs) {
      const glm::dvec3 miss_m = changed * pair.inB_m - pair.inA_m;
      sum_m2 += glm::dot(miss_m, miss_m);
    }
    EXPECT_GT(std::sqrt(sum_m2 / 8.0), fit.rms_m) << "change " << i;
  }
}

TEST(RigidFit, MirroredPointsFitOnlyMirrored) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    auto pairs = pairsOf(anyPose(random), roomCorners(), 0.0, random);
    for (PointPair& pair : pairs) pair.inB_m.x = -pair.inB_m.x;
    EXPECT_GT(fitRigid(pairs).rms_m, 0.5) << "case " << i;
    EXPECT_LT(fitMirrored(pairs).rms_m, 1e-9) << "case " << i;
  }
}

TEST(RigidFit, TellsTheScaleWhateverTheTurn) {
  Random random(5);
  for (const double scale : {1e-3, 0.0254, 0.98, 1.0, 1e3}) {
    auto pairs = pairsOf(anyPose(random), roomCorners(), 0.0, random);
    for (PointPair& pair : pairs) pair.inB_m /= scale;
    EXPECT_NEAR(scaleBetween(pairs) / scale, 1.0, 1e-9);
  }
}

TEST(RigidFit, TheExtentTellsPlanesAndLines) {
  const std::vector<glm::dvec3> line{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}};
  EXPECT_LT(extentOf(line).y, 1e-7);
  const std::vector<glm::dvec3> plane{{0, 0, 1}, {3, 0, 1}, {0, 2, 1}, {3, 2, 1}};
  EXPECT_NEAR(extentOf(plane).x, 1.5, 1e-9);
  EXPECT_NEAR(extentOf(plane).y, 1.0, 1e-9);
  EXPECT_LT(extentOf(plane).z, 1e-7);
}

// The errors that the fit states are those that it makes, over many calibrations with errors of 1 mm.
TEST(RigidFit, KnowsItsOwnErrors) {
  Random random(6);
  const std::vector<glm::dvec3> corners_m = roomCorners();
  const glm::dvec3 middle_m(0.0, 1.25, 0.0);
  constexpr int kRuns = 4000;
  double place_m2 = 0.0, statedPlace_m2 = 0.0, turn_rad2 = 0.0, statedTurn_rad2 = 0.0;
  for (int i = 0; i < kRuns; ++i) {
    const Pose truth = anyPose(random);
    const auto pairs = pairsOf(truth, corners_m, 0.001, random);
    const RigidFit fit = fitRigid(pairs);
    const FitError stated = errorOf(fit, pairs);
    const glm::dvec3 off_m = fit.aFromB * (inverse(truth) * middle_m) - middle_m;
    place_m2 += glm::dot(off_m, off_m) / 3.0;
    statedPlace_m2 += stated.place_m * stated.place_m;
    // About the worst axis of this room, which is the one with the least lever: y² + z² for x.
    const glm::dquat turn = fit.aFromB.orientation * glm::conjugate(truth.orientation);
    turn_rad2 += 4.0 * turn.x * turn.x;
    statedTurn_rad2 += stated.turn_rad * stated.turn_rad;
  }
  EXPECT_NEAR(std::sqrt(place_m2 / statedPlace_m2), 1.0, 0.05);
  EXPECT_NEAR(std::sqrt(turn_rad2 / statedTurn_rad2), 1.0, 0.05);
}

TEST(RigidFit, FewOrStraightPointsHaveNoBoundOfError) {
  Random random(7);
  const auto three = pairsOf(anyPose(random), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 0.001, random);
  EXPECT_TRUE(std::isinf(errorOf(fitRigid(three), three).turn_rad));
  const auto line = pairsOf(anyPose(random), {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, 0.0, random);
  EXPECT_TRUE(std::isinf(errorOf(fitRigid(line), line).turn_rad));
}

}  // namespace
}  // namespace carom
