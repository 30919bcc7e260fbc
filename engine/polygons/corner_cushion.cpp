#include "engine/polygons/corner_cushion.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "engine/base/never.h"
#include "engine/base/root.h"
#include "engine/polygons/corner_search.h"
#include "engine/polygons/rest_axes.h"

namespace carom {

namespace {

using Vec2 = glm::dvec2;

Vec21 normalOf(const CushionPlane& cushion) {
  return cushion.axis == 0 ? Vec21{0.0, cushion.sign, 0.0} : Vec21{0.0, 0.0, cushion.sign};
}

/// The corners of a body that moves towards a cushion.
class Approach {
 public:
  Approach(const MovingShape& flight, const CushionPlane& cushion)
      : flight_(flight),
        axes_(flight.u),
        towards_(cushion.towards(flight.u)),
        away_(cushion.inside(flight.start)),
        k_(axes_.place(normalOf(cushion))),
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
  /// How far the outline reaches straight towards the cushion, from the centre.
  double ahead(double s) const {
    const SinCos by = portableSinCos(flight_.angle + flight_.turning * s);
    const Vec2 way = turnedBack(k_ / glm::length(k_), by);
    double farthest = 0.0;
    for (const Outline::Side& side : flight_.outline->sides()) {
      const double slope = glm::dot(side.normal, way);
      if (slope == 0.0) continue;
      const double far = side.offset / slope, along = glm::dot(way * far - side.from, side.along);
      if (along >= 0.0 && along <= side.length) farthest = std::max(farthest, far);
    }
    return farthest;
  }
  /// The point of the outline straight ahead of the centre, as it comes to the cushion before the centre
  /// does. None if the centre does not move towards it.
  struct Foot {
    double s;
    Vec21 event;
  };
  std::optional<Foot> foot(double from) const {
    if (!(towards_ > 0.0)) return std::nullopt;
    const double tall = glm::length(k_);
    const auto depth = [&](double s) { return towards_ * s + ahead(s) * tall - away_; };
    double s = std::max(from, (away_ - reach_) / towards_);
    const double step = (away_ / towards_ - s) / kSteps;
    if (!(step > 0.0) || depth(s) > 0.0) return Foot{s, at(s)};
    while (!(depth(s + step) > 0.0) && s < away_ / towards_) s += step;
    if (flight_.turning != 0.0) {
      s = rootOfIncreasing(depth, s + 0.5 * step, 0.5 * step);
      return Foot{s, at(s)};
    }
    s = (away_ - ahead(0.0) * tall) / towards_;
    return Foot{s, at(s)};
  }

 private:
  static constexpr int kSteps = 1000;

  Vec21 at(double s) const {
    return flight_.start + axes_(k_ * (ahead(s) / glm::length(k_))) + flight_.u * s;
  }

  /// From how soon on a corner that turns can be there: the rest of its way falls at most as
  ///     clearance − closing δ − K δ²/2,   K = Ω² reach
  double soonest(const Vec2& corner, double s, double clearance) const {
    const double most = flight_.turning * flight_.turning * reach_, speed = closing(corner, s);
    const double root = std::sqrt(speed * speed + 2.0 * most * clearance);
    return speed > 0.0 ? 2.0 * clearance / (root + speed) : (root - speed) / most;
  }

  std::optional<double> reachedTurning(const Vec2& corner, double s, double before) const {
    const double fastest = towards_ + std::abs(flight_.turning) * reach_;
    if (!(fastest > 0.0)) return std::nullopt;
    const double least = kLeastStep * flight_.radius / fastest;
    // No corner is there before, and the farthest is within a turn from then.
    if (towards_ > 0.0) s = std::max(s, (away_ - reach_) / towards_);
    double last = std::min(before, s + 7.0 / std::abs(flight_.turning));
    if (towards_ > 0.0) last = std::min(last, std::max(s, (away_ + reach_) / towards_) + least);
    double there = clearance(corner, s);
    bool beyond = there <= 0.0;
    while (s < last) {
      const double next = s + (beyond ? 1e3 * least : std::max(soonest(corner, s, there), least));
      const double then = clearance(corner, next);
      if (beyond && then <= 0.0 && closing(corner, next) > kLeastClosing) return next;  // farther again
      if (!beyond && then <= 0.0) {
        const auto depth = [&](double at) { return -clearance(corner, at); };
        return rootOfIncreasing(depth, 0.5 * (s + next), 0.5 * (next - s));
      }
      s = next;
      there = then;
      beyond = there <= 0.0;
    }
    return std::nullopt;
  }

  const MovingShape& flight_;
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

// A contact as the leg begins, and the turn with it.
CornerCushionContact atOnce(const MovingShape& flight, double properTime, const Vec21& event, bool delayed) {
  CornerCushionContact touch;
  touch.contact.withoutDelay = true;
  touch.contact.turn = {flight.start, flight.u, properTime};
  touch.contact.event = event;
  touch.contact.ownTime = flight.start.t - (delayed ? flight.u.t * flight.radius : 0.0);
  return touch;
}

// The deepest corner that is beyond the cushion and goes on.
std::optional<CornerCushionContact> touchesAtOnce(const MovingShape& flight, double properTime,
                                                  const Approach& approach, bool delayed) {
  double deepest = kCornerTouches * flight.radius;
  const Vec2* found = nullptr;
  for (const Vec2& corner : flight.outline->corners()) {
    const double clearance = approach.clearance(corner, 0.0);
    if (!(clearance <= deepest) || !(approach.closing(corner, 0.0) > kLeastClosing)) continue;
    deepest = clearance;
    found = &corner;
  }
  if (found == nullptr) return std::nullopt;
  return atOnce(flight, properTime, approach.event(*found, 0.0), delayed);
}

// The contact of an event at the cushion, heard of at the centre or, without delay, simultaneous with it.
CornerCushionContact contactAt(const MovingShape& flight, double properTime, const CushionPlane& cushion,
                               Vec21 event, bool delayed) {
  (cushion.axis == 0 ? event.x : event.y) = cushion.sign * cushion.distance;
  const Vec21 way = event - flight.start;
  const double own = dot(flight.u, way);
  const Vec21 lever = way - flight.u * own;
  const double turn =
      delayed ? own + std::sqrt(std::max(0.0, -dot(lever, lever))) : std::max(0.0, way.t / flight.u.t);
  CornerCushionContact touch;
  touch.contact.event = event;
  touch.contact.turn = {flight.start + flight.u * turn, flight.u, properTime + turn};
  touch.contact.ownTime = flight.start.t + flight.u.t * (delayed ? turn - flight.radius : turn);
  return touch;
}

// A body at its first place has been there before board time 0, and nothing touched it.
double earliest(const MovingShape& flight) { return flight.start.t == 0.0 ? -flight.radius : 0.0; }

// The earliest corner; of several, the middle.
std::optional<CornerCushionContact> firstCorner(const MovingShape& flight, double properTime,
                                                const CushionPlane& cushion, const Approach& approach,
                                                bool delayed) {
  const bool first = flight.start.t == 0.0;
  const double from = earliest(flight), tolerance = kSimultaneous * flight.radius;
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
  Vec21 event = approach.event(best.corner, best.s);
  bool sideOnSide = false;
  for (const Vec2& corner : flight.outline->corners()) {
    if (corner == best.corner || !(std::abs(approach.clearance(corner, best.s)) <= tolerance)) continue;
    const Vec21 other = approach.event(corner, best.s);
    if (!delayed && !(std::abs(other.t - event.t) <= tolerance)) continue;
    event = (approach.event(best.corner, best.s) + other) * 0.5;
    sideOnSide = true;
  }
  CornerCushionContact touch = contactAt(flight, properTime, cushion, event, delayed);
  touch.sideOnSide = sideOnSide;
  return touch;
}

}  // namespace

std::optional<CornerCushionContact> findCornerContact(const MovingShape& flight, double properTime,
                                                      const CushionPlane& cushion,
                                                      TurnConvention convention) {
  const Approach approach(flight, cushion);
  const bool delayed = convention == TurnConvention::signalAtCentre;
  if (flight.start.t != 0.0) {
    if (const auto now = touchesAtOnce(flight, properTime, approach, delayed)) return now;
  }
  const auto corner = firstCorner(flight, properTime, cushion, approach, delayed);
  if (corner && cushion.inside(corner->contact.turn.x) >= 0.0) return corner;
  const double from = earliest(flight);
  const auto foot = approach.foot(from);
  if (!foot) return corner;
  if (foot->s > from) return contactAt(flight, properTime, cushion, foot->event, delayed);
  CornerCushionContact now = atOnce(flight, properTime, foot->event, delayed);
  (cushion.axis == 0 ? now.contact.event.x : now.contact.event.y) = cushion.sign * cushion.distance;
  return now;
}

std::vector<Vec21> touchedPlaces(const MovingShape& flight, const CushionPlane& cushion, double within) {
  const Approach approach(flight, cushion);
  std::vector<Vec21> places;
  for (const Vec2& corner : flight.outline->corners())
    if (approach.clearance(corner, 0.0) <= within) places.push_back(approach.event(corner, 0.0));
  return places;
}

}  // namespace carom
