#include "cave/sculpture/sculpture_shape.h"

#include <algorithm>
#include <cmath>

#include "engine/sculpture/sculpture_reach.h"
#include "engine/sculpture/world_tube.h"

namespace carom {
namespace {

constexpr double kBeside_m = 1.2;     // how far beside the board a viewer's place still counts
constexpr double kAround_m = 0.15;    // of the rectangle around that place
constexpr double kLineStep_s = 0.04;  // of own time between the events of a viewer's line

}  // namespace

Event surfaceEvent(const ObserverView& observer, ViewTime moment, const glm::dvec2& place_m, double top_m) {
  const Event& eye = observer.middle.observation;
  const double c_m_s = observer.headFromBoard.lightSpeed_m_s();
  const Vec3 place(place_m, top_m), way_m = place - eye.r_m;
  if (moment == ViewTime::seen) return {eye.t_s - glm::length(way_m) / c_m_s, place};
  if (moment == ViewTime::boardNow) return {eye.t_s, place};
  // The head's velocity on the board: what rests in the head's frame moves so.
  const Vec3 beta = betaFromU(observer.headFromBoard.inverse().u());
  return {eye.t_s + glm::dot(beta, way_m) / c_m_s, place};
}

SculptureShape::SculptureShape(const SculptedGame& game) : game_(game), hulls_(game.bodies.size()) {
  for (const SculptedBody& body : game.bodies) {
    Rim& rim = rims_.emplace_back();
    for (const Vec2& point_m : rimOf(body.puck)) rim.emplace_back(point_m, 0.5 * body.puck.height_m);
  }
}

std::optional<SoftRim> SculptureShape::softRim(std::size_t body, const World& world) {
  const SculptedBody& sculpted = game_.bodies[body];
  if (sculpted.body >= world.soft.size() || world.soft[sculpted.body].rows.rowCount() == 0) return {};
  const SoftPast& past = world.soft[sculpted.body];
  SoftHull& hull = hulls_[body];
  if (hull.nodes.empty()) hull = softHullOf(sculpted.puck);
  return SoftRim{past.rows, past.rigid ? &*past.rigid : nullptr, hull.nodes, hull.relaxed,
                 world.histories[sculpted.body].lightSpeed_m_s()};
}

void SculptureShape::cut(std::size_t person, const FrameRecord& record, const World& world) {
  const std::size_t viewer = record.ofRoom(person);
  const ObserverView& observer = record.viewers[viewer].observer;
  const Event& eye = observer.middle.observation;
  for (std::size_t body = 0; body < game_.bodies.size(); ++body) {
    const std::optional<SoftRim> soft = softRim(body, world);
    for (const ViewTime moment : {ViewTime::seen, ViewTime::myNow, ViewTime::boardNow}) {
      if (moment == ViewTime::boardNow && person > 0) continue;
      const double fine_m = moment == ViewTime::seen ? kFine_m : kMomentFine_m;
      const std::size_t every = everyFor(game_.bodies[body].puck, fine_m / record.sculpture.place.scale);
      rim_.clear();
      for (std::size_t i = 0; i < rims_[body].size(); i += every) rim_.push_back(rims_[body][i]);
      if (cutCount_ == cuts_.size()) cuts_.emplace_back();
      TubeCut& made = cuts_[cutCount_++];
      made.body = body, made.viewer = viewer, made.moment = moment;
      if (soft) {
        cutSoftRim(*soft, eye, observer.headFromBoard, moment, view_, made.events);
      } else {
        cutRim(rim_, world.histories[game_.bodies[body].body], eye, observer.headFromBoard, moment, view_,
               made.events);
      }
    }
  }
}

void SculptureShape::spread(const FrameRecord& record) {
  low_m_ = -game_.half_m;
  high_m_ = game_.half_m;
  for (const ViewerState& viewer : record.present()) {
    const glm::dvec2 place_m(viewer.observer.middle.observation.r_m);
    const glm::dvec2 near_m = glm::clamp(place_m, -game_.half_m - kBeside_m, game_.half_m + kBeside_m);
    low_m_ = glm::min(low_m_, near_m - kAround_m);
    high_m_ = glm::max(high_m_, near_m + kAround_m);
  }
}

void OwnLines::follow(const FrameRecord& record) {
  for (std::size_t viewer = 0; viewer < record.viewerCount; ++viewer) {
    const ObserverView& observer = record.viewers[viewer].observer;
    std::vector<OwnEvent>& line = lines_[viewer];
    const OwnEvent now{observer.middle.observation, observer.properTime_s};
    while (!line.empty() && line.back().properTime_s >= now.properTime_s) line.pop_back();
    const bool isNear =
        line.size() > 1 && line.back().properTime_s < line[line.size() - 2].properTime_s + kLineStep_s;
    if (isNear) line.pop_back();
    line.push_back(now);
    const double from_s =
        now.event.t_s - sculptureReach_s(record.sculpture.place, observer.headFromBoard.lightSpeed_m_s());
    const auto kept =
        std::find_if(line.begin(), line.end(), [&](const OwnEvent& own) { return own.event.t_s > from_s; });
    line.erase(line.begin(), kept);
  }
}

void SculptureShape::follow(const FrameRecord& record, const World& world) {
  cutCount_ = 0;
  spread(record);
  for (std::size_t person = 0; person < record.viewerCount; ++person) cut(person, record, world);
}

}  // namespace carom
