#pragma once
// The laws that a hand's force device gets in a game (devices/force_law/force_law.h), in the device's axes.

#include <glm/vec3.hpp>

#include "devices/setup/force_factory.h"
#include "engine/billiard/billiard.h"

namespace carom {

class HandLaws {
 public:
  /// One scale serves the whole room: that of the game's heaviest puck, so that no force is too strong.
  HandLaws(const ForceSetup& setup, const RoomAxes& axes, const BilliardSetup& game);

  /// Returns the law of a cue that strikes a puck of this mass.
  ForceLaw cue(double mass_kg) const;
  /// Returns the law of a hand that holds a puck of this mass, carried along with `beta` in the room's axes.
  ForceLaw held(double mass_kg, const glm::dvec3& betaInRoom) const;
  /// Returns the blow of a change of momentum in the room, in units of m c.
  Blow blow(const glm::dvec3& changeInRoom, double start_s) const;

  double scale() const { return scale_; }
  double d0_m() const { return setup_.d0_m; }
  const ForceLimits& limits() const { return limits_; }
  glm::dvec3 roomFromDevice(const glm::dvec3& way) const { return setup_.roomFromDevice.orientation * way; }
  glm::dvec3 deviceFromRoom(const glm::dvec3& way) const {
    return glm::conjugate(setup_.roomFromDevice.orientation) * way;
  }

 private:
  ForceSetup setup_;
  ForceLimits limits_;
  double lightSpeed_m_s_;
  glm::dvec3 up_;
  double scale_ = 1.0;
};

}  // namespace carom
