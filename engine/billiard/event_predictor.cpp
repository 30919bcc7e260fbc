#include "engine/billiard/event_predictor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/impact/contact_finder.h"

namespace carom {

namespace {

// The earlier of two predicted events of one puck; equal times go by kind, then by name.
bool isEarlier(double ownTime, int with, const PredictedEvent& than) {
  return ownTime < than.ownTime ||
         (ownTime == than.ownTime && than.kind == PredictedKind::pair && with < than.with);
}

}  // namespace

void EventPredictor::predictAll() {
  neighbours_.layOut(game_, clock_);
  for (int i = 0; i < game_.count(); ++i) setPredictedEvent(i, {});
  for (int i = 0; i < game_.count(); ++i) predict(i);
}

void EventPredictor::predict(int i) { predictAmong(i, 0, findNear(i, 0)); }

// The second's candidates are found while the data of the first's are on their way from memory.
void EventPredictor::predictBoth(int first, int second) {
  if (!neighbours_.hasCells()) {
    predict(first);
    predict(second);
    return;
  }
  const int middle = findNear(first, 0), end = findNear(second, middle);
  predictAmong(first, 0, middle);
  predictAmong(second, middle, end);
}

int EventPredictor::findNear(int i, int begin) {
  if (!neighbours_.hasCells()) return begin;
  const int end = neighbours_.find(game_, i, begin, clock_);
  for (int k = begin; k < end; ++k) queue_.fetch(neighbours_[k]);
  return end;
}

// Of many pucks, only the neighbours from `begin` to `end` can be met.
void EventPredictor::predictAmong(int i, int begin, int end) {
  forgetParted(game_, i);
  PredictedEvent best;
  if (game_.discs[i].turnsAt < kNever) {
    best.kind = PredictedKind::turn;
    best.ownTime = game_.discs[i].turnsAt;
  }
  if (!game_.strokes.empty()) considerStrokes(i, best);
  if (!neighbours_.hasCells()) {
    const bool all = !game_.rules.areStraightDiscs();
    for (int other = 0; other < game_.count(); ++other) {
      if (other == i) continue;
      if (all || mayMeet(game_.discs[i], game_.discs[other], game_.rules.convention))
        considerPair(i, other, best);
    }
  }
  considerPairs(i, begin, end, best);
  considerCushions(i, best);
  setPredictedEvent(i, best);
}

void EventPredictor::crossCells(int i) {
  const int axis = game_.predictions[i].leavesAlong(), way = wayAlong(game_.discs[i], axis);
  const int end = neighbours_.cross(game_, i, axis, way);
  for (int k = 0; k < end; ++k) queue_.fetch(neighbours_[k]);
  const PredictedEvent& before = game_.predictions[i].next;
  PredictedEvent best = before;
  considerPairs(i, 0, end, best);
  considerCushions(i, best);
  if (best.ownTime == before.ownTime && best.with == before.with) return schedule(i);
  setPredictedEvent(i, best);
}

void EventPredictor::setPredictedEvent(int i, const PredictedEvent& a) {
  LargeArray<Prediction>& predictions = game_.predictions;
  Prediction& own = predictions[i];
  if (own.next.kind == PredictedKind::pair) {  // leave the list of the other
    (own.dependentBefore < 0 ? predictions[own.next.with].firstDependent
                             : predictions[own.dependentBefore].nextDependent) = own.nextDependent;
    if (own.nextDependent >= 0) predictions[own.nextDependent].dependentBefore = own.dependentBefore;
  }
  own.next = a;
  if (a.kind == PredictedKind::pair) {
    int& first = predictions[a.with].firstDependent;
    own.dependentBefore = -1;
    own.nextDependent = first;
    if (first >= 0) predictions[first].dependentBefore = i;
    first = i;
  }
  schedule(i);
}

void EventPredictor::schedule(int i) {
  const Prediction& own = game_.predictions[i];
  queue_.setDue(i, own.leavesCell < own.next.ownTime ? own.leavesCell : own.next.due());
}

void EventPredictor::predictDependents(int of) {
  const LargeArray<Prediction>& predictions = game_.predictions;
  void_.clear();
  for (int i = predictions[of].firstDependent; i >= 0; i = predictions[i].nextDependent) {
    if (isVoid(predictions[i].next)) void_.push_back(i);
  }
  std::sort(void_.begin(), void_.end());
  for (const int i : void_) {
    if (isVoid(predictions[i].next)) predict(i);
  }
}

// Whether the other puck has decided something since that makes it void.
bool EventPredictor::isVoid(const PredictedEvent& a) const {
  return a.kind == PredictedKind::pair &&
         (game_.predictions[a.with].legNumber != a.otherLeg || a.otherTime >= game_.discs[a.with].turnsAt ||
          a.otherTime < game_.decidedAt(a.with));
}

void EventPredictor::considerPairs(int i, int begin, int end, PredictedEvent& best) {
  const bool all = !game_.rules.areStraightDiscs();
  for (int k = begin; k < end; ++k) {
    const int other = neighbours_[k];
    if (all || mayMeet(game_.discs[i], game_.discs[other], game_.rules.convention))
      considerPair(i, other, best);
  }
}

void EventPredictor::considerPair(int i, int other, PredictedEvent& best) {
  const bool isFirst = i < other;
  const PairContacts& contacts = contactsOf(game_, i, other);
  const std::optional<Meeting> meeting =
      contacts.meetingOf(game_, isFirst ? PuckPair{i, other} : PuckPair{other, i});
  if (!meeting) return;
  double own = meeting->ownTime[isFirst ? 0 : 1], theirs = meeting->ownTime[isFirst ? 1 : 0];
  const Prediction &puck = game_.predictions[i], &partner = game_.predictions[other];
  // Found again on the leg after.
  if (own >= game_.discs[i].turnsAt || theirs >= game_.discs[other].turnsAt) return;
  const double ownDecided = game_.decidedAt(i), theirsDecided = game_.decidedAt(other);
  if (contacts.isStruckAgain(game_, i, other)) {
    own = std::max(own, ownDecided);
    theirs = std::max(theirs, theirsDecided);
  }
  if (own < ownDecided || theirs < theirsDecided) return;  // what came after it is decided already
  const bool mine = isEarlier(own, other, best), also = isEarlier(theirs, i, partner.next);
  if (!(mine || also) || contacts.haveMet(game_, i, other)) return;
  PredictedEvent a;
  a.kind = PredictedKind::pair;
  a.withoutDelay = meeting->withoutDelay;
  if (also) {
    a.with = i;
    a.otherLeg = puck.legNumber;
    a.ownTime = theirs;
    a.otherTime = own;
    setPredictedEvent(other, a);
  }
  if (mine) {
    a.with = other;
    a.otherLeg = partner.legNumber;
    a.ownTime = own;
    a.otherTime = theirs;
    best = a;
  }
}

// A cushion is at least as near as the edge of a cell when it is touched, so only those of the outermost
// cells matter.
void EventPredictor::considerCushions(int i, PredictedEvent& best) const {
  const CellGrid& cells = neighbours_.cells();
  const int cell = cells.cellOf(i);
  if (!cells.isAtRim(cell)) return;
  const std::vector<CushionPlane>& cushions = game_.rules.cushions;
  const CushionContacts& contacts = cushionContactsOf(game_, i);
  const Leg leg = game_.flightOf(i);
  const unsigned met = game_.predictions[i].metCushions;
  for (int cushion = 0; cushion < static_cast<int>(cushions.size()); ++cushion) {
    const CushionPlane& plane = cushions[cushion];
    if (cells.canLeave(cell, plane.axis, plane.sign > 0.0 ? 1 : -1)) continue;
    if ((met >> cushion & 1u) == 0 && contacts.mayTouch(plane, leg.u)) considerCushion(i, leg, cushion, best);
  }
}

void EventPredictor::considerCushion(int i, const Leg& leg, int cushion, PredictedEvent& best) const {
  const CushionPlane& plane = game_.rules.cushions[cushion];
  // No earlier than straight flight to R (1 + u_n) from the plane, as R sqrt(1 + u_n²) is less; a glide is
  // slower.
  const double un = plane.towards(leg.u);
  const double atLeast = plane.inside(leg.start) - game_.discs[i].radius * (1.0 + std::abs(un));
  if (un > 0.0 ? atLeast * leg.u.t > (best.ownTime - leg.start.t) * un : atLeast > 0.0) return;
  const std::optional<CushionContact> contact =
      cushionContactsOf(game_, i).touchOf(game_, i, leg, game_.spins[i].turning, cushion);
  if (!contact) return;
  const double own = contact->ownTime;
  if (own >= game_.discs[i].turnsAt || own > best.ownTime) return;
  if (own == best.ownTime && best.kind <= PredictedKind::cushion) return;
  best = {};
  best.kind = PredictedKind::cushion;
  best.withoutDelay = contact->withoutDelay;
  best.with = cushion;
  best.ownTime = own;
}

// Whether a stroke acts before another that arrives at the same event: by values that a mirror image or a
// turned board does not change, so that the order in which they became known decides nothing but between
// strokes that are mirror images of each other.
static bool actsFirst(const PuckStroke& a, const PuckStroke& b) {
  const auto values = [](const PuckStroke& s) {
    return std::array{s.hand.t, s.height, s.px * s.px + s.py * s.py, std::abs(s.offset)};
  };
  return values(a) < values(b);
}

void EventPredictor::considerStrokes(int i, PredictedEvent& best) const {
  const Leg leg = game_.flightOf(i);
  for (const int stroke : game_.pucks[i].strokes) {
    const double own = std::max(game_.arrivesAt(stroke, leg), leg.start.t);
    if (own >= game_.discs[i].turnsAt || own > best.ownTime) continue;
    if (own == best.ownTime &&
        (best.kind != PredictedKind::stroke || !actsFirst(game_.strokes[stroke], game_.strokes[best.with])))
      continue;
    best = {};
    best.kind = PredictedKind::stroke;
    best.with = stroke;
    best.ownTime = own;
  }
}

}  // namespace carom
