#include "devices/force_law/shown_mass.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kLambda_1_s = 25.0, kSecond_s = 1.0;
constexpr double kLeast_m_s2 = 0.03;  // of the acceleration's root mean square: above an encoder's noise

}  // namespace

void ShownMass::add(const glm::dvec3& hand_m, const glm::dvec3& force_n, double period_s) {
  if (!begun_) x1_ = x2_ = hand_m;
  begun_ = true;
  const glm::dvec3 a_m_s2 = kLambda_1_s * kLambda_1_s * (hand_m - 2.0 * x1_ + x2_);
  const double share = kLambda_1_s * period_s;
  parts_[part_].forceTimesA += glm::dot(f2_, a_m_s2);
  parts_[part_].aTimesA += glm::dot(a_m_s2, a_m_s2);
  ++parts_[part_].count;
  x2_ += share * (x1_ - x2_);
  x1_ += share * (hand_m - x1_);
  f2_ += share * (f1_ - f2_);
  f1_ += share * (force_n - f1_);
  time_s_ += period_s;
  if (time_s_ - partFrom_s_ < kSecond_s / kParts) return;
  partFrom_s_ = time_s_;
  part_ = (part_ + 1) % kParts;
  parts_[part_] = {};
}

double ShownMass::mass_kg() const {
  Sums all;
  for (const Sums& part : parts_) {
    all.forceTimesA += part.forceTimesA;
    all.aTimesA += part.aTimesA;
    all.count += part.count;
  }
  const bool isShaken = time_s_ >= kSecond_s && all.aTimesA > kLeast_m_s2 * kLeast_m_s2 * all.count;
  return isShaken ? -all.forceTimesA / all.aTimesA : std::numeric_limits<double>::quiet_NaN();
}

bool ShownMass::isHidden(double mass_kg, double stiffness_n_m) {
  constexpr double kOnce_rad_s = 2.0 * std::numbers::pi, kMost = 0.1;
  return !(mass_kg * kOnce_rad_s * kOnce_rad_s <= kMost * stiffness_n_m);
}

}  // namespace carom
