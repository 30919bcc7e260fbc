#include "engine/billiard/soft_game.h"

#include "engine/game/soft_puck_mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <utility>

namespace carom {

struct SoftGame::Snapshot {
  std::shared_ptr<const SoftPlay::Snapshot> play;
  double time = 0.0;
  std::vector<std::optional<Body>> bodies;
  std::vector<std::size_t> puckOf;
  std::vector<Given> given;
  Listed listed;
  std::vector<std::size_t> legs;  // of the soft pucks' world lines, by their number in the play
  SoftRowBook::Snapshot rows;
};

namespace {

constexpr double kStiffViscosity = 0.3;
// Where a told body crushes what it holds, the centre of energy can jump. Its leg follows as fast as this.
constexpr double kFastest = 0.99;
constexpr double kOffLine = 1e-7;  // by which a centre may be beside its leg, metres

std::vector<SoftCushion> softCushions(const std::optional<Board>& board) {
  if (!board) return {};
  const double x = 0.5 * board->length_m, y = 0.5 * board->width_m;
  return {{{1.0, 0.0}, x}, {{-1.0, 0.0}, x}, {{0.0, 1.0}, y}, {{0.0, -1.0}, y}};  // in the order of `Cushion`
}

std::vector<SoftHold> holdsOf(const SoftMatter& matter, double c_m_s) {
  std::vector<SoftHold> holds;
  for (const SoftMatter::HeldSide& side : matter.held) {
    holds.push_back({side.isPlusX, {}});
    for (const SoftMatter::HeldSide::Turn& turn : side.turns)
      holds.back().turns.push_back({turn.t_s * c_m_s, turn.beta});
  }
  return holds;
}

}  // namespace

SoftGame::SoftGame(const BilliardSetup& setup, CollisionScheduler& rigid, GameHistory& history,
                   SoftRowBook& rows)
    : c_m_s_(setup.lightSpeed_m_s),
      stiffSound_(setup.rules.stiffSoundSpeed),
      pucks_(setup.pucks),
      strokes_(setup.strokes),
      play_(softCushions(setup.board)),
      rows_(&rows),
      bodies_(setup.pucks.size()) {
  rows.begin();
  play_.watch([this](std::size_t body, double) { rows_->step(body, play_); });
  std::vector<std::size_t> soft;
  for (std::size_t i = 0; i < pucks_.size(); ++i) {
    if (pucks_[i].soft) soft.push_back(i);
  }
  std::sort(soft.begin(), soft.end(),
            [&](std::size_t a, std::size_t b) { return pucks_[a].name < pucks_[b].name; });
  for (const std::size_t puck : soft) {
    const CollisionScheduler::Withdrawn was = rigid.withdraw(puck, 0.0, history);
    enter(puck, was, 0.0, *pucks_[puck].soft, nullptr);
    for (const std::size_t stroke : was.strokes) addStroke(stroke, strokes_[stroke]);
  }
}

void SoftGame::enter(std::size_t puck, const CollisionScheduler::Withdrawn& was, double clock,
                     const SoftMatter& matter, const WorldLine* rigidLine) {
  const Puck& of = pucks_[puck];
  isNews_ = true;
  const Vec21& start = was.state.x;
  bodies_[puck] = Body{puckOf_.size(), rigidLine ? std::optional(time() / c_m_s_) : std::nullopt};
  puckOf_.push_back(puck);
  play_.add({of.name,
             std::make_shared<const SoftMesh>(softMeshOf(of)),
             {matter.soundSpeed, matter.viscosity},
             of.mass_kg,
             {start.x, start.y},
             was.u,
             clock,
             holdsOf(matter, c_m_s_)});
  rows_->enter(puck, play_, rigidLine, of.height_m);
}

void SoftGame::addStroke(std::size_t stroke, const Stroke& told) {
  if (stroke >= strokes_.size()) strokes_.push_back(told);
  if (!bodies_[told.puck]) return;
  SoftStroke soft;
  soft.body = bodies_[told.puck]->number;
  soft.hand.t = told.at_s * c_m_s_;
  soft.hasPlace = told.from_m.has_value();
  if (told.from_m) {
    soft.hand.x = told.from_m->x, soft.hand.y = told.from_m->y;
    soft.height = told.from_m->z - 0.5 * pucks_[told.puck].height_m;
  }
  soft.momentum = told.momentum_kg_m_s / c_m_s_;
  given_.push_back({stroke, false});
  play_.addStroke(soft);
  isNews_ = true;
}

void SoftGame::takeInReach(CollisionScheduler& rigid, GameHistory& history) {
  for (;;) {
    std::vector<std::size_t> pucks;
    std::vector<RigidNeighbour> near;
    for (std::size_t i = 0; i < pucks_.size(); ++i) {
      if (bodies_[i]) continue;
      const Vec3 place = history.worldLines()[i].at(time() / c_m_s_).event.r_m;
      pucks.push_back(i);
      near.push_back({{place.x, place.y}, pucks_[i].radius_m});
    }
    std::vector<std::size_t> reached = play_.reached(near);
    if (reached.empty()) return;
    std::sort(reached.begin(), reached.end(),
              [&](std::size_t a, std::size_t b) { return pucks_[pucks[a]].name < pucks_[pucks[b]].name; });
    for (const std::size_t k : reached) {
      const std::size_t puck = pucks[k];
      const CollisionScheduler::Withdrawn was = rigid.withdraw(puck, time(), history);
      enter(puck, was, was.state.properTime, {.soundSpeed = stiffSound_, .viscosity = kStiffViscosity},
            &history.worldLines()[puck]);
      for (const std::size_t stroke : was.strokes) addStroke(stroke, strokes_[stroke]);
    }
  }
}

void SoftGame::playSlice(CollisionScheduler& rigid, GameHistory& history) {
  const double from = time();
  rigid.playUntil(from, std::numeric_limits<std::size_t>::max(), history);
  takeInReach(rigid, history);
  recent_.emplace_back(from, play_.snapshot());
  if (ahead_) {
    if (std::exchange(isNews_, false)) ahead_->start({recent_.back().second, rows_->snapshot(from), {}});
    const SoftAhead::Slice slice = ahead_->take();
    play_.restore(*slice.play);
    rows_->follow(slice.recorders, slice.rows);
  } else {
    play_.playSlice();
    rows_->endSlice(play_);
  }
  writeLegs(from, history);
  listEvents(history);
}

LegState SoftGame::centreAt(std::size_t puck, double t, GameHistory& history) const {
  const Motion motion = history.worldLines()[puck].at(t / c_m_s_);
  return {{t, motion.event.r_m.x, motion.event.r_m.y},
          fourVelocity(motion.u.x, motion.u.y),
          motion.properTime_s * c_m_s_};
}

// A leg goes on as long as the centre of energy is on it at the end of a slice; else another begins with the
// slice.
void SoftGame::writeLegs(double from, GameHistory& history) {
  for (std::size_t number = 0; number < puckOf_.size(); ++number) {
    const std::size_t puck = puckOf_[number];
    const glm::dvec2 centre = play_.centre(number);
    const LegState expected = centreAt(puck, time(), history);
    if (glm::length(centre - glm::dvec2(expected.x.x, expected.x.y)) <= kOffLine) continue;
    const LegState start = centreAt(puck, from, history);
    glm::dvec2 beta = (centre - glm::dvec2(start.x.x, start.x.y)) / (time() - from);
    const double speed = glm::length(beta);
    if (speed > kFastest) beta *= kFastest / speed;
    const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(beta, beta));
    history.addLeg(puck, {start.x, {gamma, gamma * beta.x, gamma * beta.y}, start.properTime}, {}, start.x);
  }
}

void SoftGame::listEvents(GameHistory& history) {
  struct New {
    double time;
    std::function<void()> list;
  };
  std::vector<New> events;
  for (Given& given : given_) {
    const std::optional<double> began = play_.strokeBegan(static_cast<std::size_t>(&given - given_.data()));
    if (std::exchange(given.isListed, began.has_value()) || !began) continue;
    events.push_back({*began, [&, began] { listStroke(given.stroke, *began, history); }});
  }
  for (; listed_.contacts < play_.collisions().size(); ++listed_.contacts) {
    const std::size_t number = listed_.contacts;
    events.push_back(
        {play_.collisions()[number].contact.t, [&, number] { listTouch(number, false, history); }});
  }
  for (const std::size_t number : play_.parted().subspan(listed_.parted))
    events.push_back(
        {play_.collisions()[number].lastTouch, [&, number] { listTouch(number, true, history); }});
  listed_.parted = play_.parted().size();
  for (const FarSides::Heard& heard : play_.heard().subspan(listed_.heard)) {
    events.push_back({heard.event.t, [&, heard] {
                        const std::size_t puck = puckOf_[heard.body];
                        const LegState state = centreAt(puck, heard.event.t, history);
                        history.addSoft(EventKind::farSide, heard.event, {&puck, 1}, {&state, 1});
                      }});
  }
  listed_.heard = play_.heard().size();
  std::stable_sort(events.begin(), events.end(), [](const New& a, const New& b) { return a.time < b.time; });
  for (const New& event : events) event.list();
}

void SoftGame::listStroke(std::size_t number, double began, GameHistory& history) {
  const Stroke& stroke = strokes_[number];
  const LegState centre = centreAt(stroke.puck, began, history);
  const double c = c_m_s_, height_m = 0.5 * pucks_[stroke.puck].height_m;
  const Vec21 hand = stroke.from_m ? Vec21{stroke.at_s * c, stroke.from_m->x, stroke.from_m->y} : centre.x;
  const std::uint64_t listed = history.addStroke(static_cast<std::uint32_t>(number), hand,
                                                 stroke.from_m ? stroke.from_m->z : height_m);
  history.addTurn(listed, stroke.puck, centre, centre.u, {});
}

void SoftGame::listTouch(std::size_t number, bool isLast, GameHistory& history) {
  const SoftCollision& collision = play_.collisions()[number];
  const bool isPair = collision.other != SoftExchange::kNone;
  const Vec21 last{collision.lastTouch, collision.lastPlace.x, collision.lastPlace.y};
  const Vec21& at = isLast ? last : collision.contact;
  std::vector<std::size_t> pucks{puckOf_[collision.body]};
  if (isPair) pucks.push_back(puckOf_[collision.other]);
  std::vector<LegState> states;
  for (const std::size_t puck : pucks) states.push_back(centreAt(puck, at.t, history));
  const EventKind touch = isPair ? EventKind::softSoft : EventKind::softCushion;
  GameEvent& event = history.addSoft(isLast ? EventKind::parted : touch, at, pucks, states);
  if (!isPair) event.cushion = static_cast<Cushion>(collision.cushion);
  event.which = static_cast<std::uint32_t>(number);
  if (isLast) event.heat_j = collision.heat() * c_m_s_ * c_m_s_;
}

void SoftGame::playAhead() {
  ahead_ = std::make_unique<SoftAhead>(play_.cushions());
  isNews_ = true;
}

void SoftGame::addTo(Ledger& ledger) const {
  const double c = c_m_s_;
  const auto book = [c](Ledger::Account& account, const Vec21& p) {
    account.energy_j += p.t * c * c;
    account.momentum_kg_m_s += Vec2(p.x, p.y) * c;
  };
  const SoftAccounts accounts = play_.accounts();
  book(ledger.motion, accounts.motion);
  book(ledger.takenByCushions, {0.0, accounts.taken.x, accounts.taken.y});
  book(ledger.givenByStrokes, accounts.givenByStrokes + accounts.givenByHolders);
  ledger.heat_j += accounts.heat * c * c;
}

std::vector<FrozenPuck> SoftGame::frozen() const {
  std::vector<FrozenPuck> all;
  for (const SoftFrozen& one : play_.frozen()) all.push_back({puckOf_[one.body], one.time / c_m_s_});
  return all;
}

SoftPuckState SoftGame::stateOf(std::size_t puck) const {
  const double c = c_m_s_;
  const Body& body = *bodies_[puck];
  const SoftTotals totals = play_.totals(body.number);
  SoftPuckState state;
  state.position_m = totals.centre;
  state.beta = Vec2(totals.momentum.x, totals.momentum.y) / totals.momentum.t;
  state.restMass_kg = totals.restMass();
  state.heat_j = totals.heat * c * c;
  state.elastic_j = totals.elastic * c * c;
  state.spin_kg_m2_s = totals.spin * c;
  const SoftMesh& mesh = play_.body(body.number).mesh();
  state.properTime_s = play_.clock(body.number, mesh.locate({0.0, 0.0})) / c;
  state.isAwake = play_.isAwake(body.number);
  state.becameSoft_s = body.becameSoft;
  return state;
}

SoftContactState SoftGame::contactState(const SoftCollision& collision) const {
  const bool isPair = collision.other != SoftExchange::kNone;
  SoftContactState state;
  state.pucks = {puckOf_[collision.body], puckOf_[isPair ? collision.other : collision.body]};
  if (!isPair) state.cushion = static_cast<Cushion>(collision.cushion);
  const double height_m = 0.5 * pucks_[state.pucks[0]].height_m;
  state.contact = {collision.contact.t / c_m_s_, {collision.contact.x, collision.contact.y, height_m}};
  if (collision.isOver || collision.lastTouch < time()) state.parted_s = collision.lastTouch / c_m_s_;
  state.impulse_kg_m_s = collision.impulse * c_m_s_;
  state.heat_j = collision.heat() * c_m_s_ * c_m_s_;
  return state;
}

// The play returns to the start of the slice, goes on to the time that is asked for, and comes back.
SoftMoment SoftGame::at(double t_s, std::span<const SoftPoint> points) {
  const double t = t_s * c_m_s_;
  const auto present = play_.wholeSnapshot();
  rows_->listen(false);
  const auto after = std::upper_bound(recent_.begin(), recent_.end(), t,
                                      [](double time, const auto& one) { return time < one.first; });
  if (after != recent_.begin()) {
    play_.restore(*std::prev(after)->second);
    if (t > play_.time()) play_.playSlice(t);
  }
  SoftMoment moment;
  for (std::size_t puck = 0; puck < pucks_.size(); ++puck) {
    const bool isSoftThen = bodies_[puck] && bodies_[puck]->number < play_.size();
    moment.pucks.push_back(isSoftThen ? std::optional(stateOf(puck)) : std::nullopt);
  }
  for (const SoftCollision& collision : play_.collisions())
    moment.contacts.push_back(contactState(collision));
  for (const SoftPoint& point : points) {
    std::optional<SoftPointState>& state = moment.points.emplace_back();
    if (!moment.pucks[point.puck]) continue;
    const std::size_t number = bodies_[point.puck]->number;
    const SoftMesh::Inside inside = play_.body(number).mesh().locate(point.offset_m);
    state = {play_.place(number, inside), play_.velocity(number, inside),
             play_.clock(number, inside) / c_m_s_};
  }
  play_.restore(*present);
  rows_->listen(true);
  return moment;
}

void SoftGame::forgetBefore(double t_s) {
  while (recent_.size() > 1 && recent_[1].first <= t_s * c_m_s_) recent_.pop_front();
}

std::shared_ptr<const SoftGame::Snapshot> SoftGame::snapshot(GameHistory& history) const {
  auto kept = std::make_shared<Snapshot>();
  kept->play = play_.snapshot();
  kept->time = time();
  kept->bodies = bodies_;
  kept->puckOf = puckOf_;
  kept->given = given_;
  kept->listed = listed_;
  kept->rows = rows_->snapshot(time());
  for (const std::size_t puck : puckOf_) kept->legs.push_back(history.legs(puck));
  return kept;
}

void SoftGame::restore(const Snapshot& snapshot, GameHistory& history) {
  play_.restore(*snapshot.play);
  isNews_ = true;
  bodies_ = snapshot.bodies;
  puckOf_ = snapshot.puckOf;
  given_ = snapshot.given;
  listed_ = snapshot.listed;
  rows_->restore(snapshot.rows);
  for (std::size_t k = 0; k < puckOf_.size(); ++k) history.keepLegs(puckOf_[k], snapshot.legs[k]);
  while (!recent_.empty() && recent_.back().first >= snapshot.time) recent_.pop_back();
}

}  // namespace carom
