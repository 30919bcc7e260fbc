// What each puck will meet next.

#include <algorithm>
#include <cmath>

#include "engine/billiard/collision_scheduler.h"
#include "engine/collision/braked_contact.h"

namespace carom {

namespace {

constexpr double kCellsPerEpoch = 64.0;  // which light crosses before the epoch of the flights moves on

}  // namespace

// A pair must be neighbours from before either's own moment of the contact on. In the rest frame of either
// puck the other's centre is then at most reach away, and the board shows that distance contracted:
// * simultaneous with the contact, reach = R1 + R2 whatever the speeds;
// * by the puck's own simultaneity, R2 + R1 γ (1 + β β_2) < (2γ + 1) R.
void CollisionScheduler::layOutCells() {
  const auto count = pucks_.size();
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double gamma = lastLeg(i).u.t;
    if (gamma > gammaBound_) gammaBound_ = 2.0 * gamma;
  }
  pairReach_ = (convention_ == TurnConvention::simultaneousWithContact ? 2.0 : 2.0 * gammaBound_ + 1.0) *
               largestRadius_;
  const double onePuckEach =
      std::sqrt(boxWidth_ * boxHeight_ / static_cast<double>(std::max<std::size_t>(1, count)));
  const double edge = 1.01 * std::max(pairReach_, onePuckEach);
  const auto fit = [&](double length) {
    return !usesCells() ? 1 : std::max(1, static_cast<int>(std::min(length / edge, 4096.0)));
  };
  cells_ = CellGrid(boxLowX_, boxLowY_, edge, fit(boxWidth_), fit(boxHeight_), static_cast<int>(count));
  near_.resize(2 * count + CellGrid::kSpare);
  found_ = FoundFlights(count);
  epoch_ = clock_;
  cellsTooSmall_ = false;
}

void CollisionScheduler::predictAll() {
  layOutCells();
  const int count = static_cast<int>(pucks_.size());
  for (int i = 0; i < count; ++i) {
    enterCell(i);
    setPredictedEvent(i, {});
  }
  for (int i = 0; i < count; ++i) predict(i);
}

void CollisionScheduler::predict(int i) { predictAmong(i, 0, usesCells() ? findCandidates(i, 0) : 0); }

// The second's candidates are found while the data of the first's are on their way from memory.
void CollisionScheduler::predictBoth(int first, int second) {
  if (!usesCells()) {
    predict(first);
    predict(second);
    return;
  }
  const int middle = findCandidates(first, 0), end = findCandidates(second, middle);
  predictAmong(first, 0, middle);
  predictAmong(second, middle, end);
}

// Of many pucks, only those among near_ from `begin` to `end` can be met.
void CollisionScheduler::predictAmong(int i, int begin, int end) {
  if (outlines_ != nullptr) forgetParted(i);
  PredictedEvent best;
  if (discs_[i].turnsAt < kNever) {
    best.kind = PredictedKind::turn;
    best.ownTime = discs_[i].turnsAt;
  }
  if (!strokes_.empty()) considerStrokes(i, best);
  if (!usesCells()) {
    for (int other = 0; other < static_cast<int>(pucks_.size()); ++other) {
      if (other == i || (excludesDiscs() && !mayMeet(discs_[i], discs_[other], convention_))) continue;
      considerPair(i, other, best);
    }
  }
  considerPairs(i, begin, end, best);
  considerCushions(i, best);
  setPredictedEvent(i, best);
}

// Writes the pucks that this one may meet to near_ from `begin` on. Returns their end.
int CollisionScheduler::findCandidates(int i, int begin) {
  // A puck that was waited for is behind the others: those it can meet may be farther off by now.
  const double behind = std::max(0.0, clock_ - std::max(predictions_[i].next.ownTime, discs_[i].start.t));
  const double reachInCells = (pairReach_ + 2.0 * behind) / cells_.cellEdge();
  const int reach = reachInCells <= 1.0 ? 1 : static_cast<int>(std::min(std::ceil(reachInCells), 4096.0));
  cells_.findNear(enterCell(i), reach, found_);
  return sortOut(i, begin);
}

// Puts the puck into the cell where its leg has it now.
int CollisionScheduler::enterCell(int i) {
  const Leg leg = flightOf(i);
  const Vec21 x = placeAt(leg, std::max(clock_, leg.start.t)).x;
  const int cell = cells_.cellAt(x.x, x.y);
  if (cell != cells_.cellOf(i)) cells_.move(i, cell, coarseFlightOf(i));
  findCellExit(i);
  return cell;
}

// The flights in the cells lose digits with the time between their epoch and the present.
void CollisionScheduler::moveEpoch() {
  if (!usesCells() || clock_ - epoch_ < kCellsPerEpoch * cells_.cellEdge()) return;
  epoch_ = clock_;
  for (int i = 0; i < static_cast<int>(pucks_.size()); ++i) cells_.change(i, coarseFlightOf(i));
}

void CollisionScheduler::findCellExit(int i) {
  const double alongX = leavesCell(i, 0), alongY = leavesCell(i, 1);
  Prediction& own = predictions_[i];
  own.leavesAlongY = alongY < alongX;
  own.leavesCell = own.leavesAlongY ? alongY : alongX;
}

void CollisionScheduler::setPredictedEvent(int i, const PredictedEvent& a) {
  Prediction& own = predictions_[i];
  if (own.next.kind == PredictedKind::pair) {  // leave the list of the other
    (own.dependentBefore < 0 ? predictions_[own.next.with].firstDependent
                             : predictions_[own.dependentBefore].nextDependent) = own.nextDependent;
    if (own.nextDependent >= 0) predictions_[own.nextDependent].dependentBefore = own.dependentBefore;
  }
  own.next = a;
  if (a.kind == PredictedKind::pair) {
    int& first = predictions_[a.with].firstDependent;
    own.dependentBefore = -1;
    own.nextDependent = first;
    if (first >= 0) predictions_[first].dependentBefore = i;
    first = i;
  }
  schedule(i);
}

// Those that counted on meeting this puck look for something else if that has become void.
void CollisionScheduler::predictDependents(int of) {
  void_.clear();
  for (int i = predictions_[of].firstDependent; i >= 0; i = predictions_[i].nextDependent) {
    if (isVoid(predictions_[i].next)) void_.push_back(i);
  }
  std::sort(void_.begin(), void_.end());
  for (const int i : void_) {
    if (isVoid(predictions_[i].next)) predict(i);
  }
}

// The earlier of two predicted events of one puck; equal times go by kind, then by name.
bool CollisionScheduler::isEarlier(double ownTime, int with, const PredictedEvent& than) {
  return ownTime < than.ownTime ||
         (ownTime == than.ownTime && than.kind == PredictedKind::pair && with < than.with);
}

// Writes those of found_ to near_ from `begin` on that the coarse flights do not exclude, without a branch,
// and asks for their data. Returns their end.
int CollisionScheduler::sortOut(int i, int begin) {
  int* const near = near_.data();
  const int* const items = found_.items.data();
  const bool all = !excludesDiscs();
  const DiscCull coarse(discs_[i], largestRadius_, convention_, epoch_);
  int kept = begin;
  for (int first = 0; first < found_.count; first += FoundFlights::kRoom) {
    std::array<int, FoundFlights::kRoom> may;
    const float *const x = &found_.x[first], *const y = &found_.y[first];
    const float *const vx = &found_.vx[first], *const vy = &found_.vy[first];
    const int end = std::min(FoundFlights::kRoom, found_.count - first);
    const int fours = (end + 3) / 4 * 4;  // which an instruction computes at once
    for (int k = 0; k < fours; ++k) may[k] = coarse.mayMeet(x[k], y[k], vx[k], vy[k]) ? 1 : 0;
    for (int k = 0; k < end; ++k) {
      near[kept] = items[first + k];
      kept += static_cast<int>(items[first + k] != i) & (may[k] | static_cast<int>(all));
    }
  }
  for (int k = begin; k < kept; ++k) {
    prefetch(&discs_[near[k]]);
    prefetch(&predictions_[near[k]]);
    queue_.fetch(near[k]);
  }
  return kept;
}

void CollisionScheduler::considerPairs(int i, int begin, int end, PredictedEvent& best) {
  const bool all = !excludesDiscs();
  for (int k = begin; k < end; ++k) {
    const int other = near_[k];
    if (all || mayMeet(discs_[i], discs_[other], convention_)) considerPair(i, other, best);
  }
}

void CollisionScheduler::considerPair(int i, int other, PredictedEvent& best) {
  const int first = std::min(i, other), second = std::max(i, other);
  const std::optional<Meeting> meeting = meetingOf(first, second);
  if (!meeting) return;
  double own = meeting->ownTime[i == first ? 0 : 1], theirs = meeting->ownTime[i == first ? 1 : 0];
  const Prediction &puck = predictions_[i], &partner = predictions_[other];
  if (own >= discs_[i].turnsAt || theirs >= discs_[other].turnsAt) return;  // found again on the leg after
  if (isStruckAgain(i, other)) own = std::max(own, decidedAt(i)), theirs = std::max(theirs, decidedAt(other));
  if (own < decidedAt(i) || theirs < decidedAt(other)) return;  // what came after it is decided already
  const bool mine = isEarlier(own, other, best), also = isEarlier(theirs, i, partner.next);
  if (!mine && !also) return;
  // Discs that have just collided part; bodies that turn may meet with other corners.
  if (!hasCorners(i, other)) {
    if (puck.lastPartner == other && partner.lastPartner == i) return;
    if (dealtWith(i, other) != nullptr) return;
  }
  PredictedEvent a;
  a.kind = PredictedKind::pair;
  a.withoutDelay = meeting->withoutDelay;
  if (also) {
    a.with = i, a.otherLeg = puck.legNumber, a.ownTime = theirs, a.otherTime = own;
    setPredictedEvent(other, a);
  }
  if (mine) {
    a.with = other, a.otherLeg = partner.legNumber, a.ownTime = own, a.otherTime = theirs;
    best = a;
  }
}

// The last contact of the legs that both follow, if it has been dealt with.
const HandledContact* CollisionScheduler::dealtWith(int i, int other) const {
  if (!predictions_[i].hasMet) return nullptr;
  const std::vector<HandledContact>& met = pucks_[i].met;
  const auto found = std::find_if(met.rbegin(), met.rend(), [&](const HandledContact& contact) {
    return contact.puck == other && contact.leg == predictions_[other].legNumber;
  });
  return found == met.rend() ? nullptr : &*found;
}

void CollisionScheduler::noteMet(int i, const HandledContact& contact) {
  pucks_[i].met.push_back(contact);
  predictions_[i].hasMet = true;
}

std::optional<Meeting> CollisionScheduler::meetingOf(int first, int second) const {
  if (hasCorners(first, second)) {
    const HandledContact* const last = dealtWith(first, second);
    if (last != nullptr && last->until == kNever) return std::nullopt;
    const std::optional<CornerContact> found = cornersMeet(first, second);
    if (!found) return std::nullopt;
    return carom::meetingOf(followedFlight(first), followedFlight(second), *found, convention_);
  }
  if (brake_ == 0.0) return findMeeting(discs_[first], discs_[second], convention_);
  const auto found = findBrakedMeeting({flightOf(first), discs_[first].radius},
                                       {flightOf(second), discs_[second].radius}, convention_);
  if (!found) return std::nullopt;
  return found->meeting;
}

// A cushion is at least as near as the edge of a cell when it is touched, so only those of the outermost
// cells matter.
void CollisionScheduler::considerCushions(int i, PredictedEvent& best) const {
  const int cell = cells_.cellOf(i);
  if (!cells_.isAtRim(cell)) return;
  for (int cushion = 0; cushion < static_cast<int>(cushions_.size()); ++cushion) {
    const CushionPlane& plane = cushions_[cushion];
    if (cells_.canLeave(cell, plane.axis, plane.sign > 0.0 ? 1 : -1)) continue;
    if ((predictions_[i].metCushions >> cushion & 1u) != 0) continue;
    if (!(plane.towards(discs_[i].u) > 0.0) && outlineOf(i) == nullptr) continue;
    considerCushion(i, cushion, best);
  }
}

void CollisionScheduler::considerCushion(int i, int cushion, PredictedEvent& best) const {
  const Leg leg = flightOf(i);
  // No earlier than straight flight to R (1 + u_n) from the plane, as R sqrt(1 + u_n²) is less; a glide is
  // slower.
  const double un = cushions_[cushion].towards(leg.u);
  const double atLeast = cushions_[cushion].inside(leg.start) - discs_[i].radius * (1.0 + std::abs(un));
  if (un > 0.0 ? atLeast * leg.u.t > (best.ownTime - leg.start.t) * un : atLeast > 0.0) return;
  const std::optional<CushionContact> contact = touchOf(i, leg, spins_[i].turning, cushion);
  if (!contact) return;
  const double own = contact->ownTime;
  if (own >= discs_[i].turnsAt || own > best.ownTime) return;
  if (own == best.ownTime && best.kind <= PredictedKind::cushion) return;
  best = {};
  best.kind = PredictedKind::cushion;
  best.withoutDelay = contact->withoutDelay;
  best.with = cushion;
  best.ownTime = own;
}

void CollisionScheduler::considerStrokes(int i, PredictedEvent& best) const {
  const Leg leg = flightOf(i);
  for (const int stroke : pucks_[i].strokes) {
    const PuckStroke& s = strokes_[stroke];
    const double arrival = s.fromHand ? signalArrives(leg, s.hand, s.height).x.t : s.hand.t;
    const double own = std::max(arrival, leg.start.t);
    if (own >= discs_[i].turnsAt || own >= best.ownTime) continue;
    best = {};
    best.kind = PredictedKind::stroke;
    best.with = stroke;
    best.ownTime = own;
  }
}

double CollisionScheduler::leavesCell(int i, int axis) const {
  const Leg leg = flightOf(i);
  const double u = axis == 0 ? leg.u.x : leg.u.y;
  const int cell = cells_.cellOf(i), step = wayAlong(i, axis);
  if (u == 0.0 || !cells_.canLeave(cell, axis, step)) return kNever;
  return reaches(leg, axis, cells_.edge(cell, axis, step));
}

void CollisionScheduler::schedule(int i) {
  const PredictedEvent& a = predictions_[i].next;
  const double leaves = predictions_[i].leavesCell;
  queue_.setDue(i, leaves < a.ownTime ? leaves : a.due());
}

}  // namespace carom
