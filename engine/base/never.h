#pragma once
// The time of what does not happen.

#include <limits>

namespace carom {

/// In any unit; what has always been the case began at -kNever.
inline constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace carom
