// The rim of a disc touches a body with corners.

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/base/never.h"
#include "engine/base/root.h"
#include "engine/polygons/corner_search.h"
#include "engine/polygons/rest_axes.h"

namespace carom {

namespace {

using Vec2 = glm::dvec2;

/// A place on a side that bends, from the disc's centre, and how it changes along the side.
struct OnSide {
  double share = 0.0;  ///< of the side: −1 where it begins, 1 where it ends
  Vec2 place{0.0}, slope{0.0}, curve{0.0};
};

const Vec2& endOf(std::span<const Vec2> corners, std::size_t side) {
  return corners[side + 1 < corners.size() ? side + 1 : 0];
}
Vec2 halfOf(std::span<const Vec2> corners, std::size_t side) {
  return (endOf(corners, side) - corners[side]) * 0.5;
}
// From the middle of a side, so that its mirror image has the same bits.
double shareNearest(std::span<const Vec2> corners, std::size_t side) {
  const Vec2 middle = (corners[side] + endOf(corners, side)) * 0.5, half = halfOf(corners, side);
  return -glm::dot(middle, half) / glm::dot(half, half);
}
Vec2 pointOn(std::span<const Vec2> corners, std::size_t side, double share) {
  if (share <= -1.0) return corners[side];
  if (share >= 1.0) return endOf(corners, side);
  return (corners[side] + endOf(corners, side)) * 0.5 + halfOf(corners, side) * share;
}

using Places = std::array<Vec2, kMostCorners>;

/// The disc and the body in the frame of U, around the disc's centre and stretched so that the disc is a
/// circle.
class StretchedFrame {
 public:
  StretchedFrame(const MovingShape& disc, const MovingShape& body, const Vec21& origin, const Vec21& U)
      : disc_(disc),
        body_(body),
        axes_(U),
        axesOfBody_(body.u),
        ofDisc_{dot(U, disc.start - origin), dot(U, disc.u)},
        ofBody_{dot(U, body.start - origin), dot(U, body.u)},
        along_(dot(U, axesOfBody_.x), dot(U, axesOfBody_.y)),
        beta_(axes_.place(disc.u) / ofDisc_.gamma) {
    velocity_ = stretched(axes_.place(body.u) / ofBody_.gamma - beta_);
    per_.x = stretched(axes_.place(axesOfBody_.x));
    per_.y = stretched(axes_.place(axesOfBody_.y));
    per_.s = stretched(axes_.place(body.u));
    reach_ = disc.radius + body.radius;
    if (body.turning != 0.0)
      for (const Outline::Side& side : body.outline->sides()) {
        bends_.push_back(bendOf(side.length));
        mostBend_ = std::max(mostBend_, bends_.back());
      }
  }

  Vec2 stretched(const Vec2& x) const { return x + beta_ * stretchAlong(x); }
  Vec2 shrunk(const Vec2& x) const { return x - beta_ * (stretchAlong(x) / ofDisc_.gamma); }
  const Vec2& velocity() const { return velocity_; }
  double radius() const { return disc_.radius; }
  double reach() const { return reach_; }
  const MovingShape& body() const { return body_; }

  /// The disc's centre at a time of the frame.
  Vec21 centreAt(double time) const {
    return disc_.start + disc_.u * ((time - ofDisc_.time) / ofDisc_.gamma);
  }
  /// The corners at a time of the frame, written to `places`.
  std::span<const Vec2> cornersAt(double time, Places& places) const {
    const std::span<const Vec2> corners = body_.outline->corners();
    const Vec2 start = startAt(time);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const AtTime point = pointAt(corners[k], time);
      places[k] = start + mapped(turned(corners[k], point.turn), point.s);
    }
    return {places.data(), corners.size()};
  }
  /// Where the body starts, from the disc's centre at a time of the frame.
  Vec2 startAt(double time) const { return stretched(axes_.place(body_.start - centreAt(time))); }
  /// A point of a side at a time of the frame: its place from the disc's centre, whose `start` is known, and
  /// the first two derivatives by its share. With w the offset from the body's centre in its axes, e half the
  /// side there, s the point's own time, and t = b + a·w + γ s for all points,
  ///     w' = e + Ω s' w⟂     w'' = 2 Ω s' e⟂ − (Ω s')² w + Ω s'' w⟂     s' = −a·e/t_s     s'' = −a·(…)/t_s
  OnSide onSide(std::size_t k, double share, double time, const Vec2& start) const {
    const Vec2 point = pointOn(body_.outline->corners(), k, share);
    const AtTime at = pointAt(point, time);
    const Vec2 w = turned(point, at.turn), e = turned(halfOf(body_.outline->corners(), k), at.turn);
    const double s1 = -glm::dot(along_, e) / at.slope, turn1 = body_.turning * s1;
    const Vec2 beside = across(e) * (2.0 * turn1) - w * (turn1 * turn1);
    const double s2 = -glm::dot(along_, beside) / at.slope;
    return {share, start + mapped(w, at.s), mapped(e + across(w) * turn1, s1),
            mapped(beside + across(w) * (body_.turning * s2), s2)};
  }
  /// How far beside its chord a side can be: an eighth of the greatest second derivative.
  double bend(std::size_t k) const { return bends_[k]; }
  double mostBend() const { return mostBend_; }
  FoundContact contact(double time, const Vec2& towards, const Vec2& touch, bool discIsFirst) const {
    const Vec2 normal = stretched(towards), place = shrunk(touch);
    const Vec21 n = axes_(normal);
    return {time, centreAt(time) + axes_(place), discIsFirst ? n : n * -1.0};
  }
  /// The disc's centre at a time of the frame, in the axes that turn with the body.
  Vec2 centreInBody(double time) const {
    const Vec21 apart = centreAt(time) - body_.start;
    const double angle = body_.angle + body_.turning * dot(body_.u, apart);
    return turnedBack(axesOfBody_.place(apart), portableSinCos(angle));
  }
  /// The same bodies at an earlier contact, since which they have not parted, and its time there.
  void remember(const StretchedFrame& earlier, double time) { cameFrom_ = earlier.centreInBody(time); }
  /// The side by which the centre has come into the body or through it since.
  std::optional<std::size_t> entrance(double time) const {
    if (!cameFrom_) return std::nullopt;
    return body_.outline->entranceOf(*cameFrom_, centreInBody(time));
  }
  bool isInside(double time) const { return body_.outline->clearanceOf(centreInBody(time)).outside <= 0.0; }
  PenetrationState penetration(double time) const {
    if (!entrance(time)) return PenetrationState::apart;
    return isInside(time) ? PenetrationState::inside : PenetrationState::through;
  }
  /// How fast the gap can close.
  double fastest() const {
    const double ofBody = std::sqrt(std::max(0.0, 1.0 - 1.0 / (ofBody_.gamma * ofBody_.gamma)));
    const double turning = std::abs(body_.turning) * body_.radius;
    return ofDisc_.gamma * (std::min(1.0, ofBody + turning) + glm::length(beta_));
  }
  /// From when to when the tubes around both overlap.
  std::array<double, 2> overlapTimes() const {
    const Vec21 d = body_.start - disc_.start;
    const Vec2 v = axes_.place(body_.u) / ofBody_.gamma - beta_;
    // Apart at the time 0 of the frame.
    const Vec2 apart =
        axes_.place(d) - axes_.place(body_.u) * (ofBody_.time / ofBody_.gamma) + beta_ * ofDisc_.time;
    const double v2 = glm::dot(v, v), half = glm::dot(apart, v),
                 far2 = glm::dot(apart, apart) - reach_ * reach_;
    if (!(v2 > 0.0)) return far2 > 0.0 ? std::array{kNever, -kNever} : std::array{-kNever, kNever};
    const double root2 = half * half - v2 * far2;
    if (root2 < 0.0) return {kNever, -kNever};
    return {(-half - std::sqrt(root2)) / v2, (-half + std::sqrt(root2)) / v2};
  }

 private:
  double stretchAlong(const Vec2& x) const {
    // (γ − 1)/β² = γ²/(γ + 1)
    return glm::dot(x, beta_) * (ofDisc_.gamma * ofDisc_.gamma / (ofDisc_.gamma + 1.0));
  }
  static Vec2 across(const Vec2& x) { return {-x.y, x.x}; }
  Vec2 mapped(const Vec2& w, double s) const { return per_.x * w.x + per_.y * w.y + per_.s * s; }
  /// A point of the body at a time t of the frame: its own time s, the turn of the body there, and dt/ds.
  struct AtTime {
    double s;
    SinCos turn;
    double slope;
  };
  /// Newton's steps. From the last one on, which is short, the turn is continued: with its square, below
  /// rounding.
  AtTime pointAt(const Vec2& point, double time) const {
    constexpr double kShort = 1e-8;
    AtTime at{(time - ofBody_.time) / ofBody_.gamma, {}, ofBody_.gamma};
    for (int step = 0; step < 60; ++step) {
      at.turn = portableSinCos(body_.angle + body_.turning * at.s);
      const Vec2 offset = turned(point, at.turn);
      const double late = ofBody_.time + glm::dot(along_, offset) + ofBody_.gamma * at.s - time;
      at.slope = ofBody_.gamma + body_.turning * glm::dot(along_, across(offset));
      const double by = -late / at.slope, angle = body_.turning * by;
      at.s += by;
      if (std::abs(angle) > kShort) continue;
      const SinCos& turn = at.turn;
      at.turn = {turn.sin + turn.cos * angle, turn.cos - turn.sin * angle};
      break;
    }
    return at;
  }
  double bendOf(double length) const {
    const double turning = std::abs(body_.turning), f = turning * body_.radius, a = glm::length(along_);
    const double slope = ofBody_.gamma - f * a;
    const double turn1 = turning * a * length / slope;
    const double beside = 2.0 * turn1 * length + turn1 * turn1 * body_.radius;
    return 0.125 * ofDisc_.gamma * beside * (1.0 + f * a / slope);
  }

  const MovingShape &disc_, &body_;
  RestAxes axes_, axesOfBody_;
  struct Start {
    double time, gamma;
  } ofDisc_, ofBody_;  // the time of the frame at which each starts, and its γ there
  Vec2 along_;
  Vec2 beta_, velocity_;
  struct Mapping {
    Vec2 x, y, s;
  } per_;  // of offsets in the body's axes and of its own time
  std::vector<double> bends_;
  double mostBend_ = 0.0;
  double reach_ = 0.0;
  std::optional<Vec2> cameFrom_;  // of the centre, in the axes that turn with the body
};

/// A point of an outline that is nearer to the circle's centre than its neighbours.
struct Nearest {
  double outside = kNever;  ///< of the centre; below 0 inside
  Vec2 towards{0.0};        ///< from the centre into the body
  std::size_t side = 0;
  double share = 0.0;  ///< of the side
};

Nearest nearestOf(std::span<const Vec2> corners) {
  double least2 = kNever, mostFront = 0.0;
  Nearest found;
  Vec2 nearest{0.0};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double share = std::clamp(shareNearest(corners, k), -1.0, 1.0);
    const Vec2 point = pointOn(corners, k, share), half = halfOf(corners, k);
    const double distance2 = glm::dot(point, point);
    const double front = (point.y * half.x - point.x * half.y) / glm::length(half);
    if (!isNearer(distance2, front, least2, mostFront)) continue;
    least2 = distance2;
    mostFront = front;
    nearest = point;
    found.side = k;
    found.share = share;
  }
  const bool atCorner = std::abs(found.share) >= 1.0;
  const bool inside =
      atCorner ? !turnsLeft(corners, found.share < 0.0 ? found.side : found.side + 1) : !(mostFront > 0.0);
  const double distance = std::sqrt(least2);
  found.outside = inside ? -distance : distance;
  found.towards = nearest * ((inside ? -1.0 : 1.0) / distance);
  if (!(distance > 0.0)) {
    const Vec2 way = halfOf(corners, found.side);
    found.outside = 0.0;
    found.towards = Vec2{-way.y, way.x} / glm::length(way);
  }
  return found;
}

// Newton's steps along the side, halved where they lead away.
OnSide nearestOnSide(const StretchedFrame& frame, std::size_t side, double share, double time,
                     const Vec2& start) {
  constexpr double kClose = 1e-4, kFound = 1e-14;  // of a side; steps below kClose lead on
  constexpr int kSteps = 32;
  OnSide here = frame.onSide(side, share, time, start);
  for (int step = 0; step < kSteps; ++step) {
    const double slope2 = glm::dot(here.slope, here.slope), bent = slope2 + glm::dot(here.place, here.curve);
    double by = -glm::dot(here.place, here.slope) / (bent > 0.25 * slope2 ? bent : slope2);
    const auto moved = [&] {
      return frame.onSide(side, std::clamp(here.share + by, -1.0, 1.0), time, start);
    };
    OnSide there = moved();
    const auto leadsAway = [&] {
      return std::abs(by) > kClose && glm::length(there.place) > glm::length(here.place);
    };
    while (leadsAway()) {
      by *= 0.5;
      there = moved();
    }
    const double way = std::abs(there.share - here.share);
    here = there;
    if (way < kFound) break;
  }
  return here;
}

// Of a centre that is inside: the point of the side by which it came in.
Nearest nearestOnEntrance(std::span<const Vec2> corners, std::size_t side) {
  const double share = std::clamp(shareNearest(corners, side), -1.0, 1.0);
  const Vec2 point = pointOn(corners, side, share);
  const double distance = glm::length(point);
  if (distance > 0.0) return {-distance, point * (-1.0 / distance), side, share};
  const Vec2 way = halfOf(corners, side);
  return {0.0, Vec2{-way.y, way.x} / glm::length(way), side, share};
}

// At a time, of a body that turns: its sides are not straight then, as their points are seen at different
// angles.
Nearest nearestOfTurning(const StretchedFrame& frame, double time, std::span<const Vec2> corners) {
  if (const auto entrance = frame.entrance(time); entrance && frame.isInside(time))
    return nearestOnEntrance(corners, *entrance);
  const Vec2 start = frame.startAt(time);
  Nearest found = nearestOf(corners);
  const double sign = found.outside < 0.0 ? -1.0 : 1.0;
  double least = kNever;
  const auto consider = [&](const Vec2& nearest, std::size_t k, double share) {
    const double distance = glm::length(nearest);
    if (!(distance > 0.0) || !(distance < least)) return;
    least = distance;
    found = {sign * distance, nearest * (sign / distance), k, share};
  };
  for (std::size_t k = 0; k < corners.size(); ++k) consider(corners[k], k, -1.0);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double share = std::clamp(shareNearest(corners, k), -1.0, 1.0);
    if (glm::length(pointOn(corners, k, share)) > least + frame.bend(k)) continue;
    const OnSide nearest = nearestOnSide(frame, k, share, time, start);
    consider(nearest.place, k, nearest.share);
  }
  return found;
}

// Those no farther than `reach`. A centre inside the outline has one, and none where it has come through it.
std::vector<Nearest> nearPoints(const StretchedFrame& frame, double time, double reach) {
  Places places;
  const std::span<const Vec2> corners = frame.cornersAt(time, places);
  if (const auto entrance = frame.entrance(time)) {
    if (!frame.isInside(time)) return {};
    return {nearestOnEntrance(corners, *entrance)};
  }
  const Nearest nearest = nearestOf(corners);
  if (!(nearest.outside <= reach)) return {};
  if (nearest.outside <= 0.0) return {nearest};
  std::vector<Nearest> points;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double share = shareNearest(corners, k);
    const bool atCorner =
        share <= -1.0 && shareNearest(corners, (k + corners.size() - 1) % corners.size()) >= 1.0;
    if (!(share > -1.0 && share < 1.0) && !atCorner) continue;
    const Vec2 point = pointOn(corners, k, std::max(share, -1.0));
    const double distance = glm::length(point);
    if (distance <= reach) points.push_back({distance, point / distance, k, std::max(share, -1.0)});
  }
  return points;
}

// Without spin the stretched corners move uniformly: the first side that the centre comes to be R outside of
// opposite one of its points, or the first corner that comes to be R away.
std::optional<FoundContact> touchStraight(const StretchedFrame& frame, const ContactWindow& window,
                                          bool discIsFirst) {
  Places places;
  const std::span<const Vec2> corners = frame.cornersAt(0.0, places);
  const Vec2& v = frame.velocity();
  const double R = frame.radius(), v2 = glm::dot(v, v);
  std::optional<FoundContact> best;
  const auto consider = [&](double time, const Vec2& towards) {
    if (best && !(time < best->time)) return;
    const FoundContact found = frame.contact(time, towards, towards * R, discIsFirst);
    if (window.holds(window.timeOf(found.event)) && !frame.entrance(time)) best = found;
  };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 &a = corners[k], middle = pointOn(corners, k, 0.0), side = halfOf(corners, k);
    const double length = glm::length(side);
    const Vec2 along = side / length, normal{along.y, -along.x};
    const double speed = glm::dot(normal, v);
    if (speed > 0.0) {
      const double time = (-glm::dot(normal, middle) - R) / speed;
      if (std::abs(glm::dot(middle + v * time, along)) <= length) consider(time, normal * -1.0);
    }
    const double half = glm::dot(a, v), root2 = half * half - v2 * (glm::dot(a, a) - R * R);
    if (v2 > 0.0 && root2 > 0.0) {
      const double time = (-half - std::sqrt(root2)) / v2;
      consider(time, (a + v * time) / R);
    }
  }
  return best;
}

// How far the rim is outside; less where it is far enough outside for the bends of the sides not to matter.
double gapAt(const StretchedFrame& frame, double time) {
  Places places;
  const std::span<const Vec2> corners = frame.cornersAt(time, places);
  const double R = frame.radius(), bend = frame.mostBend();
  const double byChords = nearestOf(corners).outside - bend - R;
  return byChords > bend ? byChords : nearestOfTurning(frame, time, corners).outside - R;
}

std::optional<FoundContact> touchTurning(const StretchedFrame& frame, const ContactWindow& window,
                                         bool discIsFirst, double start, double end) {
  const double R = frame.radius(), fastest = frame.fastest();
  if (!(fastest > 0.0)) return std::nullopt;
  AdvancingSteps steps(frame.reach(), fastest);
  double time = start, gap = gapAt(frame, time);
  bool inside = gap <= 0.0;
  const auto found = [&](double at, bool unfinished) {
    Places places;
    const Vec2 towards = nearestOfTurning(frame, at, frame.cornersAt(at, places)).towards;
    FoundContact contact = frame.contact(at, towards, towards * R, discIsFirst);
    contact.unfinished = unfinished;
    return contact;
  };
  bool behind = frame.penetration(time) == PenetrationState::through;  // then it touches nothing
  for (int step = 0; time < end; ++step) {
    if (step == kMostSteps) return found(time, true);
    const double next = time + steps.next(gap);
    const double there = gapAt(frame, next);
    double at = next;
    bool touches = inside && there <= 0.0 && there < gap - kLeastClosing * (next - time);  // deeper again
    if (!inside && there <= 0.0) {
      at = rootOfIncreasing([&](double t) { return -gapAt(frame, t); }, 0.5 * (time + next),
                            0.5 * (next - time));
      touches = true;
    }
    if (touches && !behind) {
      const FoundContact contact = found(at, false);
      if (window.holds(window.timeOf(contact.event)) && frame.penetration(at) != PenetrationState::through)
        return contact;
    }
    time = next;
    gap = there;
    inside = there <= 0.0;
    behind = frame.penetration(time) == PenetrationState::through;
  }
  return std::nullopt;
}

// The deepest point of those that go on.
std::optional<FoundContact> overlapNow(const StretchedFrame& frame, double time, bool discIsFirst) {
  const double R = frame.radius(), soon = kLeastStep * frame.reach();
  const std::vector<Nearest> points = nearPoints(frame, time, R + kCornerTouches * frame.reach());
  Places places;
  const std::span<const Vec2> then = frame.cornersAt(time + soon, places);
  const Nearest* deepest = nullptr;
  for (const Nearest& near : points) {
    const double outside = glm::dot(pointOn(then, near.side, near.share), near.towards);
    if (!((near.outside - outside) / soon > kLeastClosing)) continue;
    if (deepest == nullptr || near.outside < deepest->outside) deepest = &near;
  }
  if (deepest == nullptr) return std::nullopt;
  const Vec2& towards = deepest->towards;
  FoundContact found = frame.contact(time, towards, towards * R, discIsFirst);
  found.withoutDelay = true;
  return found;
}

StretchedFrame frameOf(const MovingShape& first, const MovingShape& second, const Vec21& U,
                       const PersistentContact* earlier) {
  const auto of = [](const MovingShape& one, const MovingShape& other, const Vec21& order) {
    const bool oneIsDisc = one.outline == nullptr;
    return StretchedFrame(oneIsDisc ? one : other, oneIsDisc ? other : one, one.start, order);
  };
  StretchedFrame frame = of(first, second, U);
  if (earlier == nullptr) return frame;
  const ContactWindow then = windowAt(*earlier);
  frame.remember(of(earlier->flights[0], earlier->flights[1], then.frame), then.from);
  return frame;
}

}  // namespace

std::optional<FoundContact> findRimContact(const MovingShape& first, const MovingShape& second,
                                           const Vec21& U, const ContactWindow& window,
                                           const PersistentContact* earlier) {
  const bool discIsFirst = first.outline == nullptr;
  StretchedFrame frame = frameOf(first, second, U, earlier);
  const MovingShape& body = frame.body();
  const auto [begin, end] = frame.overlapTimes();
  if (!(begin <= end)) return std::nullopt;
  if (window.strictly) {
    if (body.turning == 0.0) return touchStraight(frame, window, discIsFirst);
    // Board time 0 is not one time of this frame: from before it on, wherever they are near each other.
    const Vec21 apart = second.start - first.start;
    const double earliest = std::min(0.0, dot(U, apart)) - 4.0 * frame.reach() * U.t;
    return touchTurning(frame, window, discIsFirst, std::max(begin, earliest), end);
  }
  if (window.from > end) return std::nullopt;
  if (window.from >= begin && !window.resumed) {
    if (const auto overlap = overlapNow(frame, window.from, discIsFirst)) return overlap;
  }
  if (body.turning == 0.0) return touchStraight(frame, window, discIsFirst);
  return touchTurning(frame, window, discIsFirst, std::max(begin, window.from), end);
}

void addRimPlaces(const MovingShape& first, const MovingShape& second, const Vec21& U,
                  const ContactWindow& window, double within, const PersistentContact* earlier,
                  std::vector<FoundContact>& places) {
  const bool discIsFirst = first.outline == nullptr;
  StretchedFrame frame = frameOf(first, second, U, earlier);
  for (const Nearest& near : nearPoints(frame, window.from, frame.radius() + within)) {
    const Vec2& towards = near.towards;
    places.push_back(frame.contact(window.from, towards, towards * frame.radius(), discIsFirst));
  }
}

PenetrationState penetrationOfDisc(const MovingShape& first, const MovingShape& second, const Vec21& U,
                                   const ContactWindow& window, const PersistentContact& earlier) {
  return frameOf(first, second, U, &earlier).penetration(window.from);
}

}  // namespace carom
