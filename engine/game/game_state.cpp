#include "engine/game/game_state.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace carom {

namespace {

std::vector<CushionPlane> cushionsOf(const std::optional<Board>& board) {
  if (!board) return {};
  const double x = 0.5 * board->length_m, y = 0.5 * board->width_m;
  return {{0, 1.0, x}, {0, -1.0, x}, {1, 1.0, y}, {1, -1.0, y}};  // in the order of `Cushion`
}

std::vector<std::size_t> byName(const std::vector<Puck>& pucks) {
  std::vector<std::size_t> order(pucks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return pucks[a].name < pucks[b].name; });
  return order;
}

}  // namespace

GameRules::GameRules(const BilliardSetup& setup)
    : c_m_s(setup.lightSpeed_m_s),
      convention(setup.rules.collisionEvent == CollisionEvent::centre
                     ? TurnConvention::signalAtCentre
                     : TurnConvention::simultaneousWithContact),
      puckRestitution(setup.rules.puckRestitution),
      cushionRestitution(setup.rules.cushionRestitution),
      canPress(std::min(puckRestitution, cushionRestitution) < 1.0),
      brake(setup.rules.friction_m_s2 / (c_m_s * c_m_s)),
      puckRims{1.0, setup.rules.puckFriction, setup.rules.tangentialRestitution},
      cushionRims{1.0, setup.rules.cushionFriction, setup.rules.tangentialRestitution},
      slowing(setup.rules.spinDeceleration_m_s2 / (c_m_s * c_m_s)),
      cushions(cushionsOf(setup.board)) {}

GameState::GameState(const BilliardSetup& setup)
    : rules(setup),
      turns(setup.rules.puckFriction > 0.0 || setup.rules.cushionFriction > 0.0),
      predictions(setup.pucks.size()) {
  std::vector<std::optional<Outline>> outlines(setup.pucks.size());
  bool hasOutlines = false;
  for (const std::size_t file : byName(setup.pucks)) {
    const Puck& puck = setup.pucks[file];
    const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(puck.beta, puck.beta));
    const Vec21 u = fourVelocity(gamma * puck.beta.x, gamma * puck.beta.y);
    if (!puck.outline_m.empty()) {
      outlines[pucks.size()].emplace(puck.outline_m);
      hasOutlines = true;
    }
    PuckState state;
    state.mass = puck.mass_kg;
    state.height = 0.5 * puck.height_m;
    state.file = static_cast<unsigned>(file);
    discs.push_back({{0.0, puck.position_m.x, puck.position_m.y}, u, puck.radius_m, kNever});
    pucks.push_back(state);
    spins.push_back({{puck.mass_kg, puck.inertia * puck.mass_kg},
                     {puck.spin_kg_m2_s / (puck.radius_m * rules.c_m_s), 0.0}});
    turns = turns || puck.spin_kg_m2_s != 0.0;
    rules.largestRadius = std::max(rules.largestRadius, puck.radius_m);
    fastest = std::max(fastest, u.t);
    rollbackWindow = std::max(rollbackWindow, 4.0 * u.t * puck.radius_m);
  }
  if (hasOutlines) {
    rules.outlines = std::make_shared<const std::vector<std::optional<Outline>>>(std::move(outlines));
    turns = rules.canPress = true;
  }
  for (const Stroke& stroke : setup.strokes) addStroke(stroke);
}

int GameState::numberOf(std::size_t puck) const {
  const auto found =
      std::find_if(pucks.begin(), pucks.end(), [&](const PuckState& p) { return p.file == puck; });
  return static_cast<int>(found - pucks.begin());
}

Turning GameState::spunTurning(int i, double properTime) const {
  return turningAfter(lastTurning(i), spins[i].body, discs[i].radius, rules.slowing,
                      properTime - lastLeg(i).properTime);
}

MovingShape GameState::shapeOn(int i, const Leg& leg, const Turning& turning) const {
  const double radius = discs[i].radius;
  return {leg.start, leg.u, radius, outlineOf(i), turning.angle, rimBeta(spins[i].body, turning.j) / radius};
}

const HandledContact* GameState::handled(int i, int other) const {
  if (!predictions[i].hasMet) return nullptr;
  const std::vector<HandledContact>& met = pucks[i].met;
  const auto found = std::find_if(met.rbegin(), met.rend(), [&](const HandledContact& contact) {
    return contact.puck == other && contact.leg == predictions[other].legNumber;
  });
  return found == met.rend() ? nullptr : &*found;
}

void GameState::noteHandled(int i, const HandledContact& contact) {
  pucks[i].met.push_back(contact);
  predictions[i].hasMet = true;
}

const PersistentContact* GameState::persistentContact(int first, int second) const {
  const std::vector<PersistentPartner>& partners = pucks[first].partners;
  const auto found = std::find_if(partners.begin(), partners.end(),
                                  [second](const PersistentPartner& one) { return one.other == second; });
  return found == partners.end() ? nullptr : &found->contact;
}

double GameState::restitution(int i, double usual, double turnTime) {
  pucks[i].noteRest(turnTime, discs[i].radius);
  return pucks[i].jammed ? 0.0 : usual;
}

void GameState::noteKick(int i, const Vec21& turn) {
  PuckState& puck = pucks[i];
  if (puck.noteKick(turn.t, discs[i].radius))
    jams.push_back({puck.file, {turn.t / rules.c_m_s, {turn.x, turn.y, puck.height}}});
}

int GameState::addStroke(const Stroke& stroke) {
  const int number = numberOf(stroke.puck);
  PuckStroke own;
  own.hand.t = stroke.at_s * rules.c_m_s;
  own.fromHand = stroke.from_m.has_value();
  if (stroke.from_m) {
    own.hand.x = stroke.from_m->x;
    own.hand.y = stroke.from_m->y;
    own.height = stroke.from_m->z - pucks[number].height;
  }
  own.px = stroke.momentum_kg_m_s.x / rules.c_m_s;
  own.py = stroke.momentum_kg_m_s.y / rules.c_m_s;
  own.offset = stroke.offset_m;
  turns = turns || stroke.offset_m != 0.0;
  if (!isWithdrawn(number)) pucks[number].strokes.push_back(static_cast<int>(strokes.size()));
  strokes.push_back(own);
  return number;
}

void GameState::decide(int i, const CommittedLeg& given, const LegState& turn, GameHistory& history) {
  PuckState& puck = pucks[i];
  CommittedLeg decided = given;
  const double jBegan = lastTurning(i).j, j = turningAt(i, turn.properTime).j;
  decided.uBefore = turn.u;
  decided.jBefore = j;
  decided.braked = j == jBegan ? (lastLeg(i).u - turn.u) * massOf(i, j)
                               : lastLeg(i).u * massOf(i, jBegan) - turn.u * massOf(i, j);
  accounts.radiated = accounts.radiated + decided.radiated;
  accounts.taken = accounts.taken + decided.taken;
  accounts.braked = accounts.braked + decided.braked;
  history.addLeg(puck.file, decided.leg, decided.turning, decided.signal);
  rollbackWindow = std::max(rollbackWindow, 4.0 * decided.leg.u.t * discs[i].radius);
  fastest = std::max(fastest, decided.leg.u.t);

  const bool atOnce = puck.decided.empty() && (turn.x.t <= discs[i].start.t || decided.atOnce ||
                                               rules.convention == TurnConvention::simultaneousWithContact);
  if (atOnce) {
    beginLeg(i, decided.leg, decided.turning);
  } else {
    puck.decided.push_back(decided);
    discs[i].turnsAt = puck.decided.front().leg.start.t;
  }
}

void GameState::beginLeg(int i, const Leg& leg, const Turning& turning) {
  PuckState& puck = pucks[i];
  if (turns) spins[i].turning = turning;
  puck.properTime = leg.properTime;
  Prediction& own = predictions[i];
  ++own.legNumber;
  own.metCushions = 0;
  own.hasDecided = false;
  if (own.hasMet) {
    puck.met.clear();
    own.hasMet = false;
  }
  discs[i].start = leg.start;
  discs[i].u = leg.u;
  discs[i].turnsAt = puck.decided.empty() ? kNever : puck.decided.front().leg.start.t;
  begun.push_back(i);
}

void GameState::beginDecided(int i) {
  PuckState& puck = pucks[i];
  const Leg leg = puck.decided.front().leg;
  const Turning turning = puck.decided.front().turning;
  puck.decided.erase(puck.decided.begin());
  beginLeg(i, leg, turning);
}

void GameState::restore(GameHistory& history) const {
  for (int i = 0; i < count(); ++i) {
    const PuckState& puck = pucks[i];
    if (isWithdrawn(i)) continue;
    history.keepLegs(puck.file, legsBegun(i));
    for (const CommittedLeg& decided : puck.decided) {
      history.addLeg(puck.file, decided.leg, decided.turning, decided.signal);
      history.changeTurn(decided.event, puck.file,
                         {decided.leg.start, decided.uBefore, decided.leg.properTime}, decided.leg.u,
                         {decided.jBefore, decided.turning.j});
      noteBounce(decided, history);
    }
  }
}

void GameState::noteBounce(const CommittedLeg& decided, GameHistory& history) const {
  if (decided.cushion < 0) return;
  history.changeBounce(decided.event, decided.contact, decided.withoutDelay,
                       decided.heat * rules.c_m_s * rules.c_m_s);
}

Ledger GameState::ledger() const {
  const double c = rules.c_m_s;
  Vec21 motion;
  for (int i = 0; i < count(); ++i) motion = motion + lastLeg(i).u * massOf(i, lastTurning(i).j);
  const auto account = [c](const Vec21& p) { return Ledger::Account{p.t * c * c, {p.x * c, p.y * c}}; };
  return {account(motion),          account(accounts.radiated), account(accounts.taken),
          account(accounts.braked), account(accounts.given),    accounts.heat * c * c};
}

}  // namespace carom
