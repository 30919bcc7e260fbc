#include "engine/billiard/collision_scheduler.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace carom {

namespace {

std::vector<CushionPlane> cushionsOf(const std::optional<Board>& board) {
  if (!board) return {};
  const double x = 0.5 * board->length_m, y = 0.5 * board->width_m;
  return {{0, 1.0, x}, {0, -1.0, x}, {1, 1.0, y}, {1, -1.0, y}};  // in the order of `Cushion`
}

constexpr std::size_t kPucksInCache = 2000;
constexpr unsigned kStepsAtOnce = 4;  // for which data are asked for

std::vector<std::size_t> byName(const std::vector<Puck>& pucks) {
  std::vector<std::size_t> order(pucks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return pucks[a].name < pucks[b].name; });
  return order;
}

}  // namespace

CollisionScheduler::CollisionScheduler(const BilliardSetup& setup)
    : c_m_s_(setup.lightSpeed_m_s),
      convention_(setup.rules.collisionEvent == CollisionEvent::centre
                      ? TurnConvention::signalAtCentre
                      : TurnConvention::simultaneousWithContact),
      puckRestitution_(setup.rules.puckRestitution),
      cushionRestitution_(setup.rules.cushionRestitution),
      canPress_(std::min(puckRestitution_, cushionRestitution_) < 1.0),
      brake_(setup.rules.friction_m_s2 / (c_m_s_ * c_m_s_)),
      puckRims_{1.0, setup.rules.puckFriction, setup.rules.tangentialRestitution},
      cushionRims_{1.0, setup.rules.cushionFriction, setup.rules.tangentialRestitution},
      slowing_(setup.rules.spinDeceleration_m_s2 / (c_m_s_ * c_m_s_)),
      turns_(setup.rules.puckFriction > 0.0 || setup.rules.cushionFriction > 0.0),
      cushions_(cushionsOf(setup.board)),
      predictions_(setup.pucks.size()),
      queue_(static_cast<int>(setup.pucks.size())),
      inJam_(setup.pucks.size(), 0) {
  double lowX = kNever, lowY = kNever, highX = -kNever, highY = -kNever;
  for (const std::size_t file : byName(setup.pucks)) {
    const Puck& puck = setup.pucks[file];
    const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(puck.beta, puck.beta));
    PuckState state;
    const Vec21 start{0.0, puck.position_m.x, puck.position_m.y};
    const Vec21 u = fourVelocity(gamma * puck.beta.x, gamma * puck.beta.y);
    state.mass = puck.mass_kg;
    state.height = 0.5 * puck.height_m;
    state.file = static_cast<unsigned>(file);
    discs_.push_back({start, u, puck.radius_m, kNever});
    pucks_.push_back(state);
    spins_.push_back(
        {{puck.mass_kg, puck.inertia * puck.mass_kg}, {puck.spin_kg_m2_s / (puck.radius_m * c_m_s_), 0.0}});
    turns_ = turns_ || puck.spin_kg_m2_s != 0.0;
    largestRadius_ = std::max(largestRadius_, puck.radius_m);
    gammaBound_ = std::max(gammaBound_, 1.25 * u.t);
    rollbackWindow_ = std::max(rollbackWindow_, 4.0 * u.t * puck.radius_m);
    lowX = std::min(lowX, puck.position_m.x), highX = std::max(highX, puck.position_m.x);
    lowY = std::min(lowY, puck.position_m.y), highY = std::max(highY, puck.position_m.y);
  }
  takeOutlines(setup);
  if (setup.board) {
    boxLowX_ = -0.5 * setup.board->length_m, boxWidth_ = setup.board->length_m;
    boxLowY_ = -0.5 * setup.board->width_m, boxHeight_ = setup.board->width_m;
  } else if (!pucks_.empty()) {
    boxLowX_ = lowX, boxWidth_ = highX - lowX, boxLowY_ = lowY, boxHeight_ = highY - lowY;
  }
  for (const Stroke& stroke : setup.strokes) storeStroke(stroke);
  for (const Flash& flash : setup.flashes)
    flashes_.emplace_back(static_cast<std::uint32_t>(flashes_.size()), flash.at);
  std::stable_sort(flashes_.begin(), flashes_.end(),
                   [](const auto& a, const auto& b) { return a.second.t_s < b.second.t_s; });
  predictAll();
}

void CollisionScheduler::addStroke(const Stroke& stroke) { predict(storeStroke(stroke)); }

int CollisionScheduler::numberOf(std::size_t puck) const {
  const auto found =
      std::find_if(pucks_.begin(), pucks_.end(), [&](const PuckState& p) { return p.file == puck; });
  return static_cast<int>(found - pucks_.begin());
}

// It leaves a disc without mass, at rest where nothing comes.
CollisionScheduler::Withdrawn CollisionScheduler::withdraw(std::size_t puck, double t, GameHistory& history) {
  constexpr double kFarAway = 1e9;
  const int i = numberOf(puck);
  PuckState& left = pucks_[i];
  Withdrawn gone{momentAt(legOf(i), t), lastLeg(i).u, {left.strokes.begin(), left.strokes.end()}};
  history.keepLegs(left.file, legsBegun(i));
  left.decided.clear();
  left.strokes.clear();
  left.mass = 0.0;
  beginLeg(i, {{t, kFarAway, kFarAway}, {1.0, 0.0, 0.0}}, {});
  predict(i);
  predictDependents(i);
  return gone;
}

int CollisionScheduler::storeStroke(const Stroke& stroke) {
  const int number = numberOf(stroke.puck);
  PuckStroke own;
  own.hand.t = stroke.at_s * c_m_s_;
  own.fromHand = stroke.from_m.has_value();
  if (stroke.from_m) {
    own.hand.x = stroke.from_m->x, own.hand.y = stroke.from_m->y;
    own.height = stroke.from_m->z - pucks_[number].height;
  }
  own.px = stroke.momentum_kg_m_s.x / c_m_s_, own.py = stroke.momentum_kg_m_s.y / c_m_s_;
  own.offset = stroke.offset_m;
  turns_ = turns_ || stroke.offset_m != 0.0;
  if (!isWithdrawn(number)) pucks_[number].strokes.push_back(static_cast<int>(strokes_.size()));
  strokes_.push_back(own);
  return number;
}

bool CollisionScheduler::playUntil(double limit, std::size_t events, GameHistory& history) {
  deferredLater_ = 0;
  while (!pucks_.empty() && (queue_.firstDue() <= limit || hasDeferredBefore(limit))) {
    if (history.eventCount() >= events) return false;
    flashUntil(queue_.firstDue(), history);
    step(history);
  }
  flashUntil(limit, history);
  return true;
}

// Flashes take their places in the list of events when everything due before them has been committed.
void CollisionScheduler::flashUntil(double limit, GameHistory& history) {
  for (; flashed_ < flashes_.size() && flashes_[flashed_].second.t_s * c_m_s_ <= limit; ++flashed_) {
    const auto& [place, flash] = flashes_[flashed_];
    history.addFlash(place, flash);
    clock_ = std::max(clock_, flash.t_s * c_m_s_);
  }
}

// A puck put off behind a later one may still have something to do before `limit`. Those that have not are
// set aside until the limit changes: what changes the event of one of them gives it another place in the
// queue, too.
bool CollisionScheduler::hasDeferredBefore(double limit) {
  while (deferred_.size() > deferredLater_) {
    const int i = deferred_.back();
    const PredictedEvent& next = predictions_[i].next;
    if (queue_.due(i) <= next.due()) {
      deferred_.pop_back();
    } else if (next.ownTime <= limit || next.otherTime <= limit) {
      return true;
    } else {
      std::swap(deferred_.back(), deferred_[deferredLater_++]);
    }
  }
  return false;
}

// Memory takes as long as some hundred operations. Of many pucks the data are asked for some events before
// they are needed: a puck's own, then what these lead to. Of two that meet, which are due at once, the first
// does it.
void CollisionScheduler::prefetchUpcoming() {
  constexpr int kOwn = DueQueue::kSoon, kOthers = 11;  // events ahead
  const auto fetch = [&](int i) {
    prefetch(&predictions_[i]);
    prefetch(&discs_[i]);
    cells_.fetchCellOf(i);
    queue_.fetch(i);
  };
  queue_.lookAhead(0, kOwn, fetch);
  queue_.lookAhead(1, kOthers, [&](int i) {
    const Prediction& own = predictions_[i];
    const int cell = cells_.cellOf(i), axis = leavesFirst(i);
    if (own.leavesCell < own.next.ownTime) {
      cells_.fetch(cell);
      return cells_.fetchAhead(cells_.beside(cell, axis, wayAlong(i, axis)), axis, wayAlong(i, axis));
    }
    const int other = own.next.kind == PredictedKind::pair ? own.next.with : i;
    if (other < i) return;
    cells_.fetchNear(cell);
    if (cells_.cellOf(other) != cell) cells_.fetchNear(cells_.cellOf(other));
    for (const int puck : {i, other}) {
      fetchState(puck);
      if (const int dependent = predictions_[puck].firstDependent; dependent >= 0) fetch(dependent);
    }
  });
}

void CollisionScheduler::step(GameHistory& history) {
  const int i = queue_.first();
  clock_ = std::max(clock_, queue_.firstDue());
  moveEpoch();
  jamBodies_.clear();
  if (pucks_.size() > kPucksInCache && ++steps_ % kStepsAtOnce == 0) prefetchUpcoming();
  const PredictedEvent predicted = predictions_[i].next;
  if (predictions_[i].leavesCell < predicted.ownTime) return changeCell(i, leavesFirst(i));
  switch (predicted.kind) {
    case PredictedKind::none:
      return;
    case PredictedKind::turn:
      beginCommitted(i);
      break;
    case PredictedKind::stroke:
      strike(i, predicted.with, history);
      break;
    case PredictedKind::cushion:
      bounce(i, predicted, history);
      break;
    case PredictedKind::pair:
      return meet(i, history);
  }
  if (cellsTooSmall_) return predictAll();
  predict(i);
  predictDependents(i);
  predictMembers(i, i);
}

// A contact happens when it is the next thing in both pucks' own time.
void CollisionScheduler::meet(int i, GameHistory& history) {
  const PredictedEvent a = predictions_[i].next;
  const int j = a.with;
  const PredictedEvent& theirs = predictions_[j].next;
  const bool mutual = theirs.kind == PredictedKind::pair && theirs.with == i;
  if (!mutual && theirs.ownTime < a.otherTime && !waitsForItself(i)) {
    queue_.setDue(i, std::nextafter(std::max(queue_.due(i), queue_.due(j)), kNever));
    deferred_.push_back(i);
    return;
  }
  if (pucks_.size() > kPucksInCache) {
    for (const int dependent : {predictions_[i].firstDependent, predictions_[j].firstDependent}) {
      if (dependent >= 0) cells_.fetchNear(cells_.cellOf(dependent));
    }
  }
  const bool inOrder = i < j;
  PredictedEvent ordered = a;
  if (!inOrder) std::swap(ordered.ownTime, ordered.otherTime);
  const unsigned legs[2] = {predictions_[i].legNumber, predictions_[j].legNumber};
  const double until = collide(inOrder ? i : j, inOrder ? j : i, ordered, history);
  if (predictions_[i].legNumber == legs[0]) noteMet(i, {j, legs[1], until});
  if (predictions_[j].legNumber == legs[1]) noteMet(j, {i, legs[0], until});
  if (cellsTooSmall_) return predictAll();
  predictBoth(i, j);
  predictDependents(i);
  predictDependents(j);
  predictMembers(i, j);
}

// Those of a jam besides the one or two by which it was found.
void CollisionScheduler::predictMembers(int i, int j) {
  for (const JamBody& member : jamBodies_) {
    if (member.puck == i || member.puck == j) continue;
    predict(member.puck);
    predictDependents(member.puck);
  }
}

// Do the pucks that this one waits for wait, in the end, for it? Then no order is right, and the first due
// goes.
bool CollisionScheduler::waitsForItself(int i) const {
  int at = predictions_[i].next.with;
  for (std::size_t steps = 0; steps <= pucks_.size(); ++steps) {
    const PredictedEvent& a = predictions_[at].next;
    if (a.kind != PredictedKind::pair) return false;
    if (a.with == i) return true;
    const PredictedEvent& theirs = predictions_[a.with].next;
    if (theirs.kind == PredictedKind::pair && theirs.with == at) return false;
    at = a.with;
  }
  return true;
}

void CollisionScheduler::changeCell(int i, int axis) {
  const int way = wayAlong(i, axis);
  const int into = cells_.beside(cells_.cellOf(i), axis, way);
  cells_.move(i, into, coarseFlightOf(i));
  findCellExit(i);
  const PredictedEvent& before = predictions_[i].next;
  PredictedEvent best = before;
  cells_.findAhead(into, axis, way, found_);
  considerPairs(i, 0, sortOut(i, 0), best);
  considerCushions(i, best);
  if (best.ownTime == before.ownTime && best.with == before.with) return schedule(i);
  setPredictedEvent(i, best);
}

Ledger CollisionScheduler::ledger() const {
  Vec21 motion;
  for (std::size_t i = 0; i < pucks_.size(); ++i) {
    const int puck = static_cast<int>(i);
    motion = motion + lastLeg(puck).u * massOf(puck, lastTurning(puck).j);
  }
  const auto account = [&](const Vec21& p) {
    return Ledger::Account{p.t * c_m_s_ * c_m_s_, {p.x * c_m_s_, p.y * c_m_s_}};
  };
  return {account(motion),           account(accounts_.radiated), account(accounts_.taken),
          account(accounts_.braked), account(accounts_.given),    accounts_.heat * c_m_s_ * c_m_s_};
}

void CollisionScheduler::restore(GameHistory& history) const {
  for (std::size_t i = 0; i < pucks_.size(); ++i) {
    const PuckState& puck = pucks_[i];
    if (isWithdrawn(static_cast<int>(i))) continue;
    history.keepLegs(puck.file, legsBegun(static_cast<int>(i)));
    for (const CommittedLeg& decided : puck.decided) {
      history.addLeg(puck.file, decided.leg, decided.turning, decided.signal);
      history.changeTurn(decided.event, puck.file,
                         {decided.leg.start, decided.uBefore, decided.leg.properTime}, decided.leg.u,
                         {decided.jBefore, decided.turning.j});
      noteBounce(decided, history);
    }
  }
}

}  // namespace carom
