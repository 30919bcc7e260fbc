#include "engine/game/stroke_kick.h"

#include <algorithm>
#include <cmath>

namespace carom {

StruckPuck struckPuck(const SpinningBody& body, double radius, const PuckStroke& stroke, const Vec21& u,
                      double j) {
  const double mass = restMass(body, j);
  const double size = std::sqrt(stroke.px * stroke.px + stroke.py * stroke.py);
  if (stroke.offset == 0.0 || size == 0.0)
    return {fourVelocity(u.x + stroke.px / mass, u.y + stroke.py / mass), j};
  constexpr double kGrips = 0.99;
  const double alongX = stroke.px / size, alongY = stroke.py / size;
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
    const double m = restMass(body, to);
    return to - jSmooth - (std::sqrt(m * m + p2) - energy) * (perEnergy / radius);
  };
  for (double step = mass; excess(low) > 0.0; step *= 2.0) low -= step;
  for (double step = mass; excess(high) < 0.0; step *= 2.0) high += step;
  // Both ends close in alike, so that mirror images stay mirror images to the bit.
  for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high)) {
    const double over = excess(middle);
    if (!(over < 0.0)) high = middle;
    if (!(over > 0.0)) low = middle;
  }
  const double jAfter = 0.5 * (low + high), after = restMass(body, jAfter);
  return {fourVelocity(px / after, py / after), jAfter};
}

}  // namespace carom
