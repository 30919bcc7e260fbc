#pragma once
// What must hold for everything that a decoder makes of any bytes.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <span>

#include "devices/tracker/reading.h"

namespace carom::test {

/// Ends the program, loudly, where it does not hold; also in optimised builds.
inline void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

inline void expectSound(std::span<const Reading> readings) {
  for (const Reading& reading : readings) {
    expect(reading.sensor >= 0 && reading.index >= 0, "numbers count from 0");
    expect(std::isnan(reading.device_s) || std::abs(reading.device_s) < 1e30, "times are numbers or none");
    expect(std::abs(reading.latency_s) <= 1.0, "latencies are below 1 s");
    expect(std::abs(reading.value) <= 1.0, "values are in −1 … 1");
    const glm::dvec3& p = reading.pose.position_m;
    const glm::dquat& q = reading.pose.orientation;
    expect(glm::dot(p, p) <= 1.001e6, "poses are within 1 km");
    expect(std::abs(glm::dot(q, q) - 1.0) <= 1e-9, "orientations are unit quaternions");
    const glm::dvec3 &v = reading.velocity_m_s, &w = reading.angularVelocity_rad_s;
    expect(std::isfinite(glm::dot(v, v)) && std::isfinite(glm::dot(w, w)), "velocities are finite");
  }
}

}  // namespace carom::test
