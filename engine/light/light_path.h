#pragma once
// A pulse of light on its way from place to place, and where an eye sees it: by what the air, or what it
// strikes, scatters to the eye. Board frame.

#include <span>
#include <vector>

#include "engine/spacetime/event.h"

namespace carom {

/// Goes at c from the first place to the last, straight from each to the next.
struct LightPath {
  double start_s = 0.0;
  std::vector<Vec3> path_m;  ///< two places at least
};

double lengthOf(std::span<const Vec3> path_m);

/// The place so far along the path; before its beginning the first, beyond its end the last.
Vec3 placeAlong(std::span<const Vec3> path_m, double along_m);

/// How far along its path the pulse is seen by an eye at `observation`, from 0 (its start is not yet seen) to
/// the path's whole length (its end has been). It never runs back. Light that runs straight at the eye is
/// seen nowhere before it is there, and then everywhere on its way at once: of that, the end is given.
double seenAlong_m(double start_s, std::span<const Vec3> path_m, const Event& observation, double c_m_s);

/// How far along it is at board time `t_s`, within the path.
double reached_m(double start_s, std::span<const Vec3> path_m, double t_s, double c_m_s);

}  // namespace carom
