#include "engine/billiard/billiard.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "engine/base/bisection.h"
#include "engine/billiard/collision_scheduler.h"
#include "engine/billiard/soft_game.h"
#include "engine/game/game_history.h"
#include "engine/game/setup_check.h"

namespace carom {

namespace {

// Points of the game to which a stroke can return: kept the more densely the nearer they are to the present.
constexpr std::size_t kSnapshots = 24;
constexpr std::size_t kSnapshotPucks = 100000;  // in all of them together
constexpr std::size_t kLeastBetween = 64;       // events
constexpr std::size_t kBetweenPerPuck = 8;

std::size_t betweenSnapshots(const BilliardSetup& setup) {
  return std::max(kLeastBetween, kBetweenPerPuck * setup.pucks.size());
}

bool sameKnot(const Knot& a, const Knot& b) {
  return a.turn.t_s == b.turn.t_s && a.turn.r_m == b.turn.r_m && a.u == b.u &&
         a.properTime_s == b.properTime_s && a.signal.t_s == b.signal.t_s && a.signal.r_m == b.signal.r_m &&
         a.spin == b.spin;
}

}  // namespace

struct Billiard::Snapshot {
  CollisionScheduler game;
  std::uint64_t events = 0;
  std::size_t strokes = 0;
  std::shared_ptr<const SoftGame::Snapshot> soft{};
  double time = 0.0;  ///< to which it is played
};

namespace {

bool hasSoft(const BilliardSetup& setup) {
  return std::any_of(setup.pucks.begin(), setup.pucks.end(),
                     [](const Puck& puck) { return puck.soft.has_value(); });
}

}  // namespace

Billiard::Billiard(const BilliardSetup& setup) {
  checkSetup(setup);
  setup_ = setup;
  history_ = std::make_unique<GameHistory>(setup_);
  game_ = std::make_unique<CollisionScheduler>(setup_);
  softRows_ = std::make_unique<SoftRowBook>();
  if (hasSoft(setup_)) beginSoft();
  reported_.assign(setup_.pucks.size(), 1);
  nextSnapshot_ = betweenSnapshots(setup_);
}

Billiard::~Billiard() = default;
Billiard::Billiard(Billiard&&) noexcept = default;
Billiard& Billiard::operator=(Billiard&&) noexcept = default;

void Billiard::beginSoft() {
  soft_ = std::make_unique<SoftGame>(setup_, *game_, *history_, *softRows_);
  if (playsAhead_) soft_->playAhead();
}

void Billiard::playAhead() {
  playsAhead_ = true;
  if (soft_) soft_->playAhead();
}

void Billiard::advanceTo(double t_s) {
  if (!(t_s > advancedTo_s_)) return;
  advancedTo_s_ = t_s;
  play();
  // A stroke that is known from the beginning may have changed turns whose signal was on its way.
  const double changed_s = history_->takeChangedFrom_s();
  if (changed_s < truncatedFrom_s_.value_or(std::numeric_limits<double>::infinity()))
    truncatedFrom_s_ = changed_s;
}

// Slices are played as a whole, so that the commitments do not depend on the times advanced to.
void Billiard::playSoft() {
  constexpr double kBetween = 0.02;  // metres of light, between the points to which the game can return
  const auto limit = [&] {
    // As far ahead as rows can be apart, too.
    return advancedTo_s_ * setup_.lightSpeed_m_s + std::max(game_->rollbackWindow(), RowRecorder::kLongest) +
           SoftPlay::kSlice;
  };
  while (soft_->time() < limit()) {
    if (snapshots_.empty() ? soft_->time() > 0.0 : soft_->time() - snapshots_.back().time >= kBetween)
      keepSnapshot();
    soft_->playSlice(*game_, *history_);
  }
  soft_->forgetBefore(advancedTo_s_);
}

void Billiard::play() {
  if (soft_) return playSoft();
  while (!game_->playUntil(advancedTo_s_ * setup_.lightSpeed_m_s + game_->rollbackWindow(), nextSnapshot_,
                           *history_)) {
    keepSnapshot();
    nextSnapshot_ = history_->eventCount() + betweenSnapshots(setup_);
  }
}

// When there are too many, the one goes whose absence leaves the smallest gap, compared with its age.
void Billiard::keepSnapshot() {
  const std::size_t most = std::clamp<std::size_t>(kSnapshotPucks / setup_.pucks.size(), 2, kSnapshots);
  snapshots_.push_back({*game_, history_->eventCount(), setup_.strokes.size(),
                        soft_ ? soft_->snapshot(*history_) : nullptr,
                        soft_ ? soft_->time() : game_->clock()});
  if (snapshots_.size() <= most) return;
  const double present = snapshots_.back().time;
  std::size_t spare = 0;
  double least = std::numeric_limits<double>::infinity();
  // A forgotten time cannot be played again: the first point after that stays.
  for (std::size_t i = forgottenBefore_s_ > 0.0 ? 1 : 0; i + 1 < snapshots_.size(); ++i) {
    const double earlier = i == 0 ? 0.0 : snapshots_[i - 1].time;
    const double gap = (snapshots_[i + 1].time - earlier) / (present - earlier);
    if (gap < least) {
      least = gap;
      spare = i;
    }
  }
  snapshots_.erase(snapshots_.begin() + static_cast<std::ptrdiff_t>(spare));
}

// Where the stroke's light meets the world line as far as it is decided.
double Billiard::arrivalOnKnownLegs_s(const Stroke& stroke) const {
  if (!stroke.from_m) return stroke.at_s;
  if (soft_ && soft_->isSoft(stroke.puck)) return reachesSoft_s(stroke);
  const double c = setup_.lightSpeed_m_s;
  const Vec21 hand{stroke.at_s * c, stroke.from_m->x, stroke.from_m->y};
  const Knots knots = worldLines()[stroke.puck].knots();
  double t_s = 0.0;
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const Knot& knot = knots[k];
    const Leg leg{{knot.turn.t_s * c, knot.turn.r_m.x, knot.turn.r_m.y},
                  fourVelocity(knot.u.x, knot.u.y),
                  0.0,
                  knot.deceleration_m_s2 / (c * c)};
    t_s = signalArrives(leg, hand, stroke.from_m->z - knot.turn.r_m.z).x.t / c;
    if (k + 1 < knots.size() && t_s < knots[k + 1].turn.t_s) break;
  }
  return t_s;
}

// Where the light of the hand is a diameter and a slice before the centre of a soft puck: its nodes are
// struck one by one, from about then on. The light gains on the distance all the time, so there is one such
// moment.
double Billiard::reachesSoft_s(const Stroke& stroke) const {
  const double c = setup_.lightSpeed_m_s;
  const Puck& puck = setup_.pucks[stroke.puck];
  const double before_m = 2.0 * puck.radius_m + SoftPlay::kSlice;
  const auto isShort = [&](double t_s) {
    const Vec3 away_m = worldLines()[stroke.puck].at(t_s).event.r_m - *stroke.from_m;
    const double apart_m = std::max(0.0, std::hypot(away_m.x, away_m.y) - before_m);
    return c * (t_s - stroke.at_s) < std::hypot(apart_m, away_m.z);
  };
  double most_s = 1.0;
  while (isShort(stroke.at_s + most_s) && most_s < 1e9) most_s *= 2.0;
  constexpr int kHalvings = 60;
  return bisect({stroke.at_s, stroke.at_s + most_s}, kHalvings, isShort).low;
}

// Nothing turns a puck in a game with soft ones, so there the offset of a stroke does not count.
double Billiard::strike(const Stroke& given) {
  Stroke stroke = given;
  if (soft_) stroke.offset_m = 0.0;
  checkStroke(setup_, stroke, setup_.strokes.size());
  double arrival_s = arrivalOnKnownLegs_s(stroke);
  // On a last leg that flees the light the arrival may be far off, and a turn to come bring it near: so not
  // all of the way at once.
  for (double ahead_s = 1.0; arrival_s > advancedTo_s_; ahead_s *= 2.0) {
    advanceTo(std::min(arrival_s, advancedTo_s_ + ahead_s));
    arrival_s = arrivalOnKnownLegs_s(stroke);
  }
  if (!(arrival_s >= 0.0 && arrival_s >= forgottenBefore_s_)) {
    throw std::invalid_argument("a stroke on puck \"" + setup_.pucks[stroke.puck].name + "\" arrives at " +
                                std::to_string(arrival_s) + " s: expected " +
                                std::to_string(std::max(0.0, forgottenBefore_s_)) + " s or later");
  }
  setup_.strokes.push_back(stroke);
  rewind(arrival_s);
  return arrival_s;
}

// Returns to the last point of the game before the arrival, and plays again with all strokes up to the same
// time.
void Billiard::rewind(double t_s) {
  const double t = t_s * setup_.lightSpeed_m_s;
  while (!snapshots_.empty() && !(snapshots_.back().time < t)) snapshots_.pop_back();
  std::vector<std::vector<Knot>> before;
  for (const WorldLine& line : worldLines()) before.emplace_back(line.knots().begin(), line.knots().end());

  if (snapshots_.empty()) {
    game_ = std::make_unique<CollisionScheduler>(setup_);
    game_->restore(*history_);
    history_->keepEvents(0);
    if (soft_) beginSoft();
    nextSnapshot_ = betweenSnapshots(setup_);
  } else {
    const Snapshot& from = snapshots_.back();
    *game_ = from.game;
    history_->keepEvents(from.events);
    game_->restore(*history_);
    if (soft_) soft_->restore(*from.soft, *history_);
    nextSnapshot_ = from.events + betweenSnapshots(setup_);
    for (std::size_t i = from.strokes; i < setup_.strokes.size(); ++i) {
      game_->addStroke(setup_.strokes[i]);
      if (soft_) soft_->addStroke(i, setup_.strokes[i]);
    }
  }
  play();
  history_->takeChangedFrom_s();  // seen by the comparison, too
  noteChanges(before);
}

// The earliest knot that is not what it was.
void Billiard::noteChanges(const std::vector<std::vector<Knot>>& before) {
  double changed_s = truncatedFrom_s_.value_or(std::numeric_limits<double>::infinity());
  for (std::size_t puck = 0; puck < before.size(); ++puck) {
    const Knots now = worldLines()[puck].knots();
    const std::vector<Knot>& then = before[puck];
    std::size_t k = 0;
    while (k < now.size() && k < then.size() && sameKnot(now[k], then[k])) ++k;
    if (k < then.size()) changed_s = std::min(changed_s, then[k].turn.t_s);
    if (k < now.size() && k < then.size()) changed_s = std::min(changed_s, now[k].turn.t_s);
  }
  if (changed_s < std::numeric_limits<double>::infinity()) truncatedFrom_s_ = changed_s;
}

Changes Billiard::takeChanges() {
  Changes changes;
  changes.truncatedFrom_s = std::exchange(truncatedFrom_s_, std::nullopt);
  for (std::size_t puck = 0; puck < reported_.size(); ++puck) {
    const Knots knots = worldLines()[puck].knots();
    const std::size_t forgotten = history_->legs(puck) - knots.size();
    std::size_t first = std::max<std::size_t>(reported_[puck], forgotten + 1) - forgotten;
    if (changes.truncatedFrom_s) {
      while (first > 1 && (first > knots.size() || knots[first - 1].turn.t_s >= *changes.truncatedFrom_s))
        --first;
    }
    for (std::size_t k = first; k < knots.size(); ++k) changes.knots.push_back({puck, knots[k]});
    reported_[puck] = history_->legs(puck);
  }
  changes.eventsKept = std::min<std::uint64_t>(reportedEvents_, history_->takeUnchangedEvents());
  const std::size_t kept = changes.eventsKept - std::min(changes.eventsKept, history_->forgottenEvents());
  changes.events.assign(events().begin() + static_cast<std::ptrdiff_t>(kept), events().end());
  reportedEvents_ = history_->eventCount();
  return changes;
}

// The game can return to its last point before that time, and what this point needs is not forgotten.
void Billiard::forgetBefore(double t_s) {
  const double c = setup_.lightSpeed_m_s;
  std::size_t last = snapshots_.size();
  while (last > 0 && !(snapshots_[last - 1].time < t_s * c)) --last;
  if (last == 0) return;
  snapshots_.erase(snapshots_.begin(), snapshots_.begin() + static_cast<std::ptrdiff_t>(last - 1));
  forgottenBefore_s_ = std::max(forgottenBefore_s_, t_s);
  const Snapshot& from = snapshots_.front();
  history_->forgetBefore((from.time - from.game.rollbackWindow()) / c);
}

std::span<const WorldLine> Billiard::worldLines() const { return history_->worldLines(); }
std::span<const GameEvent> Billiard::events() const { return history_->events(); }
Ledger Billiard::ledger() const {
  Ledger ledger = game_->ledger();
  if (soft_) soft_->addTo(ledger);
  return ledger;
}
SoftMoment Billiard::softAt(double t_s, std::span<const SoftPoint> points) const {
  return soft_ ? soft_->at(t_s, points) : SoftMoment{};
}
void Billiard::takeSoftRows(SoftRows& rows) { softRows_->take(rows); }
std::vector<FrozenPuck> Billiard::frozen() const {
  return soft_ ? soft_->frozen() : std::vector<FrozenPuck>{};
}
std::span<const JamNote> Billiard::jams() const { return game_->jams(); }

}  // namespace carom
