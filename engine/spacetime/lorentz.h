#pragma once
// Lorentz transforms between inertial frames.
//
// Velocities are carried as u = γβ (celerity over c): unlike β it has no upper limit, keeps its
// precision as β → 1, and u, γ = sqrt(1+u²) are together the four-velocity (γ, u).

#include <cmath>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include "engine/spacetime/event.h"

namespace carom {

/// γ = sqrt(1 + u²) = cosh η, of u = γβ = sinh η.
inline double gammaFromU(const Vec3& u) { return std::sqrt(1.0 + glm::dot(u, u)); }
/// β = u/γ.
Vec3 betaFromU(const Vec3& u);
/// u = β/sqrt(1 − β²); needs |β| < 1.
Vec3 uFromBeta(const Vec3& beta);

/// A proper, orthochronous Lorentz transform `aFromB` of displacements: rotations and boosts, composed.
/// Chains read by matching neighbours: aFromC = aFromB * bFromC.
class Lorentz {
 public:
  explicit Lorentz(double c_m_s) : c_m_s_(c_m_s), matrix_(1.0) {}
  /// The transform that has this matrix, such as one read from a file; whether it is a Lorentz transform is
  /// not checked.
  Lorentz(double c_m_s, const glm::dmat4& matrix) : c_m_s_(c_m_s), matrix_(matrix) {}

  /// aFromB without rotation, where B moves through A with u = γβ.
  static Lorentz boost(const Vec3& u, double c_m_s);
  /// aFromB where B has been accelerated from rest in A without turning: rapidity = proper acceleration ×
  /// proper time / c, u = sinh(rapidity) along it.
  static Lorentz fromRapidity(const Vec3& rapidity, double c_m_s);
  /// aFromB for frames at rest to each other, B's axes turned into A's by `aFromB`.
  static Lorentz rotation(const glm::dquat& aFromB, double c_m_s);

  Displacement operator*(const Displacement& inB) const;
  Lorentz operator*(const Lorentz& bFromC) const;
  /// bFromA = g aFromBᵀ g, with g the metric: exact, no elimination.
  Lorentz inverse() const;

  /// u = γβ of B's origin in A.
  Vec3 u() const;
  /// Returns the same transform with rounding removed: boost(u) after the rotation nearest to the rest.
  Lorentz orthonormalised() const;

  double lightSpeed_m_s() const { return c_m_s_; }
  /// Acts on columns (c t, x, y, z), in metres.
  const glm::dmat4& matrix() const { return matrix_; }

 private:
  double c_m_s_;
  glm::dmat4 matrix_;
};

}  // namespace carom
