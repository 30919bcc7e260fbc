#include "engine/light/sampled_history.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "engine/light/point_emission.h"

namespace carom {

SampledHistory::SampledHistory(double c_m_s, std::vector<double> times_s, std::vector<Vec3> places_m,
                               std::vector<Vec3> velocities)
    : c_m_s_(c_m_s),
      times_s_(std::move(times_s)),
      places_m_(std::move(places_m)),
      velocities_(std::move(velocities)) {}

double SampledHistory::insideBy_m(std::size_t row, std::size_t vertex, const Event& observation) const {
  const Event event = eventOf(row, vertex);
  return c_m_s_ * (observation.t_s - event.t_s) - glm::length(observation.r_m - event.r_m);
}

double SampledHistory::properTime_s(std::size_t row, std::size_t vertex) const {
  double sum_s = 0.0;
  for (std::size_t k = 0; k < row; ++k)
    sum_s += std::sqrt(interval_m2(eventOf(k + 1, vertex) - eventOf(k, vertex), c_m_s_)) / c_m_s_;
  return sum_s;
}

Vec3 SampledHistory::shiningU(std::size_t row, std::size_t vertex, double share, const Vec3& chordU) const {
  if (velocities_.empty()) return chordU;
  const std::size_t count = vertexCount();
  const double part = std::clamp(share, 0.0, 1.0);
  return uFromBeta((1.0 - part) * velocities_[row * count + vertex] +
                   part * velocities_[(row + 1) * count + vertex]);
}

// With the way (T, X) from the observation to the row, and (dT, dX) on to the next, light connects at the
// share s with (T + s dT)² = (X + s dX)²:   s = C/(B + sqrt(B² − A C)),   A = dT² − dX²,   B = X·dX − T dT,
// C = T² − X².
std::optional<Emission> SampledHistory::seenAt(std::size_t vertex, const Event& observation,
                                               const Lorentz& headFromBoard) const {
  if (insideBy_m(0, vertex, observation) < 0.0) return std::nullopt;
  std::size_t row = 0, after = rowCount() - 1;
  while (after - row > 1) {
    const std::size_t middle = (row + after) / 2;
    if (insideBy_m(middle, vertex, observation) >= 0.0) {
      row = middle;
    } else {
      after = middle;
    }
  }
  const Displacement start = eventOf(row, vertex) - observation,
                     step = eventOf(row + 1, vertex) - eventOf(row, vertex);
  const double T = c_m_s_ * start.dt_s, dT = c_m_s_ * step.dt_s;
  const Vec3 &X = start.dr_m, &dX = step.dr_m;
  const double distance = glm::length(X);
  const double A = dT * dT - glm::dot(dX, dX), B = glm::dot(X, dX) - T * dT;
  const double C = (distance + T) * (T - distance);
  const double s = C / (B + std::sqrt(std::max(0.0, B * B - A * C)));

  Emission result;
  const Displacement fromEye{start.dt_s + s * step.dt_s, X + s * dX};
  result.event = observation + fromEye;
  result.seen = headFromBoard * fromEye;
  result.u = shiningU(row, vertex, s, dX / std::sqrt(A));
  result.doppler = dopplerFactor(fromEye, result.u, headFromBoard.inverse().u());
  result.properTime_s = properTime_s(row, vertex) + s * std::sqrt(A) / c_m_s_;
  return result;
}

}  // namespace carom
