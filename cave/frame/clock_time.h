#pragma once
// A time as every clock shows it, on cushions, plates, panels and the console: in seconds, rounded down to
// tenths.

#include <cmath>

namespace carom {

inline double shownTime_s(double time_s) { return std::floor(10.0 * time_s) / 10.0; }

/// The longest time that is shown, about six years: the shaders count tenths in 32 bits.
inline constexpr double kMostShown_s = 2e8;

}  // namespace carom
