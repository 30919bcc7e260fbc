#include "engine/polygons/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "engine/text/joined_text.h"

namespace carom {

namespace {

using Vec2 = glm::dvec2;

constexpr double kOnSide = 1e-9;  // of the radius: nearer than this lies on a side

template <class... Parts>
OutlineFault fault(std::size_t corner, const Parts&... parts) {
  constexpr int kDigits = 6;
  return {corner, joinedText(kDigits, parts...)};
}

/// Twice the area, with the sign of the direction of turning. Measured from a corner, so that nothing
/// cancels.
double twiceArea(std::span<const Vec2> corners) {
  double sum = 0.0;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    sum += cross2(corners[k] - corners[0], corners[k + 1] - corners[0]);
  return sum;
}

/// Whether no corner is farther than `beside` from the line through the first one and the one farthest from
/// it.
bool onOneLine(std::span<const Vec2> corners, double beside) {
  Vec2 line{0.0};
  for (const Vec2& corner : corners)
    if (glm::length(corner - corners[0]) > glm::length(line)) line = corner - corners[0];
  return std::all_of(corners.begin(), corners.end(), [&](const Vec2& corner) {
    return std::abs(cross2(line, corner - corners[0])) <= beside * glm::length(line);
  });
}

double extentOf(std::span<const Vec2> corners) {
  double extent = 0.0;
  for (const Vec2& corner : corners)
    extent = std::max({extent, std::abs(corner.x - corners[0].x), std::abs(corner.y - corners[0].y)});
  return extent;
}

}  // namespace

bool sidesMeet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto side = [](const Vec2& p, const Vec2& q, const Vec2& r) {
    const double z = cross2(q - p, r - p);
    return (z > 0.0) - (z < 0.0);
  };
  const auto within = [](const Vec2& p, const Vec2& q, const Vec2& r) {
    return std::min(p.x, q.x) <= r.x && r.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= r.y &&
           r.y <= std::max(p.y, q.y);
  };
  const int abc = side(a, b, c), abd = side(a, b, d), cda = side(c, d, a), cdb = side(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && within(a, b, c)) || (abd == 0 && within(a, b, d)) || (cda == 0 && within(c, d, a)) ||
         (cdb == 0 && within(c, d, b));
}

std::optional<OutlineFault> faultOf(std::span<const Vec2> corners) {
  const std::size_t count = corners.size();
  if (count < kLeastCorners || count > kMostCorners)
    return fault(0, count, count == 1 ? " corner" : " corners", ": expected ", kLeastCorners, " to ",
                 kMostCorners);
  for (std::size_t k = 0; k < count; ++k)
    if (!std::isfinite(corners[k].x) || !std::isfinite(corners[k].y))
      return fault(k, "corner ", k + 1, " is not a place: expected two finite numbers");
  const double extent = extentOf(corners), same = 1e-9 * extent;
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t before = 0; before < k; ++before)
      if (!(glm::length(corners[k] - corners[before]) > same))
        return fault(k, "corner ", k + 1, " lies on corner ", before + 1, ": expected different places");
  // Sides on one line touch, too, and a bow tie has no area, either: the more telling is said.
  if (onOneLine(corners, same)) return fault(0, "the corners lie on one line: expected an area");
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2 &a = corners[k], &b = corners[(k + 1) % count], &c = corners[(k + 2) % count];
    if (std::abs(cross2(b - a, c - b)) <= 1e-12 * extent * extent && glm::dot(b - a, c - b) < 0.0)
      return fault((k + 1) % count, "the sides at corner ", (k + 1) % count + 1,
                   " lie on each other: expected an angle");
    for (std::size_t other = k + 2; other < count; ++other) {
      if (other + 1 == count && k == 0) continue;
      if (sidesMeet(a, b, corners[other], corners[(other + 1) % count]))
        return fault(other, "the side from corner ", other + 1, " crosses or touches the side from corner ",
                     k + 1, ": expected an outline that meets itself nowhere");
    }
  }
  const double area2 = twiceArea(corners);
  if (!(std::abs(area2) > same * extent)) return fault(0, "the corners enclose no area: expected an area");
  if (area2 < 0.0) return fault(0, "the corners run clockwise: expected them anticlockwise seen from above");
  return std::nullopt;
}

bool turnsLeft(std::span<const Vec2> corners, std::size_t corner) {
  const std::size_t count = corners.size();
  const Vec2 &at = corners[corner % count], &before = corners[(corner + count - 1) % count];
  return cross2(at - before, corners[(corner + 1) % count] - at) > 0.0;
}

bool isNearer(double distance2, double front, double least2, double frontOfLeast) {
  if (distance2 != least2) return distance2 < least2;
  const bool inFront = front > 0.0, leastInFront = frontOfLeast > 0.0;
  return inFront != leastInFront ? inFront : std::abs(front) > std::abs(frontOfLeast);
}

// Sums over the triangles from the origin to each side a b, with z = a × b: area z/2, first moment z (a +
// b)/6, second moment z (a·a + a·b + b·b)/12.
OutlineMoments momentsOf(std::span<const Vec2> corners) {
  double area2 = 0.0, second = 0.0, farthest2 = 0.0;
  Vec2 first{0.0};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 &a = corners[k], &b = corners[(k + 1) % corners.size()];
    const double z = cross2(a, b);
    area2 += z;
    first += (a + b) * (z / 6.0);
    second += z * (glm::dot(a, a) + glm::dot(a, b) + glm::dot(b, b)) / 12.0;
    farthest2 = std::max(farthest2, glm::dot(a, a));
  }
  return {0.5 * area2, first / (0.5 * area2), second / (0.5 * area2 * farthest2)};
}

Outline::Outline(std::span<const Vec2> corners) : corners_(corners.begin(), corners.end()) {
  const std::size_t count = corners_.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2 way = corners_[(k + 1) % count] - corners_[k];
    Side side;
    side.from = corners_[k];
    side.length = glm::length(way);
    side.along = way / side.length;
    side.normal = {side.along.y, -side.along.x};
    // From both ends, so that an outline's mirror image has the same bits.
    side.offset = 0.5 * (glm::dot(side.normal, side.from) + glm::dot(side.normal, corners_[(k + 1) % count]));
    sides_.push_back(side);
    radius_ = std::max(radius_, glm::length(corners_[k]));
  }
  for (std::size_t k = 0; k < count; ++k)
    convex_ = convex_ && cross2(sides_[k].along, sides_[(k + 1) % count].along) >= -1e-12;
}

// For a convex outline, takes the side from which the point lies farthest outside; for another, the nearest
// side: the part behind it, or nearest to a dent, lies inside.
Outline::Clearance Outline::clearanceOf(const Vec2& point) const {
  Clearance found;
  if (convex_) {
    found.outside = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      const double outside = glm::dot(sides_[k].normal, point) - sides_[k].offset;
      if (outside > found.outside) found = {outside, k};
    }
    return found;
  }
  double least2 = std::numeric_limits<double>::infinity();
  double mostFront = 0.0;
  bool outside = false;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const Side& side = sides_[k];
    const Vec2 a = side.from, b = corners_[(k + 1) % corners_.size()];
    const Vec2 middle = (a + b) * 0.5;
    const double along = glm::dot(point - middle, side.along), half = 0.5 * side.length;
    const Vec2 way = point - (along <= -half ? a : along >= half ? b : middle + side.along * along);
    const double distance2 = glm::dot(way, way);
    const double front = glm::dot(way, side.normal);
    if (!isNearer(distance2, front, least2, mostFront)) continue;
    least2 = distance2;
    mostFront = front;
    found.side = k;
    outside = std::abs(along) < half ? front > 0.0 : turnsLeft(corners_, along < 0.0 ? k : k + 1);
  }
  found.outside = outside ? std::sqrt(least2) : -std::sqrt(least2);
  return found;
}

// What begins or ends on a side has not crossed it.
std::optional<std::size_t> Outline::entranceOf(const Vec2& from, const Vec2& to) const {
  const double touches = kOnSide * radius_;
  double last = -1.0;
  std::optional<std::size_t> entrance;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const Side& side = sides_[k];
    const double before = glm::dot(side.normal, from) - side.offset;
    const double after = glm::dot(side.normal, to) - side.offset;
    if (!(before >= -touches && after < -touches)) continue;
    const double at = std::max(0.0, before / (before - after));
    const double along = glm::dot(side.along, from + (to - from) * at - side.from);
    if (!(along >= -touches && along <= side.length + touches) || !(at > last)) continue;
    last = at;
    entrance = k;
  }
  return entrance;
}

}  // namespace carom
