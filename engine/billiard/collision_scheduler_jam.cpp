// What happens to pucks that press on one another: see `Billiard` in billiard.h.

#include <algorithm>
#include <cmath>

#include "engine/billiard/collision_scheduler.h"

namespace carom {

namespace {

constexpr int kImpactsOfAJam = 64;
constexpr double kSlow = 1e-6;     // of light speed, or of the hardest impact: slower than this is together
constexpr double kGrazing = 1e-3;  // closing over relative speed: they pass, a millionth of R1 + R2 deep
constexpr double kStill = 1e-6;    // of that again: rounding
constexpr int kImpactsByPressed = 16;  // the number that the kick of a pressed puck counts
constexpr int kJamsToDouble = 4;       // turns in a jam until the bound of slowness doubles
constexpr double kMostLeft = 1e-3;     // of the hardest impact: what closes faster is kicked

}  // namespace

// Of many at once, by what presses or lies on the puck.
void CollisionScheduler::noteImpact(int i, double turnTime, double closing, bool manifold) {
  if (!canPress_) return;
  PuckState& puck = pucks_[i];
  const double radius = discs_[i].radius;
  const bool peace = turnTime - puck.lastImpact > radius;
  const bool newRun = puck.impacts < kImpactsOfAJam && turnTime - puck.impactsBegan > radius;
  if (peace || newRun)
    puck.impactsBegan = turnTime, puck.impacts = 0, puck.jams = 0, puck.hardestImpact = 0.0;
  puck.impacts += manifold ? kImpactsByPressed : 1;
  puck.lastImpact = std::max(puck.lastImpact, turnTime);
  puck.hardestImpact = std::max(puck.hardestImpact, closing);
}

bool CollisionScheduler::isPressed(int i, double t) const {
  const PuckState& puck = pucks_[i];
  return canPress_ && puck.impacts >= kImpactsOfAJam && !(t - puck.lastImpact > discs_[i].radius);
}

// The kick of two pressed pucks: together with all pressed pucks that touch them, in a chain, they come to
// where none closes on another.
void CollisionScheduler::settle(const std::array<int, 2>& who, const PairContact& contact,
                                const std::array<LegState, 2>& turn, GameHistory& history) {
  const std::array<double, 2> mass{massOf(who[0], turningAt(who[0], turn[0].properTime).j),
                                   massOf(who[1], turningAt(who[1], turn[1].properTime).j)};
  const std::optional<PairKick> kick = kickPair(contact.U, contact.n, {turn[0].u, turn[1].u}, mass, 0.0);
  if (!kick) return;
  double hardest = kick->closing;
  for (const int i : who) hardest = std::max(hardest, pucks_[i].hardestImpact);
  const double impact = std::min(1.0, hardest), slow = slowIn(who, hardest);
  const double relative = std::sqrt(relative2(turn[0].u, turn[1].u));
  if (kick->closing < slow && (relative <= kStill * slow || kick->closing < kGrazing * relative)) return;
  for (const int i : who) pucks_[i].hardestImpact = hardest;
  jamBodies_.clear();
  for (int k = 0; k < 2; ++k) jamBodies_.push_back(jamBodyOf(who[k], turn[k]));
  gatherJam(contact.U, std::min(turn[0].x.t, turn[1].x.t));
  for (JamBody& member : jamBodies_) {
    for (int k = 0; k < 2; ++k) {
      if (member.puck == who[k]) member.kick(kick->u[k], kick->heat[k]);
    }
  }
  JamSolver solver = jamSolver();
  solver.moveOnTogether(
      solver.relax(0.125 * std::min(slow, kMostLeft * impact)) || outlines_ == nullptr ? slow : kNever);
  commitJam(contact.event, history);
}

// Slower members move on together.
double CollisionScheduler::slowIn(std::span<const int> who, double hardest) const {
  int jams = 0;
  for (const int i : who) jams = std::max(jams, pucks_[i].jams);
  return std::min(1.0, hardest) * std::min(1.0, std::ldexp(kSlow, jams / kJamsToDouble));
}

JamBody CollisionScheduler::jamBodyOf(int i, const LegState& turn) const {
  JamBody member;
  member.puck = i;
  member.masses = spins_[i].body;
  member.radius = discs_[i].radius;
  member.outline = outlineOf(i);
  member.turn = turn;
  member.turning = turningAt(i, turn.properTime);
  member.j = member.turning.j;
  member.mass = massOf(i, member.j);
  member.u = turn.u;
  for (std::size_t cushion = 0; cushion < cushions_.size(); ++cushion) {
    const bool near = cushions_[cushion].inside(turn.x) <= discs_[i].radius * (1.0 + kJamTouching);
    if (near && (member.outline == nullptr ||
                 !touchedPlaces(member.shape(), cushions_[cushion], kJamTouching * member.radius).empty()))
      member.cushions |= 1u << cushion;
  }
  return member;
}

// Where a further puck would turn; none if it meets something else before.
std::optional<LegState> CollisionScheduler::joinsAt(int i, const Vec21& touched, const Vec21& U,
                                                    double earliest) const {
  const Leg leg = lastLeg(i);
  LegState turn = simultaneousWith(leg, touched, U);
  if (turn.x.t < earliest) turn = momentAt(leg, earliest);
  if (turn.x.t < leg.start.t) turn = {leg.start, leg.u, leg.properTime};
  const PredictedEvent& next = predictions_[i].next;
  if (next.kind == PredictedKind::cushion && next.ownTime < turn.x.t) return std::nullopt;
  for (const int stroke : pucks_[i].strokes) {
    const PuckStroke& s = strokes_[stroke];
    const double arrival = s.fromHand ? signalArrives(leg, s.hand, s.height).x.t : s.hand.t;
    if (arrival < turn.x.t) return std::nullopt;
  }
  for (int k = 0; k < static_cast<int>(cushions_.size()); ++k) {
    const auto before = touchOf(i, leg, lastTurning(i), k);
    if (before && before->turn.x.t < turn.x.t) return std::nullopt;
  }
  return turn;
}

bool CollisionScheduler::touch(const JamBody& one, const JamBody& other) const {
  const double radii = discs_[one.puck].radius + discs_[other.puck].radius,
               reach = radii * (1.0 + kJamTouching);
  const Vec21 n = wayBetween(one, other);
  if (!(-dot(n, n) <= reach * reach)) return false;
  return !hasCorners(one.puck, other.puck) || !placesOf(one, other).empty();
}

// Adds all pressed pucks that touch the members, in a chain.
void CollisionScheduler::gatherJam(const Vec21& U, double earliest) {
  for (const JamBody& member : jamBodies_) inJam_[member.puck] = true;
  for (std::size_t m = 0; m < jamBodies_.size(); ++m) {
    const int found = cells_.findNear(cells_.cellOf(jamBodies_[m].puck), 1, near_.data());
    std::sort(near_.begin(), near_.begin() + found);
    for (int k = 0; k < found; ++k) {
      const int other = near_[k];
      if (!isPressed(other, earliest) || inJam_[other]) continue;
      const std::optional<LegState> at = joinsAt(other, jamBodies_[m].turn.x, U, earliest);
      if (!at) continue;
      const JamBody member = jamBodyOf(other, *at);
      if (!touch(jamBodies_[m], member)) continue;
      inJam_[other] = true;
      jamBodies_.push_back(member);
    }
  }
  for (const JamBody& member : jamBodies_) inJam_[member.puck] = false;
  std::sort(jamBodies_.begin(), jamBodies_.end(),
            [](const JamBody& x, const JamBody& y) { return x.puck < y.puck; });
  jamContacts_.clear();
  const int count = static_cast<int>(jamBodies_.size());
  for (int i = 0; i < count; ++i) {
    jamBodies_[i].group = i;
    const Vec21& x = jamBodies_[i].turn.x;
    for (int j = i + 1; j < count; ++j) {
      const Vec21& y = jamBodies_[j].turn.x;
      if (std::abs(x.x - y.x) > 8.0 * largestRadius_ || std::abs(x.y - y.y) > 8.0 * largestRadius_) continue;
      if (!touch(jamBodies_[i], jamBodies_[j])) continue;
      const bool corners = hasCorners(jamBodies_[i].puck, jamBodies_[j].puck);
      jamContacts_.push_back({i, j, corners, {}});
      if (corners) jamContacts_.back().places = placesOf(jamBodies_[i], jamBodies_[j]);
    }
  }
}

// Returns whether anything has changed.
bool CollisionScheduler::commitJam(const Vec21& touch, GameHistory& history) {
  std::erase_if(jamBodies_, [](const JamBody& m) {
    return m.heat == 0.0 && m.u.x == m.turn.u.x && m.u.y == m.turn.u.y && m.j == m.turning.j;
  });
  if (jamBodies_.empty()) return false;
  double heat = 0.0;
  double hardest = 0.0;
  for (const JamBody& member : jamBodies_) hardest = std::max(hardest, pucks_[member.puck].hardestImpact);
  for (const JamBody& member : jamBodies_) {
    const int i = member.puck;
    PuckState& puck = pucks_[i];
    CommittedLeg decided;
    decided.leg = {member.turn.x, member.u, member.turn.properTime, brake_};
    decided.turning = {member.j, member.turning.angle};
    decided.signal = member.turn.x;
    decided.event = history.addJam(touch, member.heat * c_m_s_ * c_m_s_);
    decided.heat = member.heat;
    decided.radiated = member.radiated;
    decided.taken = member.taken;
    history.addTurn(decided.event, puck.file, member.turn, member.u, {member.turning.j, member.j});
    accounts_.heat += member.heat;
    heat += member.heat;
    const double delay =
        convention_ == TurnConvention::signalAtCentre ? member.turn.u.t * discs_[i].radius : 0.0;
    noteDecided(i, std::max(decidedAt(i), member.turn.x.t - delay));
    decide(i, decided, member.turn, history);
    puck.lastImpact = std::max(puck.lastImpact, member.turn.x.t);
    puck.hardestImpact = std::max(puck.hardestImpact, hardest);
    ++puck.jams;
    predictions_[i].lastPartner = -1;
  }
  const PuckState& first = pucks_[jamBodies_.front().puck];
  jams_.push_back({first.file,
                   {touch.t / c_m_s_, {touch.x, touch.y, first.height}},
                   jamBodies_.size(),
                   heat * c_m_s_ * c_m_s_});
  return true;
}

}  // namespace carom
