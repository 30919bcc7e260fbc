#pragma once
// The numbers of Halley's steps that find the emission of a point of a spinning body within the rounding of
// floats.

namespace carom {

inline constexpr double kFewSpinSteps = 4.0;   ///< for rims up to 0.99 c
inline constexpr double kMostSpinSteps = 6.0;  ///< for any

}  // namespace carom
