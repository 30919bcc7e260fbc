// How bodies with corners enter the game: their flights, contacts and kicks. A game of discs never comes here.

#include <algorithm>
#include <cmath>

#include "engine/billiard/collision_scheduler.h"
#include "engine/collision/corner_cushion.h"

namespace carom {

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
  turns_ = true;
}

ShapedFlight CollisionScheduler::shapedFlight(int i, const Leg& leg, const Turning& turning) const {
  const double radius = discs_[i].radius;
  return {leg.start, leg.u, radius, outlineOf(i), turning.angle, rimBeta(spins_[i].body, turning.j) / radius};
}

std::optional<CornerContact> CollisionScheduler::cornersMeet(int first, int second) const {
  return findCornerContact(shapedFlight(first, flightOf(first), spins_[first].turning),
                           shapedFlight(second, flightOf(second), spins_[second].turning));
}

// The contact of a leg with a cushion.
std::optional<CushionContact> CollisionScheduler::touchOf(int i, const Leg& leg, const Turning& turning,
                                                          int cushion) const {
  if (outlineOf(i) == nullptr) return findContact(leg, discs_[i].radius, cushions_[cushion], convention_);
  const auto found =
      findCornerContact(shapedFlight(i, leg, turning), leg.properTime, cushions_[cushion], convention_);
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
  const auto found = findCornerContact(shapedFlight(i, legOf(i), spins_[i].turning), pucks_[i].properTime,
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
    bodies[k].puck.u = u[k];
  }
  RimRules rules = puckRims_;
  rules.restitution = restitution;
  return kickCorners(contact.U, contact.n, bodies, rules);
}

// The kick of bodies with corners that were in contact already. Where they lie on each other with two corners, each
// kick at one of them sends the other into the next, at a share of the speed. What closes slowly beside the hardest
// of the recent blows is therefore kicked without rebound, and what closes hardly at all is left as it is.
std::optional<SpinningPairKick> CollisionScheduler::lastingKick(const std::array<int, 2>& who,
                                                                const PairContact& contact,
                                                                const std::array<LegState, 2>& turn,
                                                                const std::array<double, 2>& j,
                                                                double restitution) const {
  constexpr double kSlowly = 1e-2, kHardly = 1e-6;  // of the hardest blow
  const double hardest = std::max(pucks_[who[0]].hardestBlow, pucks_[who[1]].hardestBlow);
  const auto kick = pairKick(who, contact, turn, j, restitution);
  if (!kick || !(kick->centres.closing < kSlowly * hardest)) return kick;
  if (kick->centres.closing < kHardly * hardest) return std::nullopt;
  return restitution < 1.0 ? pairKick(who, contact, turn, j, 0.0) : kick;
}

// Two pressed bodies with corners come to rest on each other: what is left of their motion and their spins in the
// frame of their total momentum becomes heat.
PairKick CollisionScheduler::restOnEachOther(const std::array<int, 2>& who, const std::array<Vec21, 2>& u,
                                             const std::array<double, 2>& j, double closing) const {
  std::array<Vec21, 2> p;
  for (int k = 0; k < 2; ++k) p[k] = u[k] * massOf(who[k], j[k]);
  const Vec21 P = p[0] + p[1];
  const Vec21 together = P * (1.0 / std::sqrt(dot(P, P)));
  PairKick kick;
  kick.closing = closing;
  for (int k = 0; k < 2; ++k) {
    kick.u[k] = fourVelocity(together.x, together.y);
    kick.heat[k] = std::max(0.0, dot(p[k], together) - pucks_[who[k]].mass);
  }
  return kick;
}

}  // namespace carom
