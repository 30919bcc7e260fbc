#pragma once
// What every clock shows of a time, on cushions, plates, panels and the console: seconds, and the tenths of a
// second that have gone by.

#include <cmath>

namespace carom {

inline double shownTime_s(double time_s) { return std::floor(10.0 * time_s) / 10.0; }

/// The longest that is shown, six years: the shaders count tenths in 32 bits.
inline constexpr double kMostShown_s = 2e8;

}  // namespace carom
