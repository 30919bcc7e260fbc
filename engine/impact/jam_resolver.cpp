#include "engine/impact/jam_resolver.h"

#include <algorithm>
#include <cmath>

#include "engine/impact/contact_finder.h"

namespace carom {

namespace {

constexpr double kSlow = 1e-6;      // of light speed, or of the hardest impact: slower than this is together
constexpr double kGrazing = 1e-3;   // closing over relative speed: they pass, a millionth of R1 + R2 deep
constexpr double kRounded = 1e-6;   // of that again: rounding
constexpr int kJamsToDouble = 4;    // turns in a jam until the bound of slowness doubles
constexpr int kJamsToRest = 64;     // without peace, after which a body moves on with what it touches
constexpr double kMostLeft = 1e-3;  // of the hardest impact: what closes faster is kicked

}  // namespace

void JamResolver::settle(const PuckPair& who, const PairContact& contact,
                         const std::array<LegState, 2>& turn) {
  std::array<double, 2> mass;
  for (int k = 0; k < 2; ++k) mass[k] = game_.massOf(who[k], game_.turningAt(who[k], turn[k].properTime).j);
  const std::optional<PairKick> kick = kickPair(contact.U, contact.n, {turn[0].u, turn[1].u}, mass, 0.0);
  if (!kick) return;
  double hardest = kick->closing;
  for (const int i : who) hardest = std::max(hardest, game_.pucks[i].hardestImpact);
  const double impact = std::min(1.0, hardest), slow = slowIn(who, hardest);
  const double relative = std::sqrt(relative2(turn[0].u, turn[1].u));
  if (kick->closing < slow && (relative <= kRounded * slow || kick->closing < kGrazing * relative)) return;
  for (const int i : who) game_.pucks[i].hardestImpact = hardest;
  jam_.bodies.clear();
  for (int k = 0; k < 2; ++k) jam_.bodies.push_back(bodyOf(who[k], turn[k]));
  gather(contact.U, std::min(turn[0].x.t, turn[1].x.t));
  for (JamBody& body : jam_.bodies) {
    for (int k = 0; k < 2; ++k) {
      if (body.puck == who[k]) body.kick(kick->u[k], kick->heat[k]);
    }
  }
  const bool settled = solver().relax(0.125 * std::min(slow, kMostLeft * impact));
  solver().moveOnTogether(settled || game_.rules.outlines == nullptr ? slow : kNever);
  commit(contact.event);
}

bool JamResolver::settleEverywhere(std::span<const int> who, std::span<const LegState> turn,
                                   const Vec21& touch, const Vec21& U) {
  jam_.bodies.clear();
  double earliest = kNever, hardest = 0.0;
  for (std::size_t k = 0; k < who.size(); ++k) {
    jam_.bodies.push_back(bodyOf(who[k], turn[k]));
    earliest = std::min(earliest, turn[k].x.t);
    hardest = std::max(hardest, game_.pucks[who[k]].hardestImpact);
  }
  gather(U, earliest);
  const double slow = slowIn(who, hardest);
  const bool again = game_.pucks[who[0]].jams >= kJamsToRest;
  const bool settled = solver().relax(0.125 * slow);
  solver().moveOnTogether(settled && !again ? slow : kNever);
  return commit(touch);
}

JamSolver JamResolver::solver() {
  const GameRules& rules = game_.rules;
  return {{rules.puckRestitution, rules.cushionRestitution, rules.outlines != nullptr},
          rules.cushions,
          jam_.bodies,
          jam_.contacts};
}

// Slower members move on together.
double JamResolver::slowIn(std::span<const int> who, double hardest) const {
  int jams = 0;
  for (const int i : who) jams = std::max(jams, game_.pucks[i].jams);
  return std::min(1.0, hardest) * std::min(1.0, std::ldexp(kSlow, jams / kJamsToDouble));
}

JamBody JamResolver::bodyOf(int i, const LegState& turn) const {
  JamBody body;
  body.puck = i;
  body.masses = game_.spins[i].body;
  body.radius = game_.discs[i].radius;
  body.outline = game_.outlineOf(i);
  body.turn = turn;
  body.turning = game_.turningAt(i, turn.properTime);
  body.j = body.turning.j;
  body.mass = game_.massOf(i, body.j);
  body.u = turn.u;
  const std::vector<CushionPlane>& cushions = game_.rules.cushions;
  for (std::size_t k = 0; k < cushions.size(); ++k) {
    const bool isNear = cushions[k].inside(turn.x) <= body.radius * (1.0 + kJamTouching);
    if (isNear && cushionContactsOf(game_, i).touches(body, cushions[k])) body.cushions |= 1u << k;
  }
  return body;
}

// Where a further puck would turn; none if it meets something else before.
std::optional<LegState> JamResolver::joinsAt(int i, const Vec21& touched, const Vec21& U,
                                             double earliest) const {
  const Leg leg = game_.lastLeg(i);
  LegState turn = simultaneousWith(leg, touched, U);
  if (turn.x.t < earliest) turn = momentAt(leg, earliest);
  if (turn.x.t < leg.start.t) turn = {leg.start, leg.u, leg.properTime};
  const PredictedEvent& next = game_.predictions[i].next;
  if (next.kind == PredictedKind::cushion && next.ownTime < turn.x.t) return std::nullopt;
  for (const int stroke : game_.pucks[i].strokes) {
    if (game_.arrivesAt(stroke, leg) < turn.x.t) return std::nullopt;
  }
  for (int k = 0; k < static_cast<int>(game_.rules.cushions.size()); ++k) {
    const auto before = cushionContactsOf(game_, i).touchOf(game_, i, leg, game_.lastTurning(i), k);
    if (before && before->turn.x.t < turn.x.t) return std::nullopt;
  }
  return turn;
}

std::optional<JamContact> JamResolver::contactOf(const JamBody& one, const JamBody& other) const {
  const double radii = one.radius + other.radius, reach = radii * (1.0 + kJamTouching);
  const Vec21 n = wayBetween(one, other);
  if (!(-dot(n, n) <= reach * reach)) return std::nullopt;
  return contactsOf(game_, one.puck, other.puck).jamContactOf(game_, one, other);
}

// Adds all pressed pucks that touch the members, in a chain.
void JamResolver::gather(const Vec21& U, double earliest) {
  std::vector<JamBody>& bodies = jam_.bodies;
  for (const JamBody& body : bodies) jam_.isIn[body.puck] = true;
  for (std::size_t m = 0; m < bodies.size(); ++m) {
    const int found = cells_.findNear(cells_.cellOf(bodies[m].puck), 1, jam_.near.data());
    std::sort(jam_.near.begin(), jam_.near.begin() + found);
    for (int k = 0; k < found; ++k) {
      const int other = jam_.near[k];
      if (!game_.isPressed(other, earliest) || jam_.isIn[other]) continue;
      const std::optional<LegState> at = joinsAt(other, bodies[m].turn.x, U, earliest);
      if (!at) continue;
      const JamBody body = bodyOf(other, *at);
      if (!contactOf(bodies[m], body)) continue;
      jam_.isIn[other] = true;
      bodies.push_back(body);
    }
  }
  for (const JamBody& body : bodies) jam_.isIn[body.puck] = false;
  std::sort(bodies.begin(), bodies.end(), [](const JamBody& x, const JamBody& y) { return x.puck < y.puck; });
  gatherContacts();
}

void JamResolver::gatherContacts() {
  jam_.contacts.clear();
  const int count = static_cast<int>(jam_.bodies.size());
  const double far = 8.0 * game_.rules.largestRadius;
  for (int i = 0; i < count; ++i) {
    jam_.bodies[i].group = i;
    const Vec21& x = jam_.bodies[i].turn.x;
    for (int j = i + 1; j < count; ++j) {
      const Vec21& y = jam_.bodies[j].turn.x;
      if (std::abs(x.x - y.x) > far || std::abs(x.y - y.y) > far) continue;
      std::optional<JamContact> contact = contactOf(jam_.bodies[i], jam_.bodies[j]);
      if (!contact) continue;
      contact->first = i;
      contact->second = j;
      jam_.contacts.push_back(std::move(*contact));
    }
  }
}

// Returns whether anything has changed.
bool JamResolver::commit(const Vec21& touch) {
  std::vector<JamBody>& bodies = jam_.bodies;
  std::erase_if(bodies, [](const JamBody& m) {
    return m.heat == 0.0 && m.u.x == m.turn.u.x && m.u.y == m.turn.u.y && m.j == m.turning.j;
  });
  if (bodies.empty()) return false;
  const GameRules& rules = game_.rules;
  double heat = 0.0, hardest = 0.0;
  for (const JamBody& body : bodies) hardest = std::max(hardest, game_.pucks[body.puck].hardestImpact);
  for (const JamBody& body : bodies) {
    const int i = body.puck;
    PuckState& puck = game_.pucks[i];
    CommittedLeg decided;
    decided.leg = {body.turn.x, body.u, body.turn.properTime, rules.brake};
    decided.turning = {body.j, body.turning.angle};
    decided.signal = body.turn.x;
    decided.event = history_.addJam(touch, body.heat * rules.c_m_s * rules.c_m_s);
    decided.heat = body.heat;
    decided.radiated = body.radiated;
    decided.taken = body.taken;
    history_.addTurn(decided.event, puck.file, body.turn, body.u, {body.turning.j, body.j});
    game_.accounts.heat += body.heat;
    heat += body.heat;
    const double delay =
        rules.convention == TurnConvention::signalAtCentre ? body.turn.u.t * body.radius : 0.0;
    game_.noteDecided(i, std::max(game_.decidedAt(i), body.turn.x.t - delay));
    game_.decide(i, decided, body.turn, history_);
    puck.lastImpact = std::max(puck.lastImpact, body.turn.x.t);
    puck.hardestImpact = std::max(puck.hardestImpact, hardest);
    ++puck.jams;
    game_.predictions[i].lastPartner = -1;
  }
  const PuckState& first = game_.pucks[bodies.front().puck];
  game_.jams.push_back({first.file,
                        {touch.t / rules.c_m_s, {touch.x, touch.y, first.height}},
                        bodies.size(),
                        heat * rules.c_m_s * rules.c_m_s});
  return true;
}

}  // namespace carom
