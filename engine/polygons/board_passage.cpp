#include "engine/polygons/board_passage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/base/never.h"
#include "engine/polygons/rest_axes.h"

namespace carom {

namespace {

using Vec2 = glm::dvec2;

constexpr double kTouches = 1e-9;   // of the radii: so far apart they have come out of each other
constexpr double kLeastWay = 1e-4;  // likewise: the least way between two looks
constexpr double kFastest = 2.0;    // over c: no corner and side of two bodies come nearer faster
constexpr int kMostLooks = 4096;

/// The widest gap between two bodies along a side of either, below 0 if they overlap; and the largest cosine
/// between a direction and a side that parts them.
struct SideGap {
  double width = -kNever, alongWidest = -1.0, along = -1.0;
};

double ownTime(const MovingShape& flight, double t) { return (t - flight.start.t) / flight.u.t; }

/// Two bodies at board times, and the impulse as it lay at their contact or has turned with either since.
class PairOnBoard {
 public:
  PairOnBoard(const MovingShape& first, const MovingShape& second, const PersistentContact& touched)
      : flights_{&first, &second}, touched_(touched), reach_(first.radius + second.radius) {
    impulse_ = glm::normalize(Vec2{touched.n.x, touched.n.y});
  }

  SideGap gapAt(double t) const {
    const std::array<Vec2, 3> impulses{impulse_, turned(impulse_, portableSinCos(turnedBy(0, t))),
                                       turned(impulse_, portableSinCos(turnedBy(1, t)))};
    const auto alongOf = [&](const Vec2& outwards) {
      double along = -1.0;
      for (const Vec2& impulse : impulses) along = std::max(along, glm::dot(impulse, outwards));
      return along;
    };
    const Vec2 apart = placeOf(1, t) - placeOf(0, t);
    const double distance = glm::length(apart);
    if (distance > reach_) {
      const double along = alongOf(apart / distance);
      return {distance - reach_, along, along};
    }
    const std::array<std::vector<Vec2>, 2> corners{cornersOnBoard(*flights_[0], t),
                                                   cornersOnBoard(*flights_[1], t)};
    SideGap gap;
    for (int i = 0; i < 2; ++i) {
      const std::vector<Vec2>&one = corners[i], &other = corners[1 - i];
      for (std::size_t k = 0; k < one.size(); ++k) {
        const Vec2 side = one[(k + 1) % one.size()] - one[k];
        const Vec2 normal = Vec2{side.y, -side.x} / glm::length(side), outwards = i == 0 ? normal : -normal;
        const double along = alongOf(outwards);
        double width = kNever;
        for (const Vec2& corner : other) width = std::min(width, glm::dot(normal, corner - one[k]));
        if (width > 0.0) gap.along = std::max(gap.along, along);
        if (width > gap.width) gap.width = width, gap.alongWidest = along;
      }
    }
    return gap;
  }

  double reach() const { return reach_; }
  /// Whether they are farther apart than they reach, and recede.
  bool haveLeft(double t) const {
    const Vec2 apart = placeOf(1, t) - placeOf(0, t);
    return glm::length(apart) > reach_ && glm::dot(apart, velocityOf(1) - velocityOf(0)) > 0.0;
  }

 private:
  Vec2 velocityOf(int i) const { return Vec2{flights_[i]->u.x, flights_[i]->u.y} / flights_[i]->u.t; }
  Vec2 placeOf(int i, double t) const {
    const MovingShape& flight = *flights_[i];
    return Vec2{flight.start.x, flight.start.y} + velocityOf(i) * (t - flight.start.t);
  }
  double turnedBy(int i, double t) const {
    const MovingShape &now = *flights_[i], &then = touched_.flights[i];
    return now.angle + now.turning * ownTime(now, t) - then.angle -
           then.turning * ownTime(then, touched_.event.t);
  }

  std::array<const MovingShape*, 2> flights_;
  const PersistentContact& touched_;
  double reach_;
  Vec2 impulse_;
};

}  // namespace

bool passEachOther(const MovingShape& first, const MovingShape& second, const PersistentContact& touched) {
  const PairOnBoard pair(first, second, touched);
  const double reach = pair.reach();
  double t = std::max(first.start.t, second.start.t);
  bool elsewhere = false, overlapping = false;
  for (int looks = 0; looks < kMostLooks; ++looks) {
    const SideGap gap = pair.gapAt(t);
    const bool apart = gap.width > kTouches * reach;
    if (looks == 0 && apart) elsewhere = gap.along < 0.0;
    if (overlapping && apart) elsewhere = gap.alongWidest < 0.0;
    overlapping = !apart;
    if (pair.haveLeft(t)) break;
    t += std::max(std::abs(gap.width), kLeastWay * reach) / kFastest;
  }
  return elsewhere;
}

}  // namespace carom
