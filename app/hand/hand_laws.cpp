#include "app/hand/hand_laws.h"

#include <algorithm>

namespace carom {

HandLaws::HandLaws(const ForceSetup& setup, const RoomAxes& axes, const BilliardSetup& game)
    : setup_(setup),
      limits_(limitsOf(setup)),
      lightSpeed_m_s_(game.lightSpeed_m_s),
      up_(deviceFromRoom(axes.up)) {
  for (const Puck& puck : game.pucks) {
    const double restEnergy_j = puck.mass_kg * lightSpeed_m_s_ * lightSpeed_m_s_;
    scale_ = std::min(scale_, forceScale(restEnergy_j, setup.d0_m, limits_));
  }
}

ForceLaw HandLaws::cue(double mass_kg) const {
  ForceLaw law;
  law.kind = ForceLaw::Kind::cue;
  law.up = up_;
  law.cue = {mass_kg * lightSpeed_m_s_ * lightSpeed_m_s_, setup_.d0_m, scale_};
  return law;
}

// The coupling is stepped at the loop's period, however fast a server holds its springs.
ForceLaw HandLaws::held(double mass_kg, const glm::dvec3& betaInRoom) const {
  ForceLaw law;
  law.kind = ForceLaw::Kind::heldPuck;
  law.up = up_;
  law.puck.mass_kg = mass_kg;
  law.puck.lightSpeed_m_s = lightSpeed_m_s_;
  law.puck.carried_m_s = lightSpeed_m_s_ * deviceFromRoom(betaInRoom);
  law.puck.stiffness_n_m = std::min(limits_.stiffness_n_m, 2.0 * limits_.damping_ns_m / limits_.period_s);
  law.puck.damping_ns_m = couplingDamping_ns_m(limits_, law.puck.stiffness_n_m);
  return law;
}

Blow HandLaws::blow(const glm::dvec3& changeInRoom, double start_s) const {
  return blowOf(deviceFromRoom(changeInRoom), start_s, limits_.force_n);
}

}  // namespace carom
