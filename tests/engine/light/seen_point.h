#pragma once
// A point of a body that bounces, and a moving head that sees it: a random case of what the views show.

#include <glm/gtc/quaternion.hpp>

#include "engine/light_speed.h"
#include "engine/random_world.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/world_line.h"

namespace carom::test {

inline constexpr double kTolerance_m = 1e-8;  // rounding in double, through γ up to 7 twice

struct SeenPoint {
  WorldLine line;
  Vec3 offset_m;
  Event eye;
  Lorentz headFromBoard;
};

/// Returns a line with bounces up to 0.9 c, `spacing_s` apart on average, and a head up to 0.95 c whose axes
/// are turned. The eye's event is amid the bounces, or up to `after_s` after the last.
inline SeenPoint randomSeenPoint(Random& random, int bounces, double spacing_s, double friction_m_s2,
                                 double after_s) {
  const double radius_m = random.in(0.02, 0.2);
  const WorldLine line = randomWorldLine(random, kC_m_s, radius_m, bounces, spacing_s, 0.9, friction_m_s2);
  const Event eye{random.in(-1.0, line.knots().back().turn.t_s + after_s), random.inBox(2.0)};
  const glm::dquat turn = glm::angleAxis(random.in(0.0, 3.0), random.direction());
  const Vec3 offset_m = random.inBall(radius_m);
  return {line, offset_m, eye, Lorentz::boost(random.u(0.95), kC_m_s) * Lorentz::rotation(turn, kC_m_s)};
}

}  // namespace carom::test
