#include "engine/collision/corner_cushion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "engine/base/root.h"
#include "engine/collision/corner_search.h"
#include "engine/collision/rest_axes.h"

namespace carom {

namespace {

using Vec2 = glm::dvec2;

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kTie = 1e-9;        // of the radius
constexpr double kLeastStep = 1e-6;  // of the radius
constexpr int kMostSteps = 4096;

Vec21 normalOf(const CushionPlane& cushion) {
  return cushion.axis == 0 ? Vec21{0.0, cushion.sign, 0.0} : Vec21{0.0, 0.0, cushion.sign};
}

/// The corners of a body that moves towards a cushion.
class Approach {
 public:
  Approach(const ShapedFlight& flight, const CushionPlane& cushion)
      : flight_(flight),
        axes_(flight.u),
        towards_(cushion.towards(flight.u)),
        away_(cushion.inside(flight.start)),
        k_(axes_.place(normalOf(cushion) + flight.u * towards_)),
        reach_(flight.radius * glm::length(k_)) {}

  Vec2 offset(const Vec2& corner, double s) const {
    return turned(corner, portableSinCos(flight_.angle + flight_.turning * s));
  }
  double clearance(const Vec2& corner, double s) const {
    return away_ - towards_ * s - glm::dot(offset(corner, s), k_);
  }
  Vec21 event(const Vec2& corner, double s) const {
    return flight_.start + axes_(offset(corner, s)) + flight_.u * s;
  }
  double closing(const Vec2& corner, double s) const {
    const Vec2 d = offset(corner, s);
    return towards_ + flight_.turning * (d.x * k_.y - d.y * k_.x);
  }
  /// The own time at which a corner comes to the cushion, from s on.
  std::optional<double> reached(const Vec2& corner, double from, double before) const {
    if (flight_.turning != 0.0) return reachedTurning(corner, from, before);
    if (!(towards_ > 0.0)) return std::nullopt;
    const double s = clearance(corner, 0.0) / towards_;
    return s >= from ? std::optional(s) : std::nullopt;
  }
  double radius() const { return flight_.radius; }

 private:
  std::optional<double> reachedTurning(const Vec2& corner, double s, double before) const {
    const double fastest = towards_ + std::abs(flight_.turning) * reach_;
    if (!(fastest > 0.0)) return std::nullopt;
    const double least = kLeastStep * flight_.radius / fastest;
    // No corner is there before; and none later than a whole turn after the farthest could be.
    if (towards_ > 0.0) s = std::max(s, (away_ - reach_) / towards_);
    double last = std::min(before, s + 7.0 / std::abs(flight_.turning));
    if (towards_ > 0.0) last = std::min(before, std::max(s, (away_ + reach_) / towards_) + least);
    double there = clearance(corner, s);
    bool beyond = there <= 0.0;
    for (int step = 0; step < kMostSteps && s < last; ++step) {
      const double next = s + (beyond ? 1e3 * least : std::max(there / fastest, least));
      const double then = clearance(corner, next);
      if (beyond && then <= 0.0 && closing(corner, next) > kLeastClosing) return next;  // farther again
      if (!beyond && then <= 0.0) {
        const auto depth = [&](double at) { return -clearance(corner, at); };
        return rootOfIncreasing(depth, 0.5 * (s + next), 0.5 * (next - s));
      }
      s = next, there = then, beyond = there <= 0.0;
    }
    return std::nullopt;
  }

  const ShapedFlight& flight_;
  RestAxes axes_;
  double towards_, away_;
  Vec2 k_;
  double reach_;
};

/// A corner at the cushion.
struct Touch {
  double order = kNever;  // own time, or board time
  double s = 0.0;
  Vec2 corner{0.0};
};

// The deepest corner that is beyond the cushion and goes on.
std::optional<CornerCushionContact> touchesAtOnce(const ShapedFlight& flight, double properTime,
                                                  const Approach& approach, bool delayed) {
  double deepest = kCornerTouches * flight.radius;
  const Vec2* found = nullptr;
  for (const Vec2& corner : flight.outline->corners()) {
    const double clearance = approach.clearance(corner, 0.0);
    if (!(clearance <= deepest) || !(approach.closing(corner, 0.0) > kLeastClosing)) continue;
    deepest = clearance, found = &corner;
  }
  if (found == nullptr) return std::nullopt;
  CornerCushionContact touch;
  touch.contact.withoutDelay = true;
  touch.contact.turn = {flight.start, flight.u, properTime};
  touch.contact.event = approach.event(*found, 0.0);
  touch.contact.ownTime = flight.start.t - (delayed ? flight.u.t * flight.radius : 0.0);
  return touch;
}

}  // namespace

std::optional<CornerCushionContact> findCornerContact(const ShapedFlight& flight, double properTime,
                                                      const CushionPlane& cushion,
                                                      TurnConvention convention) {
  const Approach approach(flight, cushion);
  const bool delayed = convention == TurnConvention::signalAtCentre, first = flight.start.t == 0.0;
  if (!first) {
    if (const auto now = touchesAtOnce(flight, properTime, approach, delayed)) return now;
  }
  // A body at its first place has been there before board time 0, and nothing touched it.
  const double from = first ? -flight.radius : 0.0;
  Touch best;
  for (const Vec2& corner : flight.outline->corners()) {
    const auto s = approach.reached(corner, from, delayed ? best.order : kNever);
    if (!s) continue;
    const Vec21 event = approach.event(corner, *s);
    if (first && !(event.t > 0.0)) continue;
    const double order = delayed ? *s : event.t;
    if (order < best.order) best = {order, *s, corner};
  }
  if (!(best.order < kNever)) return std::nullopt;

  CornerCushionContact touch;
  Vec21 event = approach.event(best.corner, best.s);
  // Another corner that touches at the same time is the other end of a side.
  for (const Vec2& corner : flight.outline->corners()) {
    if (corner == best.corner) continue;
    const double tolerance = kTie * flight.radius;
    if (!(std::abs(approach.clearance(corner, best.s)) <= tolerance)) continue;
    const Vec21 other = approach.event(corner, best.s);
    if (!delayed && !(std::abs(other.t - event.t) <= tolerance)) continue;
    event = (approach.event(best.corner, best.s) + other) * 0.5;
    touch.sideOnSide = true;
  }
  (cushion.axis == 0 ? event.x : event.y) = cushion.sign * cushion.distance;
  const Vec21 way = event - flight.start;
  const double own = dot(flight.u, way);
  const Vec21 lever = way - flight.u * own;
  const double turn = delayed ? own + std::sqrt(std::max(0.0, -dot(lever, lever))) : way.t / flight.u.t;
  touch.contact.event = event;
  touch.contact.turn = {flight.start + flight.u * turn, flight.u, properTime + turn};
  touch.contact.ownTime = flight.start.t + flight.u.t * (delayed ? turn - flight.radius : turn);
  return touch;
}

}  // namespace carom
