#pragma once
// A slow way to the contact of two pucks, by other means than the engine's closed form: both pucks are
// boosted into the frame of equal and opposite speeds, drawn there as two ellipses, each contracted along its
// own motion, and moved until their contact function reaches 1. The kick is found by solving for it: along
// the rims' common normal, conserving four-momentum and both rest masses. In long double.

#include <array>
#include <cmath>
#include <optional>

namespace carom::reference {

using Real = long double;

struct Point {
  Real t = 0, x = 0, y = 0;  // c = 1
};

struct ReferencePuck {
  Point start;
  Real vx = 0, vy = 0, radius = 0, mass = 0;
};

struct ReferenceContact {
  Point contact;
  std::array<Point, 2> turnAtSignal, turnAtContact;
  std::array<std::array<Real, 2>, 2> after;  // velocities
};

/// The event in a frame moving with (vx, vy), by the textbook's boost.
inline Point boosted(const Point& p, Real vx, Real vy) {
  const Real v2 = vx * vx + vy * vy;
  if (v2 == 0) return p;
  const Real gamma = 1 / std::sqrt(1 - v2), along = (p.x * vx + p.y * vy) / v2;
  const Real shift = (gamma - 1) * along - gamma * p.t;
  return {gamma * (p.t - p.x * vx - p.y * vy), p.x + shift * vx, p.y + shift * vy};
}

struct Flight {
  Point at;  // in the equal-speed frame
  Real vx, vy, radius;
  std::array<Real, 3> shape() const {  // xx, xy, yy of R² (1 − v vᵀ)
    return {radius * radius * (1 - vx * vx), -radius * radius * vx * vy, radius * radius * (1 - vy * vy)};
  }
};

inline Flight inFrame(const ReferencePuck& puck, Real fx, Real fy) {
  const Point a = boosted(puck.start, fx, fy);
  const Point b = boosted({puck.start.t + 1, puck.start.x + puck.vx, puck.start.y + puck.vy}, fx, fy);
  return {a, (b.x - a.x) / (b.t - a.t), (b.y - a.y) / (b.t - a.t), puck.radius};
}

/// Perram and Wertheim's contact function at time t of the frame: below 1 the ellipses overlap. With it the
/// point at which it is reached, and the rims' normal there.
struct ContactFunction {
  Real value, px, py, nx, ny;
};
inline ContactFunction contactFunction(const Flight& a, const Flight& b, Real t) {
  const Real ax = a.at.x + a.vx * (t - a.at.t), ay = a.at.y + a.vy * (t - a.at.t);
  const Real rx = b.at.x + b.vx * (t - b.at.t) - ax, ry = b.at.y + b.vy * (t - b.at.t) - ay;
  const auto A = a.shape(), B = b.shape();
  const auto at = [&](Real l) {
    const Real xx = (1 - l) * A[0] + l * B[0], xy = (1 - l) * A[1] + l * B[1], yy = (1 - l) * A[2] + l * B[2];
    const Real det = xx * yy - xy * xy;
    const Real nx = (yy * rx - xy * ry) / det, ny = (xx * ry - xy * rx) / det;
    return ContactFunction{l * (1 - l) * (rx * nx + ry * ny), ax + (1 - l) * (A[0] * nx + A[1] * ny),
                           ay + (1 - l) * (A[1] * nx + A[2] * ny), nx, ny};
  };
  // At its maximum the point is as deep in one ellipse as in the other: (1−λ)² nᵀAn = λ² nᵀBn.
  Real low = 0, high = 1;
  for (int i = 0; i < 80; ++i) {
    const Real l = (low + high) / 2;
    const ContactFunction f = at(l);
    const Real inA = (1 - l) * (1 - l) * (A[0] * f.nx * f.nx + 2 * A[1] * f.nx * f.ny + A[2] * f.ny * f.ny);
    const Real inB = l * l * (B[0] * f.nx * f.nx + 2 * B[1] * f.nx * f.ny + B[2] * f.ny * f.ny);
    (inA > inB ? low : high) = l;
  }
  return at((low + high) / 2);
}

/// When the light of an event meets a straight flight, by halving.
inline Point arrival(const Point& signal, const ReferencePuck& puck) {
  const auto place = [&](Real t) {
    return Point{t, puck.start.x + puck.vx * (t - puck.start.t), puck.start.y + puck.vy * (t - puck.start.t)};
  };
  const auto late = [&](Real t) {
    const Point p = place(t);
    return t - signal.t - std::hypot(p.x - signal.x, p.y - signal.y);
  };
  Real low = signal.t, high = signal.t + 1;
  while (late(high) < 0) high += high - signal.t;
  for (int i = 0; i < 200; ++i) (late((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
  return place(high);
}

// q = λ (ε, nx, ny) with p1 + q and p2 − q on their mass shells, in the equal-speed frame:
//   2 (p1·q) + q² = 0  and  −2 (p2·q) + q² = 0.   Divided by λ, their difference gives ε, then either gives
//   λ.
inline std::array<Real, 3> solveKick(const std::array<Real, 3>& p1, const std::array<Real, 3>& p2, Real nx,
                                     Real ny) {
  const Real n1 = p1[1] * nx + p1[2] * ny, n2 = p2[1] * nx + p2[2] * ny, nn = nx * nx + ny * ny;
  const Real epsilon = (n1 + n2) / (p1[0] + p2[0]);
  const Real lambda = 2 * (n1 - epsilon * p1[0]) / (epsilon * epsilon - nn);
  return {lambda * epsilon, lambda * nx, lambda * ny};
}

/// The first contact of two straight flights, if their tubes meet, whenever that is.
inline std::optional<ReferenceContact> slowContact(const ReferencePuck& one, const ReferencePuck& two) {
  const auto gammaOf = [](const ReferencePuck& p) { return 1 / std::sqrt(1 - p.vx * p.vx - p.vy * p.vy); };
  const Real g1 = gammaOf(one), g2 = gammaOf(two);
  const Real fx = (g1 * one.vx + g2 * two.vx) / (g1 + g2), fy = (g1 * one.vy + g2 * two.vy) / (g1 + g2);
  const Flight a = inFrame(one, fx, fy), b = inFrame(two, fx, fy);
  // Closest approach of the centres, from which the contact lies at most reach/relative speed before.
  const Real wx = b.vx - a.vx, wy = b.vy - a.vy, w2 = wx * wx + wy * wy;
  const Real dx = b.at.x - b.vx * b.at.t - a.at.x + a.vx * a.at.t,
             dy = b.at.y - b.vy * b.at.t - a.at.y + a.vy * a.at.t;
  const Real closest = -(dx * wx + dy * wy) / w2;
  if (contactFunction(a, b, closest).value >= 1) return std::nullopt;
  Real before = closest - 2 * (one.radius + two.radius) / std::sqrt(w2), after = closest;
  for (int i = 0; i < 90; ++i) {
    const Real middle = (before + after) / 2;
    (contactFunction(a, b, middle).value > 1 ? before : after) = middle;
  }
  const ContactFunction touch = contactFunction(a, b, after);

  ReferenceContact result;
  result.contact = boosted({after, touch.px, touch.py}, -fx, -fy);
  const std::array<const ReferencePuck*, 2> pucks{&one, &two};
  for (int k = 0; k < 2; ++k) {
    const Flight& flight = k == 0 ? a : b;
    const Real dt = after - flight.at.t;
    result.turnAtContact[k] =
        boosted({after, flight.at.x + flight.vx * dt, flight.at.y + flight.vy * dt}, -fx, -fy);
    result.turnAtSignal[k] = arrival(result.contact, *pucks[k]);
  }
  const auto momentum = [](const Flight& f, Real mass) {
    const Real g = mass / std::sqrt(1 - f.vx * f.vx - f.vy * f.vy);
    return std::array<Real, 3>{g, g * f.vx, g * f.vy};
  };
  const auto p1 = momentum(a, one.mass), p2 = momentum(b, two.mass);
  const auto q = solveKick(p1, p2, touch.nx, touch.ny);
  for (int k = 0; k < 2; ++k) {
    const auto& p = k == 0 ? p1 : p2;
    const Real sign = k == 0 ? 1 : -1;
    const Point out = boosted({p[0] + sign * q[0], p[1] + sign * q[1], p[2] + sign * q[2]}, -fx, -fy);
    result.after[k] = {out.x / out.t, out.y / out.t};
  }
  return result;
}

}  // namespace carom::reference
