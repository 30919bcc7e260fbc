#include "app/tables/event_table.h"

#include <algorithm>
#include <cmath>

#include "engine/base/bisection.h"
#include "engine/spacetime/lorentz.h"

namespace carom {
namespace {

/// Returns c (t − t_e) − |r − r_e|, which is not negative once the event's light has arrived. It grows along
/// every world line slower than light.
double insideBy_m(const Event& source, const Event& receiver, double c_m_s) {
  return c_m_s * (receiver.t_s - source.t_s) - glm::length(receiver.r_m - source.r_m);
}

Event between(const Event& a, const Event& b, double part) {
  return {a.t_s + part * (b.t_s - a.t_s), a.r_m + part * (b.r_m - a.r_m)};
}

/// Numbers the rows by time: 1 plus the number of earlier rows.
template <class TimeOf>
void numberRows(std::vector<EventRow>& rows, std::size_t EventRow::*order, const TimeOf& timeOf) {
  std::vector<double> times_s;
  for (const EventRow& row : rows) times_s.push_back(timeOf(row));
  std::sort(times_s.begin(), times_s.end());
  for (EventRow& row : rows) {
    const auto first = std::lower_bound(times_s.begin(), times_s.end(), timeOf(row));
    row.*order = 1 + static_cast<std::size_t>(first - times_s.begin());
  }
}

}  // namespace

std::string whoOf(const GameEvent& event, std::span<const std::string> pucks,
                  std::span<const std::string> flashes) {
  if (event.kind == EventKind::flash) return event.which < flashes.size() ? flashes[event.which] : "";
  std::string who;
  for (const Turn& turn : event.turns) {
    who += (who.empty() ? "" : ", ") + (turn.puck < pucks.size() ? pucks[turn.puck] : std::string("?"));
  }
  return who;
}

Reception receptionAt(const Vec3& place_m, const Event& source, double c_m_s) {
  return {source.t_s + glm::length(place_m - source.r_m) / c_m_s, {}, {}};
}

std::optional<Reception> receptionBy(std::span<const HeadAt> head, const Event& source, double c_m_s) {
  const auto outside = [&](const HeadAt& at) { return insideBy_m(source, at.event, c_m_s) < 0.0; };
  const auto first = std::partition_point(head.begin(), head.end(), outside);
  if (first == head.begin() || first == head.end()) return std::nullopt;
  const HeadAt &before = first[-1], &after = *first;
  constexpr int kHalvings = 60;  // below rounding
  const auto isOnTheWay = [&](double share) {
    return insideBy_m(source, between(before.event, after.event, share), c_m_s) < 0.0;
  };
  const double high = bisect({0.0, 1.0}, kHalvings, isOnTheWay).high;
  return Reception{between(before.event, after.event, high).t_s,
                   before.properTime_s + high * (after.properTime_s - before.properTime_s), after.frame};
}

std::vector<EventRow> eventRows(std::span<const GameEvent> events, std::span<const std::string> pucks,
                                std::span<const std::string> flashes, const Vec3& movingBeta, double c_m_s) {
  const Lorentz movingFromBoard = Lorentz::boost(-uFromBeta(movingBeta), c_m_s);
  std::vector<EventRow> rows;
  for (const GameEvent& event : events) {
    const Event moving = Event{} + movingFromBoard * (event.at - Event{});
    rows.push_back({event, whoOf(event, pucks, flashes), 0, moving, 0, {}});
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const EventRow& a, const EventRow& b) { return a.event.at.t_s < b.event.at.t_s; });
  numberRows(rows, &EventRow::order, [](const EventRow& row) { return row.event.at.t_s; });
  numberRows(rows, &EventRow::movingOrder, [](const EventRow& row) { return row.moving.t_s; });
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
    rows[i].toNext = relationOf(rows[i + 1].event.at - rows[i].event.at, c_m_s);
  return rows;
}

}  // namespace carom
