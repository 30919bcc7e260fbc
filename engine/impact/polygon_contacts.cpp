#include "engine/impact/polygon_contacts.h"

#include <algorithm>

#include "engine/polygons/corner_contact.h"
#include "engine/polygons/corner_cushion.h"
#include "engine/polygons/corner_kick.h"

namespace carom {

namespace {

constexpr double kPressed = 0.02;     // of light speed: slower ones that others press are not sent back
constexpr int kKicksOfAnImpact = 16;  // at places where bodies lie on each other when they meet at another

bool areBothPolygons(const GameState& game, int first, int second) {
  return game.outlineOf(first) != nullptr && game.outlineOf(second) != nullptr;
}

// Whether one of them has still to turn.
bool awaitsTurn(const GameState& game, const PuckPair& who) {
  return !game.pucks[who[0]].decided.empty() || !game.pucks[who[1]].decided.empty();
}

std::optional<CornerContact> nextContact(const GameState& game, const PuckPair& who) {
  const HandledContact* const last = game.handled(who[0], who[1]);
  return findCornerContact(game.followedShape(who[0]), game.followedShape(who[1]),
                           last == nullptr ? -kNever : last->until, game.persistentContact(who[0], who[1]),
                           awaitsTurn(game, who));
}

// The lever from the centre to the contact, simultaneous in the body's own frame.
LeveredBody levered(const GameState& game, int i, const Vec21& touch, const LegState& at, double j) {
  const Vec21 way = touch - at.x;
  return {{game.spins[i].body, j, at.u}, game.discs[i].radius, way - at.u * dot(at.u, way)};
}

// What an impact gives the second of two in the frame of their common momentum P: q − (q·P/P·P) P.
Vec21 impulseOnSecond(const GameState& game, const PuckPair& who, const std::array<LegState, 2>& turn,
                      const PairOutcome& outcome) {
  std::array<Vec21, 2> before, after;
  for (int k = 0; k < 2; ++k) {
    const double j = game.turningAt(who[k], turn[k].properTime).j;
    before[k] = turn[k].u * game.massOf(who[k], j);
    after[k] = outcome.kick.centres.u[k] * game.massOf(who[k], outcome.kick.j[k]);
  }
  const Vec21 q = after[1] - before[1], P = after[0] + after[1];
  return q - P * (dot(q, P) / dot(P, P));
}

// Those that something else has turned while they were behind each other stay there.
bool haveParted(const GameState& game, int first, int second, PersistentContact& earlier) {
  const MovingShape one = game.followedShape(first), other = game.followedShape(second);
  const Vec21 U = equalSpeedFrame(one.u, other.u);
  const double since = std::max(dot(U, one.start - earlier.event), dot(U, other.start - earlier.event));
  if (!(since > 0.0)) return false;
  const PenetrationState penetration = penetrationSince(earlier, one, other);
  earlier.behind = earlier.behind || penetration == PenetrationState::through;
  const bool undisturbed =
      game.predictions[first].lastPartner == second && game.predictions[second].lastPartner == first;
  return penetration == PenetrationState::apart || (penetration == PenetrationState::through && !undisturbed);
}

}  // namespace

std::optional<Meeting> PolygonPair::meetingOf(const GameState& game, const PuckPair& who) const {
  const HandledContact* const last = game.handled(who[0], who[1]);
  if (last != nullptr && last->until == kNever) return std::nullopt;
  const std::optional<CornerContact> found = nextContact(game, who);
  if (!found) return std::nullopt;
  return carom::meetingOf(game.followedShape(who[0]), game.followedShape(who[1]), *found,
                          game.rules.convention);
}

GameContact PolygonPair::contactOf(const GameState& game, const PuckPair& who, bool withoutDelay) const {
  const std::optional<CornerContact> next = nextContact(game, who);
  GameContact found;
  if (!next) {
    found.unfinished = true;
    return found;
  }
  const CornerContact& corners = *next;
  const bool both = areBothPolygons(game, who[0], who[1]);
  found.contact = corners.contact;
  found.until = corners.unfinished || both || !awaitsTurn(game, who) ? corners.time : kNever;
  found.untilAfterKick = both ? corners.time : kNever;
  found.jam = withoutDelay ? JamLaw::everywhere : JamLaw::none;
  found.unfinished = corners.unfinished;
  found.sideOnSide = corners.sideOnSide;
  return found;
}

// Bodies that lie on each other at several places and recede at that of the contact: takes the one at which
// they approach fastest.
bool PolygonPair::recede(const GameState& game, const PuckPair& who, bool withoutDelay,
                         GameContact& found) const {
  const std::array<Vec21, 2> u = game.lastVelocities(who);
  const std::array<double, 2> j = game.lastSpins(who);
  const auto own = kick(game, who, found.contact, u, j, 1.0);
  if (!withoutDelay) return !own;
  if (own && !(own->centres.closing < kResting)) return false;
  const double radii = game.discs[who[0]].radius + game.discs[who[1]].radius;
  double fastest = kResting;
  const PairContact there = found.contact;
  for (const TouchedPlace& place :
       touchedPlaces(game.followedShape(who[0]), game.followedShape(who[1]), kJamTouching * radii,
                     game.persistentContact(who[0], who[1]))) {
    PairContact here = there;
    here.event = place.event;
    here.n = place.n;
    const auto next = kick(game, who, here, u, j, 1.0);
    if (!next || !(next->centres.closing > fastest)) continue;
    fastest = next->centres.closing;
    found.contact = here;
  }
  return !(fastest > kResting);
}

// With the levers on the legs being followed, on which the contact was found.
std::optional<SpinningPairKick> PolygonPair::kick(const GameState& game, const PuckPair& who,
                                                  const PairContact& contact, const std::array<Vec21, 2>& u,
                                                  const std::array<double, 2>& j, double restitution) const {
  std::array<LeveredBody, 2> bodies;
  for (int k = 0; k < 2; ++k) {
    const Disc& flight = game.discs[who[k]];
    bodies[k] = levered(game, who[k], contact.event, {flight.start, flight.u, 0.0}, j[k]);
    if (contact.central) bodies[k].lever = {};
    bodies[k].puck.u = u[k];
  }
  return kickCorners(contact.U, contact.n, bodies,
                     GameRules::withRestitution(game.rules.puckRims, restitution));
}

// Bodies that have not parted lie in each other at other places as well: until they recede at all of them by
// the momenta that are decided, the impact goes on there.
void PolygonPair::kickElsewhere(const GameState& game, const PuckPair& who, const PairContact& contact,
                                PairOutcome& outcome) const {
  const PersistentContact* const earlier = game.persistentContact(who[0], who[1]);
  if (earlier == nullptr || !areBothPolygons(game, who[0], who[1])) return;
  const MovingShape first = game.followedShape(who[0]), second = game.followedShape(who[1]);
  std::vector<TouchedPlace> places =
      placesKeptOut(first, second, dot(contact.U, contact.event - first.start), *earlier);
  places.push_back({contact.event, contact.n});
  const double e = std::max(kJamRebound, outcome.restitution);
  for (int kicks = 0; kicks < kKicksOfAnImpact; ++kicks) {
    double fastest = kResting;
    std::optional<SpinningPairKick> next;
    const SpinningPairKick& before = outcome.kick;
    for (const TouchedPlace& place : places) {
      PairContact here = contact;
      here.event = place.event;
      here.n = place.n;
      const auto found = kick(game, who, here, before.centres.u, before.j, e);
      if (!found || !(found->centres.closing > fastest)) continue;
      fastest = found->centres.closing;
      next = found;
    }
    if (!next) return;
    outcome.add(*next);
  }
}

// Light tells the centres late. Bodies that have gone through each other by then, or go past each other
// without another touch, and would part for good on another side than that on which they touch, give each
// other one more kick along their impulse. It comes with the same signal. Where others press them, and they
// are slow or do not rebound, the jam is settled instead.
void PolygonPair::sendBack(const GameState& game, const PuckPair& who, const PairContact& contact,
                           const std::array<LegState, 2>& turn, PairOutcome& outcome) const {
  if (!areBothPolygons(game, who[0], who[1])) return;
  const bool pressed = game.isPressed(who[0], turn[0].x.t) || game.isPressed(who[1], turn[1].x.t);
  if (pressed && outcome.restitution == 0.0) return;
  std::array<std::vector<MovingShape>, 2> flights;
  for (int k = 0; k < 2; ++k) {
    const int i = who[k];
    flights[k].push_back(game.followedShape(i));
    for (const CommittedLeg& decided : game.pucks[i].decided)
      flights[k].push_back(game.shapeOn(i, decided.leg, decided.turning));
    const Leg leg{turn[k].x, outcome.kick.centres.u[k], turn[k].properTime, game.rules.brake};
    const double angle = game.turningAt(i, turn[k].properTime).angle;
    flights[k].push_back(game.shapeOn(i, leg, {outcome.kick.j[k], angle}));
  }
  PairContact central = contact;
  central.n = impulseOnSecond(game, who, turn, outcome);
  central.central = true;
  const PersistentContact touched{{flights[0].front(), flights[1].front()}, contact.event, central.n};
  const PersistentContact* const noted = game.persistentContact(who[0], who[1]);
  if (!partElsewhere(flights, touched) && !goPast(flights[0].back(), flights[1].back(), touched, noted))
    return;
  const auto back = kick(game, who, central, outcome.kick.centres.u, outcome.kick.j, outcome.restitution);
  if (back && back->centres.closing > (pressed ? kPressed : kResting)) outcome.add(*back);
}

// On the legs that both follow.
void PolygonPair::noteContact(GameState& game, const PuckPair& who, const PairContact& contact) const {
  const PersistentContact now{
      {game.followedShape(who[0]), game.followedShape(who[1])}, contact.event, contact.n, false};
  if (const PersistentContact* const earlier = game.persistentContact(who[0], who[1])) {
    const double time = dot(contact.U, contact.event - now.flights[0].start);
    if (!areBothPolygons(game, who[0], who[1]) ||
        penetrationSince(*earlier, now.flights[0], now.flights[1], time) != PenetrationState::apart)
      return;
    for (int k = 0; k < 2; ++k)
      std::erase_if(game.pucks[who[k]].partners,
                    [&](const PersistentPartner& one) { return one.other == who[1 - k]; });
  }
  const std::array<unsigned, 2> legs{game.predictions[who[0]].legNumber, game.predictions[who[1]].legNumber};
  for (int k = 0; k < 2; ++k) game.pucks[who[k]].partners.push_back({who[1 - k], now, legs});
}

// A pair is looked at once on each pair of legs.
void PolygonPair::forgetParted(GameState& game, int i) const {
  std::erase_if(game.pucks[i].partners, [&](PersistentPartner& one) {
    const int first = std::min(i, one.other), second = std::max(i, one.other);
    const std::array<unsigned, 2> legs{game.predictions[first].legNumber, game.predictions[second].legNumber};
    if (legs == one.legs) return false;
    std::vector<PersistentPartner>& theirs = game.pucks[one.other].partners;
    const auto same =
        std::find_if(theirs.begin(), theirs.end(), [i](const PersistentPartner& x) { return x.other == i; });
    const bool parted = haveParted(game, first, second, one.contact);
    same->contact.behind = one.contact.behind;
    one.legs = same->legs = legs;
    if (parted) theirs.erase(same);
    return parted;
  });
}

bool PolygonPair::isStruckAgain(const GameState& game, int i, int other) const {
  return areBothPolygons(game, i, other) && game.predictions[i].lastPartner == other &&
         game.predictions[other].lastPartner == i && !game.pucks[i].decided.empty() &&
         !game.pucks[other].decided.empty();
}

std::optional<JamContact> PolygonPair::jamContactOf(const GameState& game, const JamBody& one,
                                                    const JamBody& other) const {
  if (other.puck < one.puck) return jamContactOf(game, other, one);
  JamContact contact;
  contact.hasCorners = true;
  contact.places = touchedPlaces(one.shape(), other.shape(), kJamTouching * (one.radius + other.radius),
                                 game.persistentContact(one.puck, other.puck));
  if (contact.places.empty()) return std::nullopt;
  return contact;
}

std::optional<CushionContact> PolygonAtCushion::touchOf(const GameState& game, int i, const Leg& leg,
                                                        const Turning& turning, int cushion) const {
  const auto found = findCornerContact(game.shapeOn(i, leg, turning), leg.properTime,
                                       game.rules.cushions[cushion], game.rules.convention);
  if (!found) return std::nullopt;
  return found->contact;
}

std::optional<SpinningCushionKick> PolygonAtCushion::kick(const GameState& game, int i, int cushion,
                                                          const Vec21& touch, const LegState& turn, double j,
                                                          double restitution) const {
  return kickCornerOffCushion(game.rules.cushions[cushion], levered(game, i, touch, turn, j),
                              GameRules::withRestitution(game.rules.cushionRims, restitution));
}

bool PolygonAtCushion::liesAt(const GameState& game, int i, int cushion) const {
  const auto found = findCornerContact(game.followedShape(i), game.pucks[i].properTime,
                                       game.rules.cushions[cushion], game.rules.convention);
  return found && found->sideOnSide;
}

bool PolygonAtCushion::touches(const JamBody& body, const CushionPlane& cushion) const {
  return !touchedPlaces(body.shape(), cushion, kJamTouching * body.radius).empty();
}

}  // namespace carom
