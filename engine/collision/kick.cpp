#include "engine/collision/kick.h"

#include <cmath>

namespace carom {

std::optional<PairKick> kickPair(const Vec21& U, const Vec21& n, const std::array<Vec21, 2>& u,
                                 const std::array<double, 2>& mass, double restitution) {
  const Vec21 p1 = u[0] * mass[0], p2 = u[1] * mass[1];
  const Vec21 P = p1 + p2;
  const Vec21 k = n - U * (dot(n, P) / dot(U, P));
  const double p1k = dot(p1, k), kk = dot(k, k);  // k points from 1 to 2, so p1·k < 0 is approach; kk < 0
  if (!(p1k < 0.0)) return std::nullopt;
  const Vec21 impulse = k * (-(1.0 + restitution) * p1k / kk);
  const double gained = (1.0 - restitution * restitution) * p1k * p1k / -kk;  // m'² − m²

  PairKick kick;
  kick.closing = -p1k / std::sqrt(-kk) * (1.0 / mass[0] + 1.0 / mass[1]);
  for (int i = 0; i < 2; ++i) {
    const double m = mass[i];
    const double after = std::sqrt(m * m + gained);
    const Vec21 p = i == 0 ? p1 + impulse : p2 - impulse;
    kick.u[i] = fourVelocity(p.x / after, p.y / after);
    kick.heat[i] = gained / (after + m);
  }
  return kick;
}

std::optional<CushionKick> kickOffCushion(const CushionPlane& cushion, const Vec21& u, double mass,
                                          double restitution) {
  const double un = cushion.towards(u);
  if (!(un > 0.0)) return std::nullopt;
  const double gained = (1.0 - restitution * restitution) * un * un;  // (m'/m)² − 1
  const double massRatio = std::sqrt(1.0 + gained);
  const double normal = -restitution / massRatio, along = 1.0 / massRatio;
  CushionKick kick;
  kick.u =
      cushion.axis == 0 ? fourVelocity(u.x * normal, u.y * along) : fourVelocity(u.x * along, u.y * normal);
  kick.heat = mass * gained / (massRatio + 1.0);
  return kick;
}

}  // namespace carom
