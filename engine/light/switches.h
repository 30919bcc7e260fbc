#pragma once
// The five effects of relativity on the picture. Each can be switched off to show its part.

#include <cstdint>

namespace carom {

/// 1: on, 0: off. With all off the picture is Euclid's and Newton's.
struct Switches {
  std::uint8_t retardation = 1;  ///< off: bodies are drawn where they are at the eye's board time
  std::uint8_t contraction = 1;  ///< off: at each board time a body is its centre's place + its rest shape
  std::uint8_t aberration = 1;   ///< off: directions are the board's, for the eye and for lamps on bodies
  std::uint8_t colour = 0;       ///< Doppler shift of the spectrum
  std::uint8_t searchlight = 0;  ///< radiance grows with D⁴

  bool operator==(const Switches&) const = default;
};

/// All off: no vertex needs more than a matrix.
inline constexpr Switches kNoSwitches{0, 0, 0, 0, 0};

}  // namespace carom
