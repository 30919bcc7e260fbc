#include "cave/record/frame_state.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

#include "engine/light/vertex_history.h"

namespace carom {
namespace {

/// Returns whether an event is over, as the game decides it (GameHistory::forgetBefore).
bool isOver(const GameEvent& event, double before_s) {
  return event.at.t_s < before_s &&
         std::all_of(event.turns.begin(), event.turns.end(),
                     [before_s](const Turn& turn) { return turn.event.t_s < before_s; });
}

void applyEvents(const FrameState& state, std::vector<GameEvent>& events) {
  while (!events.empty() && events.back().number >= state.record.eventsKept) events.pop_back();
  events.insert(events.end(), state.events.begin(), state.events.end());
  const double before_s = state.record.forgetBefore_s;
  if (!std::isfinite(before_s)) return;
  events.erase(events.begin(),
               std::find_if_not(events.begin(), events.end(),
                                [before_s](const GameEvent& event) { return isOver(event, before_s); }));
}

void truncateRows(double time_m, std::vector<SoftPast>& soft) {
  for (SoftPast& past : soft) {
    past.rows.truncateFrom(time_m);
    if (past.rows.rowCount() == 0) past.rigid.reset();
  }
}

void forgetRows(double time_m, std::vector<SoftPast>& soft) {
  for (SoftPast& past : soft) {
    past.rows.forgetBefore(time_m);
    if (past.rigid && !past.rows.row(0).wasRigid) past.rigid.reset();
  }
}

void applyRows(const FrameState& state, World& world) {
  const FrameRecord& record = state.record;
  if (record.rowsFrom_m < std::numeric_limits<double>::infinity())
    truncateRows(record.rowsFrom_m, world.soft);
  std::size_t node = 0;
  for (const SoftRow& row : state.rows) {
    if (row.body >= world.histories.size() || row.nodes > state.rowNodes.size() - node)
      throw std::out_of_range("frame record: a row of a body that is not there, or without its nodes");
    if (world.soft.empty()) world.soft.resize(world.histories.size());
    SoftPast& past = world.soft[row.body];
    past.rows.append(row, std::span(state.rowNodes).subspan(node, row.nodes));
    node += row.nodes;
    if (!row.wasRigid) continue;
    past.rigid = world.histories[row.body];
    past.rigid->truncateFrom(row.time / past.rigid->lightSpeed_m_s());
  }
  if (std::isfinite(record.rowsForgottenBefore_m)) forgetRows(record.rowsForgottenBefore_m, world.soft);
}

/// Moments that another viewer of a session might still ask for.
constexpr double kPeopleKept_s = 600.0;

void applyTold(const FrameState& state, World& world) {
  for (const ToldMoment& moment : state.told) {
    if (moment.person >= kMostViewers || world.histories.empty())
      throw std::out_of_range("frame record: a person who is one too many");
    if (moment.person >= world.people.size())
      world.people.resize(moment.person + 1, ToldPath(world.histories.front().lightSpeed_m_s()));
    world.people[moment.person].add(moment);
  }
  if (!std::isfinite(state.record.forgetBefore_s)) return;
  for (ToldPath& path : world.people) path.forgetBefore(state.record.forgetBefore_s - kPeopleKept_s);
}

}  // namespace

void applyFrame(const FrameState& state, World& world) {
  const std::span<WorldLine> histories = world.histories;
  if (state.record.pucks > 0 && state.record.pucks >= histories.size()) {
    throw std::out_of_range("frame record: more pucks than there are histories");
  }
  if (std::isfinite(state.record.truncateFrom_s)) {
    for (WorldLine& history : histories.subspan(1, state.record.pucks)) {
      history.truncateFrom(state.record.truncateFrom_s);
    }
  }
  for (const BodyKnot& knot : state.knots) {
    if (knot.body >= histories.size())
      throw std::out_of_range("frame record: a knot of a body that is not there");
    WorldLine& history = histories[knot.body];
    history.append(knot.knot);
    if (!history.settlesBeforeNext(history.knots().size() - 2)) history.settlesAfter(joinedAfter_s(history));
  }
  applyRows(state, world);
  applyTold(state, world);
  if (std::isfinite(state.record.forgetBefore_s)) {
    for (WorldLine& history : histories.subspan(1, state.record.pucks)) {
      history.forgetBefore(state.record.forgetBefore_s);
    }
  }
  applyEvents(state, world.events);
}

}  // namespace carom
