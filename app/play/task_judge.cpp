#include "app/play/task_judge.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "cave/frame/lesson_readings.h"
#include "engine/light/light_cone.h"

namespace carom {

Switches switchesOf(TaskWorld world, const Switches& before) {
  Switches switches = before;
  switches.retardation = world != TaskWorld::measured ? 1 : 0;
  switches.contraction = world != TaskWorld::newton ? 1 : 0;
  switches.aberration = world == TaskWorld::seen ? 1 : 0;
  return switches;
}

namespace {

bool takesPart(const GameEvent& event, std::size_t puck) {
  return std::any_of(event.turns.begin(), event.turns.end(),
                     [puck](const Turn& turn) { return turn.puck == puck; });
}

}  // namespace

void TaskJudge::struck(std::size_t puck, double arrives_s) {
  if (!struck_) arrives_s_ = arrives_s;
  struck_ = puck;
  carom_.struck(puck, arrives_s);
}

/// Returns for how long the eye has known of an event; negative if it does not yet. Its light has arrived
/// when t + |r_o − r|/c ≤ t_o; where a world shows everything as it is now, t ≤ t_o.
double TaskJudge::late_s(const Event& event, const Event& eye) const {
  const double way_m = task_->world == TaskWorld::measured ? 0.0 : glm::distance(event.r_m, eye.r_m);
  return eye.t_s - event.t_s - way_m / c_m_s_;
}

bool TaskJudge::hits(std::span<const GameEvent> events, const Event& eye) const {
  const std::size_t target = task_->goal.pucks[0];
  return target != *struck_ && std::any_of(events.begin(), events.end(), [&](const GameEvent& event) {
           return isOfPucks(event.kind) && event.at.t_s >= arrives_s_ && takesPart(event, target) &&
                  takesPart(event, *struck_) && late_s(event.at, eye) >= 0.0;
         });
}

/// The moment of the viewer's own time at which an event is seen lies between two frames, in which its
/// lateness runs evenly to the second order of their distance.
bool TaskJudge::hitsBoth(std::span<const GameEvent> events, const Moment& now) {
  for (const GameEvent& event : events) {
    if (!isOfPucks(event.kind) || event.at.t_s < arrives_s_) continue;
    const bool first = takesPart(event, task_->goal.pucks[0]),
               second = takesPart(event, task_->goal.pucks[1]);
    const double late_s = this->late_s(event.at, now.eye);
    const double before_s = before_ ? this->late_s(event.at, before_->eye) : 0.0;
    if (first == second || late_s < 0.0 || before_s >= 0.0) continue;
    const double share = before_s / (before_s - late_s);
    const double own_s = before_->own_s + share * (now.own_s - before_->own_s);
    hitAt_s_[first ? 0 : 1] = own_s;
    const std::optional<double>& other_s = hitAt_s_[first ? 1 : 0];
    if (other_s && std::abs(own_s - *other_s) <= kAtOnce_s) return true;
  }
  return false;
}

bool TaskJudge::look(std::span<const GameEvent> events, std::span<const WorldLine> pucks,
                     const ObserverView& observer, const Lorentz& boardFromRoom) {
  const Moment now{observer.middle.observation, observer.properTime_s};
  const auto seen = [&](std::size_t goal) {
    return centreSeen(pucks[task_->goal.pucks[goal]], now.eye, switchesOf(task_->world, {}));
  };
  const auto isDone = [&] {
    if (!struck_) return false;
    switch (task_->goal.kind) {
      case TaskGoal::Kind::hit:
        return hits(events, now.eye);
      case TaskGoal::Kind::cushions: {
        const auto cushions = carom_.look(events, now.eye, c_m_s_);
        return cushions && *cushions >= task_->goal.cushions;
      }
      case TaskGoal::Kind::hitBoth:
        return hitsBoth(events, now);
      case TaskGoal::Kind::looksFaster:
        return gauged(GaugeQuantity::apparentSpeed, seen(0),
                      {observer, boardFromRoom, LessonPhase::none, switchesOf(task_->world, {})}) > 1.0;
      case TaskGoal::Kind::clockReads:
        return std::abs(seen(0).properTime_s - seen(1).properTime_s) <= kSameTime_s;
    }
    return false;
  };
  const bool done = isDone();
  before_ = now;
  return done;
}

}  // namespace carom
