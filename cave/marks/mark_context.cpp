#include "cave/marks/mark_context.h"

#include <algorithm>
#include <numbers>

namespace carom {

void addClothRing(MarkBuffer& batch, const Resting& draw, const Vec3& middle_m, double inner_m,
                  double outer_m, const glm::vec4& colour) {
  std::array<glm::dvec3, kAround + 1> inner, outer;
  for (std::size_t i = 0; i <= kAround; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * static_cast<double>(i) / kAround;
    const Vec3 direction(std::cos(angle_rad), std::sin(angle_rad), 0.0);
    inner[i] = draw(middle_m + inner_m * direction);
    outer[i] = draw(middle_m + outer_m * direction);
  }
  batch.addStrip(inner, outer, colour);
}

StandingPlate standingPlate(const MarkContext& sight, const PlateText& text, PlateShape shape,
                            const Vec3& foot_m) {
  constexpr double kReadable_m = 1.6, kMostTimes = 3.0;
  const double away_m = glm::distance(foot_m, sight.observer.middle.observation.r_m);
  return {text, shape, foot_m, std::clamp(away_m / kReadable_m, 1.0, kMostTimes)};
}

double LabelLayout::raise_m(const StandingPlate& plate) {
  constexpr double kLeast_m = 0.1, kGap_m = 0.006;
  const Vec3 way_m = plate.foot_m - eye_m_;
  const double away_m = std::max(std::hypot(way_m.x, way_m.y), kLeast_m);
  Box box{std::atan2(way_m.y, way_m.x), 0.5 * plate.width_m() / away_m, way_m.z / away_m,
          (way_m.z + plate.height_m()) / away_m};
  double raised = 0.0;
  const auto covers = [&](const Box& other) {
    const double apart_rad = std::remainder(box.azimuth_rad - other.azimuth_rad, 2.0 * std::numbers::pi);
    return std::abs(apart_rad) < box.half + other.half && box.lower + raised < other.upper &&
           other.lower < box.upper + raised;
  };
  for (std::size_t tries = 0; tries < count_; ++tries) {
    const auto other = std::find_if(boxes_.begin(), boxes_.begin() + count_, covers);
    if (other == boxes_.begin() + count_) break;
    raised = other->upper - box.lower + kGap_m / away_m;
  }
  if (count_ < boxes_.size()) {
    boxes_[count_++] = {box.azimuth_rad, box.half, box.lower + raised, box.upper + raised};
  }
  return raised * away_m;
}

}  // namespace carom
