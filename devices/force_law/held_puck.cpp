#include "devices/force_law/held_puck.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace carom {
namespace {

/// Returns m gamma V of a velocity.
glm::dvec3 momentumOf(const HeldPuckLaw& law) {
  const double beta = glm::length(law.carried_m_s) / law.lightSpeed_m_s;
  return law.mass_kg / std::sqrt((1.0 - beta) * (1.0 + beta)) * law.carried_m_s;
}

}  // namespace

HeldPuck::HeldPuck(const HeldPuckLaw& law, const glm::dvec3& hand_m)
    : law_(law), momentum_(momentumOf(law)), deviation_m_(hand_m) {}

double HeldPuck::speedOf(double momentum) const {
  return momentum / std::hypot(law_.mass_kg, momentum / law_.lightSpeed_m_s);
}

glm::dvec3 HeldPuck::velocity_m_s() const {
  const double size = glm::length(momentum_);
  return size > 0.0 ? speedOf(size) / size * momentum_ : glm::dvec3(0.0);
}

glm::dvec3 HeldPuck::step(const glm::dvec3& hand_m, const glm::dvec3& hand_m_s, double period_s) {
  const double coupling = law_.stiffness_n_m * period_s + law_.damping_ns_m, g = period_s * coupling;
  const glm::dvec3 r =
      momentum_ + period_s * (law_.stiffness_n_m * (hand_m - deviation_m_) + law_.damping_ns_m * hand_m_s) +
      g * law_.carried_m_s;
  const double target = glm::length(r);
  const double m = law_.mass_kg, c = law_.lightSpeed_m_s;
  double p = std::min(target, glm::length(momentum_));
  for (int i = 0; i < kSteps; ++i) {
    const double energy = std::hypot(m, p / c);  // E/c^2
    const double f = p + g * p / energy - target, slope = 1.0 + g * m * m / (energy * energy * energy);
    p = std::max(0.0, p - f / slope);
  }
  const glm::dvec3 before = momentum_;
  momentum_ = target > 0.0 ? p / target * r : glm::dvec3(0.0);
  deviation_m_ += period_s * (velocity_m_s() - law_.carried_m_s);
  const glm::dvec3 stretch_m = hand_m - deviation_m_;
  const double carriedP = glm::length(momentumOf(law_));
  const double kinetic_j = c * c * (std::hypot(m, p / c) - std::hypot(m, carriedP / c)) -
                           glm::dot(law_.carried_m_s, momentum_ - momentumOf(law_));
  stored_j_ = kinetic_j + 0.5 * law_.stiffness_n_m * glm::dot(stretch_m, stretch_m);
  return -(momentum_ - before) / period_s;
}

}  // namespace carom
