#include "engine/spacetime/lorentz.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

namespace carom {

Vec3 betaFromU(const Vec3& u) { return u / gammaFromU(u); }

Vec3 uFromBeta(const Vec3& beta) { return beta / std::sqrt(1.0 - glm::dot(beta, beta)); }

// Λ⁰₀ = γ, Λ⁰ᵢ = Λⁱ₀ = uᵢ, Λⁱⱼ = δᵢⱼ + uᵢuⱼ/(γ+1)   (Jackson, Classical Electrodynamics, §11.7)
Lorentz Lorentz::boost(const Vec3& u, double c_m_s) {
  const double gamma = gammaFromU(u);
  glm::dmat4 m(1.0);
  m[0][0] = gamma;
  for (int i = 0; i < 3; ++i) {
    m[0][i + 1] = m[i + 1][0] = u[i];
    for (int j = 0; j < 3; ++j) m[j + 1][i + 1] += u[i] * u[j] / (gamma + 1.0);
  }
  return {c_m_s, m};
}

Lorentz Lorentz::fromRapidity(const Vec3& rapidity, double c_m_s) {
  const double size = glm::length(rapidity);
  return boost(size > 0.0 ? rapidity * (std::sinh(size) / size) : Vec3(0.0), c_m_s);
}

Lorentz Lorentz::rotation(const glm::dquat& aFromB, double c_m_s) {
  const glm::dmat3 rotation = glm::mat3_cast(aFromB);
  glm::dmat4 m(1.0);
  for (int col = 0; col < 3; ++col) m[col + 1] = glm::dvec4(0.0, rotation[col]);
  return {c_m_s, m};
}

Displacement Lorentz::operator*(const Displacement& inB) const {
  const glm::dvec4 out = matrix_ * glm::dvec4(c_m_s_ * inB.dt_s, inB.dr_m);
  return {out.x / c_m_s_, {out.y, out.z, out.w}};
}

Lorentz Lorentz::operator*(const Lorentz& bFromC) const { return {c_m_s_, matrix_ * bFromC.matrix_}; }

Lorentz Lorentz::inverse() const {
  glm::dmat4 m = glm::transpose(matrix_);
  for (int i = 1; i < 4; ++i) {
    m[0][i] = -m[0][i];
    m[i][0] = -m[i][0];
  }
  return {c_m_s_, m};
}

Vec3 Lorentz::u() const { return {matrix_[0][1], matrix_[0][2], matrix_[0][3]}; }

Lorentz Lorentz::orthonormalised() const {
  const Lorentz pureBoost = boost(u(), c_m_s_);
  const glm::dmat4 rest = (pureBoost.inverse() * *this).matrix_;
  const glm::dmat3 turn(Vec3(rest[1].y, rest[1].z, rest[1].w), Vec3(rest[2].y, rest[2].z, rest[2].w),
                        Vec3(rest[3].y, rest[3].z, rest[3].w));
  return pureBoost * rotation(glm::normalize(glm::quat_cast(turn)), c_m_s_);
}

}  // namespace carom
