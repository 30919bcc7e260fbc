// Commits predicted events: turns, kicks, and their certain consequences.

#include <algorithm>
#include <cmath>

#include "engine/billiard/collision_scheduler.h"
#include "engine/collision/braked_contact.h"

namespace carom {

namespace {

// Two turns closer than this, in metres of light, are one: the rest of a cancellation when a corner's two
// kicks arrive together.
double sameTurn_m(double radius) { return 1e-9 * radius; }

constexpr int kKicksOfAJam = 64;
constexpr double kJamPerRadius = 1e-6;  // of the time in which light crosses the radius
constexpr double kStill = 1e-9;         // of light speed: slower than this, jammed pucks do not kick
constexpr double kStands = 1e-18;       // likewise: a disc that comes to a cushion slower than this stops

/// Whether a kick keeps every spin.
bool isSmooth(const RimRules& rims) { return rims.friction == 0.0; }

RimRules withRestitution(RimRules rims, double restitution) {
  rims.restitution = restitution;
  return rims;
}

}  // namespace

// By the momenta that are decided. Whether discs recede does not depend on their masses, and so not on what
// the cloth has left of their spins: by P = m1 u1 + m2 u2,   p1·k = m1 m2 ((n·u1) (U·u2) − (n·u2)
// (U·u1))/(U·P).
bool CollisionScheduler::receding(const std::array<int, 2>& who, const PairContact& contact,
                                  const PredictedEvent& a, const std::array<double, 2>& touchAt) const {
  const bool braked = brake_ != 0.0;
  std::array<Vec21, 2> u;
  std::array<double, 2> mass, spin;
  for (int k = 0; k < 2; ++k) {
    const int i = who[k];
    const Leg leg = lastLeg(i);
    u[k] = braked ? momentAt(leg, touchAt[k]).u : leg.u;
    spin[k] = lastTurning(i).j;
    mass[k] = massOf(i, spin[k]);
  }
  if (hasCorners(who[0], who[1])) {
    const auto kick = cornerKick(who, contact, u, spin, 1.0);
    return !kick || (a.withoutDelay && kick->centres.closing < kResting);
  }
  return !kickPair(contact.U, contact.n, u, mass, 1.0);
}

std::optional<SpinningPairKick> CollisionScheduler::pairKick(const std::array<int, 2>& who,
                                                             const PairContact& contact,
                                                             const std::array<LegState, 2>& turn,
                                                             const std::array<double, 2>& j,
                                                             double restitution) const {
  if (hasCorners(who[0], who[1])) return cornerKick(who, contact, {turn[0].u, turn[1].u}, j, restitution);
  if (!isSmooth(puckRims_)) {
    return kickSpinningPair(contact.U, contact.n,
                            {SpinningPuck{spins_[who[0]].body, j[0], turn[0].u},
                             SpinningPuck{spins_[who[1]].body, j[1], turn[1].u}},
                            withRestitution(puckRims_, restitution));
  }
  const auto kick = kickPair(contact.U, contact.n, {turn[0].u, turn[1].u},
                             {massOf(who[0], j[0]), massOf(who[1], j[1])}, restitution);
  if (!kick) return std::nullopt;
  return SpinningPairKick{*kick, j};
}

std::optional<SpinningCushionKick> CollisionScheduler::cushionKick(int i, int cushion, const Vec21& touch,
                                                                   const LegState& turn, double j,
                                                                   double restitution) const {
  const Vec21& u = turn.u;
  if (outlineOf(i) != nullptr)
    return kickCornerOffCushion(cushions_[cushion], levered(i, touch, turn, j),
                                withRestitution(cushionRims_, restitution));
  if (!isSmooth(cushionRims_)) {
    return kickSpinningOffCushion(cushions_[cushion], {spins_[i].body, j, u},
                                  withRestitution(cushionRims_, restitution));
  }
  const auto kick = kickOffCushion(cushions_[cushion], u, massOf(i, j), restitution);
  if (!kick) return std::nullopt;
  return SpinningCushionKick{*kick, j};
}

// Returns until when this pair's contacts on the legs that they follow have been dealt with: for good, but
// where nothing comes of a contact of bodies that turn, up to this one.
double CollisionScheduler::collide(int first, int second, const PredictedEvent& a, GameHistory& history) {
  const std::array<int, 2> who{first, second};
  const bool braked = brake_ != 0.0;
  for (const int i : who) history.fetch(pucks_[i].file);
  const auto disc = [&](int k) { return BrakedDisc{legOf(who[k]), discs_[who[k]].radius}; };
  // Board times at which the straight flights touch the world lines.
  std::array<double, 2> touchAt{};
  if (braked) touchAt = findBrakedMeeting(disc(0), disc(1), convention_).value().touchAt;
  const auto flight = [&](int k) { return braked ? flightAt(disc(k), touchAt[k]) : discs_[who[k]]; };
  const std::optional<CornerContact> corners =
      hasCorners(first, second) ? cornersMeet(first, second) : std::nullopt;
  if (corners && corners->unfinished) return corners->time;
  PairContact contact = corners ? corners->contact : contactOf(flight(0), flight(1), a.withoutDelay);

  const bool waits = !pucks_[first].decided.empty() || !pucks_[second].decided.empty();
  const bool polygons = haveOutlines(first, second);
  const double time = corners ? corners->time : kNever;
  const double until = !waits || polygons ? time : kNever;
  if (receding(who, contact, a, touchAt) && !(corners && approachElsewhere(who, a, contact))) return until;
  const bool simultaneous = a.withoutDelay || convention_ == TurnConvention::simultaneousWithContact;
  const bool again = isStruckAgain(first, second);
  std::array<LegState, 2> turn;
  for (int k = 0; k < 2; ++k) {
    const LegState onFollowedLeg = turnOnFollowedLeg(who[k], k, contact, simultaneous);
    const Place place =
        placeTurn(who[k], simultaneous ? onFollowedLeg.x : contact.event, -1, onFollowedLeg, history);
    if (place.tooLate && !again) return kNever;
    // News of a second place that comes before the first waits for it.
    const Leg last = lastLeg(who[k]);
    turn[k] = place.tooLate ? LegState{last.start, last.u, last.properTime} : place.turn;
  }
  if (isPressed(first, turn[0].x.t) && isPressed(second, turn[1].x.t)) {
    if (!corners && !discsStayElastic()) return settle(who, contact, turn, history), kNever;
    if (corners && a.withoutDelay && settleCorners(who, turn, contact.event, contact.U, history))
      return kNever;
  }
  const double e = std::min(restitution(first, puckRestitution_, turn[0].x.t),
                            restitution(second, puckRestitution_, turn[1].x.t));
  const std::array<double, 2> j{turningAt(first, turn[0].properTime).j,
                                turningAt(second, turn[1].properTime).j};
  const auto found = pairKick(who, contact, turn, j, e);
  if (!found) return until;
  const bool jammed = pucks_[first].jammed || pucks_[second].jammed;
  if (e == 0.0 && found->centres.closing < kStill && jammed) return kNever;
  PairOutcome outcome(*found, e);
  if (corners && !a.withoutDelay) kickOtherPlaces(who, contact, outcome);
  if (corners) notePersistentPair(who, contact);
  if (corners) sendBack(who, contact, turn, outcome);
  commitKick(who, contact, turn, outcome, a, history);
  if (corners && corners->sideOnSide) history.noteSideOnSide();
  return polygons ? time : kNever;
}

void CollisionScheduler::commitKick(const std::array<int, 2>& who, const PairContact& contact,
                                    const std::array<LegState, 2>& turn, const PairOutcome& outcome,
                                    const PredictedEvent& a, GameHistory& history) {
  const SpinningPairKick& found = outcome.kick;
  const PairKick& kick = found.centres;
  const double heat = kick.heat[0] + kick.heat[1];
  const std::uint64_t collision =
      history.addCollision(std::nullopt, contact.event, a.withoutDelay, heat * c_m_s_ * c_m_s_);
  accounts_.heat += heat;
  const bool lies = a.withoutDelay && hasCorners(who[0], who[1]);
  const std::array<bool, 2> byMany{lies || isPressed(who[1], turn[1].x.t),
                                   lies || isPressed(who[0], turn[0].x.t)};
  for (int k = 0; k < 2; ++k) {
    const int i = who[k];
    const Turning turning = turningAt(i, turn[k].properTime);
    history.addTurn(collision, pucks_[i].file, turn[k], kick.u[k], {turning.j, found.j[k]});
    CommittedLeg decided;
    decided.leg = {turn[k].x, kick.u[k], turn[k].properTime, brake_};
    decided.turning = {found.j[k], turning.angle};
    decided.signal = a.withoutDelay ? turn[k].x : contact.event;
    decided.event = collision;
    decided.heat = kick.heat[k];
    decided.radiated = outcome.radiated[k];
    const unsigned followed = predictions_[i].legNumber;
    decide(i, decided, turn[k], history);
    if (predictions_[i].legNumber == followed) noteDecided(i, k == 0 ? a.ownTime : a.otherTime);
    noteKick(i, turn[k].x);
    noteImpact(i, turn[k].x.t, kick.closing, byMany[k]);
    predictions_[i].lastPartner = who[1 - k];
  }
}

void CollisionScheduler::bounce(int i, const PredictedEvent& a, GameHistory& history) {
  PuckState& puck = pucks_[i];
  predictions_[i].metCushions |= static_cast<unsigned char>(1u << a.with);
  std::optional<CushionContact> contact = followedTouchOf(i, a.with);
  if (!contact) return;
  std::size_t foundOn = legsBegun(i);
  if (!puck.decided.empty()) {
    if (contact->withoutDelay) return;
    // A decided leg has turned the puck off this cushion already.
    if (outlineOf(i) == nullptr && !(cushions_[a.with].towards(lastLeg(i).u) > 0.0)) return;
    const Place place = placeTurn(i, contact->event, a.with, contact->turn, history);
    if (place.tooLate) return;
    contact->turn = place.turn;
    if (place.touchedBefore) {
      contact = place.touchedBefore, foundOn = lastLegNumber(i);
    } else if (cornerBefore(a.with, *contact)) {
      return;  // the leg that the neighbour's signal begins has its own contact with this cushion
    }
  }
  noteDecided(i, a.ownTime);
  const bool lies = contact->withoutDelay && outlineOf(i) != nullptr;
  if (lies && isPressed(i, contact->turn.x.t) &&
      settleCorners({&i, 1}, {&contact->turn, 1}, contact->event, contact->turn.u, history))
    return;
  bounceAt(i, a.with, *contact, foundOn, history);
}

// The cushions end at the corners, and so does what can be touched: the end of the cushion, if the contact
// found with its prolonged line lies beyond a neighbour. It can do so only
// * after the leg has touched that neighbour, whose signal is still on its way: the rim met the neighbour
// there
//   before, and has never come to where this leg, which does not know of it yet, would have it;
// * or where the rim was in contact before the leg began, on this leg continued backwards through its turn at
//   that neighbour. Then the signal is taken to come from the end of the cushion: the event from which it
//   reaches the centre at the contact's turn or, where turns do not wait for signal, at the time of the
//   contact.
std::optional<Vec21> CollisionScheduler::cornerBefore(int cushion, const CushionContact& contact) const {
  const int firstNeighbour = cushions_[cushion].axis == 0 ? 2 : 0;
  const bool delayed = convention_ == TurnConvention::signalAtCentre && !contact.withoutDelay;
  for (const int k : {firstNeighbour, firstNeighbour + 1}) {
    const CushionPlane& neighbour = cushions_[k];
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
void CollisionScheduler::bounceAt(int i, int cushion, CushionContact contact, std::size_t foundOn,
                                  GameHistory& history) {
  PuckState& puck = pucks_[i];
  const double e = restitution(i, cushionRestitution_, contact.turn.x.t);
  const Turning turning = turningAt(i, contact.turn.properTime);
  std::optional<SpinningCushionKick> found =
      cushionKick(i, cushion, contact.event, contact.turn, turning.j, e);
  if (!found) return;
  // Two rough cushions in whose corner a disc lies turn it by turns, at one moment, and slow it without end.
  if (outlineOf(i) == nullptr && cushions_[cushion].towards(contact.turn.u) < kStands) {
    const double heat = massOf(i, turning.j) * contact.turn.u.t - massOf(i, 0.0);
    found = SpinningCushionKick{{{1.0, 0.0, 0.0}, heat, 0.0}, 0.0};
  }
  const CushionKick* const kick = &found->centre;
  accounts_.heat += kick->heat;
  contact.event = cornerBefore(cushion, contact).value_or(contact.event);
  CommittedLeg decided;
  decided.event = history.addCollision(static_cast<Cushion>(cushion), contact.event, contact.withoutDelay,
                                       kick->heat * c_m_s_ * c_m_s_);
  if (liesOnCushion(i, cushion, contact)) history.noteSideOnSide();
  history.addTurn(decided.event, puck.file, contact.turn, kick->u, {turning.j, found->j});
  decided.leg = {contact.turn.x, kick->u, contact.turn.properTime, brake_};
  decided.turning = {found->j, turning.angle};
  decided.signal = contact.withoutDelay ? contact.turn.x : contact.event;
  decided.cushion = cushion;
  decided.contact = contact.event, decided.ownTime = contact.ownTime;
  decided.withoutDelay = contact.withoutDelay;
  decided.foundOn = foundOn;
  decided.heat = kick->heat;
  decided.radiated = kick->u * kick->heat;
  decided.taken = contact.turn.u * massOf(i, turning.j) - kick->u * (massOf(i, found->j) + kick->heat);
  decide(i, decided, contact.turn, history);
  noteKick(i, contact.turn.x);
  if (outlineOf(i) != nullptr) noteImpact(i, contact.turn.x.t, kick->closing, contact.withoutDelay);
  predictions_[i].lastPartner = -1;
}

LegState CollisionScheduler::turnOnFollowedLeg(int i, int which, const PairContact& contact,
                                               bool simultaneous) const {
  const Leg leg = legOf(i);
  if (brake_ == 0.0) {
    return momentAfter(leg,
                       std::max(0.0, simultaneous ? contact.simultaneous[which] : contact.signal[which]));
  }
  const LegState turn =
      simultaneous ? simultaneousWith(leg, contact.event, contact.U) : signalArrives(leg, contact.event);
  return turn.x.t < leg.start.t ? momentAt(leg, leg.start.t) : turn;
}

// Where the future cone of the signal meets the centre's world line as it stands. On the leg being followed
// the caller knows.
CollisionScheduler::Place CollisionScheduler::placeTurn(int i, const Vec21& signal, int cushion,
                                                        const LegState& onFollowedLeg, GameHistory& history) {
  const PuckState& puck = pucks_[i];
  if (puck.decided.empty()) return {onFollowedLeg, false, {}};
  if (onFollowedLeg.x.t < puck.decided.front().leg.start.t - sameTurn_m(discs_[i].radius) * discs_[i].u.t) {
    return {onFollowedLeg, true, {}};
  }
  return whereSignalArrives(i, signal, cushion, history);
}

// Where signal finds the centre from the last leg decided on. Cushions that it reaches before are bounced off
// first. The signal of a cushion kicks it once for one approach: where the leg's own contact with that
// cushion is heard of first, this stands for it, and the older signal has nothing more to say.
CollisionScheduler::Place CollisionScheduler::whereSignalArrives(int i, const Vec21& signal, int cushion,
                                                                 GameHistory& history) {
  const double same = sameTurn_m(discs_[i].radius);
  while (true) {
    const Leg leg = lastLeg(i);
    LegState turn = signalArrives(leg, signal);
    if (turn.x.t < leg.start.t) {
      const bool tooLate = turn.x.t < leg.start.t - same * leg.u.t;
      if (tooLate) return {turn, true, {}};
      turn = {leg.start, leg.u, leg.properTime};
    }
    int cushionBefore = -1;
    CushionContact before;
    before.turn = turn;
    for (int k = 0; k < static_cast<int>(cushions_.size()); ++k) {
      const auto contact = touchOf(i, leg, lastTurning(i), k);
      // What friction has stopped by the time at which the signal comes is not kicked.
      if (contact && contact->turn.x.t < before.turn.x.t - same * leg.u.t && isKickedBy(i, k, *contact))
        cushionBefore = k, before = *contact;
    }
    if (cushionBefore < 0) return {turn, false, {}};
    if (cushionBefore == cushion) return {before.turn, false, before};
    bounceAt(i, cushionBefore, before, lastLegNumber(i), history);
  }
}

void CollisionScheduler::decide(int i, const CommittedLeg& given, const LegState& turn,
                                GameHistory& history) {
  PuckState& puck = pucks_[i];
  CommittedLeg decided = given;
  const double jBegan = lastTurning(i).j, j = turningAt(i, turn.properTime).j;
  decided.uBefore = turn.u;
  decided.jBefore = j;
  decided.braked = j == jBegan ? (lastLeg(i).u - turn.u) * massOf(i, j)
                               : lastLeg(i).u * massOf(i, jBegan) - turn.u * massOf(i, j);
  accounts_.radiated = accounts_.radiated + decided.radiated;
  accounts_.taken = accounts_.taken + decided.taken;
  accounts_.braked = accounts_.braked + decided.braked;
  history.addLeg(puck.file, decided.leg, decided.turning, decided.signal);
  rollbackWindow_ = std::max(rollbackWindow_, 4.0 * decided.leg.u.t * discs_[i].radius);
  if (convention_ == TurnConvention::signalAtCentre && decided.leg.u.t > gammaBound_) cellsTooSmall_ = true;

  const bool atOnce = puck.decided.empty() && (turn.x.t <= discs_[i].start.t || decided.atOnce ||
                                               convention_ == TurnConvention::simultaneousWithContact);
  if (atOnce) {
    beginLeg(i, decided.leg, decided.turning);
  } else {
    puck.decided.push_back(decided);
    discs_[i].turnsAt = puck.decided.front().leg.start.t;
  }
}

void CollisionScheduler::beginLeg(int i, const Leg& leg, const Turning& turning) {
  PuckState& puck = pucks_[i];
  if (turns_) spins_[i].turning = turning;
  puck.properTime = leg.properTime;
  Prediction& own = predictions_[i];
  ++own.legNumber;
  own.metCushions = 0;
  own.hasDecided = false;
  if (own.hasMet) puck.met.clear(), own.hasMet = false;
  discs_[i].start = leg.start;
  discs_[i].u = leg.u;
  discs_[i].turnsAt = puck.decided.empty() ? kNever : puck.decided.front().leg.start.t;
  if (usesCells()) cells_.change(i, coarseFlightOf(i));
}

void CollisionScheduler::beginCommitted(int i) {
  PuckState& puck = pucks_[i];
  const Leg leg = puck.decided.front().leg;
  const Turning turning = puck.decided.front().turning;
  puck.decided.erase(puck.decided.begin());
  beginLeg(i, leg, turning);
}

// The stroke changes the leg being followed. Kicks decided but still on their way keep their impulse (a
// cushion: its law) and act where their signal meets the new motion, or where the new motion itself has
// touched the cushion before. A cushion that the stroke keeps the puck from, or drives it away from, does
// nothing.
void CollisionScheduler::strike(int i, int stroke, GameHistory& history) {
  PuckState& puck = pucks_[i];
  const PuckStroke& s = strokes_[stroke];
  const auto sum = [&] {
    return accounts_.radiated + accounts_.taken + accounts_.braked +
           lastLeg(i).u * massOf(i, lastTurning(i).j);
  };
  const Vec21 before = sum();
  std::erase(puck.strokes, stroke);
  std::vector<CommittedLeg> onTheirWay = std::move(puck.decided);
  puck.decided.clear();
  for (const CommittedLeg& old : onTheirWay) {
    accounts_.radiated = accounts_.radiated - old.radiated;
    accounts_.taken = accounts_.taken - old.taken;
    accounts_.braked = accounts_.braked - old.braked;
  }
  history.keepLegs(puck.file, legsBegun(i));

  const Leg followed = legOf(i);
  LegState struck = s.fromHand ? signalArrives(followed, s.hand, s.height) : momentAt(followed, s.hand.t);
  // Light that arrives as a turn does may by rounding find the new leg before it begins.
  if (struck.x.t < followed.start.t) struck = {followed.start, followed.u, followed.properTime};
  const Turning turning = turningAt(i, struck.properTime);
  const auto [u, j] = struckBy(i, s, struck.u, turning.j);
  const std::size_t struckLeg = legsBegun(i);
  CommittedLeg decided;
  if (!onTheirWay.empty()) history.noteChange(struck.x);
  decided.leg = {struck.x, u, struck.properTime, brake_};
  decided.turning = {j, turning.angle};
  decided.signal = struck.x;
  decided.atOnce = true;
  decided.event = history.addStroke(static_cast<std::uint32_t>(stroke), s.fromHand ? s.hand : struck.x,
                                    puck.height + (s.fromHand ? s.height : 0.0));
  history.addTurn(decided.event, puck.file, struck, u, {turning.j, j});
  decide(i, decided, struck, history);
  predictions_[i].lastPartner = -1;

  while (!onTheirWay.empty()) {
    const Leg leg = lastLeg(i);
    const auto arrives = [&](const CommittedLeg& kick) { return signalArrives(leg, kick.signal).x.t; };
    const auto next = std::min_element(onTheirWay.begin(), onTheirWay.end(),
                                       [&](const auto& a, const auto& b) { return arrives(a) < arrives(b); });
    const CommittedLeg old = *next;
    onTheirWay.erase(next);
    if (old.cushion >= 0 &&
        (old.isPrevented(struckLeg, struck.x.t) || !(cushions_[old.cushion].towards(leg.u) > 0.0))) {
      accounts_.heat -= old.heat;
      history.changeBounce(old.event, old.contact, true, 0.0);
      const double kept = lastTurning(i).j;
      history.changeTurn(old.event, puck.file, {leg.start, leg.u, leg.properTime}, leg.u, {kept, kept});
    } else {
      placeAnew(i, old, history);
    }
  }
  accounts_.given = accounts_.given + (sum() - before);
}

// A kick on its way acts on the last leg decided, which is not the one that it was found for.
void CollisionScheduler::placeAnew(int i, CommittedLeg kick, GameHistory& history) {
  PuckState& puck = pucks_[i];
  Place place = whereSignalArrives(i, kick.signal, kick.cushion, history);
  const Leg leg = lastLeg(i);
  if (place.tooLate) place.turn = {leg.start, leg.u, leg.properTime};
  const LegState& turn = place.turn;
  if (place.touchedBefore) {
    kick.contact = cornerBefore(kick.cushion, *place.touchedBefore).value_or(place.touchedBefore->event);
    kick.ownTime = place.touchedBefore->ownTime;
    kick.withoutDelay = place.touchedBefore->withoutDelay;
    kick.signal = kick.withoutDelay ? turn.x : kick.contact;
    kick.foundOn = lastLegNumber(i);
  }
  const double oldHeat = kick.heat;
  kick.leg.start = turn.x;
  kick.leg.properTime = turn.properTime;
  const Turning turning = turningAt(i, turn.properTime);
  if (kick.cushion >= 0) {
    const double e = restitution(i, cushionRestitution_, turn.x.t);
    const auto bounced = cushionKick(i, kick.cushion, kick.contact, turn, turning.j, e);
    kick.heat = bounced ? bounced->centre.heat : 0.0;
    kick.leg.u = bounced ? bounced->centre.u : turn.u;
    kick.turning = {bounced ? bounced->j : turning.j, turning.angle};
    kick.taken = turn.u * massOf(i, turning.j) - kick.leg.u * (massOf(i, kick.turning.j) + kick.heat);
  } else {
    giveAnew(i, turn.u, turning, kick);
  }
  kick.radiated = kick.leg.u * kick.heat;
  accounts_.heat += kick.heat - oldHeat;
  noteBounce(kick, history);
  history.changeTurn(kick.event, puck.file, turn, kick.leg.u, {turning.j, kick.turning.j});
  decide(i, kick, turn, history);
}

// The kick of another puck on its way gives the impulse and the spin that it would have given.
void CollisionScheduler::giveAnew(int i, const Vec21& u, const Turning& turning, CommittedLeg& kick) const {
  const double before = massOf(i, kick.jBefore), after = massOf(i, kick.turning.j);
  const Turning turned{turning.j + (kick.turning.j - kick.jBefore), turning.angle};
  const double now = massOf(i, turning.j), then = massOf(i, turned.j);
  if (before == after && now == then && before == now) {
    kick.leg.u = fourVelocity(u.x + kick.leg.u.x - kick.uBefore.x, u.y + kick.leg.u.y - kick.uBefore.y);
  } else {
    const Vec21 impulse = kick.leg.u * after - kick.uBefore * before;
    kick.leg.u = fourVelocity((u.x * now + impulse.x) / then, (u.y * now + impulse.y) / then);
  }
  kick.turning = turned;
}

void CollisionScheduler::noteBounce(const CommittedLeg& decided, GameHistory& history) const {
  if (decided.cushion < 0) return;
  history.changeBounce(decided.event, decided.contact, decided.withoutDelay, decided.heat * c_m_s_ * c_m_s_);
}

double CollisionScheduler::restitution(int i, double usual, double turnTime) {
  PuckState& puck = pucks_[i];
  const double window = kJamPerRadius * discs_[i].radius;
  if (puck.jammed && turnTime - puck.lastKick > window) puck.jammed = false, puck.kicksInRun = 0;
  return puck.jammed ? 0.0 : usual;
}

void CollisionScheduler::noteKick(int i, const Vec21& turn) {
  PuckState& puck = pucks_[i];
  puck.lastKick = turn.t;
  if (puck.jammed) return;
  if (puck.kicksInRun == 0 || turn.t - puck.runBegan > kJamPerRadius * discs_[i].radius) {
    puck.runBegan = turn.t;
    puck.kicksInRun = 0;
  }
  if (++puck.kicksInRun < kKicksOfAJam) return;
  puck.jammed = true;
  jams_.push_back({puck.file, {turn.t / c_m_s_, {turn.x, turn.y, puck.height}}});
}

}  // namespace carom
