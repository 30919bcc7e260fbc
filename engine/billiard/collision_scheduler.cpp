#include "engine/billiard/collision_scheduler.h"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

constexpr std::size_t kPucksInCache = 2000;
constexpr unsigned kStepsAtOnce = 4;  // for which data are asked for

}  // namespace

CollisionScheduler::CollisionScheduler(const BilliardSetup& setup)
    : game_(setup), neighbours_(setup, game_), queue_(game_.count()), jam_(setup.pucks.size()) {
  for (const Flash& flash : setup.flashes)
    flashes_.emplace_back(static_cast<std::uint32_t>(flashes_.size()), flash.at);
  std::stable_sort(flashes_.begin(), flashes_.end(),
                   [](const auto& a, const auto& b) { return a.second.t_s < b.second.t_s; });
  predictor().predictAll();
}

void CollisionScheduler::addStroke(const Stroke& stroke) { predictor().predict(game_.addStroke(stroke)); }

// It leaves a disc without mass, at rest where nothing comes.
CollisionScheduler::Withdrawn CollisionScheduler::withdraw(std::size_t puck, double t, GameHistory& history) {
  constexpr double kFarAway = 1e9;
  const int i = game_.numberOf(puck);
  PuckState& left = game_.pucks[i];
  Withdrawn gone{momentAt(game_.legOf(i), t), game_.lastLeg(i).u, {left.strokes.begin(), left.strokes.end()}};
  history.keepLegs(left.file, game_.legsBegun(i));
  left.decided.clear();
  left.strokes.clear();
  left.mass = 0.0;
  game_.beginLeg(i, {{t, kFarAway, kFarAway}, {1.0, 0.0, 0.0}}, {});
  EventPredictor predictor = this->predictor();
  predictor.predict(i);
  predictor.predictDependents(i);
  return gone;
}

bool CollisionScheduler::playUntil(double limit, std::size_t events, GameHistory& history) {
  deferredLater_ = 0;
  while (game_.count() > 0 && (queue_.firstDue() <= limit || hasDeferredBefore(limit))) {
    if (history.eventCount() >= events) return false;
    flashUntil(queue_.firstDue(), history);
    step(history);
  }
  flashUntil(limit, history);
  return true;
}

// Flashes take their places in the list of events when everything due before them has been committed.
void CollisionScheduler::flashUntil(double limit, GameHistory& history) {
  const double c = game_.rules.c_m_s;
  for (; flashed_ < flashes_.size() && flashes_[flashed_].second.t_s * c <= limit; ++flashed_) {
    const auto& [place, flash] = flashes_[flashed_];
    history.addFlash(place, flash);
    clock_ = std::max(clock_, flash.t_s * c);
  }
}

// A puck put off behind a later one may still have something to do before `limit`. Those that have not are
// set aside until the limit changes: what changes the event of one of them gives it another place in the
// queue, too.
bool CollisionScheduler::hasDeferredBefore(double limit) {
  while (deferred_.size() > deferredLater_) {
    const int i = deferred_.back();
    const PredictedEvent& next = game_.predictions[i].next;
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
  const CellGrid& cells = neighbours_.cells();
  const auto fetch = [&](int i) {
    prefetch(&game_.predictions[i]);
    prefetch(&game_.discs[i]);
    cells.fetchCellOf(i);
    queue_.fetch(i);
  };
  queue_.lookAhead(0, kOwn, fetch);
  queue_.lookAhead(1, kOthers, [&](int i) {
    const Prediction& own = game_.predictions[i];
    const int cell = cells.cellOf(i), axis = own.leavesAlong(), way = wayAlong(game_.discs[i], axis);
    if (own.leavesCell < own.next.ownTime) {
      cells.fetch(cell);
      return cells.fetchAhead(cells.beside(cell, axis, way), axis, way);
    }
    const int other = own.next.kind == PredictedKind::pair ? own.next.with : i;
    if (other < i) return;
    cells.fetchNear(cell);
    if (cells.cellOf(other) != cell) cells.fetchNear(cells.cellOf(other));
    for (const int puck : {i, other}) {
      game_.fetch(puck);
      if (const int dependent = game_.predictions[puck].firstDependent; dependent >= 0) fetch(dependent);
    }
  });
}

void CollisionScheduler::step(GameHistory& history) {
  const int i = queue_.first();
  clock_ = std::max(clock_, queue_.firstDue());
  jam_.bodies.clear();
  if (game_.pucks.size() > kPucksInCache && ++steps_ % kStepsAtOnce == 0) prefetchUpcoming();
  const PredictedEvent predicted = game_.predictions[i].next;
  if (game_.predictions[i].leavesCell < predicted.ownTime) return predictor().crossCells(i);
  switch (predicted.kind) {
    case PredictedKind::none:
      return;
    case PredictedKind::turn:
      game_.beginDecided(i);
      break;
    case PredictedKind::stroke:
      resolver(history).strike(i, predicted.with);
      break;
    case PredictedKind::cushion:
      resolver(history).bounce(i, predicted);
      break;
    case PredictedKind::pair:
      return meet(i, history);
  }
  if (neighbours_.areTooSmall(game_)) return predictor().predictAll();
  EventPredictor predictor = this->predictor();
  predictor.predict(i);
  predictor.predictDependents(i);
  predictMembers(predictor, i, i);
}

// A contact happens when it is the next thing in both pucks' own time.
void CollisionScheduler::meet(int i, GameHistory& history) {
  const PredictedEvent a = game_.predictions[i].next;
  const int j = a.with;
  Prediction &mine = game_.predictions[i], &theirs = game_.predictions[j];
  const bool mutual = theirs.next.kind == PredictedKind::pair && theirs.next.with == i;
  if (!mutual && theirs.next.ownTime < a.otherTime && !waitsForItself(i)) {
    queue_.setDue(i, std::nextafter(std::max(queue_.due(i), queue_.due(j)), kNever));
    deferred_.push_back(i);
    return;
  }
  if (game_.pucks.size() > kPucksInCache) {
    const CellGrid& cells = neighbours_.cells();
    for (const int dependent : {mine.firstDependent, theirs.firstDependent}) {
      if (dependent >= 0) cells.fetchNear(cells.cellOf(dependent));
    }
  }
  PredictedEvent ordered = a;
  if (j < i) std::swap(ordered.ownTime, ordered.otherTime);
  const unsigned myLeg = mine.legNumber, theirLeg = theirs.legNumber;
  const double until = resolver(history).collide({std::min(i, j), std::max(i, j)}, ordered);
  if (mine.legNumber == myLeg) game_.noteHandled(i, {j, theirLeg, until});
  if (theirs.legNumber == theirLeg) game_.noteHandled(j, {i, myLeg, until});
  if (neighbours_.areTooSmall(game_)) return predictor().predictAll();
  EventPredictor predictor = this->predictor();
  predictor.predictBoth(i, j);
  predictor.predictDependents(i);
  predictor.predictDependents(j);
  predictMembers(predictor, i, j);
}

// Those of a jam besides the one or two by which it was found.
void CollisionScheduler::predictMembers(EventPredictor& predictor, int i, int j) const {
  for (const JamBody& body : jam_.bodies) {
    if (body.puck == i || body.puck == j) continue;
    predictor.predict(body.puck);
    predictor.predictDependents(body.puck);
  }
}

// Do the pucks that this one waits for wait, in the end, for it? Then no order is right, and the first due
// goes.
bool CollisionScheduler::waitsForItself(int i) const {
  int at = game_.predictions[i].next.with;
  for (int steps = 0; steps <= game_.count(); ++steps) {
    const PredictedEvent& a = game_.predictions[at].next;
    if (a.kind != PredictedKind::pair) return false;
    if (a.with == i) return true;
    const PredictedEvent& theirs = game_.predictions[a.with].next;
    if (theirs.kind == PredictedKind::pair && theirs.with == at) return false;
    at = a.with;
  }
  return true;
}

}  // namespace carom
