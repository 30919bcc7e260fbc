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
constexpr int kBlowsByPressed = 16;  // the kick of a pressed puck counts as so many
constexpr int kJamsToDouble = 4;     // turns in a jam until what is slow is twice as fast
constexpr double kMostLeft = 1e-3;   // of the hardest blow: what closes faster is kicked
constexpr int kSweeps = 10000;

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

void CollisionScheduler::noteBlow(int i, double turnTime, double closing, bool byPressed) {
  if (!canPress(i)) return;
  PuckState& player = pucks_[i];
  const double radius = discs_[i].radius;
  const bool peace = turnTime - player.lastBlow > radius;
  const bool newRun = player.blows < kBlowsOfAJam && turnTime - player.blowsBegan > radius;
  if (peace || newRun)
    player.blowsBegan = turnTime, player.blows = 0, player.jams = 0, player.hardestBlow = 0.0;
  player.blows += byPressed ? kBlowsByPressed : 1;
  player.lastBlow = std::max(player.lastBlow, turnTime);
  player.hardestBlow = std::max(player.hardestBlow, closing);
}

bool CollisionScheduler::isPressed(int i, double t) const {
  const PuckState& player = pucks_[i];
  return canPress(i) && player.blows >= kBlowsOfAJam && !(t - player.lastBlow > discs_[i].radius);
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
  const double blow = std::min(1.0, hardest);
  const int jams = std::max(pucks_[who[0]].jams, pucks_[who[1]].jams);
  const double slow = blow * std::min(1.0, std::ldexp(kSlow, jams / kJamsToDouble));
  const double relative = std::sqrt(relative2(turn[0].u, turn[1].u));
  if (kick->closing < slow && (relative <= kStill * slow || kick->closing < kGrazing * relative)) return;
  for (const int i : who) pucks_[i].hardestBlow = hardest;
  gatherJam(who, contact, turn);
  for (Member& member : members_) {
    for (int k = 0; k < 2; ++k) {
      if (member.puck == who[k]) kicked(member, kick->u[k], kick->heat[k]);
    }
  }
  relax(0.125 * std::min(slow, kMostLeft * blow));
  moveOnTogether(slow);
  commitJam(contact, history);
}

void CollisionScheduler::kicked(Member& member, const Vec21& u, double heat) {
  member.u = u;
  member.heat += heat;
  member.radiated = member.radiated + u * heat;
}

void CollisionScheduler::addMember(int i, const LegState& turn) {
  Member member;
  member.puck = i;
  member.turn = turn;
  member.turning = turningAt(i, turn.properTime);
  member.mass = massOf(i, member.turning.j);
  member.u = turn.u;
  for (std::size_t cushion = 0; cushion < cushions_.size(); ++cushion) {
    if (cushions_[cushion].inside(turn.x) <= discs_[i].radius * (1.0 + kTouching))
      member.cushions |= 1u << cushion;
  }
  inJam_[i] = true;
  members_.push_back(member);
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
  for (const CushionPlane& cushion : cushions_) {
    const auto before = findContact(leg, discs_[i].radius, cushion, convention_);
    if (before && before->turn.x.t < turn.x.t) return std::nullopt;
  }
  return turn;
}

void CollisionScheduler::gatherJam(const std::array<int, 2>& who, const PairContact& contact,
                                   const std::array<LegState, 2>& turn) {
  const double earliest = std::min(turn[0].x.t, turn[1].x.t);
  members_.clear();
  for (int k = 0; k < 2; ++k) addMember(who[k], turn[k]);
  const auto touch = [&](const Member& one, int other, const LegState& at) {
    const double reach = (discs_[one.puck].radius + discs_[other].radius) * (1.0 + kTouching);
    const Vec21 n = poseOf(one.turn.x, one.turn.u, at.x, at.u).n;
    return -dot(n, n) <= reach * reach;
  };
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const int found = cells_.findNear(cells_.cellOf(members_[m].puck), 1, near_.data());
    std::sort(near_.begin(), near_.begin() + found);
    for (int k = 0; k < found; ++k) {
      const int other = near_[k];
      if (!isPressed(other, earliest) || inJam_[other] || outlineOf(other) != nullptr) continue;
      const std::optional<LegState> at = joinsAt(other, members_[m].turn.x, contact.U, earliest);
      if (at && touch(members_[m], other, *at)) addMember(other, *at);
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
      if (touch(members_[i], members_[j].puck, members_[j].turn)) presses_.push_back({i, j});
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

// Perfectly plastic kicks, one after the other, until none closes faster than `slow`.
void CollisionScheduler::relax(double slow) {
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    bool settled = true;
    for (std::size_t k = 0; k < presses_.size(); ++k) {
      const Press& press = presses_[sweep % 2 == 0 ? k : presses_.size() - 1 - k];
      Member &one = members_[press.first], &two = members_[press.second];
      if (one.changed < sweep - 1 && two.changed < sweep - 1) continue;
      const Pose pose = poseOf(one.turn.x, one.u, two.turn.x, two.u);
      const std::array<double, 2> mass{one.mass, two.mass};
      const std::optional<PairKick> kick = kickPair(pose.U, pose.n, {one.u, two.u}, mass, 0.0);
      if (!kick || kick->closing < slow) continue;
      settled = false;
      one.changed = two.changed = sweep;
      kicked(one, kick->u[0], kick->heat[0]);
      kicked(two, kick->u[1], kick->heat[1]);
    }
    for (Member& member : members_) {
      const Vec21 before = member.u;
      if (member.cushions == 0) continue;
      leaveCushions(member, slow);
      if (before.x != member.u.x || before.y != member.u.y) settled = false, member.changed = sweep;
    }
    if (settled) return;
  }
}

// Those that touch and move relative to each other slower than `slow` get one velocity, that of their total
// momentum. Of member i heat m_i (γ_i − 1) in the frame of this velocity: Σ (m_i + heat_i) u = Σ m_i u_i.
void CollisionScheduler::moveOnTogether(double slow) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const Press& press : presses_) {
      Member &one = members_[press.first], &two = members_[press.second];
      if (one.body == two.body || !(relative2(one.u, two.u) < slow * slow)) continue;
      const int body = std::min(one.body, two.body);
      one.body = two.body = body;
      changed = true;
    }
  }
  for (std::size_t first = 0; first < members_.size(); ++first) {
    if (members_[first].body != static_cast<int>(first)) continue;
    Vec21 sum;
    unsigned cushions = 0;
    bool differ = false;
    for (const Member& member : members_) {
      if (member.body != static_cast<int>(first)) continue;
      differ = differ || member.u.x != members_[first].u.x || member.u.y != members_[first].u.y;
      sum = sum + member.u * member.mass;
      cushions |= member.cushions;
    }
    if (!differ && cushions == 0) continue;
    const double perMass = 1.0 / std::sqrt(dot(sum, sum));
    const Vec21 u = differ ? fourVelocity(sum.x * perMass, sum.y * perMass) : members_[first].u;
    for (Member& member : members_) {
      if (member.body != static_cast<int>(first)) continue;
      const double heat = 0.5 * member.mass * relative2(member.u, u);
      member.heat += heat;
      member.radiated = member.radiated + u * heat;
      member.u = u;
      member.cushions = cushions;
      leaveCushions(member, 0.0);
    }
  }
}

void CollisionScheduler::commitJam(const PairContact& contact, GameHistory& history) {
  std::erase_if(members_,
                [](const Member& m) { return m.heat == 0.0 && m.u.x == m.turn.u.x && m.u.y == m.turn.u.y; });
  double heat = 0.0;
  double hardest = 0.0;
  for (const Member& member : members_) hardest = std::max(hardest, pucks_[member.puck].hardestBlow);
  for (const Member& member : members_) {
    const int i = member.puck;
    PuckState& player = pucks_[i];
    CommittedLeg decided;
    decided.leg = {member.turn.x, member.u, member.turn.properTime, brake_};
    decided.turning = member.turning;
    decided.signal = member.turn.x;
    decided.event = history.addJam(contact.event, member.heat * c_m_s_ * c_m_s_);
    decided.heat = member.heat;
    decided.radiated = member.radiated;
    decided.taken = member.taken;
    history.addTurn(decided.event, player.file, member.turn, member.u, {member.turning.j, member.turning.j});
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
                   {contact.event.t / c_m_s_, {contact.event.x, contact.event.y, first.height}},
                   members_.size(),
                   heat * c_m_s_ * c_m_s_});
}

}  // namespace carom
