#pragma once
// The person's hands as the room shows them: a ray, a cue drawn back, the platform's drive. Room frame; the
// hands are drawn where they are, in the room, at the time of the head.

#include <cmath>
#include <cstdint>

#include "engine/spacetime/event.h"

namespace carom {

/// The cue: a ray from the hand and, if the ray points to a puck, the stroke that is being prepared for that
/// puck.
struct HandView {
  std::uint8_t shown = 0;       ///< 1: a hand aims
  std::uint8_t pulling = 0;     ///< 1: the cue is drawn back to strike `target`
  std::uint64_t target = 0;     ///< body of the scene that is aimed at; 0: none
  Vec3 from_m{0.0}, to_m{0.0};  ///< the ray's ends
  Vec3 target_m{0.0};           ///< where the target is seen
  Vec3 towards{0.0};            ///< unit vector: direction of the stroke, along the cloth
  double u = 0.0;               ///< γβ that the stroke would give the target at rest: p/(m c)
  double offset_m = 0.0;        ///< how far to the right of the target's centre it would strike
};

/// The force in the hand, as its device's loop took it.
struct ForceView {
  std::uint8_t shown = 0;  ///< 1: a force device is in the hand
  double scale = 1.0;      ///< s: 1 N in the hand is 1/s N at the cue
  Vec3 place_m{0.0};       ///< of the device
  Vec3 force_n{0.0};       ///< on the hand
};

/// Returns the energy that a stroke of u = γβ costs, in rest energies of the target: γ − 1.
inline double costOf(double u) { return u * u / (1.0 + std::sqrt(1.0 + u * u)); }

/// How the platform is driven.
enum class DriveMode : std::uint8_t {
  free,     ///< as the person steers it, or not at all
  braking,  ///< thrust against its motion on the board, until it is at rest
  home,     ///< returns by itself to where it started
  tour,     ///< follows the legs that the scenario gives
};

struct DriveView {
  Vec3 thrust{0.0};       ///< fraction of the strongest thrust, in the room's axes
  Vec3 thrust_m_s2{0.0};  ///< the same in board seconds and metres, for the one who steers
  DriveMode mode = DriveMode::free;
  std::uint8_t atLimit = 0;  ///< 1: more was asked for than the platform can do
};

}  // namespace carom
