#include "engine/collision/rim_friction.h"

#include <algorithm>
#include <cmath>

#include "engine/base/portable_math.h"

namespace carom {
namespace {

double square(double x) { return x * x; }

/// A value and its slope.
struct Sloped {
  double value, slope;
};

/// Returns the root between `low` and `high` of a function that rises, by Newton's steps; a step that would
/// leave the known bounds of the root goes half of the way instead. Such steps square the
/// error: after one of less than `fine` none is left.
template <typename Function>
double rootBetween(const Function& f, double low, double high, double guess, double fine) {
  constexpr int kSteps = 100;  // by halving alone, 60 would do
  double x = guess > low && guess < high ? guess : 0.5 * (low + high);
  for (int i = 0; i < kSteps; ++i) {
    const Sloped at = f(x);
    if (at.value == 0.0) return x;
    if (at.value > 0.0) {
      high = x;
    } else {
      low = x;
    }
    double next = x - at.value / at.slope;
    const bool steep = !(std::abs(at.value) < 1.0);  // towards the ends it grows without bound
    if (!steep && std::abs(next - x) <= fine) return next;
    if (steep || !(next > low && next < high)) next = 0.5 * (low + high);
    if (!(next > low && next < high)) return x;
    x = next;
  }
  return x;
}

/// A puck pressed on the wall, in a frame in which the wall rests along the normal. Its momentum along the
/// tangent as E + p_t and E − p_t, whose product is m² + p_n²: nothing cancels when either is small.
struct Momentum {
  double plus = 0.0, minus = 0.0;
  double across = 0.0;  // p_n

  Momentum(double mass, double energy, double across_, double along) : across(across_) {
    const double product = mass * mass + across_ * across_;
    plus = along < 0.0 ? product / (energy - along) : energy + along;
    minus = along > 0.0 ? product / (energy + along) : energy - along;
  }
  /// The same in a frame that moves along the tangent with the celerity u = γ_w w: E ± p_t by k∓¹, with the
  /// Doppler factor k = γ_w (1 + w). Mirrored, it gives the mirrored bits.
  Momentum from(double u) const {
    const double k = std::abs(u) + std::sqrt(1.0 + u * u);
    Momentum moved = *this;
    moved.plus = u < 0.0 ? plus * k : plus / k;
    moved.minus = u < 0.0 ? minus / k : minus * k;
    return moved;
  }
  double energy() const { return 0.5 * (plus + minus); }
  double along() const { return 0.5 * (plus - minus); }
};

/// One puck pressed on the wall, in the wall's frame. Its angle δ = χ' − χ says how far the wall has turned
/// it.
class Pressed {
 public:
  Pressed(const SpinningBody& body, double j, const Momentum& p, double restitution)
      : body_(body),
        j_(j),
        energy_(p.energy()),
        along_(p.along()),
        sin_(along_ / energy_),
        cos_(std::sqrt(p.plus * p.minus) / energy_),
        mass_(restMass(body, j)),
        lost_((1.0 - restitution * restitution) * p.across * p.across),
        rest_(square(mass_) + lost_),
        angle_(portableAsin(sin_)),
        widest_(portableAsin(std::min(1.0, std::sqrt(rest_ + along_ * along_) / energy_))),
        fine_(0x1p-30 * (std::abs(angle_) + std::abs(j) / energy_)) {}

  /// The angle δ by which that impulse turns it: sin δ = sin χ' cos χ − cos χ' sin χ. It is below a right
  /// angle: as E |δ| = |j' − j| ≤ M(j') + M(j) ≤ E (cos χ' + cos χ) ≤ 2 E cos(δ/2), |δ| < 1.48.
  double turnedBy(double impulse) const {
    const double risen = impulse / energy_, to = sin_ + risen;
    const double toCos = std::sqrt(std::max(cos_ * cos_ - risen * (2.0 * sin_ + risen), 0.0));
    return portableAsin(std::min(std::max(to * cos_ - toCos * sin_, -1.0), 1.0));
  }
  /// m' after that impulse: m'² = m² + (1−e²) p_n² − (p_t'² − p_t²), with m its mass before.
  double massAfter(double impulse) const {
    return std::sqrt(std::max(rest_ - impulse * (2.0 * along_ + impulse), 0.0));
  }
  double spinAfter(double delta) const { return j_ + energy_ * delta; }
  /// The heat m' − M(j'): that of the normal impulse, sqrt(M² + (1−e²) p_n²) − M, and what sliding adds to
  /// it. As a difference of masses it would be rounding where light is fast; below 0 by rounding alone.
  double heatAfter(double delta) const {
    return std::max(lost_ / (std::sqrt(rest_) + mass_) - energy_ * delta * gainAt(delta).value, 0.0);
  }

  /// Angles δ at which the rim rests and at which no energy is lost.
  struct Angles {
    double noSlip = 0.0, elastic = 0.0;
  };
  /// The tangential impulse of the law of restitution, without Coulomb's limit. `near` is where the search
  /// for its angles starts, and then those angles.
  double wanted(double tangentialRestitution, Angles& near) const {
    near.noSlip = root([this](double delta) { return slipAt(delta, at(delta)); }, near.noSlip);
    if (tangentialRestitution == 0.0) return impulse(near.noSlip);
    near.elastic = root([this](double delta) { return gainAt(delta); },
                        near.elastic == 0.0 ? 2.0 * near.noSlip : near.elastic);
    return impulse(near.noSlip + tangentialRestitution * (near.elastic - near.noSlip));
  }

 private:
  struct Turned {
    double sin, cos, impulse;  // of χ'
    double chord;              // (sin χ' − sin χ)/δ
  };

  /// The tangential impulse that turns the puck by δ: E (sin χ' − sin χ).
  double impulse(double delta) const { return at(delta).impulse; }

  template <typename Function>
  double root(const Function& f, double guess) const {
    return rootBetween(f, -widest_ - angle_, widest_ - angle_, guess, fine_);
  }

  // sin χ' − sin χ = 2 sin(δ/2) cos(χ + δ/2).
  Turned at(double delta) const {
    const auto [s, c] = portableSinCos(0.5 * delta);
    const double middle = cos_ * c - sin_ * s;
    const double risen = 2.0 * s * middle;
    return {sin_ + risen, cos_ * ((c - s) * (c + s)) - 2.0 * sin_ * s * c, energy_ * risen,
            delta == 0.0 ? middle : risen / delta};
  }

  /// −h'/E = E sin χ' cos χ'/m' + f(j'), which rises.
  Sloped slipAt(double delta, const Turned& to) const {
    const double m = std::max(massAfter(to.impulse), 1e-150);
    const double push = energy_ * to.sin * to.cos / m;
    const double beads = rimEnergy(body_, spinAfter(delta));
    return {push + spinAfter(delta) / beads, energy_ * (to.cos * to.cos - to.sin * to.sin) / m +
                                                 push * energy_ * to.sin * to.cos * energy_ / (m * m) +
                                                 energy_ * square(body_.rim / beads) / beads};
  }

  /// −(h(χ') − h(χ))/(E δ): the mean of slipAt on the way, which rises too; 0 at the elastic angle. Both
  /// differences are written so that nothing cancels.
  Sloped gainAt(double delta) const {
    const Turned to = at(delta);
    const double m = massAfter(to.impulse), before = std::sqrt(rest_);
    const double j = spinAfter(delta);
    const double mean = energy_ * (to.sin + sin_) * to.chord / (m + before) +
                        (j + j_) / (rimEnergy(body_, j) + rimEnergy(body_, j_));
    const Sloped end = slipAt(delta, to);
    return {mean, delta == 0.0 ? 0.5 * end.slope : (end.value - mean) / delta};
  }

  SpinningBody body_;
  double j_;
  double energy_;
  double along_;      // p_t
  double sin_, cos_;  // of χ
  double mass_;       // M(j)
  double lost_;       // (1−e²) p_n²
  double rest_;       // M² + (1−e²) p_n²
  double angle_;      // χ
  double widest_;     // |χ'| at which m' is 0
  double fine_;       // a Newton step below this leaves no error
};

/// A puck in the centre-of-mass frame; the wall's normal and tangent are those of this puck.
struct InCentreOfMass {
  SpinningBody body;
  double j;
  Momentum p;

  /// The puck in the frame of a wall that moves along the tangent with the celerity u.
  Pressed pressed(double u, const RimRules& rules) const { return {body, j, p.from(u), rules.restitution}; }
  /// The celerity along the tangent of the point of the rim that touches, after the kick along the normal.
  /// The third axis of the puck's frame is γ_t (v_t, 0, 1) in components along time, n and t.
  double rimCelerity(double restitution) const {
    const double E = p.energy(), slowed = p.across * p.across * (1.0 - restitution * restitution);
    const double rest = std::sqrt(square(restMass(body, j)) + slowed);
    const double perGamma = std::sqrt(p.plus * p.minus) / E;
    const double lever = rest * rimBeta(body, j) / perGamma;
    return (p.along() + lever) / (perGamma * std::sqrt((E - lever) * (E + lever)));
  }
};

/// The celerity u = γ_w w of the wall at which both pucks want the same impulse, between those of the two
/// rims: each puck wants none where the wall moves with its rim. False position, by Illinois' rule; every
/// eighth step halves. Of pucks nearly as fast as light and rims as well there may be three such u, each
/// with a kick that obeys every law. Mirror images and exchanged pucks mirror the steps of the search, so
/// that it ends on the same one.
double celerityOfWall(const std::array<InCentreOfMass, 2>& pucks, const RimRules& rules) {
  std::array<Pressed::Angles, 2> near;
  double impulses = 0.0;  // how large they are
  const auto difference = [&](double u) {
    const double first = pucks[0].pressed(u, rules).wanted(rules.tangentialRestitution, near[0]);
    const double second = pucks[1].pressed(-u, rules).wanted(rules.tangentialRestitution, near[1]);
    impulses = std::abs(first) + std::abs(second);
    return first - second;
  };
  const double ends[]{pucks[0].rimCelerity(rules.restitution), -pucks[1].rimCelerity(rules.restitution)};
  double low = std::min(ends[0], ends[1]), high = std::max(ends[0], ends[1]);
  double below = difference(low);
  near = {};  // leaves no trace of which end was first
  double above = difference(high);
  near = {};
  const bool atLow = !(below < 0.0), atHigh = !(above > 0.0);
  if (atLow || atHigh) return atLow && atHigh ? 0.5 * (low + high) : atLow ? low : high;
  constexpr int kSteps = 100;
  double u = low;
  bool raised = false, lowered = false;  // by the last step
  for (int i = 1; i < kSteps; ++i) {
    u = (low * above - high * below) / (above - below);
    if (i % 8 == 0 || !(u > low && u < high)) u = 0.5 * (low + high);
    if (!(u > low && u < high)) break;
    const double value = difference(u);
    if (std::abs(value) <= 0x1p-50 * impulses) break;
    if (value > 0.0) {
      high = u;
      above = value;
      if (lowered) below *= 0.5;
    } else {
      low = u;
      below = value;
      if (raised && value < 0.0) above *= 0.5;
    }
    lowered = value > 0.0;
    raised = !lowered;
  }
  return u;
}

/// Coulomb's limit.
double limited(double impulse, double limit) { return std::min(std::max(impulse, -limit), limit); }

/// What a puck is after the impulse that the wall gives it.
struct AfterWall {
  double mass, j, heat;
};

AfterWall afterWall(const Pressed& puck, double impulse) {
  const double delta = puck.turnedBy(impulse);
  return {puck.massAfter(impulse), puck.spinAfter(delta), puck.heatAfter(delta)};
}

}  // namespace

std::optional<SpinningPairKick> kickSpinningPair(const Vec21& U, const Vec21& n,
                                                 const std::array<SpinningPuck, 2>& pucks,
                                                 const RimRules& rules) {
  const std::array<double, 2> mass{restMass(pucks[0].body, pucks[0].j), restMass(pucks[1].body, pucks[1].j)};
  const std::optional<PairKick> smooth = kickPair(U, n, {pucks[0].u, pucks[1].u}, mass, rules.restitution);
  if (!smooth) return std::nullopt;
  SpinningPairKick kick{*smooth, {pucks[0].j, pucks[1].j}};
  if (rules.friction == 0.0) return kick;

  const std::array<Vec21, 2> p{pucks[0].u * mass[0], pucks[1].u * mass[1]};
  const Vec21 P = p[0] + p[1];
  const Vec21 centre = P * (1.0 / std::sqrt(dot(P, P)));
  Vec21 k = n - U * (dot(n, P) / dot(U, P));
  k = k * (1.0 / std::sqrt(-dot(k, k)));
  const Vec21 t = cross(k, centre);
  const double across = -dot(p[0], k);
  // The axes of the second are −k and −t.
  const std::array<InCentreOfMass, 2> inCentre{
      InCentreOfMass{pucks[0].body, pucks[0].j, Momentum(mass[0], dot(p[0], centre), across, -dot(p[0], t))},
      InCentreOfMass{pucks[1].body, pucks[1].j, Momentum(mass[1], dot(p[1], centre), across, dot(p[1], t))}};
  const double uWall = celerityOfWall(inCentre, rules);
  const std::array<Pressed, 2> pressed{inCentre[0].pressed(uWall, rules), inCentre[1].pressed(-uWall, rules)};
  const double normal = (1.0 + rules.restitution) * across;
  Pressed::Angles near;
  const double impulse =
      limited(pressed[0].wanted(rules.tangentialRestitution, near), rules.friction * normal);
  const Vec21 tangent = t * std::sqrt(1.0 + uWall * uWall) + centre * uWall;  // γ_w (t + w U)
  const Vec21 q = k * -normal + tangent * impulse;
  for (int i = 0; i < 2; ++i) {
    const AfterWall after = afterWall(pressed[i], impulse);
    const Vec21 momentum = i == 0 ? p[0] + q : p[1] - q;
    kick.centres.u[i] = fourVelocity(momentum.x / after.mass, momentum.y / after.mass);
    kick.centres.heat[i] = after.heat;
    kick.j[i] = after.j;
  }
  return kick;
}

std::optional<SpinningCushionKick> kickSpinningOffCushion(const CushionPlane& cushion,
                                                          const SpinningPuck& puck, const RimRules& rules) {
  const double mass = restMass(puck.body, puck.j);
  const std::optional<CushionKick> smooth = kickOffCushion(cushion, puck.u, mass, rules.restitution);
  if (!smooth) return std::nullopt;
  if (rules.friction == 0.0) return SpinningCushionKick{*smooth, puck.j};

  // n = (±1, 0) or (0, ±1), t = n turned anticlockwise.
  const double across = mass * cushion.towards(puck.u);
  const double along = mass * cushion.sign * (cushion.axis == 0 ? puck.u.y : -puck.u.x);
  const Pressed pressed(puck.body, puck.j, Momentum(mass, mass * puck.u.t, across, along), rules.restitution);
  const double normal = (1.0 + rules.restitution) * across;
  Pressed::Angles near;
  const double impulse = limited(pressed.wanted(rules.tangentialRestitution, near), rules.friction * normal);
  const AfterWall after = afterWall(pressed, impulse);
  const double towards = cushion.sign * -rules.restitution * across / after.mass;
  const double aside = cushion.sign * (along + impulse) / after.mass;
  const Vec21 u = cushion.axis == 0 ? fourVelocity(towards, aside) : fourVelocity(-aside, towards);
  return SpinningCushionKick{{u, after.heat}, after.j};
}

}  // namespace carom
