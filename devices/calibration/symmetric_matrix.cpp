#include "devices/calibration/symmetric_matrix.h"

#include <Eigen/Eigenvalues>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace carom {
namespace {

/// Eigenvalues ascend. One size for all, since each that Eigen is given takes the compiler ten seconds.
using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;

template <typename Matrix>
Solver solverOf(const Matrix& symmetric) {
  return Solver(
      Eigen::Map<const Eigen::MatrixXd>(glm::value_ptr(symmetric), Matrix::length(), Matrix::length()));
}

glm::dvec3 vectorOf(const Solver& solver, int column) {
  const auto& vectors = solver.eigenvectors();
  return {vectors(0, column), vectors(1, column), vectors(2, column)};
}

}  // namespace

glm::dvec3 eigenvaluesOf(const glm::dmat3& symmetric) {
  const auto values = solverOf(symmetric).eigenvalues();
  return {values(0), values(1), values(2)};
}

glm::dvec4 largestEigenvectorOf(const glm::dmat4& symmetric) {
  const Solver solver = solverOf(symmetric);
  const auto& vectors = solver.eigenvectors();
  return {vectors(0, 3), vectors(1, 3), vectors(2, 3), vectors(3, 3)};
}

/// With eigenvectors v and eigenvalues λ of a, x = Σ v (v·right)/λ over all λ that are not 0 but for
/// rounding.
glm::dvec3 leastSolution(const glm::dmat3& a, const glm::dvec3& right) {
  constexpr double kRounding = 1e-14;
  const Solver solver = solverOf(a);
  glm::dvec3 x(0.0);
  for (int i = 0; i < 3; ++i) {
    const double value = solver.eigenvalues()(i);
    if (!(value > kRounding * solver.eigenvalues()(2))) continue;
    const glm::dvec3 v = vectorOf(solver, i);
    x += v * (glm::dot(v, right) / value);
  }
  return x;
}

}  // namespace carom
