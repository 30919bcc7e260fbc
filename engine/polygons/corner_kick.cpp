#include "engine/polygons/corner_kick.h"

#include <algorithm>
#include <cmath>

#include "engine/base/root.h"

namespace carom {

namespace {

/// One body in the frame of the impulse.
struct Pushed {
  SpinningBody body;
  double j = 0.0;
  double perAlpha = 0.0, perBeta = 0.0;  // j' − j of a unit of impulse
  double normal = 0.0, along = 0.0;      // momentum; the second body's with the sign turned

  double spin(double alpha, double beta) const { return j + alpha * perAlpha + beta * perBeta; }
  double energy(double alpha, double beta) const {
    const double m = restMass(body, spin(alpha, beta)), x = normal + alpha, y = along + beta;
    return std::sqrt(m * m + x * x + y * y);
  }
};

struct Impulse {
  double alpha = 0.0, beta = 0.0;
};

/// One or two bodies and their energy.
class Collision {
 public:
  void add(const Pushed& body) { bodies_[count_++] = body; }
  const Pushed& body(int i) const { return bodies_[i]; }

  double energy(const Impulse& at) const {
    double sum = 0.0;
    for (int i = 0; i < count_; ++i) sum += bodies_[i].energy(at.alpha, at.beta);
    return sum;
  }
  /// H(0) − H(at), as the fall along the impulse: where light is fast, the difference would be rounding.
  double lostBy(const Impulse& at) const { return -rise({0.0, 0.0}, at.alpha, at.beta, 1.0); }
  /// How fast the bodies close along k where they touch: the slope of H along α.
  double closing() const { return rise({0.0, 0.0}, 1.0, 0.0, 0.0); }

  Impulse impulse(const RimRules& rules) const {
    const double speed = closing(), size = sizeOfMomentum();
    // Towards −k: H(−a) − H(0) over a, which rises with a.
    const auto normal = [&](double a) { return rise({0.0, 0.0}, -1.0, 0.0, a); };
    const double elastic = rootBeyond(normal, size * std::min(1.0, speed));
    Impulse at{-0.5 * (1.0 + rules.restitution) * elastic, 0.0};
    if (rules.friction == 0.0) return at;
    const double slope = rise(at, 0.0, 1.0, 0.0);
    if (slope == 0.0) return at;
    const double down = slope > 0.0 ? -1.0 : 1.0;
    const double step = size * std::min(1.0, std::abs(slope));
    const auto stick = [&](double b) { return slopeAlong(at, down, b); };
    double beta = rootBeyond(stick, step);
    if (rules.tangentialRestitution > 0.0) {
      const auto back = [&](double b) { return rise(at, 0.0, down, b); };
      beta += rules.tangentialRestitution * (rootBeyond(back, 2.0 * beta) - beta);
    }
    at.beta = down * std::min(beta, rules.friction * std::abs(at.alpha));
    return at;
  }

 private:
  double sizeOfMomentum() const {
    double size = 0.0;
    for (int i = 0; i < count_; ++i) size = std::max(size, bodies_[i].energy(0.0, 0.0));
    return size;
  }
  /// (H(at + s way) − H(at))/s, written so that nothing cancels; the slope for s = 0.
  double rise(const Impulse& at, double wayAlpha, double wayBeta, double s) const {
    double sum = 0.0;
    for (int i = 0; i < count_; ++i) {
      const Pushed& b = bodies_[i];
      const double turn = wayAlpha * b.perAlpha + wayBeta * b.perBeta;
      const double j0 = b.spin(at.alpha, at.beta), j1 = j0 + s * turn;
      const double mass = turn * (j0 + j1) / (rimEnergy(b.body, j0) + rimEnergy(b.body, j1));
      const double masses = restMass(b.body, j0) + restMass(b.body, j1);
      const double x = b.normal + at.alpha, y = b.along + at.beta;
      const double square =
          mass * masses + wayAlpha * (2.0 * x + s * wayAlpha) + wayBeta * (2.0 * y + s * wayBeta);
      sum +=
          square / (b.energy(at.alpha, at.beta) + b.energy(at.alpha + s * wayAlpha, at.beta + s * wayBeta));
    }
    return sum;
  }
  double slopeAlong(const Impulse& at, double down, double s) const {
    return down * rise({at.alpha, at.beta + down * s}, 0.0, 1.0, 0.0);
  }
  /// The root above 0 of a function that rises and is below 0 at 0.
  template <typename Function>
  static double rootBeyond(const Function& f, double step) {
    double low = 0.0, high = step;
    for (int doubled = 0; !(f(high) > 0.0) && doubled < 1000; ++doubled) {
      low = high;
      high *= 2.0;
    }
    return rootOfIncreasing(f, 0.5 * (low + high), 0.5 * (high - low));
  }

  std::array<Pushed, 2> bodies_;
  int count_ = 0;
};

/// What a body is afterwards, with its share of the heat.
struct After {
  double spin, mass, heat;  // j', m', m' − M(j')
  double energy;            // in the frame of the impulse
};

After after(const Pushed& body, const Impulse& q, double heatPerEnergy) {
  const double j = body.spin(q.alpha, q.beta), m = restMass(body.body, j);
  const double energy = body.energy(q.alpha, q.beta), heat = energy * heatPerEnergy;
  const double square = heat * (2.0 * energy + heat);  // m'² − M²
  const double mass = std::sqrt(m * m + square);
  return {j, mass, square / (mass + m), energy + heat};
}

double leverOf(const LeveredBody& body, const Vec21& along) {
  return dot(cross(body.lever, along), body.puck.u) / body.radius;
}

// Elastic kicks without friction have none but rounding.
double heatPerEnergy(const Collision& collision, const Impulse& q, const RimRules& rules) {
  if (rules.restitution == 1.0 && q.beta == 0.0) return 0.0;
  return std::max(0.0, collision.lostBy(q)) / collision.energy(q);
}

}  // namespace

std::optional<SpinningPairKick> kickCorners(const Vec21& U, const Vec21& n,
                                            const std::array<LeveredBody, 2>& bodies, const RimRules& rules) {
  std::array<Vec21, 2> p;
  for (int i = 0; i < 2; ++i) p[i] = bodies[i].puck.u * restMass(bodies[i].puck.body, bodies[i].puck.j);
  const Vec21 P = p[0] + p[1];
  const Vec21 centre = P * (1.0 / std::sqrt(dot(P, P)));
  Vec21 k = n - U * (dot(n, P) / dot(U, P));
  k = k * (1.0 / std::sqrt(-dot(k, k)));
  const Vec21 t = cross(k, centre);
  Collision collision;
  for (int i = 0; i < 2; ++i) {
    const double sign = i == 0 ? 1.0 : -1.0;
    const LeveredBody& body = bodies[i];
    collision.add({body.puck.body, body.puck.j, sign * leverOf(body, k), sign * leverOf(body, t),
                   -sign * dot(p[i], k), -sign * dot(p[i], t)});
  }
  const double closing = collision.closing();
  if (!(closing > 0.0)) return std::nullopt;
  const Impulse q = collision.impulse(rules);
  const double heat = heatPerEnergy(collision, q, rules);
  const std::array<After, 2> afterwards{after(collision.body(0), q, heat), after(collision.body(1), q, heat)};
  // The masses change with the spins, so that energy goes from one to the other.
  const double given = afterwards[0].energy - collision.body(0).energy(0.0, 0.0);
  const Vec21 impulse = k * q.alpha + t * q.beta + centre * given;
  SpinningPairKick kick;
  kick.centres.closing = closing;
  for (int i = 0; i < 2; ++i) {
    const After& now = afterwards[i];
    const Vec21 momentum = i == 0 ? p[0] + impulse : p[1] - impulse;
    kick.centres.u[i] = fourVelocity(momentum.x / now.mass, momentum.y / now.mass);
    kick.centres.heat[i] = now.heat;
    kick.j[i] = now.spin;
  }
  return kick;
}

std::optional<SpinningCushionKick> kickCornerOffCushion(const CushionPlane& cushion, const LeveredBody& body,
                                                        const RimRules& rules) {
  const Vec21 n = cushion.axis == 0 ? Vec21{0.0, cushion.sign, 0.0} : Vec21{0.0, 0.0, cushion.sign};
  const Vec21 t = cross(n, {1.0, 0.0, 0.0});
  const Vec21 p = body.puck.u * restMass(body.puck.body, body.puck.j);
  Collision collision;
  collision.add({body.puck.body, body.puck.j, leverOf(body, n), leverOf(body, t), -dot(p, n), -dot(p, t)});
  const double closing = collision.closing();
  if (!(closing > 0.0)) return std::nullopt;
  const Impulse q = collision.impulse(rules);
  const After now = after(collision.body(0), q, heatPerEnergy(collision, q, rules));
  const Vec21 momentum = p + n * q.alpha + t * q.beta;
  return SpinningCushionKick{{fourVelocity(momentum.x / now.mass, momentum.y / now.mass), now.heat, closing},
                             now.spin};
}

}  // namespace carom
