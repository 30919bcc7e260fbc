#pragma once
// Two bars that meet face to face, or anyhow, and how two bodies with corners pass through each other on the
// board, by the shapes that their world lines give there: an independent judge of who ends on which side.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/billiard/billiard.h"
#include "engine/collision/moving_shape.h"
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

/// The widest gap between two convex bodies along a side of either, below 0 if they overlap, and its
/// direction.
struct BoardGap {
  double width = -1e9;
  Vec2 normal{0.0};              ///< from the first body to the second
  std::array<double, 2> angles;  ///< of both bodies then
};

/// A time during which two bodies overlap on the board.
struct BoardOverlap {
  double begin = 0.0, end = 0.0, deepest = 0.0;  ///< metres
  BoardGap before, after;

  /// Whether they part on another side than that on which they came together: seen from the board and from
  /// either.
  bool isPassage() const {
    const auto along = [&](double turned) {
      const double c = std::cos(turned), s = std::sin(turned);
      const Vec2 normal{before.normal.x * c - before.normal.y * s, before.normal.x * s + before.normal.y * c};
      return glm::dot(normal, after.normal);
    };
    return along(0.0) < 0.0 && along(after.angles[0] - before.angles[0]) < 0.0 &&
           along(after.angles[1] - before.angles[1]) < 0.0;
  }
};

inline BoardGap gapOnBoard(const std::array<std::vector<Vec2>, 2>& corners) {
  BoardGap gap;
  for (int i = 0; i < 2; ++i) {
    const std::vector<Vec2>&one = corners[i], &other = corners[1 - i];
    for (std::size_t k = 0; k < one.size(); ++k) {
      const Vec2 side = one[(k + 1) % one.size()] - one[k];
      const Vec2 normal = Vec2{side.y, -side.x} / glm::length(side);
      double least = 1e9;
      for (const Vec2& corner : other) least = std::min(least, glm::dot(normal, corner - one[k]));
      if (least > gap.width) gap.width = least, gap.normal = i == 0 ? normal : -normal;
    }
  }
  return gap;
}

/// Returns when the first two pucks of a game overlap between two board times in metres of light, looked at
/// in steps.
inline std::vector<BoardOverlap> overlapsOnBoard(const Billiard& game, const BilliardSetup& setup,
                                                 double from, double until, double step) {
  std::array<std::optional<Outline>, 2> outlines;
  for (int i = 0; i < 2; ++i) outlines[i].emplace(setup.pucks[i].outline_m);
  const double reach = outlines[0]->radius() + outlines[1]->radius();
  const double least = 1e-9 * reach, c = setup.lightSpeed_m_s;
  std::vector<BoardOverlap> overlaps;
  BoardGap last;
  bool inside = false;
  for (double t = from; t < until; t += step) {
    std::array<std::vector<Vec2>, 2> corners;
    std::array<double, 2> angles{};
    std::array<Vec2, 2> places;
    for (int i = 0; i < 2; ++i) {
      const Motion motion = game.worldLines()[i].at(t / c);
      places[i] = {motion.event.r_m.x, motion.event.r_m.y};
    }
    BoardGap gap;
    if (glm::length(places[1] - places[0]) > reach) {
      gap.width = glm::length(places[1] - places[0]) - reach;
      gap.normal = glm::normalize(places[1] - places[0]);
    } else {
      for (int i = 0; i < 2; ++i) {
        const Motion motion = game.worldLines()[i].at(t / c);
        const Knot knot = game.worldLines()[i].knots()[motion.leg];
        const Vec21 start{knot.turn.t_s * c, knot.turn.r_m.x, knot.turn.r_m.y};
        const MovingShape flight{start,
                                 fourVelocity(knot.u.x, knot.u.y),
                                 outlines[i]->radius(),
                                 &*outlines[i],
                                 knot.spin.angle_rad,
                                 knot.spin.omega_rad_s / c};
        corners[i] = cornersOnBoard(flight, t);
        angles[i] = knot.spin.angle_rad + knot.spin.omega_rad_s * (motion.properTime_s - knot.properTime_s);
      }
      gap = gapOnBoard(corners);
    }
    gap.angles = angles;
    if (!inside && gap.width < -least) overlaps.push_back({t, t, 0.0, last, {}});
    inside = gap.width < -least;
    if (inside) overlaps.back().deepest = std::min(overlaps.back().deepest, gap.width);
    if (!overlaps.empty() && overlaps.back().after.width < 0.0 && !inside)
      overlaps.back().end = t, overlaps.back().after = gap;
    last = gap;
  }
  return overlaps;
}

}  // namespace carom::test
