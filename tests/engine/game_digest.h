#pragma once
// Games made of exact arithmetic alone, and a digest of all that they deliver: for the promise that the
// billiard gives the same bits on every machine.

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "engine/billiard/billiard.h"

namespace carom::test {

/// FNV-1a (Fowler, Noll, Vo) over the bits of numbers.
class Digest {
 public:
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) value_ = (value_ ^ (bits >> (8 * byte) & 0xff)) * 0x100000001b3;
  }
  void add(const Event& e) { add(e.t_s), add(e.r_m.x), add(e.r_m.y), add(e.r_m.z); }
  void add(const Vec2& v) { add(v.x), add(v.y); }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

inline std::uint64_t digestOf(const Billiard& billiard) {
  Digest digest;
  for (const WorldLine& line : billiard.worldLines()) {
    for (const Knot& knot : line.knots()) {
      digest.add(knot.turn), digest.add(knot.signal);
      digest.add(knot.u.x), digest.add(knot.u.y), digest.add(knot.properTime_s);
    }
  }
  for (const GameEvent& collision : billiard.events()) {
    if (collision.kind == EventKind::stroke || collision.kind == EventKind::flash) continue;
    digest.add(collision.cushion ? static_cast<std::uint64_t>(*collision.cushion) : 4);
    digest.add(collision.at), digest.add(collision.heat_j);
    for (const Turn& turn : collision.turns) {
      digest.add(turn.event), digest.add(turn.betaBefore), digest.add(turn.betaAfter);
    }
  }
  const Ledger ledger = billiard.ledger();
  for (const Ledger::Account* account : {&ledger.motion, &ledger.radiated, &ledger.takenByCushions,
                                         &ledger.lostToFriction, &ledger.givenByStrokes}) {
    digest.add(account->energy_j), digest.add(account->momentum_kg_m_s);
  }
  return digest.value();
}

/// `count` pucks on a square grid, of different sizes and masses if `mixed`, all at speed `beta` in random
/// directions, on a board of which the uncontracted discs of radius 1 cm cover `coverage`. c = 1 m/s. No
/// function of the C library is used but the square root.
inline BilliardSetup exactGas(int count, double coverage, double beta, bool mixed, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-53; };
  const double radius_m = 0.01;
  const double side_m = std::sqrt(count * 3.14159265358979 * radius_m * radius_m / coverage);
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.0;
  setup.board = Board{side_m, side_m};
  setup.rules.collisionEvent = CollisionEvent::contact;
  int columns = 1;
  while (columns * columns < count) ++columns;
  for (int i = 0; i < count; ++i) {
    Vec2 way(0.0);
    double length2 = 0.0;
    do {
      way = {2.0 * unit() - 1.0, 2.0 * unit() - 1.0};
      length2 = way.x * way.x + way.y * way.y;
    } while (length2 > 1.0 || length2 < 0.01);
    const Vec2 cell{(i % columns + 0.5) / columns - 0.5, (i / columns + 0.5) / columns - 0.5};
    const double size = mixed ? 0.5 + 0.5 * unit() : 1.0;
    setup.pucks.push_back({std::to_string(i), size * radius_m, 0.02, size * size, cell * side_m,
                           way * (beta / std::sqrt(length2))});
  }
  return setup;
}

}  // namespace carom::test
