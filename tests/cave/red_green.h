#pragma once
// How colours look to eyes without one sort of cones: the matrices of Machado, Oliveira and Fernandes 2009
// ("A Physiologically-based Model for Simulation of Color Vision Deficiency", severity 1), in linear light;
// and how far apart colours are, in CIELAB (CIE 15, 1976).

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace carom::test {

/// Without red cones (protanopia), and without green ones (deuteranopia); the first sees all colours.
inline const std::array<glm::dmat3, 3> kEyes{
    glm::dmat3(1.0),
    glm::transpose(glm::dmat3(0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882,
                              -0.048116, 1.051998)),
    glm::transpose(glm::dmat3(0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820,
                              0.042940, 0.968881))};

/// L*, a*, b* of linear sRGB.
inline glm::dvec3 labOf(const glm::dvec3& linear) {
  const glm::dvec3 rgb = glm::clamp(linear, 0.0, 1.0);
  const glm::dvec3 xyz(glm::dot(rgb, {0.4124, 0.3576, 0.1805}) / 0.9505,
                       glm::dot(rgb, {0.2126, 0.7152, 0.0722}),
                       glm::dot(rgb, {0.0193, 0.1192, 0.9505}) / 1.089);
  glm::dvec3 f(0.0);
  for (int i = 0; i < 3; ++i) f[i] = xyz[i] > 0.008856 ? std::cbrt(xyz[i]) : 7.787 * xyz[i] + 16.0 / 116.0;
  return {116.0 * f.y - 16.0, 500.0 * (f.x - f.y), 200.0 * (f.y - f.z)};
}

/// The least difference of two linear colours for any of these eyes. 2.3 can just be seen side by side.
inline double leastDifference(const glm::vec3& a, const glm::vec3& b) {
  double least = 1e9;
  for (const glm::dmat3& eye : kEyes)
    least = std::min(least, glm::distance(labOf(eye * glm::dvec3(a)), labOf(eye * glm::dvec3(b))));
  return least;
}

}  // namespace carom::test
