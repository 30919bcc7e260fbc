#include "engine/impact/jam_solver.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/never.h"

namespace carom {

namespace {

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

// The lever from the centre to the contact, simultaneous in the body's own frame.
LeveredBody levered(const JamBody& body, const Vec21& touch) {
  const Vec21 way = touch - body.turn.x;
  return {{body.masses, body.j, body.u}, body.radius, way - body.u * dot(body.u, way)};
}

}  // namespace

Vec21 wayBetween(const JamBody& one, const JamBody& two) {
  return poseOf(one.turn.x, one.turn.u, two.turn.x, two.turn.u).n;
}

double relative2(const Vec21& u1, const Vec21& u2) {
  const double x = u1.x - u2.x, y = u1.y - u2.y;
  const double t = ((u1.x + u2.x) * x + (u1.y + u2.y) * y) / (u1.t + u2.t);
  return std::max(0.0, x * x + y * y - t * t);
}

MovingShape JamBody::shape() const {
  return {turn.x, u, radius, outline, turning.angle, rimBeta(masses, j) / radius};
}

// Each sweep goes through the contacts the other way round; those whose bodies the last two sweeps left alone
// are left out.
bool JamSolver::relax(double slow) {
  const int sweeps = rules_.withCorners ? kSweepsWithCorners : kSweeps;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    bool settled = true;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const JamContact& contact = contacts_[sweep % 2 == 0 ? k : contacts_.size() - 1 - k];
      JamBody &one = bodies_[contact.first], &two = bodies_[contact.second];
      if (one.changed < sweep - 1 && two.changed < sweep - 1) continue;
      if (!part(contact, slow)) continue;
      settled = false;
      one.changed = two.changed = sweep;
    }
    for (JamBody& body : bodies_) {
      const Vec21 before = body.u;
      const double j = body.j;
      if (body.cushions == 0) continue;
      body.outline == nullptr ? leaveCushions(body, slow) : partFromCushions(body);
      if (before.x != body.u.x || before.y != body.u.y || j != body.j) {
        settled = false;
        body.changed = sweep;
      }
    }
    if (settled) return true;
  }
  return false;
}

bool JamSolver::part(const JamContact& contact, double slow) {
  JamBody &one = bodies_[contact.first], &two = bodies_[contact.second];
  return contact.hasCorners ? partCorners(one, two, contact.places) : partDiscs(one, two, slow);
}

// A perfectly plastic kick; among elastic bodies with corners discs bounce without loss.
bool JamSolver::partDiscs(JamBody& one, JamBody& two, double slow) const {
  const Pose pose = poseOf(one.turn.x, one.u, two.turn.x, two.u);
  const double restitution = rules_.withCorners && rules_.puckRestitution == 1.0 ? 1.0 : 0.0;
  const std::optional<PairKick> kick =
      kickPair(pose.U, pose.n, {one.u, two.u}, {one.mass, two.mass}, restitution);
  if (!kick || kick->closing < slow) return false;
  one.kick(kick->u[0], kick->heat[0]);
  two.kick(kick->u[1], kick->heat[1]);
  return true;
}

// A kick without friction at that of the places where two bodies touch at which they close fastest. Returns
// whether they close.
bool JamSolver::partCorners(JamBody& one, JamBody& two, std::span<const TouchedPlace> places) const {
  const RimRules rules{rules_.puckRestitution < 1.0 ? kJamRebound : 1.0};
  const Vec21 U = equalSpeedFrame(one.u, two.u);
  std::optional<SpinningPairKick> fastest;
  for (const TouchedPlace& place : places) {
    const std::array<LeveredBody, 2> bodies{levered(one, place.event), levered(two, place.event)};
    const auto kick = kickCorners(U, place.n, bodies, rules);
    if (kick && kick->centres.closing > (fastest ? fastest->centres.closing : kResting)) fastest = kick;
  }
  if (!fastest) return false;
  one.turnTo(fastest->j[0]), two.turnTo(fastest->j[1]);
  one.kick(fastest->centres.u[0], fastest->centres.heat[0]);
  two.kick(fastest->centres.u[1], fastest->centres.heat[1]);
  return true;
}

void JamSolver::leaveCushions(JamBody& body, double slow) const {
  for (std::size_t cushion = 0; cushion < cushions_.size(); ++cushion) {
    if ((body.cushions >> cushion & 1u) == 0 || !(cushions_[cushion].towards(body.u) > slow)) continue;
    const double mass = body.mass;
    const auto kick = kickOffCushion(cushions_[cushion], body.u, mass, 0.0);
    body.heat += kick->heat;
    body.radiated = body.radiated + kick->u * kick->heat;
    body.taken = body.taken + (body.u * mass - kick->u * (mass + kick->heat));
    body.u = kick->u;
  }
}

// Likewise from each cushion that a body with corners touches.
void JamSolver::partFromCushions(JamBody& body) const {
  const RimRules rules{rules_.cushionRestitution < 1.0 ? kJamRebound : 1.0};
  for (std::size_t k = 0; k < cushions_.size(); ++k) {
    if ((body.cushions >> k & 1u) == 0) continue;
    const MovingShape shape = body.shape();
    const Vec21 momentum = body.u * body.mass;
    std::optional<SpinningCushionKick> fastest;
    for (const Vec21& place : touchedPlaces(shape, cushions_[k], kJamTouching * shape.radius)) {
      const auto kick = kickCornerOffCushion(cushions_[k], levered(body, place), rules);
      if (kick && kick->centre.closing > (fastest ? fastest->centre.closing : kResting)) fastest = kick;
    }
    if (!fastest) continue;
    body.turnTo(fastest->j);
    body.kick(fastest->centre.u, fastest->centre.heat);
    body.taken = body.taken + (momentum - body.u * (body.mass + fastest->centre.heat));
  }
}

// Of body i heat m_i (γ_i − 1) in the frame of the common velocity: Σ (m_i + heat_i) u = Σ m_i u_i. Bodies
// with corners lose their spins, whose energy becomes heat as well.
void JamSolver::moveOnTogether(double slow) {
  const bool all = slow == kNever;
  for (bool changed = true; changed;) {
    changed = false;
    for (const JamContact& contact : contacts_) {
      JamBody &one = bodies_[contact.first], &two = bodies_[contact.second];
      if (one.group == two.group || (!all && contact.hasCorners)) continue;
      if (!(relative2(one.u, two.u) < slow * slow)) continue;
      const int group = std::min(one.group, two.group);
      one.group = two.group = group;
      changed = true;
    }
  }
  for (std::size_t first = 0; first < bodies_.size(); ++first) {
    if (bodies_[first].group != static_cast<int>(first)) continue;
    if (!all && bodies_[first].outline != nullptr) continue;
    moveGroup(static_cast<int>(first));
  }
}

void JamSolver::moveGroup(int group) {
  Vec21 sum;
  unsigned cushions = 0;
  bool differ = false;
  for (const JamBody& body : bodies_) {
    if (body.group != group) continue;
    differ = differ || body.u.x != bodies_[group].u.x || body.u.y != bodies_[group].u.y;
    sum = sum + body.u * body.mass;
    cushions |= body.cushions;
  }
  const double perMass = 1.0 / std::sqrt(dot(sum, sum));
  const Vec21 u = differ ? fourVelocity(sum.x * perMass, sum.y * perMass) : bodies_[group].u;
  for (JamBody& body : bodies_) {
    if (body.group != group) continue;
    double heat = 0.5 * body.mass * relative2(body.u, u);
    if (body.outline != nullptr) {
      heat += body.mass - body.masses.mass;
      body.turnTo(0.0);
    }
    body.kick(u, heat);
    body.cushions = cushions;
    leaveCushions(body, 0.0);
  }
}

}  // namespace carom
