#pragma once
// What passes between the game and the loop of a force device: the game posts laws, never forces, and the
// loop reports what it does. Vectors are in the device's axes, times on the session's clock.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "devices/force_law/blow.h"
#include "devices/force_law/cue_force.h"
#include "devices/force_law/held_puck.h"

namespace carom {

/// Why a force fell to 0 N.
enum class ForceFall : std::uint8_t {
  none,
  gameSilent,
  poseOld,
  rateLow,
  tickLate,
  unplugged,
  notFinite,
  ended
};

/// Returns the reason in words, such as "no pose for 20 ms".
const char* toString(ForceFall fall);

struct ForceLaw {
  enum class Kind : std::uint8_t { none, cue, heldPuck };
  Kind kind = Kind::none;
  bool held = false;  ///< the dead man's button, as far as the game knows it
  double posted_s = -std::numeric_limits<double>::infinity();
  CueForce cue;
  HeldPuckLaw puck;
  glm::dvec3 up{0.0, 1.0, 0.0};  ///< across the cloth; the cue has no force along it
  std::array<Blow, 8> blows{};   ///< the first `blowCount`
  std::size_t blowCount = 0;
  glm::dvec3 wish_m{0.0};  ///< where the hand of a simulated device wants to be
};

/// What a device says at a tick.
struct ForceDeviceState {
  glm::dvec3 position_m{0.0};
  double time_s = -std::numeric_limits<double>::infinity();  ///< when it was there
  bool pressed = false;                                      ///< its own button
  glm::dvec3 held_n{0.0};  ///< the force that its motors had since the tick before
};

/// What a device is told at a tick.
struct ForceCommand {
  glm::dvec3 force_n{0.0};
  glm::dvec3 at_m{0.0};           ///< where this force holds
  glm::dmat3 stiffness_n_m{0.0};  ///< dF/dx there, for devices that have a faster loop of their own
  double rumble = 0.0;            ///< 0 to 1, for motors without a direction
};

/// What the loop does, for the game.
struct ForceReport {
  double time_s = -std::numeric_limits<double>::infinity();  ///< of its last tick
  glm::dvec3 position_m{0.0}, force_n{0.0};
  glm::dvec3 draw_m{0.0};  ///< of the cue, since the button went down; 0 while it is not drawn
  double rate_hz = 0.0;
  double energy_j = 0.0;   ///< that the draw holds
  double port_j = 0.0;     ///< the observer's, app/doc/physics.md
  double proxyBeta = 0.0;  ///< speed of the held puck's proxy, in units of c
  double shown_kg = std::numeric_limits<double>::quiet_NaN();  ///< the mass that it showed in the last second
  bool active = false;                                         ///< a law holds and the button is down
  enum class Limit : std::uint8_t { none, force, slew, passivity } limit = Limit::none;
  ForceFall fall = ForceFall::none;  ///< the last one
  std::uint64_t falls = 0;           ///< number of them
};

}  // namespace carom
