#include "engine/polygons/moving_shape.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "engine/polygons/rest_axes.h"

namespace carom {

namespace {

using Vec2 = glm::dvec2;

constexpr double kTouching = 1e-12;  // of the radii

/// Whether the sides a b and c d cross, and by more than rounding.
bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, double least) {
  const auto beside = [](const Vec2& p, const Vec2& q, const Vec2& r) {
    return cross2(q - p, r - p) / glm::length(q - p);
  };
  const auto apart = [least](double one, double other) {
    return (one > least && other < -least) || (one < -least && other > least);
  };
  return apart(beside(a, b, c), beside(a, b, d)) && apart(beside(c, d, a), beside(c, d, b));
}

bool sidesCross(const std::vector<Vec2>& one, const std::vector<Vec2>& other, double least) {
  for (std::size_t i = 0; i < one.size(); ++i)
    for (std::size_t k = 0; k < other.size(); ++k)
      if (cross(one[i], one[(i + 1) % one.size()], other[k], other[(k + 1) % other.size()], least))
        return true;
  return false;
}

bool anyInside(const std::vector<Vec2>& corners, const std::vector<Vec2>& of, double least) {
  const Outline outline(of);
  return std::any_of(corners.begin(), corners.end(),
                     [&](const Vec2& corner) { return outline.clearanceOf(corner).outside < -least; });
}

}  // namespace

Vec21 equalSpeedFrame(const Vec21& u1, const Vec21& u2) {
  const Vec21 sum = u1 + u2;
  return sum * (1.0 / std::sqrt(dot(sum, sum)));
}

// Newton's steps for the own time at which the corner's event has the board time t.
std::vector<Vec2> cornersOnBoard(const MovingShape& flight, double t) {
  const RestAxes axes(flight.u);
  std::vector<Vec2> places;
  for (const Vec2& corner : flight.outline->corners()) {
    double s = (t - flight.start.t) / flight.u.t;
    Vec21 event;
    for (int step = 0; step < 60; ++step) {
      const Vec2 offset = turned(corner, portableSinCos(flight.angle + flight.turning * s));
      event = flight.start + axes(offset) + flight.u * s;
      const double slope = flight.u.t + flight.turning * (axes.y.t * offset.x - axes.x.t * offset.y);
      const double next = s - (event.t - t) / slope;
      if (std::abs(next - s) <= 1e-15 * flight.radius) break;
      s = next;
    }
    places.push_back({event.x, event.y});
  }
  return places;
}

// A disc is a circle once the board is stretched along its velocity.
bool overlapOnBoard(const MovingShape& first, const MovingShape& second, double t) {
  const double least = kTouching * (first.radius + second.radius);
  if (first.outline != nullptr && second.outline != nullptr) {
    const std::vector<Vec2> one = cornersOnBoard(first, t), other = cornersOnBoard(second, t);
    return sidesCross(one, other, least) || anyInside(one, other, least) || anyInside(other, one, least);
  }
  const MovingShape &disc = first.outline == nullptr ? first : second,
                    &body = first.outline == nullptr ? second : first;
  const double s = (t - disc.start.t) / disc.u.t;
  const Vec2 centre{disc.start.x + disc.u.x * s, disc.start.y + disc.u.y * s};
  const Vec2 u{disc.u.x, disc.u.y};
  std::vector<Vec2> corners = cornersOnBoard(body, t);
  for (Vec2& corner : corners) corner += u * (glm::dot(corner - centre, u) / (disc.u.t + 1.0)) - centre;
  const Outline outline(corners);
  const double outside = outline.clearanceOf({0.0, 0.0}).outside;
  if (outside < 0.0) return true;
  for (const Outline::Side& side : outline.sides()) {
    const double along = std::clamp(-glm::dot(side.from, side.along), 0.0, side.length);
    if (glm::length(side.from + side.along * along) < disc.radius - least) return true;
  }
  return false;
}

}  // namespace carom
