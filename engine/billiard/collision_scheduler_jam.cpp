// What happens to pucks that press on one another: see `Billiard` in billiard.h.

#include <algorithm>
#include <cmath>

#include "engine/billiard/collision_scheduler.h"

namespace carom {

namespace {

constexpr int kBlowsOfAJam = 64;
constexpr double kSlow = 1e-6;       // of light speed, or of the hardest blow: slower than this is together
constexpr double kTouching = 1e-6;   // of R1 + R2: nearer than this is touching
constexpr double kGrazing = 1e-3;    // closing over relative speed: they pass, a millionth of R1 + R2 deep
constexpr double kStill = 1e-6;      // of that again: rounding
constexpr int kBlowsByPressed = 16;  // the number that the kick of a pressed puck counts
constexpr int kJamsToDouble = 4;     // turns in a jam until the bound of slowness doubles
constexpr double kMostLeft = 1e-3;   // of the hardest blow: what closes faster is kicked
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
void CollisionScheduler::noteBlow(int i, double turnTime, double closing, bool manifold) {
  if (!canPress_) return;
  PuckState& player = pucks_[i];
  const double radius = discs_[i].radius;
  const bool peace = turnTime - player.lastBlow > radius;
  const bool newRun = player.blows < kBlowsOfAJam && turnTime - player.blowsBegan > radius;
  if (peace || newRun)
    player.blowsBegan = turnTime, player.blows = 0, player.jams = 0, player.hardestBlow = 0.0;
  player.blows += manifold ? kBlowsByPressed : 1;
  player.lastBlow = std::max(player.lastBlow, turnTime);
  player.hardestBlow = std::max(player.hardestBlow, closing);
}

bool CollisionScheduler::isPressed(int i, double t) const {
  const PuckState& player = pucks_[i];
  return canPress_ && player.blows >= kBlowsOfAJam && !(t - player.lastBlow > discs_[i].radius);
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
  for (const int i : who) hardest = std::max(hardest, pucks_[i].hardestBlow);
  const double blow = std::min(1.0, hardest), slow = slowIn(who, hardest);
  const double relative = std::sqrt(relative2(turn[0].u, turn[1].u));
  if (kick->closing < slow && (relative <= kStill * slow || kick->closing < kGrazing * relative)) return;
  for (const int i : who) pucks_[i].hardestBlow = hardest;
  members_.clear();
  for (int k = 0; k < 2; ++k) members_.push_back(memberOf(who[k], turn[k]));
  gatherJam(contact.U, std::min(turn[0].x.t, turn[1].x.t));
  for (Member& member : members_) {
    for (int k = 0; k < 2; ++k) {
      if (member.puck == who[k]) kicked(member, kick->u[k], kick->heat[k]);
    }
  }
  moveOnTogether(relax(0.125 * std::min(slow, kMostLeft * blow)) || outlines_ == nullptr ? slow : kNever);
  commitJam(contact.event, history);
}

// Slower members move on together.
double CollisionScheduler::slowIn(std::span<const int> who, double hardest) const {
  int jams = 0;
  for (const int i : who) jams = std::max(jams, pucks_[i].jams);
  return std::min(1.0, hardest) * std::min(1.0, std::ldexp(kSlow, jams / kJamsToDouble));
}

void CollisionScheduler::kicked(Member& member, const Vec21& u, double heat) {
  member.u = u;
  member.heat += heat;
  member.radiated = member.radiated + u * heat;
}

CollisionScheduler::Member CollisionScheduler::memberOf(int i, const LegState& turn) const {
  Member member;
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
  const PredictedEvent& next = outlooks_[i].next;
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

bool CollisionScheduler::touch(const Member& one, const Member& other) const {
  const double radii = discs_[one.puck].radius + discs_[other.puck].radius, reach = radii * (1.0 + kTouching);
  const Vec21 n = poseOf(one.turn.x, one.turn.u, other.turn.x, other.turn.u).n;
  if (!(-dot(n, n) <= reach * reach)) return false;
  return !hasCorners(one.puck, other.puck) || !placesOf(one, other).empty();
}

// Adds all pressed pucks that touch the members, in a chain.
void CollisionScheduler::gatherJam(const Vec21& U, double earliest) {
  for (const Member& member : members_) inJam_[member.puck] = true;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const int found = cells_.findNear(cells_.cellOf(members_[m].puck), 1, near_.data());
    std::sort(near_.begin(), near_.begin() + found);
    for (int k = 0; k < found; ++k) {
      const int other = near_[k];
      if (!isPressed(other, earliest) || inJam_[other]) continue;
      const std::optional<LegState> at = joinsAt(other, members_[m].turn.x, U, earliest);
      if (!at) continue;
      const Member member = memberOf(other, *at);
      if (!touch(members_[m], member)) continue;
      inJam_[other] = true;
      members_.push_back(member);
    }
  }
  for (const Member& member : members_) inJam_[member.puck] = false;
  std::sort(members_.begin(), members_.end(),
            [](const Member& x, const Member& y) { return x.puck < y.puck; });
  presses_.clear();
  const int count = static_cast<int>(members_.size());
  for (int i = 0; i < count; ++i) {
    members_[i].body = i;
    const Vec21& x = members_[i].turn.x;
    for (int j = i + 1; j < count; ++j) {
      const Vec21& y = members_[j].turn.x;
      if (std::abs(x.x - y.x) > 8.0 * largestRadius_ || std::abs(x.y - y.y) > 8.0 * largestRadius_) continue;
      if (!touch(members_[i], members_[j])) continue;
      presses_.push_back({i, j, {}});
      if (hasCorners(members_[i].puck, members_[j].puck))
        presses_.back().places = placesOf(members_[i], members_[j]);
    }
  }
}

void CollisionScheduler::leaveCushions(Member& member, double slow) {
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

bool CollisionScheduler::partDiscs(Member& one, Member& two, double slow) const {
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
    for (std::size_t k = 0; k < presses_.size(); ++k) {
      const Press& press = presses_[sweep % 2 == 0 ? k : presses_.size() - 1 - k];
      Member &one = members_[press.first], &two = members_[press.second];
      if (one.changed < sweep - 1 && two.changed < sweep - 1) continue;
      if (!(hasCorners(one.puck, two.puck) ? partCorners(one, two, press.places) : partDiscs(one, two, slow)))
        continue;
      settled = false;
      one.changed = two.changed = sweep;
    }
    for (Member& member : members_) {
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
    for (const Press& press : presses_) {
      Member &one = members_[press.first], &two = members_[press.second];
      if (one.body == two.body || (!all && hasCorners(one.puck, two.puck))) continue;
      if (!(relative2(one.u, two.u) < slow * slow)) continue;
      const int body = std::min(one.body, two.body);
      one.body = two.body = body;
      changed = true;
    }
  }
  for (std::size_t first = 0; first < members_.size(); ++first) {
    if (members_[first].body != static_cast<int>(first)) continue;
    if (!all && outlineOf(members_[first].puck) != nullptr) continue;
    moveBody(static_cast<int>(first));
  }
}

void CollisionScheduler::moveBody(int body) {
  Vec21 sum;
  unsigned cushions = 0;
  bool differ = false;
  for (const Member& member : members_) {
    if (member.body != body) continue;
    differ = differ || member.u.x != members_[body].u.x || member.u.y != members_[body].u.y;
    sum = sum + member.u * member.mass;
    cushions |= member.cushions;
  }
  const double perMass = 1.0 / std::sqrt(dot(sum, sum));
  const Vec21 u = differ ? fourVelocity(sum.x * perMass, sum.y * perMass) : members_[body].u;
  for (Member& member : members_) {
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
  std::erase_if(members_, [](const Member& m) {
    return m.heat == 0.0 && m.u.x == m.turn.u.x && m.u.y == m.turn.u.y && m.j == m.turning.j;
  });
  if (members_.empty()) return false;
  double heat = 0.0;
  double hardest = 0.0;
  for (const Member& member : members_) hardest = std::max(hardest, pucks_[member.puck].hardestBlow);
  for (const Member& member : members_) {
    const int i = member.puck;
    PuckState& player = pucks_[i];
    CommittedLeg decided;
    decided.leg = {member.turn.x, member.u, member.turn.properTime, brake_};
    decided.turning = {member.j, member.turning.angle};
    decided.signal = member.turn.x;
    decided.event = history.addJam(touch, member.heat * c_m_s_ * c_m_s_);
    decided.heat = member.heat;
    decided.radiated = member.radiated;
    decided.taken = member.taken;
    history.addTurn(decided.event, player.file, member.turn, member.u, {member.turning.j, member.j});
    accounts_.heat += member.heat;
    heat += member.heat;
    const double delay =
        convention_ == TurnConvention::signalAtCentre ? member.turn.u.t * discs_[i].radius : 0.0;
    noteDecided(i, std::max(decidedAt(i), member.turn.x.t - delay));
    decide(i, decided, member.turn, history);
    player.lastBlow = std::max(player.lastBlow, member.turn.x.t);
    player.hardestBlow = std::max(player.hardestBlow, hardest);
    ++player.jams;
    outlooks_[i].lastPartner = -1;
  }
  const PuckState& first = pucks_[members_.front().puck];
  jams_.push_back({first.file,
                   {touch.t / c_m_s_, {touch.x, touch.y, first.height}},
                   members_.size(),
                   heat * c_m_s_ * c_m_s_});
  return true;
}

}  // namespace carom
