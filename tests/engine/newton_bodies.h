#pragma once
// Two rigid convex polygons by Newton's mechanics, by a way that shares nothing with the engine's: steps no
// longer than the gap allows, and the widest gap among all lines along sides.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace carom::test {

struct NewtonBody {
  std::vector<glm::dvec2> corners;  // anticlockwise, from the centre, at angle 0
  double mass = 1.0, inertia = 1.0;
  glm::dvec2 place{0.0}, velocity{0.0};
  double angle = 0.0, turning = 0.0;

  glm::dvec2 corner(std::size_t k) const {
    const glm::dvec2& d = corners[k % corners.size()];
    const double c = std::cos(angle), s = std::sin(angle);
    return place + glm::dvec2{d.x * c - d.y * s, d.x * s + d.y * c};
  }
  glm::dvec2 velocityAt(const glm::dvec2& at) const {
    const glm::dvec2 r = at - place;
    return velocity + glm::dvec2{-r.y, r.x} * turning;
  }
  void move(double t) { place += velocity * t, angle += turning * t; }
  void push(const glm::dvec2& impulse, const glm::dvec2& at) {
    const glm::dvec2 r = at - place;
    velocity += impulse / mass;
    turning += (r.x * impulse.y - r.y * impulse.x) / inertia;
  }
};

/// The widest gap between two bodies: along a side of one of them, to the nearest corner of the other.
struct NewtonGap {
  double width = -1e9;
  glm::dvec2 normal{0.0}, at{0.0};  // from the first body to the second; the corner
};

inline NewtonGap gapOf(const std::array<NewtonBody, 2>& bodies) {
  NewtonGap gap;
  for (int i = 0; i < 2; ++i) {
    const NewtonBody &one = bodies[i], &other = bodies[1 - i];
    for (std::size_t k = 0; k < one.corners.size(); ++k) {
      const glm::dvec2 from = one.corner(k), side = one.corner(k + 1) - from;
      const glm::dvec2 normal = glm::dvec2{side.y, -side.x} / glm::length(side);
      double least = 1e9;
      glm::dvec2 nearest{0.0};
      for (std::size_t m = 0; m < other.corners.size(); ++m) {
        const double outside = glm::dot(normal, other.corner(m) - from);
        if (outside < least) least = outside, nearest = other.corner(m);
      }
      if (least > gap.width) gap = {least, i == 0 ? normal : -normal, nearest};
    }
  }
  return gap;
}

/// Plays until `until`. Returns the number of blows.
inline int playNewton(std::array<NewtonBody, 2>& bodies, double restitution, double until) {
  int blows = 0;
  double size = 0.0;
  for (const NewtonBody& body : bodies)
    for (const glm::dvec2& corner : body.corners) size = std::max(size, glm::length(corner));
  for (double t = 0.0; t < until;) {
    const NewtonGap gap = gapOf(bodies);
    const double closing = glm::dot(bodies[0].velocityAt(gap.at) - bodies[1].velocityAt(gap.at), gap.normal);
    if (gap.width < 1e-8 * size && closing > 0.0) {
      double perImpulse = 0.0;
      for (const NewtonBody& body : bodies) {
        const glm::dvec2 r = gap.at - body.place;
        const double lever = r.x * gap.normal.y - r.y * gap.normal.x;
        perImpulse += 1.0 / body.mass + lever * lever / body.inertia;
      }
      const glm::dvec2 impulse = gap.normal * ((1.0 + restitution) * closing / perImpulse);
      bodies[0].push(-impulse, gap.at), bodies[1].push(impulse, gap.at);
      ++blows;
      continue;
    }
    const double fastest = glm::length(bodies[1].velocity - bodies[0].velocity) +
                           size * (std::abs(bodies[0].turning) + std::abs(bodies[1].turning));
    const double step = std::min(until - t, std::max(gap.width, 1e-7 * size) / (1.01 * fastest));
    for (NewtonBody& body : bodies) body.move(step);
    t += std::max(step, 1e-15);
  }
  return blows;
}

}  // namespace carom::test
