#include "app/play/game.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/scenario/scenario_soft.h"
#include "cave/frame/bodies.h"
#include "engine/light/light_cone.h"
#include "engine/text/log.h"

namespace carom {
double forgettableBefore_s(std::span<const WorldLine> bodies, const ObserverView& observer) {
  Event eye = observer.middle.observation;
  eye.t_s -= kEyesMayRunBack_m / observer.headFromBoard.lightSpeed_m_s();
  double before_s = eye.t_s;
  BodyView view;
  for (const WorldLine& body : bodies) {
    for (const std::uint8_t contraction : {std::uint8_t{1}, std::uint8_t{0}}) {
      Switches switches;
      switches.contraction = contraction;
      viewBody(body, eye, observer.headFromBoard, view, switches);
      before_s = std::min(before_s, body.knots()[view.firstLeg].turn.t_s);
    }
  }
  return before_s;
}

double forgettableRowsBefore_m(std::span<const SoftPast> bodies, const ObserverView& observer) {
  const Event& eye = observer.middle.observation;
  const double now_m = eye.t_s * observer.headFromBoard.lightSpeed_m_s() - kRowsBehind_m;
  const auto isPast = [&](const SoftRow& row) {
    const glm::dvec2 way = row.centre() - glm::dvec2(eye.r_m);
    return now_m - row.time >= glm::length(glm::dvec3(way, eye.r_m.z)) + row.reach;
  };
  double before_m = std::numeric_limits<double>::infinity();
  for (const SoftPast& past : bodies) {
    if (past.rows.rowCount() == 0) continue;
    std::size_t k = 0;
    while (k + 1 < past.rows.rowCount() && isPast(past.rows.row(k + 1))) ++k;
    before_m = std::min(before_m, past.rows.row(k).time);
  }
  return before_m;
}

double latestObservation_s(const ObserverView& observer) {
  double latest_s = observer.left.observation.t_s;
  for (const EyeView& eye : observer.all()) latest_s = std::max(latest_s, eye.observation.t_s);
  return latest_s;
}

double latestObservation_s(const FrameRecord& record) {
  double latest_s = -std::numeric_limits<double>::infinity();
  for (const ViewerState& viewer : record.present())
    latest_s = std::max(latest_s, latestObservation_s(viewer.observer));
  return latest_s;
}

namespace {

BilliardSetup with(BilliardSetup setup, std::span<const Stroke> struck) {
  setup.strokes.insert(setup.strokes.end(), struck.begin(), struck.end());
  return setup;
}

}  // namespace

Game::Game(const Scenario& scenario, std::span<const Stroke> struck)
    : billiard_(with(scenario.billiard, struck)) {
  for (const Puck& puck : scenario.billiard.pucks) names_.push_back(puck.name);
  billiard_.takeChanges();
  billiard_.playAhead();
}

Event Game::strike(const Stroke& stroke) {
  const double arrival_s = billiard_.strike(stroke);
  return billiard_.worldLines()[stroke.puck].at(arrival_s).event;
}

void Game::playToNowOf(const ObserverView& observer) {
  constexpr double kNear_s = 1e-6;  // micrometres of motion
  const Event& head = observer.middle.observation;
  const Vec3 beta_s_m =
      betaFromU(observer.headFromBoard.inverse().u()) / observer.headFromBoard.lightSpeed_m_s();
  for (std::size_t puck = 0; puck < billiard_.worldLines().size(); ++puck) {
    // The head's moment: t = t_o + β·(r(t) − r_o)/c. Each turn is nearer by β v/c < 1.
    double now_s = head.t_s, before_s = now_s - 1.0;
    while (std::abs(now_s - before_s) > kNear_s) {
      billiard_.advanceTo(now_s);
      before_s = now_s;
      now_s = head.t_s + glm::dot(beta_s_m, billiard_.worldLines()[puck].at(now_s).event.r_m - head.r_m);
    }
    const WorldLine& line = billiard_.worldLines()[puck];
    billiard_.advanceTo(now_s + line.radius_m() / line.lightSpeed_m_s());  // of its rim, too
  }
}

void Game::advance(double t_s, FrameState& state) {
  billiard_.advanceTo(t_s);
  tellCrushed();
  const Changes changes = billiard_.takeChanges();
  state.record.truncateFrom_s = changes.truncatedFrom_s.value_or(std::numeric_limits<double>::infinity());
  state.record.eventsKept = changes.eventsKept;
  // A game's first frame brings all of it, because a continued session file has parts of it already.
  if (!begun_) {
    state.record.truncateFrom_s = 0.0;
    state.record.eventsKept = 0;
  }
  begun_ = true;
  state.record.pucks = billiard_.worldLines().size();
  state.events = changes.events;
  state.knots.clear();
  for (const Changes::NewKnot& change : changes.knots) {
    state.knots.push_back({kFirstPuck + change.puck, change.knot});
  }
  billiard_.takeSoftRows(rows_);
  state.record.rowsFrom_m = rows_.truncatedFrom;
  std::swap(state.rows, rows_.rows);
  std::swap(state.rowNodes, rows_.nodes);
  for (SoftRow& row : state.rows) row.body += kFirstPuck;
}

// A stroke can undo a crush that was told; a later one is told, too.
void Game::tellCrushed() {
  const std::vector<FrozenPuck> frozen = billiard_.frozen();
  crushed_ = std::min(crushed_, frozen.size());
  for (; crushed_ < frozen.size(); ++crushed_)
    log::warn(crushedText(names_[frozen[crushed_].puck], frozen[crushed_].t_s));
}

void Game::forget(const World& world, std::span<const ObserverView> observers, FrameState& state,
                  double keptFrom_s) {
  double before_s = keptFrom_s, rowsBefore_m = std::numeric_limits<double>::infinity();
  const auto pucks = std::span(world.histories).subspan(kFirstPuck, billiard_.worldLines().size());
  for (const ObserverView& observer : observers) {
    before_s = std::min(before_s, forgettableBefore_s(pucks, observer));
    rowsBefore_m = std::min(rowsBefore_m, forgettableRowsBefore_m(world.soft, observer));
  }
  billiard_.forgetBefore(before_s);
  state.record.forgetBefore_s = before_s;
  if (!observers.empty())
    rowsBefore_m = std::min(rowsBefore_m, keptFrom_s * observers[0].headFromBoard.lightSpeed_m_s());
  if (std::isfinite(rowsBefore_m)) state.record.rowsForgottenBefore_m = rowsBefore_m;
}

}  // namespace carom
