#include "engine/sculpture/soft_rim.h"

#include <algorithm>

#include "engine/game/soft_puck_mesh.h"
#include "engine/light/row_eye.h"
#include "engine/light/vertex_history.h"
#include "engine/sculpture/world_tube.h"

namespace carom {
namespace {

/// The rows of the rim's nodes as an observer has them.
class RimRows {
 public:
  RimRows(const SoftRim& rim, const Event& observation) : rim_(rim), observation_(observation) {}
  std::size_t count() const { return rim_.rows.rowCount(); }
  double time_m(std::size_t k) const {
    return rim_.rows.row(k).time - rim_.lightSpeed_m_s * observation_.t_s;
  }
  Vec3 fromEye_m(std::size_t k, std::size_t node) const {
    return Vec3(rim_.rows.place(k, rim_.nodes[node]), rim_.top_m()) - observation_.r_m;
  }
  Vec3 velocityBefore(std::size_t node) const { return after(0, node); }
  Vec3 velocityAfter(std::size_t node) const { return after(count() - 1, node); }

 private:
  Vec3 after(std::size_t k, std::size_t node) const {
    return {rim_.rows.velocityAfter(k, rim_.nodes[node]), 0.0};
  }
  const SoftRim& rim_;
  const Event& observation_;
};

/// Returns the last row at or before a time; the first, if there is none.
std::size_t lastAtOrBefore(const SoftHistory& rows, double time) {
  std::size_t low = 0, behind = rows.rowCount();
  while (behind - low > 1) {
    const std::size_t middle = (low + behind) / 2;
    (rows.row(middle).time <= time ? low : behind) = middle;
  }
  return low;
}

/// Returns where a node is at a board time: between a row and the next, or going on evenly before the first
/// and after the last.
Event nodeAt(const SoftRim& rim, std::size_t k, std::size_t node, double t_s) {
  const SoftHistory& rows = rim.rows;
  const std::size_t of = rim.nodes[node];
  const double since = rim.lightSpeed_m_s * t_s - rows.row(k).time;
  glm::dvec2 place = rows.place(k, of);
  if (since > 0.0 && k + 1 < rows.rowCount()) {
    place = glm::mix(place, rows.place(k + 1, of), since / (rows.row(k + 1).time - rows.row(k).time));
  } else {
    place += rows.velocityAfter(k, of) * since;
  }
  return {t_s, {place, rim.top_m()}};
}

}  // namespace

SoftHull softHullOf(const Puck& puck) {
  constexpr std::size_t kDiscPoints = 24;
  const SoftMesh mesh = softMeshOf(puck);
  const std::size_t count = mesh.hull().size();
  const bool isDisc = puck.outline_m.empty();
  const std::size_t every = isDisc && count % kDiscPoints == 0 ? count / kDiscPoints : 1;
  SoftHull hull;
  for (std::size_t i = 0; i < count; i += every) {
    const auto node = static_cast<std::size_t>(mesh.hull()[i]);
    hull.nodes.push_back(node);
    hull.relaxed.emplace_back(mesh.places()[node], 0.5 * puck.height_m);
  }
  return hull;
}

SliceOfRows rowsOf(const SoftRim& rim, const Span& span) {
  const SoftHistory& rows = rim.rows;
  const std::size_t first = lastAtOrBefore(rows, rim.lightSpeed_m_s * span.from_s),
                    last = std::min(lastAtOrBefore(rows, rim.lightSpeed_m_s * span.until_s) + 1,
                                    rows.rowCount() - 1);
  return {last - first + 1, rows.row(first).time, rows.row(last).time, rows.row(last).centre(),
          rim.rigid != nullptr};
}

std::vector<Event> softEventsAlong(const SoftRim& rim, std::size_t node, const Span& span) {
  const SoftHistory& rows = rim.rows;
  const double c_m_s = rim.lightSpeed_m_s, begins_s = rows.row(0).time / c_m_s;
  std::vector<Event> events;
  double from_s = span.from_s;
  if (rim.rigid && from_s < begins_s) {
    const Span rigid{from_s, std::min(begins_s, span.until_s)};
    events = eventsAlong(vertexHistory(*rim.rigid, rim.relaxed[node]), rigid, c_m_s);
    if (!(span.until_s > begins_s)) return events;
    events.pop_back();  // the first row has this moment
    from_s = begins_s;
  }
  const std::size_t first = lastAtOrBefore(rows, c_m_s * from_s);
  events.push_back(nodeAt(rim, first, node, from_s));
  std::size_t row = first;
  for (std::size_t k = first; k < rows.rowCount() && rows.row(k).time < c_m_s * span.until_s; ++k) {
    row = k;
    const double t_s = rows.row(k).time / c_m_s;
    if (t_s > from_s) events.push_back({t_s, {rows.place(k, rim.nodes[node]), rim.top_m()}});
  }
  events.push_back(nodeAt(rim, row, node, span.until_s));
  return events;
}

void cutSoftRim(const SoftRim& rim, const Event& observation, const Lorentz& headFromBoard, ViewTime moment,
                BodyView& view, std::vector<Event>& events) {
  if (rim.rigid) cutRim(rim.relaxed, *rim.rigid, observation, headFromBoard, moment, view, events);
  const bool wasThere = rim.rigid && !events.empty();
  events.resize(rim.nodes.size());
  const RowEye eye(observation, headFromBoard, {}, moment);
  const RimRows rows(rim, observation);
  std::size_t guess = 0;
  for (std::size_t node = 0; node < rim.nodes.size(); ++node) {
    const RowSpot spot = eye.find(rows, node, guess);
    guess = spot.row;
    if (!spot.isBeforeAll || !rim.rigid) {
      events[node] = observation + Displacement{spot.boardTime_m / rim.lightSpeed_m_s, spot.fromEye_m};
    } else if (!wasThere) {
      return events.clear();
    }
  }
}

}  // namespace carom
