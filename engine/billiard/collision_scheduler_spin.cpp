// How pucks turn: what the cloth leaves of a spin, and strokes beside the centre.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/billiard/collision_scheduler.h"

namespace carom {

Turning CollisionScheduler::spunTurning(int i, double properTime) const {
  return turningAfter(lastTurning(i), spins_[i].body, discs_[i].radius, slowing_,
                      properTime - lastLeg(i).properTime);
}

// With the offset d, b to the right of the momentum Δp in the puck's rest frame, and c = 1:
//     J' = J + det(u, d, (ΔE, Δp)),   E' = sqrt(M(J')² + (p + Δp)²),   ΔE = E' − E
// A puck at rest gets J' = J + b |Δp|. The determinant grows with ΔE by b u∥, u∥ the celerity along Δp, and
// E' with J' by less than 1/R, so while b u∥ < R there is one J'.
CollisionScheduler::Struck CollisionScheduler::struckBy(int i, const PuckStroke& stroke, const Vec21& u,
                                                        double j) const {
  const double mass = massOf(i, j);
  const double size = std::sqrt(stroke.px * stroke.px + stroke.py * stroke.py);
  if (stroke.offset == 0.0 || size == 0.0)
    return {fourVelocity(u.x + stroke.px / mass, u.y + stroke.py / mass), j};
  constexpr double kGrips = 0.99;
  const double radius = discs_[i].radius, alongX = stroke.px / size, alongY = stroke.py / size;
  const double along = std::abs(u.x * alongX + u.y * alongY);
  const double most = along > 0.0 ? std::min(radius, kGrips * radius / along) : radius;
  const double offset = std::clamp(stroke.offset, -most, most);

  const double dx = offset * alongY, dy = -offset * alongX, ud = u.x * dx + u.y * dy;
  const Vec21 d{ud, dx + u.x * ud / (u.t + 1.0), dy + u.y * ud / (u.t + 1.0)};
  const double px = u.x * mass + stroke.px, py = u.y * mass + stroke.py, p2 = px * px + py * py;
  const double energy = u.t * mass;
  const double perEnergy = dot(cross(d, {1.0, 0.0, 0.0}), u);
  const double jSmooth = j + dot(cross(d, {0.0, stroke.px, stroke.py}), u) / radius;
  // j' − jSmooth − (E'(j') − E) perEnergy/R = 0, which rises.
  double low = jSmooth, high = jSmooth;
  const auto excess = [&](double to) {
    const double m = restMass(spins_[i].body, to);
    return to - jSmooth - (std::sqrt(m * m + p2) - energy) * (perEnergy / radius);
  };
  for (double step = mass; excess(low) > 0.0; step *= 2.0) low -= step;
  for (double step = mass; excess(high) < 0.0; step *= 2.0) high += step;
  for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high)) {
    const double over = excess(middle);
    if (!(over < 0.0)) high = middle;
    if (!(over > 0.0)) low = middle;
  }
  const double jAfter = 0.5 * (low + high), after = massOf(i, jAfter);
  return {fourVelocity(px / after, py / after), jAfter};
}

}  // namespace carom
