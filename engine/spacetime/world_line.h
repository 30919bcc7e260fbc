#pragma once
// The world line of a body's centre, as knots: between two knots the motion is exact, so a bounce costs
// one knot and a straight flight of any length costs nothing.
// Theory: app/doc/physics.md, Friction.

#include <cstddef>
#include <limits>
#include <memory_resource>

#include "engine/base/prefetch.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/knot.h"
#include "engine/spacetime/knot_store.h"
#include "engine/spacetime/lorentz.h"

namespace carom {

/// The speed, over c, at which a point of a body catches up with its outgoing leg, in the rest frame of that
/// leg. Where its place there becomes faster than 0.8 c, by spin or friction: at (1 + that speed)/2.
inline constexpr double kCatchUpSpeed = 0.9;

// The spin `own_s` after the turn, by the centre's own clock. Before the turn it is uniform.
/// Returns the angle, from −π to π.
double angleAfter(const Spin& spin, double own_s);
/// Returns γβ of the rim.
double rimUAfter(const Spin& spin, double own_s);
double omegaAfter(const Spin& spin, double own_s);

/// The centre at one board time.
struct Motion {
  Event event;
  Vec3 u{0.0};  ///< γβ
  double properTime_s = 0.0;
  std::size_t leg = 0;  ///< index of the knot that began this leg
};

/// Returns the motion on one leg at board time `t_s`. Before the turn, the leg is continued backwards
/// inertially.
Motion motionOnLeg(const Knot& knot, double t_s, double c_m_s);

/// The knots in the order of time. The first leg reaches back without end; before `appears_s` the body does
/// not exist. `radius_m` bounds the distance of the body's points from its centre, in its rest frame. The
/// knots lie in `memory`, those of a copy in the default one.
class WorldLine {
 public:
  WorldLine(const Knot& first, double c_m_s, double radius_m = 0.0,
            double appears_s = -std::numeric_limits<double>::infinity(),
            std::pmr::memory_resource* memory = std::pmr::get_default_resource());

  /// Adds a leg. The turn must not lie before the last one and must lie on the leg it ends, within 1e-9
  /// of the coordinates' size; throws std::invalid_argument otherwise.
  void append(const Knot& knot);

  /// Prefetches from memory what `fetchEnd` reads; `fetchEnd` what `append` reads and writes.
  void fetch() const { prefetch(this), knots_.fetch(); }
  void fetchEnd() const { knots_.fetchEnd(); }

  /// Lowers the bound of when all points have joined the last leg, where a better one is known (joinedAfter_s
  /// of vertex_history.h). The bounds that the line itself computes grow with every turn that comes before
  /// all points have joined.
  void settlesAfter(double after_s);

  /// Removes the knots whose turn is at or after `t_s`, but never the first. If `forgetBefore` has removed
  /// legs and the first remaining knot is that late as well, the line begins anew with the leg that it was
  /// made with.
  void truncateFrom(double t_s);
  /// Keeps the first `knots` knots, at least one, and removes the others.
  void keepFirst(std::size_t knots);
  /// Removes the legs that ended before `t_s`; the first remaining leg then reaches back in their place.
  /// Returns the number of removed legs.
  std::size_t forgetBefore(double t_s);

  /// Returns the centre's motion at board time `t_s`.
  Motion at(double t_s) const;

  Knots knots() const { return Knots(knots_); }

  /// Returns an upper bound of the time after a knot's turn, by the centre's own clock, at which every point
  /// within the radius has joined the leg that begins there.
  double settled_s(std::size_t knot) const { return knots_.settling(knot).after_s; }
  /// Returns whether all points had joined this leg when the signal that ends it was made; true for the last
  /// leg.
  bool settlesBeforeNext(std::size_t knot) const { return knots_.settling(knot).beforeNext; }

  double radius_m() const { return radius_m_; }
  double appears_s() const { return appears_s_; }
  double lightSpeed_m_s() const { return c_m_s_; }

 private:
  Settling settlingOf(const Knot& next, const Motion& before, double radiusThen_m) const;
  // Notes whether all points have joined the last leg when the signal of the next is made. Returns how far
  // from the centre a point can be then, in the leg's rest frame.
  double noteNext(const Knot& last, const Knot& next);
  std::size_t legAt(double t_s) const;

  double c_m_s_;
  double radius_m_;
  KnotStore knots_;
  double appears_s_;
  bool forgotten_ = false;  // legs before the first knot
};

}  // namespace carom
