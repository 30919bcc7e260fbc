#pragma once
// Errors of a tracker that last for several samples, and what a filter makes of them at rest.

#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <random>

#include "devices/recorded_head.h"

namespace carom {

/// Errors that are forgotten with a time constant (Ornstein and Uhlenbeck 1930).
class LastingNoise {
 public:
  LastingNoise(std::uint64_t seed, double sigma_m, double tau_s, double rate_hz)
      : random_(seed), keeps_(std::exp(-1.0 / (rate_hz * tau_s))), sigma_m_(sigma_m) {
    now_m_ = trackerNoise(random_, sigma_m);
  }
  glm::dvec3 operator()() {
    return now_m_ = keeps_ * now_m_ + trackerNoise(random_, sigma_m_ * std::sqrt(1.0 - keeps_ * keeps_));
  }

 private:
  std::mt19937_64 random_;
  double keeps_, sigma_m_;
  glm::dvec3 now_m_{0.0};
};

/// RMS of a component from five seconds on, while the sensor keeps its place for half a minute.
inline double restOf_m_s(VelocityFilter filter, double rate_hz, const std::function<glm::dvec3()>& sample) {
  double square = 0.0;
  int count = 0;
  for (int i = 0; i < 30.0 * rate_hz; ++i) {
    const glm::dvec3 celerity_m_s = filter(i / rate_hz, sample());
    if (i < 5.0 * rate_hz) continue;
    square += glm::dot(celerity_m_s, celerity_m_s) / 3.0;
    ++count;
  }
  return std::sqrt(square / count);
}

}  // namespace carom
