#include "devices/calibration/rigid_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "devices/calibration/symmetric_matrix.h"

namespace carom {
namespace {

PointPair middleOf(std::span<const PointPair> pairs) {
  PointPair middle;
  for (const PointPair& pair : pairs) {
    middle.inA_m += pair.inA_m / static_cast<double>(pairs.size());
    middle.inB_m += pair.inB_m / static_cast<double>(pairs.size());
  }
  return middle;
}

double traceOf(const glm::dmat3& m) { return m[0][0] + m[1][1] + m[2][2]; }

/// Returns the turn q with the greatest Σ a·(q b), which leaves the least Σ |a - q b|².
/// B. K. P. Horn, "Closed-form solution of absolute orientation using unit quaternions" (1987), section 4:
/// with S = Σ b aᵀ, q is the eigenvector to the largest eigenvalue of
///   | trace S             (S - Sᵀ as a vector)ᵀ  |
///   | S - Sᵀ as a vector  S + Sᵀ - trace S · 1   |
glm::dquat turnOf(const glm::dmat3& s) {
  const double trace = traceOf(s);
  // s(row, column) is s[column][row].
  const glm::dvec3 odd(s[2][1] - s[1][2], s[0][2] - s[2][0], s[1][0] - s[0][1]);
  const glm::dmat3 even = s + glm::transpose(s) - trace * glm::dmat3(1.0);
  const glm::dmat4 n(glm::dvec4(trace, odd), glm::dvec4(odd.x, even[0]), glm::dvec4(odd.y, even[1]),
                     glm::dvec4(odd.z, even[2]));
  const glm::dvec4 q = largestEigenvectorOf(n);
  return glm::normalize(glm::dquat(q[0], q[1], q[2], q[3]));
}

/// `side` is 1, or -1 for B mirrored through its origin.
RigidFit fit(std::span<const PointPair> pairs, double side) {
  const PointPair middle = middleOf(pairs);
  glm::dmat3 s(0.0);
  for (const PointPair& pair : pairs)
    s += glm::outerProduct(side * (pair.inB_m - middle.inB_m), pair.inA_m - middle.inA_m);
  RigidFit found;
  found.aFromB.orientation = turnOf(s);
  found.aFromB.position_m = middle.inA_m - found.aFromB.orientation * (side * middle.inB_m);
  double sum_m2 = 0.0;
  for (const PointPair& pair : pairs) {
    found.misses_m.push_back(found.aFromB * (side * pair.inB_m) - pair.inA_m);
    sum_m2 += glm::dot(found.misses_m.back(), found.misses_m.back());
  }
  found.rms_m = std::sqrt(sum_m2 / static_cast<double>(pairs.size()));
  return found;
}

/// Returns Σ (p - middle)(p - middle)ᵀ.
glm::dmat3 scatterOf(std::span<const glm::dvec3> points_m) {
  glm::dvec3 middle_m(0.0);
  for (const glm::dvec3& p : points_m) middle_m += p / static_cast<double>(points_m.size());
  glm::dmat3 scatter(0.0);
  for (const glm::dvec3& p : points_m) scatter += glm::outerProduct(p - middle_m, p - middle_m);
  return scatter;
}

std::vector<glm::dvec3> pointsInA(std::span<const PointPair> pairs) {
  std::vector<glm::dvec3> points_m;
  for (const PointPair& pair : pairs) points_m.push_back(pair.inA_m);
  return points_m;
}

}  // namespace

RigidFit fitRigid(std::span<const PointPair> pairs) { return fit(pairs, 1.0); }

RigidFit fitMirrored(std::span<const PointPair> pairs) { return fit(pairs, -1.0); }

double scaleBetween(std::span<const PointPair> pairs) {
  const PointPair middle = middleOf(pairs);
  double inA = 0.0, inB = 0.0;
  for (const PointPair& pair : pairs) {
    inA += glm::dot(pair.inA_m - middle.inA_m, pair.inA_m - middle.inA_m);
    inB += glm::dot(pair.inB_m - middle.inB_m, pair.inB_m - middle.inB_m);
  }
  return inB > 0.0 ? std::sqrt(inA / inB) : std::numeric_limits<double>::quiet_NaN();
}

glm::dvec3 extentOf(std::span<const glm::dvec3> points_m) {
  const glm::dvec3 values = eigenvaluesOf(scatterOf(points_m));
  const auto deviation = [&](int i) {
    return std::sqrt(std::max(0.0, values[i]) / static_cast<double>(points_m.size()));
  };
  return {deviation(2), deviation(1), deviation(0)};
}

/// With n points and independent errors of size σ a coordinate, the misses have 3n - 6 degrees of freedom,
/// the middle has the variance σ²/n, and a small turn θ moves point r by θ × r: its covariance is
/// σ² (Σ |r|² 1 - r rᵀ)⁻¹.
FitError errorOf(const RigidFit& fit, std::span<const PointPair> pairs) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (pairs.size() < 4) return {kInfinite, kInfinite};
  const auto count = static_cast<double>(pairs.size());
  const double sigma_m = fit.rms_m * std::sqrt(count / (3.0 * count - 6.0));
  const glm::dmat3 scatter = scatterOf(pointsInA(pairs));
  const double trace = traceOf(scatter);
  const double least = eigenvaluesOf(trace * glm::dmat3(1.0) - scatter)[0];
  const bool onALine = !(least > 1e-9 * trace);
  return {sigma_m / std::sqrt(count), onALine ? kInfinite : sigma_m / std::sqrt(least)};
}

}  // namespace carom
