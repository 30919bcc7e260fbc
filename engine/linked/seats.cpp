#include "engine/linked/seats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace carom {
namespace {

using Vec2 = glm::dvec2;
using Corners = std::array<Vec2, 4>;

/// Turns a vector about the board's normal, anticlockwise seen from above.
Vec3 turned(const Vec3& v, double angle_rad) {
  const double cos = std::cos(angle_rad), sin = std::sin(angle_rad);
  return {cos * v.x - sin * v.y, sin * v.x + cos * v.y, v.z};
}

Corners cornersOnBoard(const ObserverStart& start, const Floor& floor) {
  const Vec2 forward(std::cos(start.facing_rad), std::sin(start.facing_rad)), right(forward.y, -forward.x);
  const auto corner = [&](double x_m, double y_m) {
    return Vec2(start.position_m) + x_m * right + y_m * forward;
  };
  return {corner(floor.least_m.x, floor.least_m.y), corner(floor.most_m.x, floor.least_m.y),
          corner(floor.most_m.x, floor.most_m.y), corner(floor.least_m.x, floor.most_m.y)};
}

double fromSegment_m(const Vec2& point, const Vec2& from, const Vec2& to) {
  const Vec2 way = to - from;
  const double square = glm::dot(way, way);
  const double share = square > 0.0 ? std::clamp(glm::dot(point - from, way) / square, 0.0, 1.0) : 0.0;
  return glm::distance(point, from + share * way);
}

/// Whether an edge of `a` has all of `b` on its outer side.
bool hasDividingEdge(const Corners& a, const Corners& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 edge = a[(i + 1) % a.size()] - a[i], outwards(edge.y, -edge.x);
    if (std::ranges::all_of(b, [&](const Vec2& corner) { return glm::dot(corner - a[i], outwards) > 0.0; }))
      return true;
  }
  return false;
}

}  // namespace

ObserverStart seat(const ObserverStart& scenario, std::size_t room, std::size_t rooms, double apart_m) {
  const double angle_rad = 2.0 * std::numbers::pi * static_cast<double>(room) / static_cast<double>(rooms);
  ObserverStart start = scenario;
  Vec3 outwards(scenario.position_m.x, scenario.position_m.y, 0.0);
  if (glm::length(outwards) < 1e-9)
    outwards = -Vec3(std::cos(scenario.facing_rad), std::sin(scenario.facing_rad), 0.0);
  start.position_m = turned(scenario.position_m + 0.5 * apart_m * glm::normalize(outwards), angle_rad);
  start.facing_rad += angle_rad;
  start.beta = turned(scenario.beta, angle_rad);
  return start;
}

double floorsApart_m(const ObserverStart& first, const Floor& firstFloor, const ObserverStart& second,
                     const Floor& secondFloor) {
  const Corners a = cornersOnBoard(first, firstFloor), b = cornersOnBoard(second, secondFloor);
  if (!hasDividingEdge(a, b) && !hasDividingEdge(b, a)) return 0.0;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      least_m = std::min({least_m, fromSegment_m(a[i], b[j], b[(j + 1) % b.size()]),
                          fromSegment_m(b[j], a[i], a[(i + 1) % a.size()])});
    }
  }
  return least_m;
}

double distanceFor_m(double roundTrip_s, double c_m_s) { return c_m_s * roundTrip_s / 0.6; }

double apartFor_m(const ObserverStart& scenario, std::span<const Floor> floors, double wanted_m) {
  const auto isEnough = [&](double apart_m) {
    for (std::size_t i = 0; i < floors.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (floorsApart_m(seat(scenario, i, floors.size(), apart_m), floors[i],
                          seat(scenario, j, floors.size(), apart_m), floors[j]) < wanted_m)
          return false;
      }
    }
    return true;
  };
  constexpr double kStep_m = 0.05;  // the distance does not grow evenly where a corner passes an edge
  double apart_m = 0.0;
  while (apart_m < kMostApart_m && !isEnough(apart_m)) apart_m += kStep_m;
  return std::min(apart_m, kMostApart_m);
}

}  // namespace carom
