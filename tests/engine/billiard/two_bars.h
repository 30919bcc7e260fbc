#pragma once
// Two bars that meet face to face, or anyhow.

#include <cmath>
#include <random>
#include <vector>

#include "engine/billiard/billiard.h"
#include "engine/collision/outline.h"
#include "engine/corner_games.h"

namespace carom::test {

/// How two bars of 12 cm meet: with equal and opposite speeds.
struct Meeting {
  double thick_m, beta, restitution;
  bool atContact;  // the convention
  double mostTilt_rad, mostBeside_m;
};

inline BilliardSetup twoBars(const Meeting& meeting, unsigned seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double most) {
    return std::uniform_real_distribution<double>(-most, most)(random);
  };
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.42;
  setup.rules.puckRestitution = meeting.restitution;
  setup.rules.collisionEvent = meeting.atContact ? CollisionEvent::contact : CollisionEvent::centre;
  for (const double side : {-1.0, 1.0}) {
    std::vector<Vec2> corners = rectangle(meeting.thick_m, 0.12);
    const double tilt = uniform(meeting.mostTilt_rad), c = std::cos(tilt), s = std::sin(tilt);
    for (Vec2& p : corners) p = {p.x * c - p.y * s, p.x * s + p.y * c};
    Puck bar = bodyOf(side < 0.0 ? "left" : "right", corners);
    bar.inertia = momentsOf(corners).inertia;
    bar.position_m = {0.15 * side, uniform(0.5 * meeting.mostBeside_m)};
    bar.beta = {-side * meeting.beta, 0.0};
    setup.pucks.push_back(bar);
  }
  return setup;
}

}  // namespace carom::test
