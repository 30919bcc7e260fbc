#include "engine/billiard/anticipation.h"

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

std::vector<std::size_t> byName(const std::vector<Puck>& pucks) {
  std::vector<std::size_t> order(pucks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return pucks[a].name < pucks[b].name; });
  return order;
}

}  // namespace

Anticipation::Anticipation(const BilliardSetup& setup)
    : c_m_s_(setup.lightSpeed_m_s),
      convention_(setup.rules.collisionEvent == CollisionEvent::centre
                      ? TurnConvention::newsAtCentre
                      : TurnConvention::simultaneousWithContact),
      puckRestitution_(setup.rules.puckRestitution),
      cushionRestitution_(setup.rules.cushionRestitution),
      brake_(setup.rules.friction_m_s2 / (c_m_s_ * c_m_s_)),
      cushions_(cushionsOf(setup.board)),
      prospects_(setup.pucks.size()),
      queue_(static_cast<int>(setup.pucks.size())),
      inJam_(setup.pucks.size(), 0) {
  double lowX = kNever, lowY = kNever, highX = -kNever, highY = -kNever;
  for (const std::size_t file : byName(setup.pucks)) {
    const Puck& puck = setup.pucks[file];
    const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(puck.beta, puck.beta));
    Player player;
    player.leg = {{0.0, puck.position_m.x, puck.position_m.y},
                  fourVelocity(gamma * puck.beta.x, gamma * puck.beta.y),
                  0.0,
                  brake_};
    player.mass = puck.mass_kg;
    player.height = 0.5 * puck.height_m;
    player.file = file;
    discs_.push_back({player.leg.start, player.leg.u, puck.radius_m, kNever});
    players_.push_back(player);
    largestRadius_ = std::max(largestRadius_, puck.radius_m);
    gammaBound_ = std::max(gammaBound_, 1.25 * player.leg.u.t);
    hindsight_ = std::max(hindsight_, 4.0 * player.leg.u.t * puck.radius_m);
    lowX = std::min(lowX, puck.position_m.x), highX = std::max(highX, puck.position_m.x);
    lowY = std::min(lowY, puck.position_m.y), highY = std::max(highY, puck.position_m.y);
  }
  if (setup.board) {
    boxLowX_ = -0.5 * setup.board->length_m, boxWidth_ = setup.board->length_m;
    boxLowY_ = -0.5 * setup.board->width_m, boxHeight_ = setup.board->width_m;
  } else if (!players_.empty()) {
    boxLowX_ = lowX, boxWidth_ = highX - lowX, boxLowY_ = lowY, boxHeight_ = highY - lowY;
  }
  for (const Stroke& stroke : setup.strokes) enlist(stroke);
  for (const Flash& flash : setup.flashes)
    flashes_.emplace_back(static_cast<std::uint32_t>(flashes_.size()), flash.at);
  std::stable_sort(flashes_.begin(), flashes_.end(),
                   [](const auto& a, const auto& b) { return a.second.t_s < b.second.t_s; });
  predictAll();
}

void Anticipation::addStroke(const Stroke& stroke) { predict(enlist(stroke)); }

int Anticipation::enlist(const Stroke& stroke) {
  const auto player =
      std::find_if(players_.begin(), players_.end(), [&](const Player& p) { return p.file == stroke.puck; });
  PuckStroke own;
  own.hand.t = stroke.at_s * c_m_s_;
  own.fromHand = stroke.from_m.has_value();
  if (stroke.from_m) {
    own.hand.x = stroke.from_m->x, own.hand.y = stroke.from_m->y;
    own.height = stroke.from_m->z - player->height;
  }
  own.px = stroke.momentum_kg_m_s.x / c_m_s_, own.py = stroke.momentum_kg_m_s.y / c_m_s_;
  player->strokes.push_back(static_cast<int>(strokes_.size()));
  strokes_.push_back(own);
  return static_cast<int>(player - players_.begin());
}

bool Anticipation::playUntil(double limit, std::size_t events, Chronicle& chronicle) {
  bool played = false;
  for (; !players_.empty() && (queue_.firstDue() <= limit || someoneWaitsBelow(limit)); played = true) {
    if (chronicle.eventCount() >= events) {
      chronicle.complete();
      return false;
    }
    flashUntil(queue_.firstDue(), chronicle);
    step(chronicle);
  }
  if (played) chronicle.complete();
  flashUntil(limit, chronicle);
  return true;
}

// Flashes take their places in the list of events when everything due before them has been committed.
void Anticipation::flashUntil(double limit, Chronicle& chronicle) {
  for (; flashed_ < flashes_.size() && flashes_[flashed_].second.t_s * c_m_s_ <= limit; ++flashed_) {
    const auto& [place, flash] = flashes_[flashed_];
    chronicle.addFlash(place, flash);
    clock_ = std::max(clock_, flash.t_s * c_m_s_);
  }
}

// A puck put off behind a later one may still have something to do before `limit`.
bool Anticipation::someoneWaitsBelow(double limit) {
  if (raised_.empty()) return false;
  std::erase_if(raised_, [&](int i) { return queue_.due(i) <= prospects_[i].next.due(); });
  return std::any_of(raised_.begin(), raised_.end(), [&](int i) {
    return prospects_[i].next.ownTime <= limit || prospects_[i].next.otherTime <= limit;
  });
}

void Anticipation::fetchDiscs(int found) const {
  for (int n = 0; n < found; ++n) __builtin_prefetch(&discs_[near_[n]]);
}

// Memory takes as long as some hundred operations. Of many pucks the data are asked for some events before
// they are needed: first a puck's own, then, when its turn is near, those of the pucks around it.
void Anticipation::fetchSoon() {
  const auto fetch = [&](int i) {
    __builtin_prefetch(&prospects_[i]);
    __builtin_prefetch(&discs_[i]);
    const char* player = reinterpret_cast<const char*>(&players_[i]);
    for (std::size_t byte = 0; byte < sizeof(Player); byte += 64) __builtin_prefetch(player + byte);
  };
  for (int k = 1; k < static_cast<int>(fetched_.size()); ++k) {
    const int i = queue_.soon(k);
    if (i < 0 || i == fetched_[k]) continue;
    fetched_[k] = i;
    if (k > 4) {
      fetch(i);
      continue;
    }
    const Appointment& next = prospects_[i].next;
    const int axis = leavesFirst(i), cell = cells_.cellOf(i);
    if (players_[i].leavesCell[axis] < next.ownTime) {
      const int way = wayAlong(i, axis);
      fetchDiscs(cells_.findAhead(cells_.beside(cell, axis, way), axis, way, near_.data()));
    } else {
      if (next.kind == Kind::pair) fetch(next.with);
      fetchDiscs(cells_.findNear(cell, 1, near_.data()));
    }
  }
}

void Anticipation::step(Chronicle& chronicle) {
  const int i = queue_.first();
  clock_ = std::max(clock_, queue_.firstDue());
  if (players_.size() > kPucksInCache) fetchSoon();
  const Appointment appointment = prospects_[i].next;
  const int axis = leavesFirst(i);
  if (players_[i].leavesCell[axis] < appointment.ownTime) return crossCell(i, axis);
  switch (appointment.kind) {
    case Kind::none:
      return;
    case Kind::turn:
      beginDecided(i);
      break;
    case Kind::stroke:
      strike(i, appointment.with, chronicle);
      break;
    case Kind::cushion:
      bounce(i, appointment, chronicle);
      break;
    case Kind::pair:
      return meet(i, chronicle);
  }
  if (cellsTooSmall_) return predictAll();
  predict(i);
  predictSuitors(i);
}

// A contact happens when it is the next thing in both pucks' own time.
void Anticipation::meet(int i, Chronicle& chronicle) {
  const Appointment a = prospects_[i].next;
  const int j = a.with;
  const Appointment& theirs = prospects_[j].next;
  const bool mutual = theirs.kind == Kind::pair && theirs.with == i;
  if (!mutual && theirs.ownTime < a.otherTime && !waitsForItself(i)) {
    queue_.setDue(i, std::nextafter(std::max(queue_.due(i), queue_.due(j)), kNever));
    raised_.push_back(i);
    return;
  }
  if (players_.size() > kPucksInCache) fetchDiscs(cells_.findNear(cells_.cellOf(j), 1, near_.data()));
  const bool inOrder = i < j;
  Appointment ordered = a;
  if (!inOrder) std::swap(ordered.ownTime, ordered.otherTime);
  const unsigned legs[2] = {players_[i].legNumber, players_[j].legNumber};
  members_.clear();
  collide(inOrder ? i : j, inOrder ? j : i, ordered, chronicle);
  if (players_[i].legNumber == legs[0]) players_[i].met.push_back({j, legs[1]});
  if (players_[j].legNumber == legs[1]) players_[j].met.push_back({i, legs[0]});
  if (cellsTooSmall_) return predictAll();
  predict(i);
  predict(j);
  predictSuitors(i);
  predictSuitors(j);
  for (const Member& member : members_) {
    if (member.puck == i || member.puck == j) continue;
    predict(member.puck);
    predictSuitors(member.puck);
  }
}

// Do the pucks that this one waits for wait, in the end, for it? Then no order is right, and the first due
// goes.
bool Anticipation::waitsForItself(int i) const {
  int at = prospects_[i].next.with;
  for (std::size_t steps = 0; steps <= players_.size(); ++steps) {
    const Appointment& a = prospects_[at].next;
    if (a.kind != Kind::pair) return false;
    if (a.with == i) return true;
    const Appointment& theirs = prospects_[a.with].next;
    if (theirs.kind == Kind::pair && theirs.with == at) return false;
    at = a.with;
  }
  return true;
}

void Anticipation::crossCell(int i, int axis) {
  const int way = wayAlong(i, axis);
  const int into = cells_.beside(cells_.cellOf(i), axis, way);
  cells_.move(i, into);
  players_[i].leavesCell[axis] = leavesCell(i, axis);
  const Appointment& before = prospects_[i].next;
  Appointment best = before;
  considerPairs(i, cells_.findAhead(into, axis, way, near_.data()), best);
  considerCushions(i, best);
  if (best.ownTime == before.ownTime && best.with == before.with) return schedule(i);
  makeAppointment(i, best);
}

Ledger Anticipation::ledger() const {
  Vec21 motion;
  for (std::size_t i = 0; i < players_.size(); ++i) {
    motion = motion + lastLeg(static_cast<int>(i)).u * players_[i].mass;
  }
  const auto account = [&](const Vec21& p) {
    return Ledger::Account{p.t * c_m_s_ * c_m_s_, {p.x * c_m_s_, p.y * c_m_s_}};
  };
  return {account(motion),           account(accounts_.radiated), account(accounts_.taken),
          account(accounts_.braked), account(accounts_.given),    accounts_.heat * c_m_s_ * c_m_s_};
}

void Anticipation::restore(Chronicle& chronicle) const {
  for (const Player& player : players_) {
    chronicle.keepLegs(player.file, player.begun);
    for (const Decided& decided : player.decided) {
      chronicle.addLeg(player.file, decided.leg, decided.news);
      chronicle.changeTurn(decided.event, player.file,
                           {decided.leg.start, decided.uBefore, decided.leg.properTime}, decided.leg.u);
      noteBounce(decided, chronicle);
    }
  }
}

}  // namespace carom
