#pragma once
// Shared by several file readers: vectors from a file's numbers, and checks of speeds.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/files/toml_file.h"
#include "engine/base/limits.h"

namespace carom {

/// Relative tolerance for rounding: bodies that touch within this fraction do not overlap.
inline constexpr double kTouching = 1e-12;

inline glm::dvec2 toVec2(const std::array<double, 2>& a) { return {a[0], a[1]}; }
inline glm::dvec3 toVec3(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

/// Returns γβ of the fastest that the drive makes a room, by the key fastest_beta.
inline double readMost_u(const TomlTable& table) {
  const double most = kMostPlatformU / std::hypot(1.0, kMostPlatformU);
  const double beta = table.number("fastest_beta");
  return beta < most ? beta / std::sqrt(1.0 - beta * beta) : kMostPlatformU;
}

/// Records a fault if β is not below 1.
template <class Vec>
void checkSpeed(const TomlTable& table, const Vec& beta) {
  if (glm::dot(beta, beta) < 1.0) return;
  table.fault("beta",
              fmt::format("beta has magnitude {}, expected a speed below light, under 1", glm::length(beta)));
}

}  // namespace carom
