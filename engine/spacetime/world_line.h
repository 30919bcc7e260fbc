#pragma once
// The world line of a body's centre, as knots: between two knots the motion is exact, so a bounce costs
// one knot and a straight flight of any length costs nothing.

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"

namespace carom {

/// The speed, over c, at which a point of a body catches up with its outgoing leg, in the rest frame of that
/// leg.
inline constexpr double kCatchUpSpeed = 0.9;

/// Where a leg of motion begins. Board frame.
struct Knot {
  Event turn;                      ///< the centre's event from which the leg's motion holds
  Vec3 u{0.0};                     ///< γβ at the turn
  double properTime_s = 0.0;       ///< the centre's own clock at the turn
  Event signal;                    ///< the event whose signal, at light speed, makes the body's points turn
  double deceleration_m_s2 = 0.0;  ///< constant proper deceleration from here until rest (friction)
};

/// The centre at one board time.
struct Motion {
  Event event;
  Vec3 u{0.0};  ///< γβ
  double properTime_s = 0.0;
  std::size_t leg = 0;  ///< index of the knot that began this leg
};

/// Motion along one leg at board time `t_s`. Before the turn the leg is continued backwards inertially.
Motion motionOnLeg(const Knot& knot, double t_s, double c_m_s);

/// Knots in the order of time. The first leg reaches back without end; before `appears_s` nothing of the
/// body is there to be seen. `radius_m` bounds the body's points from its centre, in its rest frame.
class WorldLine {
 public:
  WorldLine(const Knot& first, double c_m_s, double radius_m = 0.0,
            double appears_s = -std::numeric_limits<double>::infinity());

  /// Adds a leg. The turn must not lie before the last one and must lie on the leg it ends, within 1e-9
  /// of the coordinates' size; throws std::invalid_argument otherwise.
  void append(const Knot& knot);

  /// Has the last knots brought from memory, which `append` needs.
  void fetchEnd() const {
    const char* end = reinterpret_cast<const char*>(knots_.data() + knots_.size());
    for (int byte = -128; byte <= 64; byte += 64) __builtin_prefetch(end + byte);
  }

  /// The bounds of when all points have joined grow with every turn that comes before they have. Where better
  /// is known of the last leg (joinedAfter_s of vertex_history.h), this says so.
  void settlesAfter(double after_s);

  /// Forgets every knot but the first whose turn is at or after `t_s`. Where that is all that `forgetBefore`
  /// has left, the line begins anew, with the leg it was made with.
  void truncateFrom(double t_s);
  /// Forgets every knot but the first `knots`, at least one.
  void keepFirst(std::size_t knots);
  /// Forgets the legs that ended before `t_s`; the first that is left then reaches back in their stead.
  /// Returns how many.
  std::size_t forgetBefore(double t_s);

  /// The centre at board time `t_s`.
  Motion at(double t_s) const;

  std::span<const Knot> knots() const { return knots_; }

  /// How long after a knot's turn, by the centre's own clock, every point within the radius has joined the
  /// leg that begins there (an upper bound).
  double settled_s(std::size_t knot) const { return settling_[knot].after_s; }
  /// Had they all joined when the signal that ends this leg was made? True of the last leg.
  bool settlesBeforeNext(std::size_t knot) const { return settling_[knot].beforeNext; }

  double radius_m() const { return radius_m_; }
  double appears_s() const { return appears_s_; }
  double lightSpeed_m_s() const { return c_m_s_; }

 private:
  struct Settling {
    double after_s = 0.0;
    double reach_m = 0.0;  // how far from the centre a point can be until then, in the leg's rest frame
    bool beforeNext = true;
    double reachAtNext_m = 0.0;  // the same when the signal that ends this leg is made
  };
  Settling settlingOf(const Knot& next, const Motion& before) const;
  void noteNext(const Knot& next);

  double c_m_s_;
  double radius_m_;
  double appears_s_;
  Knot origin_;
  bool forgotten_ = false;  // legs before knots_.front()
  std::vector<Knot> knots_;
  std::vector<Settling> settling_;
};

}  // namespace carom
