#pragma once
// The filter of heads as one of velocity alone: of a head that never turns.

#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "devices/filter/head_filter.h"
#include "devices/recorded_head.h"

namespace carom::test {

inline Pose poseAt(const glm::dvec3& position_m) { return {position_m, glm::dquat(1.0, 0.0, 0.0, 0.0)}; }

inline VelocityFilter celerityOf(HeadFilter filter) {
  return [filter = std::move(filter)](double time_s, const glm::dvec3& position_m) mutable {
    filter.add(time_s, poseAt(position_m));
    return filter.at(time_s).celerity_m_s;
  };
}

/// A FilterMaker.
inline VelocityFilter headFilter() { return celerityOf(HeadFilter()); }

}  // namespace carom::test
