#include "engine/polygons/outline_around.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "engine/base/never.h"
#include "engine/polygons/outline.h"

namespace carom {

namespace {

using Vec2 = glm::dvec2;

constexpr double kStraight = 1e-8;  // of the extent: what lies as near to a straight side is on it

double distanceToSegment(const Vec2& x, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length2 = glm::dot(along, along);
  const double share = length2 > 0.0 ? std::clamp(glm::dot(x - a, along) / length2, 0.0, 1.0) : 0.0;
  return glm::length(x - a - share * along);
}

/// Returns how far a point is from a simple polygon; 0 inside.
double distanceTo(std::span<const Vec2> ring, const Vec2& x) {
  double nearest = kNever;
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2 &a = ring[k], &b = ring[(k + 1) % ring.size()];
    nearest = std::min(nearest, distanceToSegment(x, a, b));
    if ((a.y > x.y) != (b.y > x.y) && x.x < a.x + (b.x - a.x) * (x.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside ? 0.0 : nearest;
}

/// The outline while corners go. Side k runs from corner k to the next one.
class Shrinking {
 public:
  Shrinking(std::span<const Vec2> ring, double most) : ring_(ring), most_(most), corners_(begin(ring)) {
    for (const Vec2& corner : ring) extent_ = std::max(extent_, glm::length(corner - ring[0]));
    costs_.assign(corners_.size(), kUnknown);
    leaves_.assign(corners_.size(), 0.0);
  }

  std::vector<Vec2> around(std::size_t enough) {
    while (corners_.size() > kLeastCorners) {
      for (std::size_t k = 0; k < corners_.size(); ++k)
        if (costs_[k] == kUnknown) costs_[k] = costOf(k);
      const auto least = std::min_element(costs_.begin(), costs_.end());
      if (*least > (corners_.size() > enough ? most_ : kStraight * extent_)) break;
      const auto k = static_cast<std::size_t>(least - costs_.begin());
      if (isFree(k)) {
        drop(k);
      } else {
        *least = kBarred;
      }
    }
    return corners_;
  }

 private:
  static constexpr double kUnknown = -1.0;
  static constexpr double kBarred = std::numeric_limits<double>::max();  // until another goes

  static std::vector<Vec2> begin(std::span<const Vec2> ring) { return {ring.begin(), ring.end()}; }
  std::size_t at(std::size_t k) const { return k % corners_.size(); }
  const Vec2& corner(std::size_t k) const { return corners_[at(k)]; }

  /// How far the body turns at a corner: above 0 where it is convex.
  double bend(std::size_t k) const {
    const Vec2 &a = corner(k + corners_.size() - 1), &b = corner(k), &c = corner(k + 1);
    return cross2(b - a, c - b);
  }

  /// Is the corner in a dent or, within rounding, on a straight line?
  bool isFilled(std::size_t k) const {
    return bend(k) <= 0.0 || distanceToSegment(corner(k), corner(k + corners_.size() - 1), corner(k + 1)) <=
                                 kStraight * extent_;
  }

  /// Where the neighbours of side k meet, prolonged; none if they do not.
  bool prolonged(std::size_t k, Vec2& place) const {
    const Vec2 &a = corner(k + corners_.size() - 1), &b = corner(k), &c = corner(k + 1), &d = corner(k + 2);
    const double turn = cross2(b - a, d - c);
    if (!(bend(k) > 0.0) || !(bend(k + 1) > 0.0) || !(turn > 0.0)) return false;
    place = b + (b - a) * (cross2(c - b, d - c) / turn);
    return true;
  }

  /// A bound for the distance from the ring along a straight line, with the distances of its ends: the middle
  /// is farther than an end by half of the way at most.
  double farthestOn(const Vec2& a, double fromA, const Vec2& b, double fromB) const {
    const double known = std::max(fromA, fromB), bound = 0.5 * (fromA + fromB + glm::length(b - a));
    if (known > most_) return kNever;
    if (bound <= known + 0.01 * most_ || !(glm::length(b - a) > 1e-4 * most_)) return bound;
    const Vec2 middle = 0.5 * (a + b);
    const double from = distanceTo(ring_, middle);
    return std::max(farthestOn(a, fromA, middle, from), farthestOn(middle, from, b, fromB));
  }

  /// How far from the ring the outline is at most where it is new, if corner k (in a dent) or side k goes.
  double costOf(std::size_t k) const {
    const std::size_t before = at(k + corners_.size() - 1);
    Vec2 place;
    if (isFilled(k)) {
      const Vec2 &a = corner(before), &c = corner(k + 1);
      // Everywhere on the new side the old ones are as near as their corner, and the ring from there.
      const double simple = distanceToSegment(corner(k), a, c) + std::max(leaves_[before], leaves_[k]);
      return simple <= most_ ? simple : farthestOn(a, distanceTo(ring_, a), c, distanceTo(ring_, c));
    }
    if (!prolonged(k, place)) return kNever;
    const Vec2 &b = corner(k), &c = corner(k + 1);
    const double simple = distanceToSegment(place, b, c) + leaves_[k];
    if (simple <= most_) return simple;
    const double from = distanceTo(ring_, place);
    if (from > most_) return kNever;
    return std::max(farthestOn(b, distanceTo(ring_, b), place, from),
                    farthestOn(place, from, c, distanceTo(ring_, c)));
  }

  /// Does the outline meet itself nowhere if corner or side k goes?
  bool isFree(std::size_t k) const {
    const Vec2 &b = corner(k), &c = corner(k + 1);
    std::vector<Vec2> way{corner(k + corners_.size() - 1), c};
    // Sides that go or are prolonged: those of the corner, and of a side its neighbours, too.
    std::size_t kept = 2;
    if (!isFilled(k)) {
      way = {b, b, c};
      prolonged(k, way[1]);
      kept = 3;
    }
    for (std::size_t side = k + kept - 1; side < k + corners_.size() - 1; ++side) {
      const Vec2 &from = corner(side), &to = corner(side + 1);
      for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const bool joined =
            from == way[i] || from == way[i + 1] || to == way[i] || to == way[i + 1] || way[i] == way[i + 1];
        if (!joined && sidesMeet(way[i], way[i + 1], from, to)) return false;
      }
    }
    return true;
  }

  void drop(std::size_t k) {
    const std::size_t before = at(k + corners_.size() - 1), after = at(k + 1);
    Vec2 place;
    if (isFilled(k)) {
      leaves_[before] = costs_[k];
    } else {
      prolonged(k, place);
      for (const std::size_t side : {before, after}) leaves_[side] = std::max(leaves_[side], costs_[k]);
      corners_[after] = place;
    }
    const auto gone = static_cast<std::ptrdiff_t>(k);
    corners_.erase(corners_.begin() + gone);
    costs_.erase(costs_.begin() + gone);
    leaves_.erase(leaves_.begin() + gone);
    const std::size_t count = corners_.size();
    for (std::size_t near = k + count - 3; near < k + count + 3; ++near) costs_[near % count] = kUnknown;
    std::replace(costs_.begin(), costs_.end(), kBarred, kUnknown);
  }

  std::span<const Vec2> ring_;
  double most_ = 0.0, extent_ = 0.0;
  std::vector<Vec2> corners_;
  std::vector<double> costs_;   // of corner k, if it is in a dent, otherwise of side k
  std::vector<double> leaves_;  // a bound for how far side k is from the ring
};

}  // namespace

// Andrew's monotone chain: from the left below, then from the right above.
std::vector<Vec2> hullOf(std::span<const Vec2> points) {
  std::vector<Vec2> sorted(points.begin(), points.end());
  const auto isBefore = [](const Vec2& a, const Vec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  std::sort(sorted.begin(), sorted.end(), isBefore);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.size() < 3) return sorted;
  std::vector<Vec2> hull;
  for (const bool upper : {false, true}) {
    const std::size_t first = hull.size();
    for (const Vec2& point : sorted) {
      while (hull.size() >= first + 2 &&
             cross2(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0)
        hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();  // the other half begins with it
    if (!upper) std::reverse(sorted.begin(), sorted.end());
  }
  return hull;
}

std::vector<Vec2> outlineAround(std::span<const Vec2> ring, double most, std::size_t enough) {
  return Shrinking(ring, most).around(enough);
}

}  // namespace carom
