#include "engine/impact/impact_resolver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/game/stroke_kick.h"
#include "engine/impact/contact_finder.h"

namespace carom {

namespace {

// Two turns closer than this, in metres of light, are one: the rest of a cancellation when a corner's two
// kicks arrive together.
double sameTurn_m(double radius) { return 1e-9 * radius; }

constexpr double kStill = 1e-9;    // of light speed: slower than this, jammed pucks do not kick
constexpr double kStands = 1e-18;  // likewise: a disc that comes to a cushion slower than this stops

}  // namespace

double ImpactResolver::collide(const PuckPair& who, const PredictedEvent& a) {
  const auto [first, second] = who;
  const GameRules& rules = game_.rules;
  const PairContacts& contacts = contactsOf(game_, first, second);
  for (const int i : who) history_.fetch(game_.pucks[i].file);
  GameContact found = contacts.contactOf(game_, who, a.withoutDelay);
  if (found.unfinished || contacts.recede(game_, who, a.withoutDelay, found)) return found.until;
  const PairContact& contact = found.contact;

  const bool simultaneous = a.withoutDelay || rules.convention == TurnConvention::simultaneousWithContact;
  const bool again = contacts.isStruckAgain(game_, first, second);
  std::array<LegState, 2> turn;
  for (int k = 0; k < 2; ++k) {
    const LegState onFollowedLeg = turnOnFollowedLeg(who[k], k, contact, simultaneous);
    const Place place = placeTurn(who[k], simultaneous ? onFollowedLeg.x : contact.event, -1, onFollowedLeg);
    if (place.tooLate && !again) return kNever;
    // News of a second place that comes before the first waits for it.
    const Leg last = game_.lastLeg(who[k]);
    turn[k] = place.tooLate ? LegState{last.start, last.u, last.properTime} : place.turn;
  }
  if (settlesJam(who, found, turn)) return kNever;
  const double e = std::min(game_.restitution(first, rules.puckRestitution, turn[0].x.t),
                            game_.restitution(second, rules.puckRestitution, turn[1].x.t));
  const std::array<double, 2> j{game_.turningAt(first, turn[0].properTime).j,
                                game_.turningAt(second, turn[1].properTime).j};
  const auto kick = contacts.kick(game_, who, contact, {turn[0].u, turn[1].u}, j, e);
  if (!kick) return found.until;
  const bool jammed = game_.pucks[first].jammed || game_.pucks[second].jammed;
  if (e == 0.0 && kick->centres.closing < kStill && jammed) return kNever;
  PairOutcome outcome(*kick, e);
  if (!a.withoutDelay) contacts.kickElsewhere(game_, who, contact, outcome);
  contacts.noteContact(game_, who, contact);
  contacts.sendBack(game_, who, contact, turn, outcome);
  commitKick(who, found, turn, outcome, a);
  return found.untilAfterKick;
}

// Whether both are pressed, and come to rest with what presses them.
bool ImpactResolver::settlesJam(const PuckPair& who, const GameContact& found,
                                const std::array<LegState, 2>& turn) {
  if (!game_.isPressed(who[0], turn[0].x.t) || !game_.isPressed(who[1], turn[1].x.t)) return false;
  if (found.jam == JamLaw::everywhere)
    return jams_.settleEverywhere(who, turn, found.contact.event, found.contact.U);
  if (found.jam == JamLaw::plastic) jams_.settle(who, found.contact, turn);
  return found.jam == JamLaw::plastic;
}

void ImpactResolver::commitKick(const PuckPair& who, const GameContact& found,
                                const std::array<LegState, 2>& turn, const PairOutcome& outcome,
                                const PredictedEvent& a) {
  const PairContact& contact = found.contact;
  const PairKick& kick = outcome.kick.centres;
  const double heat = kick.heat[0] + kick.heat[1], c = game_.rules.c_m_s;
  const std::uint64_t collision =
      history_.addCollision(std::nullopt, contact.event, a.withoutDelay, heat * c * c);
  game_.accounts.heat += heat;
  const bool lies = found.jam == JamLaw::everywhere;
  const std::array<bool, 2> byMany{lies || game_.isPressed(who[1], turn[1].x.t),
                                   lies || game_.isPressed(who[0], turn[0].x.t)};
  for (int k = 0; k < 2; ++k) {
    const int i = who[k];
    const Turning turning = game_.turningAt(i, turn[k].properTime);
    const double j = outcome.kick.j[k];
    history_.addTurn(collision, game_.pucks[i].file, turn[k], kick.u[k], {turning.j, j});
    CommittedLeg decided;
    decided.leg = {turn[k].x, kick.u[k], turn[k].properTime, game_.rules.brake};
    decided.turning = {j, turning.angle};
    decided.signal = a.withoutDelay ? turn[k].x : contact.event;
    decided.event = collision;
    decided.heat = kick.heat[k];
    decided.radiated = outcome.radiated[k];
    const unsigned followed = game_.predictions[i].legNumber;
    game_.decide(i, decided, turn[k], history_);
    if (game_.predictions[i].legNumber == followed) game_.noteDecided(i, k == 0 ? a.ownTime : a.otherTime);
    game_.noteKick(i, turn[k].x);
    game_.noteImpact(i, turn[k].x.t, kick.closing, byMany[k]);
    game_.predictions[i].lastPartner = who[1 - k];
  }
  if (found.sideOnSide) history_.noteSideOnSide();
}

void ImpactResolver::bounce(int i, const PredictedEvent& a) {
  const PuckState& puck = game_.pucks[i];
  const CushionContacts& contacts = cushionContactsOf(game_, i);
  game_.predictions[i].metCushions |= static_cast<unsigned char>(1u << a.with);
  std::optional<CushionContact> contact =
      contacts.touchOf(game_, i, game_.legOf(i), game_.spins[i].turning, a.with);
  if (!contact) return;
  std::size_t foundOn = game_.legsBegun(i);
  if (!puck.decided.empty()) {
    if (contact->withoutDelay) return;
    // A decided leg has turned the puck off this cushion already.
    if (!contacts.mayTouch(game_.rules.cushions[a.with], game_.lastLeg(i).u)) return;
    const Place place = placeTurn(i, contact->event, a.with, contact->turn);
    if (place.tooLate) return;
    contact->turn = place.turn;
    if (place.touchedBefore) {
      contact = place.touchedBefore;
      foundOn = game_.lastLegNumber(i);
    } else if (cornerBefore(a.with, *contact)) {
      return;  // the leg that the neighbour's signal begins has its own contact with this cushion
    }
  }
  game_.noteDecided(i, a.ownTime);
  const bool lies = contact->withoutDelay && contacts.canLie();
  if (lies && game_.isPressed(i, contact->turn.x.t) &&
      jams_.settleEverywhere({&i, 1}, {&contact->turn, 1}, contact->event, contact->turn.u))
    return;
  bounceAt(i, a.with, *contact, foundOn);
}

// The cushions end at the corners, and so does what can be touched: the end of the cushion, if the contact
// found with its prolonged line lies beyond a neighbour. It can do so only
// * after the leg has touched that neighbour, whose signal is still on its way: the rim met the neighbour
//   there before, and has never come to where this leg, which does not know of it yet, would have it;
// * or where the rim was in contact before the leg began, on this leg continued backwards through its turn at
//   that neighbour. Then the signal is taken to come from the end of the cushion: the event from which it
//   reaches the centre at the contact's turn or, where turns do not wait for signal, at the time of the
//   contact.
std::optional<Vec21> ImpactResolver::cornerBefore(int cushion, const CushionContact& contact) const {
  const std::vector<CushionPlane>& cushions = game_.rules.cushions;
  const int firstNeighbour = cushions[cushion].axis == 0 ? 2 : 0;
  const bool delayed = game_.rules.convention == TurnConvention::signalAtCentre && !contact.withoutDelay;
  for (const int k : {firstNeighbour, firstNeighbour + 1}) {
    const CushionPlane& neighbour = cushions[k];
    if (!(neighbour.inside(contact.event) < 0.0)) continue;
    Vec21 corner = contact.event;
    (neighbour.axis == 0 ? corner.x : corner.y) = neighbour.sign * neighbour.distance;
    const Vec21 way = contact.turn.x - corner;
    if (delayed) corner.t = contact.turn.x.t - std::sqrt(way.x * way.x + way.y * way.y);
    return corner;
  }
  return std::nullopt;
}

// Commits the kick of a cushion at contact.turn, on the last leg decided.
void ImpactResolver::bounceAt(int i, int cushion, CushionContact contact, std::size_t foundOn) {
  const PuckState& puck = game_.pucks[i];
  const GameRules& rules = game_.rules;
  const CushionContacts& contacts = cushionContactsOf(game_, i);
  const double e = game_.restitution(i, rules.cushionRestitution, contact.turn.x.t);
  const Turning turning = game_.turningAt(i, contact.turn.properTime);
  std::optional<SpinningCushionKick> found =
      contacts.kick(game_, i, cushion, contact.event, contact.turn, turning.j, e);
  if (!found) return;
  const double mass = game_.massOf(i, turning.j);
  // Two rough cushions in whose corner a disc lies turn it by turns, at one moment, and slow it without end.
  if (!contacts.canLie() && rules.cushions[cushion].towards(contact.turn.u) < kStands)
    found = SpinningCushionKick{{{1.0, 0.0, 0.0}, mass * contact.turn.u.t - game_.massOf(i, 0.0), 0.0}, 0.0};
  const CushionKick& kick = found->centre;
  game_.accounts.heat += kick.heat;
  contact.event = cornerBefore(cushion, contact).value_or(contact.event);
  CommittedLeg decided;
  decided.event = history_.addCollision(static_cast<Cushion>(cushion), contact.event, contact.withoutDelay,
                                        kick.heat * rules.c_m_s * rules.c_m_s);
  if (!contact.withoutDelay && contacts.liesAt(game_, i, cushion)) history_.noteSideOnSide();
  history_.addTurn(decided.event, puck.file, contact.turn, kick.u, {turning.j, found->j});
  decided.leg = {contact.turn.x, kick.u, contact.turn.properTime, rules.brake};
  decided.turning = {found->j, turning.angle};
  decided.signal = contact.withoutDelay ? contact.turn.x : contact.event;
  decided.cushion = cushion;
  decided.contact = contact.event;
  decided.ownTime = contact.ownTime;
  decided.withoutDelay = contact.withoutDelay;
  decided.foundOn = foundOn;
  decided.heat = kick.heat;
  decided.radiated = kick.u * kick.heat;
  decided.taken = contact.turn.u * mass - kick.u * (game_.massOf(i, found->j) + kick.heat);
  game_.decide(i, decided, contact.turn, history_);
  game_.noteKick(i, contact.turn.x);
  if (contacts.canLie()) game_.noteImpact(i, contact.turn.x.t, kick.closing, contact.withoutDelay);
  game_.predictions[i].lastPartner = -1;
}

LegState ImpactResolver::turnOnFollowedLeg(int i, int which, const PairContact& contact,
                                           bool simultaneous) const {
  const Leg leg = game_.legOf(i);
  if (game_.rules.brake == 0.0) {
    return momentAfter(leg,
                       std::max(0.0, simultaneous ? contact.simultaneous[which] : contact.signal[which]));
  }
  const LegState turn =
      simultaneous ? simultaneousWith(leg, contact.event, contact.U) : signalArrives(leg, contact.event);
  return turn.x.t < leg.start.t ? momentAt(leg, leg.start.t) : turn;
}

// Where the future cone of the signal meets the centre's world line as it stands. On the leg being followed
// the caller knows.
ImpactResolver::Place ImpactResolver::placeTurn(int i, const Vec21& signal, int cushion,
                                                const LegState& onFollowedLeg) {
  const PuckState& puck = game_.pucks[i];
  if (puck.decided.empty()) return {onFollowedLeg, false, {}};
  const double same = sameTurn_m(game_.discs[i].radius) * game_.discs[i].u.t;
  if (onFollowedLeg.x.t < puck.decided.front().leg.start.t - same) return {onFollowedLeg, true, {}};
  return whereSignalArrives(i, signal, cushion);
}

// Where signal finds the centre from the last leg decided on. Cushions that it reaches before are bounced off
// first. The signal of a cushion kicks it once for one approach: where the leg's own contact with that
// cushion is heard of first, this stands for it, and the older signal has nothing more to say.
ImpactResolver::Place ImpactResolver::whereSignalArrives(int i, const Vec21& signal, int cushion) {
  const double same = sameTurn_m(game_.discs[i].radius);
  const CushionContacts& contacts = cushionContactsOf(game_, i);
  while (true) {
    const Leg leg = game_.lastLeg(i);
    LegState turn = signalArrives(leg, signal);
    if (turn.x.t < leg.start.t) {
      const bool tooLate = turn.x.t < leg.start.t - same * leg.u.t;
      if (tooLate) return {turn, true, {}};
      turn = {leg.start, leg.u, leg.properTime};
    }
    int cushionBefore = -1;
    CushionContact before;
    before.turn = turn;
    for (int k = 0; k < static_cast<int>(game_.rules.cushions.size()); ++k) {
      const auto contact = contacts.touchOf(game_, i, leg, game_.lastTurning(i), k);
      if (!contact || !(contact->turn.x.t < before.turn.x.t - same * leg.u.t)) continue;
      // What friction has stopped by the time at which the signal comes is not kicked.
      const double j = game_.turningAt(i, contact->turn.properTime).j;
      if (!contacts.kick(game_, i, k, contact->event, contact->turn, j, 1.0)) continue;
      cushionBefore = k;
      before = *contact;
    }
    if (cushionBefore < 0) return {turn, false, {}};
    if (cushionBefore == cushion) return {before.turn, false, before};
    bounceAt(i, cushionBefore, before, game_.lastLegNumber(i));
  }
}

void ImpactResolver::strike(int i, int stroke) {
  PuckState& puck = game_.pucks[i];
  Accounts& accounts = game_.accounts;
  const PuckStroke& s = game_.strokes[stroke];
  const auto sum = [&] {
    return accounts.radiated + accounts.taken + accounts.braked +
           game_.lastLeg(i).u * game_.massOf(i, game_.lastTurning(i).j);
  };
  const Vec21 before = sum();
  std::erase(puck.strokes, stroke);
  std::vector<CommittedLeg> onTheirWay = std::move(puck.decided);
  puck.decided.clear();
  for (const CommittedLeg& old : onTheirWay) {
    accounts.radiated = accounts.radiated - old.radiated;
    accounts.taken = accounts.taken - old.taken;
    accounts.braked = accounts.braked - old.braked;
  }
  history_.keepLegs(puck.file, game_.legsBegun(i));

  const Leg followed = game_.legOf(i);
  LegState struck = s.fromHand ? signalArrives(followed, s.hand, s.height) : momentAt(followed, s.hand.t);
  // Light that arrives as a turn does may by rounding find the new leg before it begins.
  if (struck.x.t < followed.start.t) struck = {followed.start, followed.u, followed.properTime};
  const Turning turning = game_.turningAt(i, struck.properTime);
  const auto [u, j] = struckPuck(game_.spins[i].body, game_.discs[i].radius, s, struck.u, turning.j);
  const std::size_t struckLeg = game_.legsBegun(i);
  if (!onTheirWay.empty()) history_.noteChange(struck.x);
  CommittedLeg decided;
  decided.leg = {struck.x, u, struck.properTime, game_.rules.brake};
  decided.turning = {j, turning.angle};
  decided.signal = struck.x;
  decided.atOnce = true;
  decided.event = history_.addStroke(static_cast<std::uint32_t>(stroke), s.fromHand ? s.hand : struck.x,
                                     puck.height + (s.fromHand ? s.height : 0.0));
  history_.addTurn(decided.event, puck.file, struck, u, {turning.j, j});
  game_.decide(i, decided, struck, history_);
  game_.predictions[i].lastPartner = -1;

  while (!onTheirWay.empty()) {
    const Leg leg = game_.lastLeg(i);
    const auto arrives = [&](const CommittedLeg& kick) { return signalArrives(leg, kick.signal).x.t; };
    const auto next = std::min_element(onTheirWay.begin(), onTheirWay.end(),
                                       [&](const auto& a, const auto& b) { return arrives(a) < arrives(b); });
    const CommittedLeg old = *next;
    onTheirWay.erase(next);
    const bool isPrevented = old.cushion >= 0 && (old.isPrevented(struckLeg, struck.x.t) ||
                                                  !(game_.rules.cushions[old.cushion].towards(leg.u) > 0.0));
    if (isPrevented) {
      prevent(i, old);
    } else {
      placeAnew(i, old);
    }
  }
  accounts.given = accounts.given + (sum() - before);
}

// The bounce stays in the list of events, with a turn that changes nothing.
void ImpactResolver::prevent(int i, const CommittedLeg& kick) {
  const Leg leg = game_.lastLeg(i);
  const double kept = game_.lastTurning(i).j;
  game_.accounts.heat -= kick.heat;
  history_.changeBounce(kick.event, kick.contact, true, 0.0);
  history_.changeTurn(kick.event, game_.pucks[i].file, {leg.start, leg.u, leg.properTime}, leg.u,
                      {kept, kept});
}

// A kick on its way acts on the last leg decided, which is not the one that it was found for.
void ImpactResolver::placeAnew(int i, CommittedLeg kick) {
  Place place = whereSignalArrives(i, kick.signal, kick.cushion);
  const Leg leg = game_.lastLeg(i);
  if (place.tooLate) place.turn = {leg.start, leg.u, leg.properTime};
  const LegState& turn = place.turn;
  if (place.touchedBefore) {
    kick.contact = cornerBefore(kick.cushion, *place.touchedBefore).value_or(place.touchedBefore->event);
    kick.ownTime = place.touchedBefore->ownTime;
    kick.withoutDelay = place.touchedBefore->withoutDelay;
    kick.signal = kick.withoutDelay ? turn.x : kick.contact;
    kick.foundOn = game_.lastLegNumber(i);
  }
  const double oldHeat = kick.heat;
  kick.leg.start = turn.x;
  kick.leg.properTime = turn.properTime;
  const Turning turning = game_.turningAt(i, turn.properTime);
  if (kick.cushion >= 0) {
    bounceAnew(i, turn, turning, kick);
  } else {
    kickAnew(i, turn.u, turning, kick);
  }
  kick.radiated = kick.leg.u * kick.heat;
  game_.accounts.heat += kick.heat - oldHeat;
  game_.noteBounce(kick, history_);
  history_.changeTurn(kick.event, game_.pucks[i].file, turn, kick.leg.u, {turning.j, kick.turning.j});
  game_.decide(i, kick, turn, history_);
}

// The kick of a cushion on its way keeps its law.
void ImpactResolver::bounceAnew(int i, const LegState& turn, const Turning& turning, CommittedLeg& kick) {
  const double e = game_.restitution(i, game_.rules.cushionRestitution, turn.x.t);
  const auto bounced =
      cushionContactsOf(game_, i).kick(game_, i, kick.cushion, kick.contact, turn, turning.j, e);
  kick.heat = bounced ? bounced->centre.heat : 0.0;
  kick.leg.u = bounced ? bounced->centre.u : turn.u;
  kick.turning = {bounced ? bounced->j : turning.j, turning.angle};
  kick.taken =
      turn.u * game_.massOf(i, turning.j) - kick.leg.u * (game_.massOf(i, kick.turning.j) + kick.heat);
}

// The kick of another puck on its way gives the impulse and the spin that it would have given.
void ImpactResolver::kickAnew(int i, const Vec21& u, const Turning& turning, CommittedLeg& kick) const {
  const double before = game_.massOf(i, kick.jBefore), after = game_.massOf(i, kick.turning.j);
  const Turning turned{turning.j + (kick.turning.j - kick.jBefore), turning.angle};
  const double now = game_.massOf(i, turning.j), then = game_.massOf(i, turned.j);
  if (before == after && now == then && before == now) {
    kick.leg.u = fourVelocity(u.x + kick.leg.u.x - kick.uBefore.x, u.y + kick.leg.u.y - kick.uBefore.y);
  } else {
    const Vec21 impulse = kick.leg.u * after - kick.uBefore * before;
    kick.leg.u = fourVelocity((u.x * now + impulse.x) / then, (u.y * now + impulse.y) / then);
  }
  kick.turning = turned;
}

}  // namespace carom
