#pragma once
// What the person's hands do, as the room shows it: a ray, a cue drawn back, the platform's drive. Room
// frame; hands are where the room has them at the head's moment.

#include <cmath>
#include <cstdint>

#include "engine/spacetime/event.h"

namespace carom {

/// The cue: a ray from the hand, and where it points to a puck, the stroke that is being drawn back for it.
struct HandView {
  std::uint8_t shown = 0;       ///< 1: a hand aims
  std::uint8_t pulling = 0;     ///< 1: the cue is drawn back for `target`
  std::uint64_t target = 0;     ///< body of the scene that is aimed at; 0: none
  Vec3 from_m{0.0}, to_m{0.0};  ///< the ray
  Vec3 target_m{0.0};           ///< where the target is seen
  Vec3 towards{0.0};            ///< unit vector: the way of the stroke, along the cloth
  double u = 0.0;               ///< γβ that the stroke would give the target at rest: p/(m c)
};

/// What the stroke costs, in rest energies of the target: γ − 1, of u = γβ.
inline double costOf(double u) { return u * u / (1.0 + std::sqrt(1.0 + u * u)); }

/// What the platform does.
enum class DriveMode : std::uint8_t {
  free,     ///< as it is steered, or not at all
  braking,  ///< against its motion on the board, until it rests
  home,     ///< on its own way back to where it started
  tour,     ///< through the legs that the scenario gives
};

struct DriveView {
  Vec3 thrust{0.0};  ///< share of the strongest, in the room's axes
  DriveMode mode = DriveMode::free;
  std::uint8_t atLimit = 0;  ///< 1: more was asked for
};

}  // namespace carom
