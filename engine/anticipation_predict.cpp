// What each puck will meet next.

#include <algorithm>
#include <cmath>

#include "engine/anticipation.h"
#include "engine/braked_contact.h"

namespace carom {

namespace {

constexpr int kPucksWithoutCells = 32;

}  // namespace

// A pair must be neighbours from before either's own moment of the contact on. In the rest frame of either
// puck the other's centre is then at most reach away, and the board shows that distance contracted:
// * simultaneous with the contact, reach = R1 + R2 whatever the speeds;
// * by the puck's own simultaneity, R2 + R1 γ (1 + β β_2) < (2γ + 1) R.
void Anticipation::layOutCells() {
  const int count = static_cast<int>(players_.size());
  for (const Player& player : players_) {
    if (lastLeg(static_cast<int>(&player - players_.data())).u.t > gammaBound_) {
      gammaBound_ = 2.0 * lastLeg(static_cast<int>(&player - players_.data())).u.t;
    }
  }
  pairReach_ = (convention_ == TurnConvention::simultaneousWithContact ? 2.0 : 2.0 * gammaBound_ + 1.0) *
               largestRadius_;
  const double onePuckEach = std::sqrt(boxWidth_ * boxHeight_ / std::max(1, count));
  const double edge = 1.01 * std::max(pairReach_, onePuckEach);
  const auto fit = [&](double length) {
    return count <= kPucksWithoutCells ? 1 : std::max(1, static_cast<int>(std::min(length / edge, 4096.0)));
  };
  cells_ = CellGrid(boxLowX_, boxLowY_, edge, fit(boxWidth_), fit(boxHeight_), count);
  cellsTooSmall_ = false;
}

void Anticipation::predictAll() {
  layOutCells();
  const int count = static_cast<int>(players_.size());
  for (int i = 0; i < count; ++i) {
    const Vec21 x = momentAt(players_[i].leg, std::max(clock_, players_[i].leg.start.t)).x;
    cells_.move(i, cells_.cellAt(x.x, x.y));
    makeAppointment(i, {});
  }
  for (int i = 0; i < count; ++i) predict(i);
}

void Anticipation::predict(int i) {
  Player& player = players_[i];
  const double behind = std::max(0.0, clock_ - std::max(next_[i].ownTime, player.leg.start.t));
  const Vec21 x = momentAt(player.leg, std::max(clock_, player.leg.start.t)).x;
  const int cell = cells_.cellAt(x.x, x.y);
  if (cell != cells_.cellOf(i)) cells_.move(i, cell);
  scheduleCrossing(i);

  Appointment best;
  if (!player.decided.empty()) {
    best.kind = Kind::turn;
    best.ownTime = discs_[i].turnsAt;
  }
  if (!player.strokes.empty()) considerStrokes(i, best);
  // A puck that was waited for is behind the others: those it can meet may be farther off by now.
  const double reachInCells = (pairReach_ + 2.0 * behind) / cells_.cellEdge();
  cells_.forEachNear(cell,
                     reachInCells <= 1.0 ? 1 : static_cast<int>(std::min(std::ceil(reachInCells), 4096.0)),
                     [&](int other) { considerPair(i, other, best); });
  considerCushions(i, best);
  makeAppointment(i, best);
}

void Anticipation::makeAppointment(int i, const Appointment& a) {
  if (next_[i].kind == Kind::pair) {  // leave the list of the other
    const Suitor& own = suitors_[i];
    (own.before < 0 ? suitors_[next_[i].with].first : suitors_[own.before].next) = own.next;
    if (own.next >= 0) suitors_[own.next].before = own.before;
  }
  next_[i] = a;
  if (a.kind == Kind::pair) {
    const int first = suitors_[a.with].first;
    suitors_[i].before = -1;
    suitors_[i].next = first;
    if (first >= 0) suitors_[first].before = i;
    suitors_[a.with].first = i;
  }
  schedule(i);
}

// Those that counted on meeting this puck look for something else if that has become void.
void Anticipation::predictSuitors(int of) {
  scratch_.clear();
  for (int i = suitors_[of].first; i >= 0; i = suitors_[i].next) {
    if (isVoid(next_[i])) scratch_.push_back(i);
  }
  std::sort(scratch_.begin(), scratch_.end());
  for (const int i : scratch_) {
    if (isVoid(next_[i])) predict(i);
  }
}

// The earlier of two appointments of one puck; equal times go by kind, then by name.
bool Anticipation::isEarlier(double ownTime, int with, const Appointment& than) {
  return ownTime < than.ownTime || (ownTime == than.ownTime && than.kind == Kind::pair && with < than.with);
}

void Anticipation::considerPair(int i, int other, Appointment& best) {
  if (other == i) return;
  const int first = std::min(i, other), second = std::max(i, other);
  if (brake_ == 0.0 && !mayMeet(discs_[first], discs_[second], convention_)) return;
  const Player& player = players_[i];
  double touchAt = 0.0;
  const std::optional<Meeting> meeting = meetingOf(first, second, touchAt);
  if (!meeting) return;
  const double own = meeting->ownTime[i == first ? 0 : 1], theirs = meeting->ownTime[i == first ? 1 : 0];
  const Player& partner = players_[other];
  if (own >= discs_[i].turnsAt || theirs >= discs_[other].turnsAt) return;  // found again on the leg after
  if (own < player.decidedAt || theirs < partner.decidedAt) return;  // what came after it is decided already
  const bool mine = isEarlier(own, other, best), also = isEarlier(theirs, i, next_[other]);
  if (!mine && !also) return;
  if (player.lastPartner == other && partner.lastPartner == i) return;
  for (const Met& met : player.met) {
    if (met.puck == other && met.leg == partner.legNumber) return;
  }
  Appointment a;
  a.kind = Kind::pair;
  a.withoutDelay = meeting->withoutDelay;
  a.touchAt = touchAt;
  if (also) {
    a.with = i, a.otherLeg = player.legNumber, a.ownTime = theirs, a.otherTime = own;
    makeAppointment(other, a);
  }
  if (mine) {
    a.with = other, a.otherLeg = partner.legNumber, a.ownTime = own, a.otherTime = theirs;
    best = a;
  }
}

std::optional<Meeting> Anticipation::meetingOf(int first, int second, double& touchAt) const {
  if (brake_ == 0.0) return findMeeting(discs_[first], discs_[second], convention_);
  const auto found = findBrakedMeeting({players_[first].leg, discs_[first].radius},
                                       {players_[second].leg, discs_[second].radius}, convention_);
  if (!found) return std::nullopt;
  touchAt = found->touchAt;
  return found->meeting;
}

// A cushion is at least as near as the edge of a cell when it is touched, so only those of the outermost
// cells matter.
void Anticipation::considerCushions(int i, Appointment& best) const {
  const int cell = cells_.cellOf(i);
  for (int cushion = 0; cushion < static_cast<int>(cushions_.size()); ++cushion) {
    const CushionPlane& plane = cushions_[cushion];
    if (cells_.canLeave(cell, plane.axis, plane.sign > 0.0 ? 1 : -1)) continue;
    if (!(plane.towards(players_[i].leg.u) > 0.0) || (players_[i].metCushions >> cushion & 1u) != 0) continue;
    considerCushion(i, cushion, best);
  }
}

void Anticipation::considerCushion(int i, int cushion, Appointment& best) const {
  const Player& player = players_[i];
  // No earlier than straight flight to R (1 + u_n) from the plane, as R sqrt(1 + u_n²) is less; a glide is
  // slower.
  const double un = cushions_[cushion].towards(player.leg.u);
  const double atLeast = cushions_[cushion].inside(player.leg.start) - discs_[i].radius * (1.0 + un);
  if (atLeast * player.leg.u.t > (best.ownTime - player.leg.start.t) * un) return;
  const std::optional<CushionContact> contact =
      findContact(player.leg, discs_[i].radius, cushions_[cushion], convention_);
  if (!contact) return;
  const double own = contact->ownTime;
  if (own >= discs_[i].turnsAt || own > best.ownTime) return;
  if (own == best.ownTime && best.kind <= Kind::cushion) return;
  best = {};
  best.kind = Kind::cushion;
  best.withoutDelay = contact->withoutDelay;
  best.with = cushion;
  best.ownTime = own;
}

void Anticipation::considerStrokes(int i, Appointment& best) const {
  const Player& player = players_[i];
  for (const int stroke : player.strokes) {
    const PuckStroke& s = strokes_[stroke];
    const double arrival = s.fromHand ? newsArrives(player.leg, s.hand, s.height).x.t : s.hand.t;
    const double own = std::max(arrival, player.leg.start.t);
    if (own >= discs_[i].turnsAt || own >= best.ownTime) continue;
    best = {};
    best.kind = Kind::stroke;
    best.with = stroke;
    best.ownTime = own;
  }
}

void Anticipation::scheduleCrossing(int i) {
  Player& player = players_[i];
  const int cell = cells_.cellOf(i);
  player.crossing = kNever;
  for (int axis = 0; axis < 2; ++axis) {
    const double u = axis == 0 ? player.leg.u.x : player.leg.u.y;
    const int step = u > 0.0 ? 1 : -1;
    if (u == 0.0 || !cells_.canLeave(cell, axis, step)) continue;
    const double when = reaches(player.leg, axis, cells_.edge(cell, axis, step));
    if (when < player.crossing)
      player.crossing = when, player.crossingAxis = axis, player.crossingStep = step;
  }
}

void Anticipation::schedule(int i) {
  const Appointment& a = next_[i];
  queue_.setDue(i, players_[i].crossing < a.ownTime ? players_[i].crossing : a.due());
}

}  // namespace carom
