#pragma once
// A pulse of light on its way from place to place, and where an eye sees it, by light that the air, or the
// surface it strikes, scatters to the eye. Board frame.

#include <span>
#include <vector>

#include "engine/spacetime/event.h"

namespace carom {

/// The path of a pulse that goes at c from the first place to the last, straight from each to the next.
struct LightPath {
  double start_s = 0.0;
  std::vector<Vec3> path_m;  ///< at least two places
};

double lengthOf(std::span<const Vec3> path_m);

/// Returns the place at the distance `along_m` along the path; before its beginning the first place, beyond
/// its end the last.
Vec3 placeAlong(std::span<const Vec3> path_m, double along_m);

/// Returns how far along its path an eye at `observation` sees the pulse, from 0 (its start is not yet seen)
/// to the whole length of the path (its end has been seen). The result never decreases with time. An eye to
/// which the pulse comes straight sees it nowhere before it arrives, and then everywhere on that way at once;
/// the function then returns the end of that way.
double seenAlong_m(double start_s, std::span<const Vec3> path_m, const Event& observation, double c_m_s);

/// Returns how far along the path the pulse is at board time `t_s`, within the path.
double reached_m(double start_s, std::span<const Vec3> path_m, double t_s, double c_m_s);

/// Returns the event at which light from `from` meets a point that is at `at` and moves on with `beta` (v/c);
/// `at` itself, if the light has passed it by then.
Event lightMeets(const Event& from, const Event& at, const Vec3& beta, double c_m_s);

}  // namespace carom
