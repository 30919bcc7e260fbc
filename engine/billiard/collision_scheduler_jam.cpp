// What happens to pucks that press on one another: see `Billiard` in billiard.h.

#include <algorithm>
#include <cmath>

#include "engine/billiard/collision_scheduler.h"

namespace carom {

namespace {

constexpr int kImpactsOfAJam = 64;
constexpr double kSlow = 1e-6;      // of light speed, or of the hardest impact: slower than this is together
constexpr double kTouching = 1e-6;  // of R1 + R2: nearer than this is touching
constexpr double kGrazing = 1e-3;   // closing over relative speed: they pass, a millionth of R1 + R2 deep
constexpr double kStill = 1e-6;     // of that again: rounding
constexpr int kImpactsByPressed = 16;  // the number that the kick of a pressed puck counts
constexpr int kJamsToDouble = 4;       // turns in a jam until the bound of slowness doubles
constexpr double kMostLeft = 1e-3;     // of the hardest impact: what closes faster is kicked
constexpr int kSweeps = 10000;
constexpr int kSweepsWithCorners = 300;  // after which bodies that are wedged move on together

// How two centres at two events lie to each other when the later of both has turned, in the frame in which
// they move with equal speeds: U its four-velocity, n from the first to the second.
struct Pose {
  Vec21 U, n;
};

Pose poseOf(const Vec21& x1, const Vec21& u1, const Vec21& x2, const Vec21& u2) {
  const Vec21 sum = u1 + u2;
  const double twoGamma = std::sqrt(dot(sum, sum));
  Pose pose;
  pose.U = sum * (1.0 / twoGamma);
  pose.n = x2 - x1;
  const double lead = dot(pose.U, pose.n), ownTime = 2.0 * lead / twoGamma;
  pose.n = pose.n - (lead > 0.0 ? u1 : u2) * ownTime;
  return pose;
}

// 2(γrel − 1), which is the square of a small relative celerity, without cancellation.
double relative2(const Vec21& u1, const Vec21& u2) {
  const double x = u1.x - u2.x, y = u1.y - u2.y;
  const double t = ((u1.x + u2.x) * x + (u1.y + u2.y) * y) / (u1.t + u2.t);
  return std::max(0.0, x * x + y * y - t * t);
}

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
      if (member.puck == who[k]) kicked(member, kick->u[k], kick->heat[k]);
    }
  }
  moveOnTogether(relax(0.125 * std::min(slow, kMostLeft * impact)) || outlines_ == nullptr ? slow : kNever);
  commitJam(contact.event, history);
}

// Slower members move on together.
double CollisionScheduler::slowIn(std::span<const int> who, double hardest) const {
  int jams = 0;
  for (const int i : who) jams = std::max(jams, pucks_[i].jams);
  return std::min(1.0, hardest) * std::min(1.0, std::ldexp(kSlow, jams / kJamsToDouble));
}

void CollisionScheduler::kicked(JamBody& member, const Vec21& u, double heat) {
  member.u = u;
  member.heat += heat;
  member.radiated = member.radiated + u * heat;
}

CollisionScheduler::JamBody CollisionScheduler::jamBodyOf(int i, const LegState& turn) const {
  JamBody member;
  member.puck = i;
  member.turn = turn;
  member.turning = turningAt(i, turn.properTime);
  member.j = member.turning.j;
  member.mass = massOf(i, member.j);
  member.u = turn.u;
  for (std::size_t cushion = 0; cushion < cushions_.size(); ++cushion) {
    const bool near = cushions_[cushion].inside(turn.x) <= discs_[i].radius * (1.0 + kTouching);
    if (near && (outlineOf(i) == nullptr || isTouched(member, cushions_[cushion])))
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
  if (next.kind == Kind::cushion && next.ownTime < turn.x.t) return std::nullopt;
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
  const double radii = discs_[one.puck].radius + discs_[other.puck].radius, reach = radii * (1.0 + kTouching);
  const Vec21 n = poseOf(one.turn.x, one.turn.u, other.turn.x, other.turn.u).n;
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
    jamBodies_[i].body = i;
    const Vec21& x = jamBodies_[i].turn.x;
    for (int j = i + 1; j < count; ++j) {
      const Vec21& y = jamBodies_[j].turn.x;
      if (std::abs(x.x - y.x) > 8.0 * largestRadius_ || std::abs(x.y - y.y) > 8.0 * largestRadius_) continue;
      if (!touch(jamBodies_[i], jamBodies_[j])) continue;
      jamContacts_.push_back({i, j, {}});
      if (hasCorners(jamBodies_[i].puck, jamBodies_[j].puck))
        jamContacts_.back().places = placesOf(jamBodies_[i], jamBodies_[j]);
    }
  }
}

void CollisionScheduler::leaveCushions(JamBody& member, double slow) {
  for (std::size_t cushion = 0; cushion < cushions_.size(); ++cushion) {
    if ((member.cushions >> cushion & 1u) == 0 || !(cushions_[cushion].towards(member.u) > slow)) continue;
    const double mass = member.mass;
    const auto kick = kickOffCushion(cushions_[cushion], member.u, mass, 0.0);
    member.heat += kick->heat;
    member.radiated = member.radiated + kick->u * kick->heat;
    member.taken = member.taken + (member.u * mass - kick->u * (mass + kick->heat));
    member.u = kick->u;
  }
}

bool CollisionScheduler::partDiscs(JamBody& one, JamBody& two, double slow) const {
  const Pose pose = poseOf(one.turn.x, one.u, two.turn.x, two.u);
  const double restitution = discsStayElastic() ? 1.0 : 0.0;
  const std::optional<PairKick> kick =
      kickPair(pose.U, pose.n, {one.u, two.u}, {one.mass, two.mass}, restitution);
  if (!kick || kick->closing < slow) return false;
  kicked(one, kick->u[0], kick->heat[0]);
  kicked(two, kick->u[1], kick->heat[1]);
  return true;
}

// Perfectly plastic kicks, one after the other, until none closes faster than `slow`; of bodies with corners, which
// rebound a little, until none closes. Returns whether it came to that.
bool CollisionScheduler::relax(double slow) {
  const int sweeps = outlines_ == nullptr ? kSweeps : kSweepsWithCorners;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    bool settled = true;
    for (std::size_t k = 0; k < jamContacts_.size(); ++k) {
      const JamContact& press = jamContacts_[sweep % 2 == 0 ? k : jamContacts_.size() - 1 - k];
      JamBody &one = jamBodies_[press.first], &two = jamBodies_[press.second];
      if (one.changed < sweep - 1 && two.changed < sweep - 1) continue;
      if (!(hasCorners(one.puck, two.puck) ? partCorners(one, two, press.places) : partDiscs(one, two, slow)))
        continue;
      settled = false;
      one.changed = two.changed = sweep;
    }
    for (JamBody& member : jamBodies_) {
      const Vec21 before = member.u;
      const double j = member.j;
      if (member.cushions == 0) continue;
      outlineOf(member.puck) == nullptr ? leaveCushions(member, slow) : partFromCushions(member);
      if (before.x != member.u.x || before.y != member.u.y || j != member.j)
        settled = false, member.changed = sweep;
    }
    if (settled) return true;
  }
  return false;
}

// Those that touch and move relative to each other slower than `slow` get one velocity, that of their total
// momentum. Of member i heat m_i (γ_i − 1) in the frame of this velocity: Σ (m_i + heat_i) u = Σ m_i u_i. Bodies with
// corners do so only where all do, and lose their spins, whose energy becomes heat as well.
void CollisionScheduler::moveOnTogether(double slow) {
  const bool all = slow == kNever;
  for (bool changed = true; changed;) {
    changed = false;
    for (const JamContact& press : jamContacts_) {
      JamBody &one = jamBodies_[press.first], &two = jamBodies_[press.second];
      if (one.body == two.body || (!all && hasCorners(one.puck, two.puck))) continue;
      if (!(relative2(one.u, two.u) < slow * slow)) continue;
      const int body = std::min(one.body, two.body);
      one.body = two.body = body;
      changed = true;
    }
  }
  for (std::size_t first = 0; first < jamBodies_.size(); ++first) {
    if (jamBodies_[first].body != static_cast<int>(first)) continue;
    if (!all && outlineOf(jamBodies_[first].puck) != nullptr) continue;
    moveBody(static_cast<int>(first));
  }
}

void CollisionScheduler::moveBody(int body) {
  Vec21 sum;
  unsigned cushions = 0;
  bool differ = false;
  for (const JamBody& member : jamBodies_) {
    if (member.body != body) continue;
    differ = differ || member.u.x != jamBodies_[body].u.x || member.u.y != jamBodies_[body].u.y;
    sum = sum + member.u * member.mass;
    cushions |= member.cushions;
  }
  const double perMass = 1.0 / std::sqrt(dot(sum, sum));
  const Vec21 u = differ ? fourVelocity(sum.x * perMass, sum.y * perMass) : jamBodies_[body].u;
  for (JamBody& member : jamBodies_) {
    if (member.body != body) continue;
    double heat = 0.5 * member.mass * relative2(member.u, u);
    if (outlineOf(member.puck) != nullptr)
      heat += member.mass - pucks_[member.puck].mass, turned(member, 0.0);
    kicked(member, u, heat);
    member.cushions = cushions;
    leaveCushions(member, 0.0);
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
