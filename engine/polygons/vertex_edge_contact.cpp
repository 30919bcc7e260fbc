// A corner of one body pierces a side of the other.

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "engine/base/never.h"
#include "engine/base/root.h"
#include "engine/polygons/corner_search.h"
#include "engine/polygons/rest_axes.h"

namespace carom {

namespace {

using Vec2 = glm::dvec2;

constexpr double kDeeper = 1e-2;  // of the radii: so much deeper goes a corner that slides in the other body
constexpr double kFront = 0.1;    // the cosine of the angle between sides that look the same way
// Steps of the search for the parting: the first one, of the radii, over the speeds; how they grow; and how
// many.
constexpr double kPartingStep = 0.02, kPartingGrowth = 1.2;
constexpr int kPartingSteps = 30;
constexpr double kPassageTouches = 1e-6;  // of the radii: so far apart they have come out of each other
constexpr double kPassageStep = 1e-4;     // likewise: the least step in which a passage is followed
constexpr double kEnd = 1e-12;            // of a side's length: by so much it reaches beyond its corners

/// A quantity that is linear in the offset of a corner and in its own time.
struct Linear {
  double at0, perX, perY, perS;
  double operator()(const Vec2& offset, double s) const {
    return at0 + perX * offset.x + perY * offset.y + perS * s;
  }
};

/// Where a corner is in the axes that turn with b, and how these lie then.
struct Spot {
  Vec2 place;
  SinCos ofB;
};

/// A corner as it lies to b: `Outline::Clearance`, and whether it has come through b and is behind it.
struct CornerPosition {
  double outside;
  std::size_t side;
  bool through = false;
};

/// Corners of one body, a, as another, b, meets them.
class Corners {
 public:
  Corners(const MovingShape& a, const MovingShape& b, const Vec21& origin, const Vec21& U,
          const ContactWindow& window, bool aIsFirst)
      : a_(a), b_(b), window_(window), axesOfA_(a.u), axesOfB_(b.u), aIsFirst_(aIsFirst) {
    ofA_ = portableSinCos(a.angle);
    ofB_ = portableSinCos(b.angle);
    const Vec21 d = a.start - b.start;
    place_ = axesOfB_.place(d);
    perX_ = axesOfB_.place(axesOfA_.x);
    perY_ = axesOfB_.place(axesOfA_.y);
    perS_ = axesOfB_.place(a.u);
    ownTimeOfB_ = linear(b.u, d);
    time_ = linear(U, a.start - origin);
    windowTime_ = linear(window.frame, a.start - window.origin);
    size_ = a.radius + b.radius;
  }

  /// The same bodies at an earlier contact, since which they have not parted.
  void remember(const Corners& earlier, const PersistentContact& contact);
  /// Finds how the corners have come from there by `window.from`.
  void lookBack();
  PenetrationState penetration() const { return penetration_; }
  /// Of convex bodies, by the sides that have all corners of the other outside: one of which looks back to
  /// where the other was at the earlier contact, or only such as look away.
  PenetrationState penetrationOfConvex(bool haveBeenBehind) const;
  /// Whether a line across the normal of the earlier contact parts a from b, in front of b.
  bool isInFront() const;
  /// The widest gap between b's sides and a at `window.from`, below 0 if none parts them, and the cosine of
  /// the angle between that side's normal and the way out on which a was at the earlier contact.
  struct Gap {
    double width = -kNever, along = 1.0;
  };
  Gap gap() const;
  void setPenetration(PenetrationState of, bool behind) { penetration_ = of, behind_ = behind; }

  /// Bodies without spin: keeps the earliest piercing in `best`.
  void pierceStraight(std::optional<FoundContact>& best) const;
  /// Without spin: keeps the deepest corner that is inside b as both flights have begun, and goes deeper.
  void overlapStraight(double& deepest, std::optional<FoundContact>& best) const;
  /// Keeps the earliest contact in `best`; in the body, of several at once the deepest.
  void pierceTurning(double& deepest, std::optional<FoundContact>& best) const;
  /// Adds the corners that are inside b or nearer to it than `within` as both flights have begun.
  void addTouching(double within, std::vector<FoundContact>& places) const;

 private:
  Linear linear(const Vec21& of, const Vec21& from) const {
    return {dot(of, from), dot(of, axesOfA_.x), dot(of, axesOfA_.y), dot(of, a_.u)};
  }
  Vec2 placeOf(const Vec2& offset, double s) const {
    return place_ + perX_ * offset.x + perY_ * offset.y + perS_ * s;
  }
  FoundContact contact(const Vec2& offset, double s, const Vec2& normalInB) const {
    const Vec21 n = axesOfB_(normalInB);  // out of b
    return {time_(offset, s), a_.start + axesOfA_(offset) + a_.u * s, aIsFirst_ ? n * -1.0 : n};
  }
  double startOf(const Vec2& corner) const;
  Spot spotOf(const Vec2& corner, double s) const;
  CornerPosition positionOf(std::size_t corner, const Spot& spot) const;
  CornerPosition positionAt(std::size_t corner, double s) const {
    return positionOf(corner, spotOf(cornerOf(corner), s));
  }
  /// Likewise; a corner that has come in, or is through, as it lies to the side by which it came.
  CornerPosition keptOut(std::size_t corner, const Spot& spot) const;
  CornerPosition keptOutAt(std::size_t corner, double s) const {
    return keptOut(corner, spotOf(cornerOf(corner), s));
  }
  double outsideOf(std::size_t side, const Vec2& place) const {
    const Outline::Side& of = b_.outline->sides()[side];
    return glm::dot(of.normal, place) - of.offset;
  }
  double outsideOf(std::size_t side, std::size_t corner, double s) const {
    return outsideOf(side, spotOf(cornerOf(corner), s).place);
  }
  /// The side of b to which a corner that is known by its way belongs.
  std::optional<std::size_t> entranceOf(std::size_t corner, const Spot& spot) const;
  /// The way out of b on which a was at the earlier contact, in the axes that turn with b.
  Vec2 outwards(const Spot& spot) const { return turnedBack(outwards_, spot.ofB); }
  /// Whether what belongs to one side comes to another from behind.
  bool looksAway(std::size_t side, std::size_t entrance) const {
    const double along = glm::dot(b_.outline->sides()[side].normal, b_.outline->sides()[entrance].normal);
    return along < (behind_ ? kFront : -kSameNormal);
  }
  bool isKnownByItsWay(std::size_t corner) const {
    return behind_ || penetration_ == PenetrationState::through ||
           (penetration_ == PenetrationState::inside && hasEntered_[corner]);
  }
  const Vec2& cornerOf(std::size_t k) const { return a_.outline->corners()[k]; }
  FoundContact contactAt(const Vec2& corner, double s, std::size_t side) const;
  /// Where a search along a corner's way ends.
  struct SearchResult {
    double s;
    bool unfinished = false;
  };
  std::optional<SearchResult> advance(std::size_t corner, double s, double end, double before) const;

  const MovingShape &a_, &b_;
  const ContactWindow& window_;
  RestAxes axesOfA_, axesOfB_;
  SinCos ofA_, ofB_;  // of their angles as their flights begin
  bool aIsFirst_;
  Vec2 place_, perX_, perY_, perS_;
  Linear ownTimeOfB_, time_, windowTime_;
  double size_;
  // Of each corner at the earlier contact its place in the axes that turn with b; none without such a
  // contact.
  std::vector<Vec2> cameFrom_;
  std::vector<Spot> spots_;  // and at `window.from`
  std::vector<char> hasEntered_;
  Vec2 outwards_{0.0};
  bool behind_ = false;                                     // convex, and through each other since
  PenetrationState penetration_ = PenetrationState::apart;  // of all corners of both
};

void keepEarlier(std::optional<FoundContact>& best, const FoundContact& found) {
  if (!best || found.time < best->time) best = found;
}

// With b's angle turned into its axes, each side towards which the corners move is pierced at most once by
// each.
void Corners::pierceStraight(std::optional<FoundContact>& best) const {
  const Vec2 w = turnedBack(perS_, ofB_);
  struct Entry {
    Vec2 normal, along;
    double offset, perSpeed, from, length, drift;
    std::size_t side;
  };
  std::array<Entry, kMostCorners> entries;
  std::size_t count = 0;
  const std::span<const Outline::Side> sides = b_.outline->sides();
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const double speed = -glm::dot(sides[k].normal, w);
    if (!(speed > 0.0)) continue;
    const double beyond = kEnd * (sides[k].length + size_);
    entries[count++] = {sides[k].normal,
                        sides[k].along,
                        sides[k].offset,
                        1.0 / speed,
                        glm::dot(sides[k].along, sides[k].from) - beyond,
                        sides[k].length + 2.0 * beyond,
                        glm::dot(sides[k].along, w),
                        k};
  }
  double earliest = best ? best->time : kNever;
  for (std::size_t c = 0; c < a_.outline->corners().size(); ++c) {
    const Vec2 offset = turned(cornerOf(c), ofA_), z = turnedBack(placeOf(offset, 0.0), ofB_);
    const double time0 = time_(offset, 0.0), window0 = windowTime_(offset, 0.0);
    for (std::size_t k = 0; k < count; ++k) {
      const Entry& entry = entries[k];
      const double s = (glm::dot(entry.normal, z) - entry.offset) * entry.perSpeed;
      const double time = time0 + time_.perS * s;
      if (!(time < earliest)) continue;
      const double along = glm::dot(entry.along, z) + entry.drift * s - entry.from;
      if (!(along >= 0.0 && along <= entry.length)) continue;
      if (!window_.holds(window0 + windowTime_.perS * s)) continue;
      if (isKnownByItsWay(c)) {
        const auto entrance = entranceOf(c, {z + w * s, ofB_});
        if (entrance && looksAway(entry.side, *entrance)) continue;
      }
      earliest = time;
      best = contact(offset, s, turned(entry.normal, ofB_));
    }
  }
}

void Corners::overlapStraight(double& deepest, std::optional<FoundContact>& best) const {
  const Vec2 w = turnedBack(perS_, ofB_);
  for (std::size_t c = 0; c < a_.outline->corners().size(); ++c) {
    const Vec2 offset = turned(cornerOf(c), ofA_);
    const double s = (window_.from - windowTime_(offset, 0.0)) / windowTime_.perS;
    const CornerPosition there = keptOut(c, {turnedBack(placeOf(offset, s), ofB_), ofB_});
    if (there.through || !(there.outside <= kCornerTouches * size_) || !(there.outside < deepest)) continue;
    const Vec2& normal = b_.outline->sides()[there.side].normal;
    if (!(-glm::dot(normal, w) > kLeastClosing)) continue;
    deepest = there.outside;
    best = contact(offset, s, turned(normal, ofB_));
    best->withoutDelay = true;
  }
}

/// The own time from which on contacts of this corner count: Newton's steps, as its time grows with s.
double Corners::startOf(const Vec2& corner) const {
  double s = (window_.from - windowTime_.at0) / windowTime_.perS;
  for (int step = 0; step < 60; ++step) {
    const Vec2 offset = turned(corner, portableSinCos(a_.angle + a_.turning * s));
    const double slope =
        windowTime_.perS + a_.turning * (windowTime_.perY * offset.x - windowTime_.perX * offset.y);
    const double next = s - (windowTime_(offset, s) - window_.from) / slope;
    if (std::abs(next - s) <= 1e-15 * size_ || next == s) return next;
    s = next;
  }
  return s;
}

Spot Corners::spotOf(const Vec2& corner, double s) const {
  const Vec2 offset = turned(corner, a_.turning == 0.0 ? ofA_ : portableSinCos(a_.angle + a_.turning * s));
  const SinCos ofB =
      b_.turning == 0.0 ? ofB_ : portableSinCos(b_.angle + b_.turning * ownTimeOfB_(offset, s));
  return {turnedBack(placeOf(offset, s), ofB), ofB};
}

void Corners::remember(const Corners& earlier, const PersistentContact& contact) {
  for (const Vec2& corner : a_.outline->corners())
    cameFrom_.push_back(earlier.spotOf(corner, earlier.startOf(corner)).place);
  outwards_ = axesOfB_.place(contact.n) * (aIsFirst_ ? -1.0 : 1.0);
  outwards_ /= glm::length(outwards_);
}

void Corners::lookBack() {
  const std::size_t count = cameFrom_.size();
  spots_.clear(), hasEntered_.clear();
  penetration_ = PenetrationState::apart;
  for (std::size_t k = 0; k < count; ++k) {
    const Spot spot = spotOf(cornerOf(k), startOf(cornerOf(k)));
    spots_.push_back(spot);
    hasEntered_.push_back(b_.outline->entranceOf(cameFrom_[k], spot.place).has_value());
    if (!hasEntered_[k]) continue;
    const bool inside = b_.outline->clearanceOf(spot.place).outside <= 0.0;
    penetration_ = std::max(penetration_, inside ? PenetrationState::inside : PenetrationState::through);
  }
}

Corners::Gap Corners::gap() const {
  std::array<Spot, kMostCorners> spots;
  const std::size_t count = a_.outline->corners().size();
  for (std::size_t k = 0; k < count; ++k) spots[k] = spotOf(cornerOf(k), startOf(cornerOf(k)));
  Gap widest;
  for (const Outline::Side& side : b_.outline->sides()) {
    double least = kNever, along = 1.0;
    for (const Spot& spot : std::span(spots).first(count)) {
      const double outside = glm::dot(side.normal, spot.place) - side.offset;
      if (outside < least) {
        least = outside;
        along = glm::dot(side.normal, outwards(spot));
      }
    }
    if (least > widest.width) widest = {least, along};
  }
  return widest;
}

bool Corners::isInFront() const {
  return std::all_of(spots_.begin(), spots_.end(), [this](const Spot& spot) {
    const Vec2 front = outwards(spot);
    double farthest = -kNever;
    for (const Vec2& corner : b_.outline->corners()) farthest = std::max(farthest, glm::dot(corner, front));
    return glm::dot(spot.place, front) > farthest;
  });
}

PenetrationState Corners::penetrationOfConvex(bool haveBeenBehind) const {
  if (haveBeenBehind && isInFront()) return PenetrationState::apart;
  PenetrationState penetration = PenetrationState::inside;
  for (const Outline::Side& side : b_.outline->sides()) {
    double least = kNever, along = 1.0;
    bool isFar = false;
    for (const Spot& spot : spots_) {
      const double outside = glm::dot(side.normal, spot.place) - side.offset;
      if (!(outside < least)) continue;
      const Vec2 front = outwards(spot);
      least = outside;
      along = glm::dot(side.normal, front);
      isFar = glm::dot(spot.place, front) < -b_.radius;
    }
    if (!(least >= -kCornerTouches * size_)) continue;
    // A body far behind is outside of sides that are turned a little, too; one on its way back, of others.
    if (along > -kFront && !isFar && !haveBeenBehind) return PenetrationState::apart;
    penetration = PenetrationState::through;
  }
  return penetration;
}

// Bodies that have come through each other are free to turn there. They belong where they were on the board.
std::optional<std::size_t> Corners::entranceOf(std::size_t corner, const Spot& spot) const {
  if (!behind_) return b_.outline->entranceOf(cameFrom_[corner], spot.place);
  const Vec2 front = outwards(spot);
  const std::span<const Outline::Side> sides = b_.outline->sides();
  std::size_t entrance = 0;
  for (std::size_t k = 1; k < sides.size(); ++k)
    if (glm::dot(sides[k].normal, front) > glm::dot(sides[entrance].normal, front)) entrance = k;
  return entrance;
}

CornerPosition Corners::positionOf(std::size_t corner, const Spot& spot) const {
  const Outline::Clearance there = b_.outline->clearanceOf(spot.place);
  const CornerPosition nearest{there.outside, there.side};
  if (!isKnownByItsWay(corner)) return nearest;
  const auto entrance = entranceOf(corner, spot);
  if (!entrance) return nearest;
  const bool away = looksAway(there.side, *entrance);
  if (there.outside > 0.0) return {there.outside, there.side, away || !behind_};
  if (!away) return nearest;
  const Outline::Side& side = b_.outline->sides()[*entrance];
  return {glm::dot(side.normal, spot.place) - side.offset, *entrance};
}

CornerPosition Corners::keptOut(std::size_t corner, const Spot& spot) const {
  if (penetration_ != PenetrationState::apart && hasEntered_[corner]) {
    const auto entrance = entranceOf(corner, spot);
    if (entrance) return {outsideOf(*entrance, spot.place), *entrance};
  }
  return positionOf(corner, spot);
}

FoundContact Corners::contactAt(const Vec2& corner, double s, std::size_t side) const {
  const Vec2 offset = turned(corner, portableSinCos(a_.angle + a_.turning * s));
  const double angle = b_.angle + b_.turning * ownTimeOfB_(offset, s);
  return contact(offset, s, turned(b_.outline->sides()[side].normal, portableSinCos(angle)));
}

/// The own time at which a corner is outside no more, or goes deeper, from s on and no later than `end` and,
/// in the frame of U, `before`.
std::optional<Corners::SearchResult> Corners::advance(std::size_t corner, double s, double end,
                                                      double before) const {
  const double gamma = ownTimeOfB_.perS, beta = glm::length(perS_) / gamma;
  const double ofA = std::abs(a_.turning) * a_.radius, ofB = std::abs(b_.turning) * b_.radius;
  const double fastest = gamma * (1.0 + beta * ofA) * (std::min(1.0, beta + ofA) + ofB);
  if (!(fastest > 0.0)) return std::nullopt;
  AdvancingSteps steps(size_, fastest);
  const double latest =
      (before - time_.at0 + size_ * (std::abs(time_.perX) + std::abs(time_.perY))) / time_.perS;
  const double last = std::min(end, latest);
  CornerPosition here = positionAt(corner, s);
  double shallowest = here.outside;
  for (int step = 0; s < last; ++step) {
    if (step == kMostSteps) return SearchResult{s, true};
    const bool inside = here.outside <= 0.0;
    const bool slides = inside && isKnownByItsWay(corner);
    const double next = s + (slides ? 0.5 * kDeeper * size_ / fastest : steps.next(here.outside));
    const CornerPosition there = positionAt(corner, next);
    const bool comparable = there.side == here.side || !isKnownByItsWay(corner);
    shallowest = inside && comparable ? std::max(shallowest, there.outside) : there.outside;
    const double slack = isKnownByItsWay(corner) ? kDeeper * size_ : kLeastClosing * (next - s);
    if (inside && comparable && !window_.onlyNew && there.outside <= 0.0 && there.outside < here.outside &&
        there.outside < shallowest - slack)
      return SearchResult{next};  // deeper again
    if (!inside && there.outside <= 0.0 && !here.through) {
      const auto depth = [&](double at) { return -positionAt(corner, at).outside; };
      return SearchResult{rootOfIncreasing(depth, 0.5 * (s + next), 0.5 * (next - s))};
    }
    s = next;
    here = there;
  }
  return std::nullopt;
}

void Corners::pierceTurning(double& deepest, std::optional<FoundContact>& best) const {
  // Where the tubes around both overlap, by a's own time; a corner's events at that time are up to βR beside.
  const double speed2 = glm::dot(perS_, perS_), half = glm::dot(place_, perS_);
  const double apart2 = glm::dot(place_, place_) - size_ * size_;
  const double root2 = half * half - speed2 * apart2;
  double begin = -kNever, end = kNever;
  if (speed2 > 0.0) {
    if (root2 < 0.0 && penetration_ == PenetrationState::apart) return;
    const double margin = std::sqrt(speed2) / ownTimeOfB_.perS * a_.radius;
    const double root = std::sqrt(std::max(0.0, root2));
    begin = (-half - root) / speed2 - margin;
    end = (-half + root) / speed2 + margin;
  } else if (apart2 > 0.0 && penetration_ == PenetrationState::apart) {
    return;
  }
  for (std::size_t c = 0; c < a_.outline->corners().size(); ++c) {
    const Vec2& corner = cornerOf(c);
    const double start = startOf(corner);
    const bool entered = penetration_ != PenetrationState::apart && hasEntered_[c];
    if (start > end && !entered) continue;
    double s = entered ? start : std::max(begin, start);
    if (s == start && !window_.strictly && !window_.resumed) {
      const CornerPosition there = keptOutAt(c, s);
      const double soon = kLeastStep * size_;
      if (!there.through && there.outside <= kCornerTouches * size_) {
        const double later = entered ? outsideOf(there.side, c, s + soon) : positionAt(c, s + soon).outside;
        const double closing = (there.outside - later) / soon;
        if (closing > kLeastClosing) {
          if (!(there.outside < deepest)) continue;
          deepest = there.outside;
          best = contactAt(corner, s, there.side);
          best->withoutDelay = true;
          continue;
        }
        s += soon;
      }
    }
    if (best && best->withoutDelay) continue;
    const std::optional<SearchResult> found = advance(c, s, end, best ? best->time : kNever);
    if (!found) continue;
    FoundContact contact = contactAt(corner, found->s, positionAt(c, found->s).side);
    contact.unfinished = found->unfinished;
    keepEarlier(best, contact);
  }
}

void Corners::addTouching(double within, std::vector<FoundContact>& places) const {
  for (std::size_t c = 0; c < a_.outline->corners().size(); ++c) {
    const double s = startOf(cornerOf(c));
    const CornerPosition there = keptOutAt(c, s);
    if (!there.through && there.outside <= within) places.push_back(contactAt(cornerOf(c), s, there.side));
  }
}

/// The corners of both.
struct BothCorners {
  Corners ofFirst, ofSecond;

  BothCorners(const MovingShape& first, const MovingShape& second, const Vec21& U,
              const ContactWindow& window, const PersistentContact* earlier)
      : ofFirst(first, second, first.start, U, window, true),
        ofSecond(second, first, first.start, U, window, false) {
    if (earlier == nullptr) return;
    const auto& [one, other] = earlier->flights;
    const ContactWindow then = windowAt(*earlier);
    ofFirst.remember({one, other, one.start, then.frame, then, true}, *earlier);
    ofSecond.remember({other, one, one.start, then.frame, then, false}, *earlier);
    lookBack(first.outline->isConvex() && second.outline->isConvex(), earlier->behind);
  }

  /// Finds how the two have come from the earlier contact by `window.from`.
  void lookBack(bool convex, bool haveBeenBehind) {
    ofFirst.lookBack(), ofSecond.lookBack();
    PenetrationState penetration = std::max(ofFirst.penetration(), ofSecond.penetration());
    if (convex && (penetration != PenetrationState::apart || haveBeenBehind)) {
      const PenetrationState bySecond = ofFirst.penetrationOfConvex(haveBeenBehind),
                             byFirst = ofSecond.penetrationOfConvex(haveBeenBehind);
      const bool apart = bySecond == PenetrationState::apart || byFirst == PenetrationState::apart;
      penetration = apart ? PenetrationState::apart : std::max(bySecond, byFirst);
    }
    const bool behind = convex && penetration != PenetrationState::apart;
    ofFirst.setPenetration(penetration, behind), ofSecond.setPenetration(penetration, behind);
  }
};

// The centres are no farther apart than R1 + R2 as the later flight begins.
bool mayOverlap(const MovingShape& first, const MovingShape& second, const Vec21& U, double from) {
  const auto placeAt = [&](const MovingShape& flight) {
    return flight.start + flight.u * ((from - dot(U, flight.start - first.start)) / dot(U, flight.u));
  };
  const Vec21 apart = placeAt(second) - placeAt(first);
  const double reach = (first.radius + second.radius) * (1.0 + kCornerTouches);
  return -dot(apart, apart) <= reach * reach;
}

}  // namespace

std::optional<FoundContact> findPiercing(const MovingShape& first, const MovingShape& second, const Vec21& U,
                                         const ContactWindow& window, const PersistentContact* earlier) {
  const auto [ofFirst, ofSecond] = BothCorners(first, second, U, window, earlier);
  std::optional<FoundContact> best;
  double deepest = kNever;
  if (first.turning != 0.0 || second.turning != 0.0) {
    ofFirst.pierceTurning(deepest, best);
    ofSecond.pierceTurning(deepest, best);
    return best;
  }
  const bool come = ofFirst.penetration() != PenetrationState::apart;
  if (!window.strictly && !window.resumed && (come || mayOverlap(first, second, U, window.from))) {
    ofFirst.overlapStraight(deepest, best);
    ofSecond.overlapStraight(deepest, best);
  }
  if (!best) {
    ofFirst.pierceStraight(best);
    ofSecond.pierceStraight(best);
  }
  if (best) settleSimultaneous(first, second, U, *best);
  return best;
}

void addPiercedPlaces(const MovingShape& first, const MovingShape& second, const Vec21& U,
                      const ContactWindow& window, double within, const PersistentContact* earlier,
                      std::vector<FoundContact>& places) {
  const BothCorners corners(first, second, U, window, earlier);
  corners.ofFirst.addTouching(within, places);
  corners.ofSecond.addTouching(within, places);
}

PenetrationState penetrationOfCorners(const MovingShape& first, const MovingShape& second, const Vec21& U,
                                      const ContactWindow& window, const PersistentContact& earlier) {
  return BothCorners(first, second, U, window, &earlier).ofFirst.penetration();
}

void followPassage(const MovingShape& first, const MovingShape& second, const PersistentContact& earlier,
                   double until, Passage& passage) {
  ContactWindow now = windowAt(earlier);
  now.from = std::max({now.from, now.timeOf(first.start), now.timeOf(second.start)});
  const double size = first.radius + second.radius;
  // Of the gap, in its body's axes: a corner comes at less than light speed, and dτ/dt < 2γ at its events.
  const double fastest =
      2.0 * std::max(dot(now.frame, first.u), dot(now.frame, second.u)) *
      (1.0 + std::abs(first.turning) * first.radius + std::abs(second.turning) * second.radius);
  const BothCorners corners(first, second, now.frame, now, &earlier);
  for (int steps = 0; steps == 0 || (steps < kMostSteps && now.from < until); ++steps) {
    if (passage.isOver()) return;
    const auto bySecond = corners.ofFirst.gap(), byFirst = corners.ofSecond.gap();
    const auto& widest = bySecond.width > byFirst.width ? bySecond : byFirst;
    const bool apart = widest.width > kPassageTouches * size;
    if (passage.overlapping && apart) {
      passage.elsewhere = widest.along < 0.0;
      passage.leastAlong = std::min(passage.leastAlong, widest.along);
    }
    passage.overlapping = !apart;
    now.from += std::max(std::abs(widest.width), kPassageStep * size) / fastest;
  }
}

double partingOfCorners(const MovingShape& first, const MovingShape& second, const Vec21& U,
                        const ContactWindow& window, const PersistentContact& earlier, double until) {
  const double size = first.radius + second.radius, sum = dot(first.u, second.u);
  const double fastest = std::sqrt(2.0 * std::max(0.0, sum - 1.0) / (sum + 1.0)) +
                         std::abs(first.turning) * first.radius + std::abs(second.turning) * second.radius;
  double step = kPartingStep * size / fastest;
  if (!(step < kNever)) return kNever;
  ContactWindow then = window;
  then.strictly = false;
  const bool convex = first.outline->isConvex() && second.outline->isConvex();
  BothCorners corners(first, second, U, then, &earlier);
  if (corners.ofFirst.penetration() == PenetrationState::apart) return kNever;
  for (int steps = 0; steps < kPartingSteps && then.from < until; ++steps, step *= kPartingGrowth) {
    then.from += step;
    corners.lookBack(convex, earlier.behind);
    if (corners.ofFirst.penetration() == PenetrationState::apart) return then.from;
  }
  return kNever;
}

}  // namespace carom
