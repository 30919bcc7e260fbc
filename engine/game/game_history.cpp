#include "engine/game/game_history.h"

#include <algorithm>
#include <numeric>

namespace carom {

namespace {

constexpr std::size_t kFewPucks = 256;  // whose world lines' ends lie in the caches
// Memory that is used for the first time costs time. Of many pucks it is taken in advance for about four
// collisions a puck: that number of events, and bytes of knots. The list of events has addresses for what a
// session keeps that forgets what is past, so that it need not be moved.
constexpr std::size_t kBoughtEvents = 4, kBoughtBytes = 1100;
constexpr std::size_t kAddressesPerPuck = 32, kMostAddresses = std::size_t{1} << 24;
// Of more pucks, at most this number of legs wait.
constexpr std::size_t kNewLegs = 256, kNewLegsPerPuck = 1;

Vec2 betaOf(const Vec21& u) { return {u.x / u.t, u.y / u.t}; }

}  // namespace

GameHistory::GameHistory(const BilliardSetup& setup)
    : c_m_s_(setup.lightSpeed_m_s),
      friction_m_s2_(setup.rules.friction_m_s2),
      slowing_1_s_(setup.rules.spinDeceleration_m_s2 / setup.lightSpeed_m_s),
      forgottenLegs_(setup.pucks.size(), 0) {
  buyMemory(setup.pucks.size());
  lines_.reserve(setup.pucks.size());
  shapes_.reserve(setup.pucks.size());
  bodies_.reserve(setup.pucks.size());
  for (const Puck& puck : setup.pucks) {
    const double height_m = 0.5 * puck.height_m;
    shapes_.push_back({height_m, puck.radius_m});
    bodies_.push_back({puck.mass_kg, puck.inertia * puck.mass_kg});
    const Event start{0.0, {puck.position_m.x, puck.position_m.y, height_m}};
    const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(puck.beta, puck.beta));
    const Turning turning{puck.spin_kg_m2_s / (puck.radius_m * c_m_s_), 0.0};
    const Knot first{start,
                     {gamma * puck.beta.x, gamma * puck.beta.y, 0.0},
                     0.0,
                     start,
                     friction_m_s2_,
                     spinOf(shapes_.size() - 1, turning)};
    lines_.emplace_back(first, c_m_s_, std::hypot(puck.radius_m, height_m),
                        -std::numeric_limits<double>::infinity(), &knots_);
  }
}

void GameHistory::buyMemory(std::size_t pucks) {
  if (pucks <= kFewPucks) return;
  knots_.buy(kBoughtBytes * pucks);
  events_.reserve(std::min(std::max(kMostAddresses, kBoughtEvents * pucks), kAddressesPerPuck * pucks));
  events_.resize(kBoughtEvents * pucks);
  events_.clear();
}

void GameHistory::addLeg(std::size_t puck, const Leg& leg, const Turning& turning, const Vec21& signal) {
  const NewLeg added{leg.start,      signal,  {leg.u.x, leg.u.y},
                     leg.properTime, turning, static_cast<std::uint32_t>(puck)};
  if (lines_.size() <= kFewPucks) return append(added);
  newLegs_.push_back(added);
  prefetch(&newLegs_.back() + 4, sizeof(NewLeg));
  if (newLegs_.size() >= std::max(kNewLegs, kNewLegsPerPuck * lines_.size())) complete();
}

// The world lines of many pucks are scattered over the memory. Many legs are therefore appended at once, line
// after line, and the data of those to come are asked for while one is added.
void GameHistory::complete() {
  if (newLegs_.empty()) return;
  ends_.assign(lines_.size() + 1, 0);
  for (const NewLeg& leg : newLegs_) ++ends_[leg.puck + 1];
  std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
  byPuck_.resize(newLegs_.size());
  for (std::size_t k = 0; k < newLegs_.size(); ++k)
    byPuck_[ends_[newLegs_[k].puck]++] = static_cast<std::uint32_t>(k);
  constexpr std::size_t kLegs = 24, kLines = 16, kEnds = 8;  // ahead
  const auto ahead = [&](std::size_t k) { return &newLegs_[byPuck_[std::min(k, byPuck_.size() - 1)]]; };
  for (std::size_t k = 0; k < byPuck_.size(); ++k) {
    prefetch(ahead(k + kLegs), sizeof(NewLeg));
    lines_[ahead(k + kLines)->puck].fetch();
    lines_[ahead(k + kEnds)->puck].fetchEnd();
    append(newLegs_[byPuck_[k]]);
  }
  newLegs_.clear();
}

void GameHistory::append(const NewLeg& leg) {
  lines_[leg.puck].append({eventOf(leg.puck, leg.start),
                           {leg.u.x, leg.u.y, 0.0},
                           leg.properTime / c_m_s_,
                           eventOf(leg.puck, leg.signal),
                           friction_m_s2_,
                           spinOf(leg.puck, leg.turning)});
}

void GameHistory::keepLegs(std::size_t puck, std::size_t legs) {
  complete();
  lines_[puck].keepFirst(legs - forgottenLegs_[puck]);
}

GameEvent& GameHistory::add(EventKind kind, const Event& at) {
  GameEvent& event = events_.emplace_back();
  prefetch(&event + 2, sizeof(GameEvent));
  event.number = eventCount() - 1;
  event.kind = kind;
  event.at = at;
  return event;
}

std::uint64_t GameHistory::addCollision(std::optional<Cushion> cushion, const Vec21& contact,
                                        bool withoutDelay, double heat_j) {
  GameEvent& event = add(cushion ? EventKind::puckCushion : EventKind::puckPuck,
                         {contact.t / c_m_s_, {contact.x, contact.y, 0.0}});
  event.cushion = cushion;
  event.withoutDelay = withoutDelay;
  event.heat_j = heat_j;
  return event.number;
}

std::uint64_t GameHistory::addJam(const Vec21& contact, double heat_j) {
  GameEvent& event = add(EventKind::jam, {contact.t / c_m_s_, {contact.x, contact.y, 0.0}});
  event.withoutDelay = true;
  event.heat_j = heat_j;
  return event.number;
}

std::uint64_t GameHistory::addStroke(std::uint32_t stroke, const Vec21& at, double height_m) {
  GameEvent& event = add(EventKind::stroke, {at.t / c_m_s_, {at.x, at.y, height_m}});
  event.which = stroke;
  return event.number;
}

GameEvent& GameHistory::addSoft(EventKind kind, const Vec21& at, std::span<const std::size_t> pucks,
                                std::span<const LegState> states) {
  GameEvent& event = add(kind, eventOf(pucks[0], at));
  for (std::size_t k = 0; k < pucks.size(); ++k)
    event.turns.push_back(turnOf(pucks[k], states[k], states[k].u, {}));
  return event;
}

std::uint64_t GameHistory::addFlash(std::uint32_t flash, const Event& at) {
  GameEvent& event = add(EventKind::flash, at);
  event.which = flash;
  return event.number;
}

void GameHistory::addTurn(std::uint64_t event, std::size_t puck, const LegState& before, const Vec21& uAfter,
                          const TurnedSpin& spin) {
  GameEvent& noted = events_[event - forgottenEvents_];
  noted.turns.push_back(turnOf(puck, before, uAfter, spin));
  if (noted.kind != EventKind::stroke) noted.at.r_m.z = noted.turns[0].event.r_m.z;
}

GameEvent& GameHistory::change(std::uint64_t event) {
  unchangedEvents_ = std::min(unchangedEvents_, event);
  return events_[event - forgottenEvents_];
}

void GameHistory::changeTurn(std::uint64_t event, std::size_t puck, const LegState& before,
                             const Vec21& uAfter, const TurnedSpin& spin) {
  if (event < forgottenEvents_) return;
  for (Turn& turn : change(event).turns) {
    if (turn.puck == puck) turn = turnOf(puck, before, uAfter, spin);
  }
}

void GameHistory::changeBounce(std::uint64_t event, const Vec21& contact, bool withoutDelay, double heat_j) {
  if (event < forgottenEvents_) return;
  GameEvent& changed = change(event);
  changed.at = {contact.t / c_m_s_, {contact.x, contact.y, changed.at.r_m.z}};
  changed.withoutDelay = withoutDelay;
  changed.heat_j = heat_j;
}

void GameHistory::keepEvents(std::uint64_t count) {
  events_.resize(count - forgottenEvents_);
  unchangedEvents_ = std::min(unchangedEvents_, count);
}

void GameHistory::forgetBefore(double t_s) {
  complete();
  for (std::size_t puck = 0; puck < lines_.size(); ++puck)
    forgottenLegs_[puck] += lines_[puck].forgetBefore(t_s);
  const auto over = std::find_if(events_.begin(), events_.end(), [t_s](const GameEvent& event) {
    return event.at.t_s >= t_s || std::any_of(event.turns.begin(), event.turns.end(),
                                              [t_s](const Turn& turn) { return turn.event.t_s >= t_s; });
  });
  forgottenEvents_ += static_cast<std::uint64_t>(over - events_.begin());
  events_.erase(events_.begin(), over);
}

Event GameHistory::eventOf(std::size_t puck, const Vec21& x) const {
  return {x.t / c_m_s_, {x.x, x.y, shapes_[puck].height_m}};
}

Turn GameHistory::turnOf(std::size_t puck, const LegState& before, const Vec21& uAfter,
                         const TurnedSpin& spin) const {
  const double perJ = shapes_[puck].radius_m * c_m_s_;
  return {puck,
          eventOf(puck, before.x),
          betaOf(before.u),
          betaOf(uAfter),
          before.properTime / c_m_s_,
          spin.before * perJ,
          spin.after * perJ};
}

Spin GameHistory::spinOf(std::size_t puck, const Turning& turning) const {
  if (turning.j == 0.0) return {.angle_rad = turning.angle};
  const SpinningBody& body = bodies_[puck];
  return {turning.angle, rimBeta(body, turning.j) * (c_m_s_ / shapes_[puck].radius_m), turning.j / body.rim,
          slowing_1_s_};
}

}  // namespace carom
