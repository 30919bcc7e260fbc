// How bodies with corners enter the game: their flights, contacts and kicks. A game of discs never comes
// here.

#include <algorithm>
#include <cmath>

#include "engine/billiard/collision_scheduler.h"
#include "engine/collision/corner_cushion.h"

namespace carom {

namespace {

constexpr int kKicksOfAnImpact = 16;  // at places where bodies lie on each other when they meet at another
constexpr int kJamsToRest = 64;       // without peace, after which a body moves on with what it touches

}  // namespace

void CollisionScheduler::takeOutlines(const BilliardSetup& setup) {
  std::vector<std::optional<Outline>> outlines(pucks_.size());
  bool any = false;
  for (std::size_t i = 0; i < pucks_.size(); ++i) {
    const std::vector<Vec2>& corners = setup.pucks[pucks_[i].file].outline_m;
    if (corners.empty()) continue;
    outlines[i].emplace(corners);
    any = true;
  }
  if (!any) return;
  outlines_ = std::make_shared<const std::vector<std::optional<Outline>>>(std::move(outlines));
  turns_ = canPress_ = true;
}

MovingShape CollisionScheduler::movingShape(int i, const Leg& leg, const Turning& turning) const {
  const double radius = discs_[i].radius;
  return {leg.start, leg.u, radius, outlineOf(i), turning.angle, rimBeta(spins_[i].body, turning.j) / radius};
}

std::optional<CornerContact> CollisionScheduler::cornersMeet(int first, int second) const {
  const HandledContact* const last = dealtWith(first, second);
  const bool waits = !pucks_[first].decided.empty() || !pucks_[second].decided.empty();
  return findCornerContact(followedFlight(first), followedFlight(second),
                           last == nullptr ? -kNever : last->until, persistentContact(first, second), waits);
}

const PersistentContact* CollisionScheduler::persistentContact(int first, int second) const {
  const std::vector<PersistentPartner>& partners = pucks_[first].partners;
  const auto found = std::find_if(partners.begin(), partners.end(),
                                  [second](const PersistentPartner& one) { return one.other == second; });
  return found == partners.end() ? nullptr : &found->contact;
}

// On the legs that both follow.
void CollisionScheduler::notePersistentPair(const std::array<int, 2>& who, const PairContact& contact) {
  const PersistentContact now{{followedFlight(who[0]), followedFlight(who[1])}, contact.event, contact.n};
  const std::array<unsigned, 2> legs{predictions_[who[0]].legNumber, predictions_[who[1]].legNumber};
  if (const PersistentContact* const earlier = persistentContact(who[0], who[1])) {
    const double time = dot(contact.U, contact.event - now.flights[0].start);
    if (!haveOutlines(who[0], who[1]) ||
        penetrationSince(*earlier, now.flights[0], now.flights[1], time) != PenetrationState::apart)
      return;
    for (int k = 0; k < 2; ++k)
      std::erase_if(pucks_[who[k]].partners,
                    [&](const PersistentPartner& one) { return one.other == who[1 - k]; });
  }
  for (int k = 0; k < 2; ++k) pucks_[who[k]].partners.push_back({who[1 - k], now, legs});
}

// A pair is looked at once on each pair of legs.
void CollisionScheduler::forgetParted(int i) {
  std::erase_if(pucks_[i].partners, [&](PersistentPartner& one) {
    const int first = std::min(i, one.other), second = std::max(i, one.other);
    const std::array<unsigned, 2> legs{predictions_[first].legNumber, predictions_[second].legNumber};
    if (legs == one.legs) return false;
    std::vector<PersistentPartner>& theirs = pucks_[one.other].partners;
    const auto same =
        std::find_if(theirs.begin(), theirs.end(), [i](const PersistentPartner& x) { return x.other == i; });
    const bool parted = haveParted(first, second, one.contact);
    same->contact.behind = one.contact.behind;
    one.legs = same->legs = legs;
    if (parted) theirs.erase(same);
    return parted;
  });
}

// Those that something else has turned while they were behind each other stay there.
bool CollisionScheduler::haveParted(int first, int second, PersistentContact& earlier) const {
  const MovingShape one = followedFlight(first), other = followedFlight(second);
  const Vec21 U = equalSpeedFrame(one.u, other.u);
  const double since = std::max(dot(U, one.start - earlier.event), dot(U, other.start - earlier.event));
  if (!(since > 0.0)) return false;
  const PenetrationState penetration = penetrationSince(earlier, one, other);
  earlier.behind = earlier.behind || penetration == PenetrationState::through;
  const bool undisturbed =
      predictions_[first].lastPartner == second && predictions_[second].lastPartner == first;
  return penetration == PenetrationState::apart || (penetration == PenetrationState::through && !undisturbed);
}

std::vector<CollisionScheduler::CurrentLeg> CollisionScheduler::currentLegs() const {
  std::vector<CurrentLeg> all(pucks_.size());
  for (std::size_t i = 0; i < pucks_.size(); ++i)
    all[pucks_[i].file] = {discs_[i].start.t, discs_[i].u, !pucks_[i].decided.empty()};
  return all;
}

std::vector<CollisionScheduler::PersistentPair> CollisionScheduler::persistentPairs() const {
  std::vector<PersistentPair> pairs;
  for (std::size_t i = 0; i < pucks_.size(); ++i) {
    const int first = static_cast<int>(i);
    for (const PersistentPartner& one : pucks_[i].partners) {
      if (one.other < first) continue;
      pairs.push_back({{pucks_[i].file, pucks_[static_cast<std::size_t>(one.other)].file}, one.contact});
    }
  }
  return pairs;
}

// Bodies that lie on each other at several places and recede at that of the contact: takes the one at which
// they approach fastest. Returns whether there is one.
bool CollisionScheduler::approachElsewhere(const std::array<int, 2>& who, const PredictedEvent& a,
                                           PairContact& contact) const {
  if (!a.withoutDelay) return false;
  const std::array<Vec21, 2> u{lastLeg(who[0]).u, lastLeg(who[1]).u};
  const std::array<double, 2> j{lastTurning(who[0]).j, lastTurning(who[1]).j};
  const double radii = discs_[who[0]].radius + discs_[who[1]].radius;
  double fastest = kResting;
  for (const TouchedPlace& place : touchedPlaces(followedFlight(who[0]), followedFlight(who[1]),
                                                 kJamTouching * radii, persistentContact(who[0], who[1]))) {
    PairContact here = contact;
    here.event = place.event, here.n = place.n;
    const auto kick = cornerKick(who, here, u, j, 1.0);
    if (!kick || !(kick->centres.closing > fastest)) continue;
    fastest = kick->centres.closing;
    contact = here;
  }
  return fastest > kResting;
}

// Bodies that have not parted lie in each other at other places as well: until they recede at all of them by
// the momenta that are decided, the impact goes on there.
void CollisionScheduler::kickOtherPlaces(const std::array<int, 2>& who, const PairContact& contact,
                                         PairOutcome& outcome) const {
  const PersistentContact* const earlier = persistentContact(who[0], who[1]);
  if (earlier == nullptr || !haveOutlines(who[0], who[1])) return;
  const MovingShape first = followedFlight(who[0]), second = followedFlight(who[1]);
  std::vector<TouchedPlace> places =
      placesKeptOut(first, second, dot(contact.U, contact.event - first.start), *earlier);
  places.push_back({contact.event, contact.n});
  const double e = std::max(kJamRebound, outcome.restitution);
  for (int kicks = 0; kicks < kKicksOfAnImpact; ++kicks) {
    double fastest = kResting;
    std::optional<SpinningPairKick> next;
    SpinningPairKick& kick = outcome.kick;
    for (const TouchedPlace& place : places) {
      PairContact here = contact;
      here.event = place.event, here.n = place.n;
      const auto found = cornerKick(who, here, kick.centres.u, kick.j, e);
      if (found && found->centres.closing > fastest) fastest = found->centres.closing, next = found;
    }
    if (!next) return;
    outcome.add(*next);
  }
}

// Light tells the centres late. Bodies that have gone through each other by then, and would part for good on
// another side than that on which they touch, give each other one more kick along their impulse. It comes
// with the same signal.
void CollisionScheduler::sendBack(const std::array<int, 2>& who, const PairContact& contact,
                                  const std::array<LegState, 2>& turn, PairOutcome& outcome) const {
  if (!haveOutlines(who[0], who[1])) return;
  std::array<std::vector<MovingShape>, 2> flights;
  for (int k = 0; k < 2; ++k) {
    const int i = who[k];
    flights[k].push_back(followedFlight(i));
    for (const CommittedLeg& decided : pucks_[i].decided)
      flights[k].push_back(movingShape(i, decided.leg, decided.turning));
    const Turning turning = turningAt(i, turn[k].properTime);
    const Leg leg{turn[k].x, outcome.kick.centres.u[k], turn[k].properTime, brake_};
    flights[k].push_back(movingShape(i, leg, {outcome.kick.j[k], turning.angle}));
  }
  if (!partElsewhere(flights, *persistentContact(who[0], who[1]))) return;
  PairContact central = contact;
  central.n = outcome.kick.centres.u[1] - turn[1].u;
  central.n = central.n - contact.U * dot(contact.U, central.n);
  central.central = true;
  const auto kick = cornerKick(who, central, outcome.kick.centres.u, outcome.kick.j, outcome.restitution);
  if (kick && kick->centres.closing > kResting) outcome.add(*kick);
}

// The contact of a leg with a cushion.
std::optional<CushionContact> CollisionScheduler::touchOf(int i, const Leg& leg, const Turning& turning,
                                                          int cushion) const {
  if (outlineOf(i) == nullptr) return findContact(leg, discs_[i].radius, cushions_[cushion], convention_);
  const auto found =
      findCornerContact(movingShape(i, leg, turning), leg.properTime, cushions_[cushion], convention_);
  if (!found) return std::nullopt;
  return found->contact;
}

// Of the leg being followed.
std::optional<CushionContact> CollisionScheduler::followedTouchOf(int i, int cushion) const {
  return touchOf(i, legOf(i), spins_[i].turning, cushion);
}

// Whether what the body is as it turns goes towards the cushion.
bool CollisionScheduler::isKickedBy(int i, int cushion, const CushionContact& contact) const {
  if (outlineOf(i) == nullptr) return cushions_[cushion].towards(contact.turn.u) > 0.0;
  const double j = turningAt(i, contact.turn.properTime).j;
  return cushionKick(i, cushion, contact.event, contact.turn, j, 1.0).has_value();
}

// With two corners at once.
bool CollisionScheduler::liesOnCushion(int i, int cushion, const CushionContact& contact) const {
  if (outlineOf(i) == nullptr || contact.withoutDelay) return false;
  const auto found = findCornerContact(movingShape(i, legOf(i), spins_[i].turning), pucks_[i].properTime,
                                       cushions_[cushion], convention_);
  return found && found->sideOnSide;
}

// The lever from the centre to the contact, simultaneous in the body's own frame.
LeveredBody CollisionScheduler::levered(int i, const Vec21& touch, const LegState& at, double j) const {
  const Vec21 way = touch - at.x;
  return {{spins_[i].body, j, at.u}, discs_[i].radius, way - at.u * dot(at.u, way)};
}

// With the levers on the legs being followed, on which the contact was found.
std::optional<SpinningPairKick> CollisionScheduler::cornerKick(const std::array<int, 2>& who,
                                                               const PairContact& contact,
                                                               const std::array<Vec21, 2>& u,
                                                               const std::array<double, 2>& j,
                                                               double restitution) const {
  std::array<LeveredBody, 2> bodies;
  for (int k = 0; k < 2; ++k) {
    const Disc& flight = discs_[who[k]];
    bodies[k] = levered(who[k], contact.event, {flight.start, flight.u, 0.0}, j[k]);
    if (contact.central) bodies[k].lever = {};
    bodies[k].puck.u = u[k];
  }
  RimRules rules = puckRims_;
  rules.restitution = restitution;
  return kickCorners(contact.U, contact.n, bodies, rules);
}

std::vector<TouchedPlace> CollisionScheduler::placesOf(const JamBody& one, const JamBody& other) const {
  if (other.puck < one.puck) return placesOf(other, one);
  const MovingShape first = one.shape(), second = other.shape();
  return touchedPlaces(first, second, kJamTouching * (first.radius + second.radius),
                       persistentContact(one.puck, other.puck));
}

// Bodies with corners that lie on each other or on a cushion would be kicked at one place after the other,
// each kick sending others together. All such kicks are taken at once. Returns whether there are any.
bool CollisionScheduler::settleCorners(std::span<const int> who, std::span<const LegState> turn,
                                       const Vec21& touch, const Vec21& U, GameHistory& history) {
  jamBodies_.clear();
  double earliest = kNever, hardest = 0.0;
  for (std::size_t k = 0; k < who.size(); ++k) {
    jamBodies_.push_back(jamBodyOf(who[k], turn[k]));
    earliest = std::min(earliest, turn[k].x.t);
    hardest = std::max(hardest, pucks_[who[k]].hardestImpact);
  }
  gatherJam(U, earliest);
  const double slow = slowIn(who, hardest);
  const bool again = pucks_[who[0]].jams >= kJamsToRest;
  JamSolver solver = jamSolver();
  solver.moveOnTogether(solver.relax(0.125 * slow) && !again ? slow : kNever);
  return commitJam(touch, history);
}

}  // namespace carom
