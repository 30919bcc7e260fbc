#include "app/report/soft_sides.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr double kApart_m = 0.01;  // of light, from place to place

bool hasSoft(const BilliardSetup& setup) {
  return std::any_of(setup.pucks.begin(), setup.pucks.end(),
                     [](const Puck& puck) { return puck.soft.has_value(); });
}

/// Returns how far the relaxed matter of a puck reaches along an axis.
double reach_m(const Puck& puck, char along) {
  if (puck.outline_m.empty()) return puck.radius_m;
  const Vec2 corner_m = glm::abs(puck.outline_m.front());
  return along == 'x' ? corner_m.x : corner_m.y;
}

}  // namespace

std::vector<SoftSides> softSides(const BilliardSetup& setup, char along, double until_s) {
  if (!hasSoft(setup)) return {};
  std::vector<SoftPoint> points;
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    const double far_m = reach_m(setup.pucks[i], along);
    for (const double side : {-1.0, 1.0})
      points.push_back({i, side * far_m * (along == 'x' ? Vec2(1.0, 0.0) : Vec2(0.0, 1.0))});
  }
  Billiard billiard(setup);
  std::vector<SoftSides> sides(setup.pucks.size());
  const double step_s = kApart_m / setup.lightSpeed_m_s;
  for (double t_s = 0.0; t_s <= until_s; t_s += step_s) {
    billiard.advanceTo(t_s);
    const SoftMoment moment = billiard.softAt(t_s, points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (!moment.points[k]) continue;
      const double z_m = 0.5 * setup.pucks[points[k].puck].height_m;
      sides[points[k].puck].lines[k % 2].push_back({t_s, Vec3(moment.points[k]->position_m, z_m)});
    }
  }
  for (std::size_t i = 0; i < sides.size(); ++i) sides[i].puck = i;
  std::erase_if(sides, [](const SoftSides& one) { return one.lines[0].empty(); });
  return sides;
}

}  // namespace carom
