#pragma once
// Bodies with corners, and discs, by a slow way that shares nothing with the engine's: explicit Lorentz
// matrices, chords and halving for times, and inside by the number of crossings of a ray. c = 1.

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "engine/spacetime/minkowski.h"

namespace carom::test {

inline Vec21 fourVelocityOf(const glm::dvec2& beta) {
  const double gamma = 1.0 / std::sqrt(1.0 - (beta.x * beta.x + beta.y * beta.y));
  return fourVelocity(gamma * beta.x, gamma * beta.y);
}

struct Matrix {
  double m[3][3];
};

/// Returns the boost from the board into the rest frame of beta.
inline Matrix boost(const glm::dvec2& beta) {
  const double b2 = beta.x * beta.x + beta.y * beta.y, gamma = 1.0 / std::sqrt(1.0 - b2);
  const double a = b2 > 0.0 ? (gamma - 1.0) / b2 : 0.0;
  return {{{gamma, -gamma * beta.x, -gamma * beta.y},
           {-gamma * beta.x, 1.0 + a * beta.x * beta.x, a * beta.x * beta.y},
           {-gamma * beta.y, a * beta.x * beta.y, 1.0 + a * beta.y * beta.y}}};
}

inline Vec21 operator*(const Matrix& m, const Vec21& x) {
  const double v[3]{x.t, x.x, x.y};
  double r[3]{};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) r[i] += m.m[i][k] * v[k];
  return {r[0], r[1], r[2]};
}

/// A body on one leg, which passes through `start` with its angle there.
struct SampledBody {
  std::vector<glm::dvec2> corners;  // none: a disc
  Vec21 start;
  double turning = 0.0, radius = 0.0, angle = 0.0;
  Matrix rest, back;  // from the board and to it

  SampledBody(std::vector<glm::dvec2> corners_, const Vec21& start_, const glm::dvec2& beta, double turning_,
              double radius_, double angle_ = 0.0)
      : corners(std::move(corners_)),
        start(start_),
        turning(turning_),
        radius(radius_),
        angle(angle_),
        rest(boost(beta)),
        back(boost(-beta)) {}

  Vec21 restPlace(const Vec21& event) const { return rest * (event - start); }
  Vec21 eventOf(const glm::dvec2& d, double s) const {
    const double a = angle + turning * s;
    return start +
           back * Vec21{s, d.x * std::cos(a) - d.y * std::sin(a), d.x * std::sin(a) + d.y * std::cos(a)};
  }
  /// Returns the event of a point of the body at a time of a frame: by chords, and by halving where they
  /// fail.
  Vec21 eventAt(const glm::dvec2& d, const Matrix& frame, double time) const {
    const auto late = [&](double s) { return (frame * eventOf(d, s)).t - time; };
    const double gamma = (frame * (back * Vec21{1.0, 0.0, 0.0})).t;
    double low = -(late(0.0) + 2.0 * gamma * radius) / gamma, high = low + 4.0 * radius;
    while (late(low) > 0.0) low -= 4.0 * radius;
    while (late(high) < 0.0) high += 4.0 * radius;
    double atLow = late(low), atHigh = late(high);
    for (int step = 0; step < 100 && high - low > 1e-15 * (1.0 + std::abs(low)); ++step) {
      double middle = low - atLow * (high - low) / (atHigh - atLow);
      if (step % 3 == 2 || !(middle > low && middle < high)) middle = 0.5 * (low + high);
      const double there = late(middle);
      if (std::abs(there) <= 1e-15 * (1.0 + std::abs(time))) return eventOf(d, middle);
      (there < 0.0 ? low : high) = middle;
      (there < 0.0 ? atLow : atHigh) = there;
    }
    return eventOf(d, 0.5 * (low + high));
  }
  /// Returns how deep an event lies inside, below 0 outside.
  double depthOf(const Vec21& event) const {
    const Vec21 x = restPlace(event);
    if (corners.empty()) return radius - std::hypot(x.x, x.y);
    const double a = -angle - turning * x.t;
    const glm::dvec2 z{x.x * std::cos(a) - x.y * std::sin(a), x.x * std::sin(a) + x.y * std::cos(a)};
    bool inside = false;
    double nearest = 1e9;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const glm::dvec2 p = corners[k], q = corners[(k + 1) % corners.size()], side = q - p;
      if ((p.y > z.y) != (q.y > z.y) && z.x < p.x + side.x * (z.y - p.y) / side.y) inside = !inside;
      const double along = std::clamp(glm::dot(z - p, side) / glm::dot(side, side), 0.0, 1.0);
      nearest = std::min(nearest, glm::length(z - p - side * along));
    }
    return inside ? nearest : -nearest;
  }
  /// Returns the corners; of a disc, points of the rim.
  std::vector<glm::dvec2> points() const {
    if (!corners.empty()) return corners;
    constexpr int kPoints = 64;
    std::vector<glm::dvec2> rim;
    for (int k = 0; k < kPoints; ++k)
      rim.push_back({radius * std::cos(0.1 + 2.0 * M_PI * k / kPoints),
                     radius * std::sin(0.1 + 2.0 * M_PI * k / kPoints)});
    return rim;
  }
};

/// Returns the greatest depth of a point of one body in the other, at a time of a frame.
inline double depthAt(const SampledBody& one, const SampledBody& other, const Matrix& frame, double time) {
  double most = -1e9;
  for (const glm::dvec2& d : one.points()) most = std::max(most, other.depthOf(one.eventAt(d, frame, time)));
  for (const glm::dvec2& d : other.points())
    most = std::max(most, one.depthOf(other.eventAt(d, frame, time)));
  return most;
}

/// Returns how far the rim of a disc would have to be drawn in for it to touch a body with corners no more,
/// at a time of a frame: its radius less the distance of the nearest point of the outline, by halving around
/// the nearest of many; more than the radius where the centre is inside the body.
inline double overlapOfDisc(const SampledBody& disc, const SampledBody& body, const Matrix& frame,
                            double time) {
  constexpr int kParts = 32;
  double nearest = 1e9;
  for (std::size_t k = 0; k < body.corners.size(); ++k) {
    const glm::dvec2 from = body.corners[k], side = body.corners[(k + 1) % body.corners.size()] - from;
    const auto distanceAt = [&](double share) {
      const Vec21 x = disc.restPlace(body.eventAt(from + side * share, frame, time));
      return std::hypot(x.x, x.y);
    };
    double best = 0.0, distance = distanceAt(0.0);
    for (int part = 1; part <= kParts; ++part) {
      const double there = distanceAt(static_cast<double>(part) / kParts);
      if (there < distance) distance = there, best = static_cast<double>(part) / kParts;
    }
    if (distance > nearest + 2.0 * glm::length(side) / kParts) continue;
    for (double step = 0.5 / kParts; step > 1e-10; step *= 0.5) {
      for (const double share : {best - step, best + step}) {
        const double there = distanceAt(std::clamp(share, 0.0, 1.0));
        if (there < distance) distance = there, best = std::clamp(share, 0.0, 1.0);
      }
    }
    nearest = std::min(nearest, distance);
  }
  const bool inside = body.depthOf(disc.eventAt({0.0, 0.0}, frame, time)) > 0.0;
  return disc.radius + (inside ? nearest : -nearest);
}

}  // namespace carom::test
