#include "app/live/sculpture_stand.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "app/stage/scenario_scene.h"
#include "cave/frame/event_mark.h"
#include "cave/texts/saying.h"
#include "cave/texts/texts.h"
#include "engine/sculpture/event_order.h"
#include "engine/text/log.h"

namespace carom {
namespace {

constexpr double kAside_m = 1.05, kAhead_m = 0.55;  // from the person
constexpr double kFromWall_m = 0.45;

}  // namespace

Pose standingAt(const Vec3& foot_m, const RoomAxes& axes, const Lorentz& boardFromRoom) {
  const Displacement alongX = boardFromRoom.inverse() * Displacement{0.0, {1.0, 0.0, 0.0}};
  const Vec3 level = alongX.dr_m - axes.up * glm::dot(alongX.dr_m, axes.up);
  const Vec3 x = glm::length(level) > 1e-6 ? glm::normalize(level) : axes.right;
  return {foot_m, glm::normalize(glm::quat_cast(glm::dmat3(x, glm::cross(axes.up, x), axes.up)))};
}

SculptureStand::SculptureStand(const Rig& rig, const Scenario& scenario,
                               const std::optional<FrameRecord>& before)
    : axes_(rig.axes) {
  for (const Puck& puck : scenario.billiard.pucks) topOfPucks_m_ = std::max(topOfPucks_m_, puck.height_m);
  const SculptedBodies bodies = sculptedBodies(scenario);
  sculpted_ = bodies.pucks.size() + bodies.bodies.size();
  left_ = bodies.leftOut;
  for (const ViewerSetup& viewer : rig.viewers) names_.push_back(viewer.name);
  for (const Flash& flash : scenario.billiard.flashes) flashes_.push_back(flash.name);
  if (before) {
    view_ = before->sculpture;
    view_.held = 0;
    isPlaced_ = true;
    return;
  }
  const SpacetimeSetup& setup = scenario.spacetime ? *scenario.spacetime : rig.spacetime;
  view_.place = sizeOf(setup, scenario.billiard.lightSpeed_m_s);
  place_m_ = setup.place_m;
  box_ = boxOf(rig);
  if (const auto warning = warningOf(setup, rig)) log::warn(*warning);
}

// To the right of the person, between them and the table, within the walls.
void SculptureStand::putInto(FrameRecord& record) {
  if (!isPlaced_) {
    const Vec3 head_m = record.viewers.front().observer.middle.positionInRoom_m;
    Vec3 foot_m = head_m + axes_.right * kAside_m + axes_.forward * kAhead_m;
    if (box_) {
      for (const Vec3& axis : {axes_.right, axes_.forward}) {
        const double a = glm::dot(box_->low_m, axis), b = glm::dot(box_->high_m, axis),
                     at = glm::dot(foot_m, axis);
        const double least = std::min(a, b) + kFromWall_m, most = std::max(a, b) - kFromWall_m;
        if (least < most) foot_m += axis * (std::clamp(at, least, most) - at);
      }
    }
    const double floor =
        box_ ? std::min(glm::dot(box_->low_m, axes_.up), glm::dot(box_->high_m, axes_.up)) : 0.0;
    foot_m += axes_.up * (floor - glm::dot(foot_m, axes_.up));
    view_.place.roomFromFoot = standingAt(place_m_.value_or(foot_m), axes_, record.boardFromRoom);
    isPlaced_ = true;
  }
  if (!record.views.spacetime) {
    hands_.letGo();
    view_.held = 0;
  }
  record.sculpture = view_;
}

SculptureStand::Touch SculptureStand::touch(const HandInput& hand, std::size_t viewer, const World& world,
                                            FrameRecord& record) {
  Touch touch;
  const bool isNew = !std::exchange(wasShown_, record.views.spacetime != 0);
  if (!record.views.spacetime) return touch;
  if (isNew && left_ > 0) touch.said = texts::say(texts::message::kNotSculpted, sculpted_, left_);
  const ObserverView& first = record.viewers.front().observer;
  const SculptureMap map(view_.place, first.middle.observation, first.headFromBoard.lightSpeed_m_s());
  const SculptureHands::Outcome outcome = hands_.step(hand, viewer, map, world.events, topOfPucks_m_, view_);
  view_.held = hands_.holds() ? 1 : 0;
  touch.takes = outcome.takes;
  touch.at_m = outcome.at_m;
  if (texts::Saying words = wordsOf(outcome, viewer, world, record); !words.empty() && words != said_)
    touch.said = said_ = std::move(words);
  if (!outcome.takes) said_ = {};
  record.sculpture = view_;
  return touch;
}

texts::Saying SculptureStand::wordsOf(const SculptureHands::Outcome& outcome, std::size_t viewer,
                                      const World& world, const FrameRecord& record) const {
  if (outcome.boosts)
    return outcome.atLimit ? texts::say(texts::message::kSculptureFastest, kMostSculptureBeta)
                           : texts::say(texts::message::kSculptureSpeed, glm::length(view_.place.beta));
  if (!outcome.picked || view_.picked == 0) return {};
  const auto eventOf = [&](std::uint64_t picked) {
    const auto found = std::find_if(world.events.begin(), world.events.end(),
                                    [&](const GameEvent& event) { return event.number + 1 == picked; });
    return found == world.events.end() ? nullptr : &*found;
  };
  const GameEvent *const last = eventOf(view_.picked), *const before = eventOf(view_.compared);
  if (last && before) return compare(*before, *last, viewer, record);
  return last ? texts::say(texts::message::kPicked, eventMark(*last, flashes_)) : texts::Saying();
}

texts::Saying SculptureStand::compare(const GameEvent& a, const GameEvent& b, std::size_t viewer,
                                      const FrameRecord& record) const {
  const double c_m_s = record.viewers[viewer].observer.headFromBoard.lightSpeed_m_s();
  const Displacement way = b.at - a.at;
  const auto first = [&](const Vec3& beta) {
    const int order = firstOf(a.at, b.at, beta, c_m_s);
    return order == 0 ? texts::Saying(texts::message::kNeitherFirst)
                      : texts::Saying(eventMark(order < 0 ? a : b, flashes_));
  };
  const auto betaOf = [&](std::size_t who) {
    return betaFromU(record.viewers[who].observer.headFromBoard.inverse().u());
  };
  texts::Saying order;
  if (interval_m2(way, c_m_s) >= 0.0) {
    order = texts::say(texts::message::kOneOrder, first(Vec3(0.0)));
  } else {
    order = texts::say(texts::message::kNoOrder, first(Vec3(0.0)), first(betaOf(viewer)));
    for (std::size_t other = 0; other < record.viewerCount; ++other)
      if (other != viewer) order += texts::say(texts::message::kOrderOf, first(betaOf(other)), names_[other]);
    order += texts::message::kOrderEnds;
  }
  return texts::say(texts::message::kPickedTwo, eventMark(a, flashes_), eventMark(b, flashes_),
                    glm::length(way.dr_m), c_m_s * std::abs(way.dt_s), order);
}

}  // namespace carom
