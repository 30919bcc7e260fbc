#include "engine/soft/soft_collisions.h"

#include <algorithm>

namespace carom {

const SoftCollision* SoftCollisions::note(const SoftExchange& touch, const SoftGroup& group,
                                          std::span<const std::size_t> members, double time) {
  const bool isPair = touch.other != SoftExchange::kNone;
  const std::size_t body = members[touch.body];
  const std::size_t other = isPair ? members[touch.other] : SoftExchange::kNone;
  const auto heat = [&](bool before) {
    const auto of = [&](std::size_t k) { return before ? group.surveyBefore(k).heat : group.survey(k).heat; };
    return of(touch.body) + (isPair ? of(touch.other) : 0.0);
  };
  const auto known = std::find_if(
      all_.begin() + static_cast<std::ptrdiff_t>(settled_), all_.end(), [&](const SoftCollision& one) {
        return !one.isOver && one.body == body && one.other == other && one.cushion == touch.cushion;
      });
  const bool isNew = known == all_.end();
  if (isNew) {
    all_.push_back({body, other, touch.cushion, {time - touch.since, touch.place.x, touch.place.y}});
    all_.back().heatBefore = heat(true);
  }
  SoftCollision& collision = isNew ? all_.back() : *known;
  collision.lastTouch = time;
  collision.lastPlace = touch.place;
  collision.impulse += touch.impulse;
  collision.heatAfter = heat(false);
  return isNew ? &collision : nullptr;
}

void SoftCollisions::end(double time, const std::function<double(std::size_t)>& soundTimeOf) {
  const auto soundTime = [&](std::size_t body) {
    return body == SoftExchange::kNone ? 0.0 : soundTimeOf(body);
  };
  bool allOver = true;
  for (std::size_t k = settled_; k < all_.size(); ++k) {
    SoftCollision& one = all_[k];
    if (!one.isOver && time - one.lastTouch > std::max(soundTime(one.body), soundTime(one.other))) {
      one.isOver = true;
      parted_.push_back(k);
    }
    allOver = allOver && one.isOver;
    if (allOver) settled_ = k + 1;
  }
}

void SoftCollisions::restore(const State& state) {
  settled_ = state.settled;
  state.all.restore(all_);
  state.parted.restore(parted_);
}

}  // namespace carom
