#pragma once
// Two bars that meet face to face, or anyhow, and how two bodies with corners leave each other on the board,
// by the shapes that their world lines give there: an independent judge of who ends on which side.
//
// The side on which two bodies last touched is the one to which the impulse q of their last contact pushes
// the second. They recede for good from another side if
// * they recede against it: q·(u2 − u1) > 0 with the last four-velocities, on which all frames agree;
// * and where they come out of each other for the last time, the side of either that parts them there looks
//   against it, too: on the board, and to each body as it has turned with the impulse since. Of bodies that
//   are not in each other after the contact, all sides that part them when both have turned.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/billiard/billiard.h"
#include "engine/collision/spinning_body.h"
#include "engine/corner_games.h"
#include "engine/polygons/moving_shape.h"
#include "engine/polygons/outline.h"

namespace carom::test {

/// How two bars of 12 cm meet: with equal and opposite speeds.
struct BarMeeting {
  double thick_m, beta, restitution;
  bool atContact;  // the convention
  double mostTilt_rad, mostBeside_m;
};

inline BilliardSetup twoBars(const BarMeeting& meeting, unsigned seed) {
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
  Vec2 normal{0.0};           ///< from the first body to the second
  std::vector<Vec2> normals;  ///< of all sides that part them
};

/// A time during which two bodies overlap on the board, and how they come out of each other.
struct BoardOverlap {
  double begin = 0.0, end = 0.0;  ///< metres of light
  BoardGap after;
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
      const Vec2 outwards = i == 0 ? normal : -normal;
      if (least > 0.0) gap.normals.push_back(outwards);
      if (least > gap.width) gap.width = least, gap.normal = outwards;
    }
  }
  return gap;
}

/// The first two pucks of a game, on the board.
class BarsOnBoard {
 public:
  BarsOnBoard(const Billiard& game, const BilliardSetup& setup) : game_(game), c_(setup.lightSpeed_m_s) {
    for (int i = 0; i < 2; ++i) outlines_[i].emplace(setup.pucks[i].outline_m);
  }

  /// Both at a board time in metres of light.
  BoardGap gapAt(double t) const {
    std::array<std::vector<Vec2>, 2> corners;
    std::array<Vec2, 2> places;
    for (int i = 0; i < 2; ++i) {
      const Vec3 r = motionOf(i, t).event.r_m;
      places[i] = {r.x, r.y};
    }
    const Vec2 apart = places[1] - places[0];
    const double reach = outlines_[0]->radius() + outlines_[1]->radius();
    if (glm::length(apart) > reach) {
      const Vec2 normal = glm::normalize(apart);
      return {glm::length(apart) - reach, normal, {normal}};
    }
    for (int i = 0; i < 2; ++i) corners[i] = cornersOnBoard(flightOf(i, t), t);
    return gapOnBoard(corners);
  }
  double angleAt(int i, double t) const {
    const Motion motion = motionOf(i, t);
    const Knot knot = knotOf(i, motion);
    return knot.spin.angle_rad + knot.spin.omega_rad_s * (motion.properTime_s - knot.properTime_s);
  }

  /// Returns when they overlap between two board times, looked at in steps, and at another time between them.
  std::vector<BoardOverlap> overlaps(double from, double until, double step, double also) const {
    const double least = 1e-9 * (outlines_[0]->radius() + outlines_[1]->radius());
    std::vector<BoardOverlap> overlaps;
    bool inside = false;
    for (double t = from; t < until; t = t < also && t + step > also ? also : t + step) {
      const BoardGap gap = gapAt(t);
      const bool isInside = gap.width < -least;
      if (isInside && !inside) overlaps.push_back({t, until, {}});
      if (!isInside && inside) overlaps.back().end = t, overlaps.back().after = gap;
      inside = isInside;
    }
    return overlaps;
  }

 private:
  Motion motionOf(int i, double t) const { return game_.worldLines()[i].at(t / c_); }
  Knot knotOf(int i, const Motion& motion) const { return game_.worldLines()[i].knots()[motion.leg]; }
  MovingShape flightOf(int i, double t) const {
    const Knot knot = knotOf(i, motionOf(i, t));
    return {{knot.turn.t_s * c_, knot.turn.r_m.x, knot.turn.r_m.y},
            fourVelocity(knot.u.x, knot.u.y),
            outlines_[i]->radius(),
            &*outlines_[i],
            knot.spin.angle_rad,
            knot.spin.omega_rad_s / c_};
  }

  const Billiard& game_;
  double c_;
  std::array<std::optional<Outline>, 2> outlines_;
};

/// How a pair has ended.
struct BarsEnd {
  double receding = 0.0;  ///< over c, along the last impulse, in the frame of P; below 0: against it
  double along = 1.0;     ///< the cosine of the side on which they parted with it, in the best reading
};

/// The momentum of a bar, over c: the mass changes with the spin.
inline Vec21 momentumOf(const BilliardSetup& setup, std::size_t i, const Vec2& beta, double spin_kg_m2_s) {
  const Puck& bar = setup.pucks[i];
  const SpinningBody body{bar.mass_kg, bar.inertia * bar.mass_kg};
  const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(beta, beta));
  const Vec21 u{gamma, gamma * beta.x, gamma * beta.y};
  return u * restMass(body, spin_kg_m2_s / (bar.radius_m * setup.lightSpeed_m_s));
}

/// Returns the end of a pair that has touched and of which every turn lies before `until`, metres of light.
inline BarsEnd endOf(const Billiard& game, const BilliardSetup& setup, double until, double step) {
  const GameEvent& last = game.events().back();
  std::array<Vec21, 2> before, p;
  for (const Turn& turn : last.turns) {
    before[turn.puck] = momentumOf(setup, turn.puck, turn.betaBefore, turn.spinBefore_kg_m2_s);
    p[turn.puck] = momentumOf(setup, turn.puck, turn.betaAfter, turn.spinAfter_kg_m2_s);
  }
  const Vec21 P = p[0] + p[1], given = p[1] - before[1], q = given - P * (dot(given, P) / dot(P, P));
  const auto along = [&](const Vec21& of) { return -dot(q, of) / dot(P, of); };
  BarsEnd end;
  end.receding = (along(p[1]) - along(p[0])) * std::sqrt(dot(P, P) / -dot(q, q));

  constexpr double kJustAfter_m = 1e-9;
  const double touched = last.at.t_s * setup.lightSpeed_m_s;
  double parted = touched;
  for (const Turn& turn : last.turns) parted = std::max(parted, turn.event.t_s * setup.lightSpeed_m_s);
  parted += kJustAfter_m;
  const BarsOnBoard bars(game, setup);
  const std::vector<BoardOverlap> overlaps = bars.overlaps(touched, until, step, parted);
  std::vector<Vec2> normals = bars.gapAt(parted).normals;
  if (!overlaps.empty()) parted = overlaps.back().end, normals = {overlaps.back().after.normal};
  const Vec2 push = glm::normalize(Vec2{q.x, q.y});
  end.along = -1.0;
  for (const double turned : {0.0, bars.angleAt(0, parted) - bars.angleAt(0, touched),
                              bars.angleAt(1, parted) - bars.angleAt(1, touched)}) {
    const double c = std::cos(turned), s = std::sin(turned);
    const Vec2 carried{push.x * c - push.y * s, push.x * s + push.y * c};
    for (const Vec2& normal : normals) end.along = std::max(end.along, glm::dot(carried, normal));
  }
  return end;
}

}  // namespace carom::test
