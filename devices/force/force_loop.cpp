#include "devices/force/force_loop.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace carom {
namespace {

bool isFinite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Returns how strongly a motor without a direction rumbles, 0 to 1: with the force of the draw, and with
/// the logarithm of a blow.
double rumbleFor(double now_s, double force_n, const ForceLaw& law, const ForceLimits& limits) {
  constexpr double kTremble = 0.4;
  double rumble = kTremble * std::min(1.0, force_n / limits.force_n);
  for (std::size_t i = 0; i < law.blowCount; ++i) {
    const Blow& blow = law.blows[i];
    if (!(now_s > blow.start_s && now_s < blow.start_s + kBlow_s)) continue;
    rumble = std::max(rumble, rumbleOf(glm::length(blow.peak_n) / (kBlowShare * limits.force_n)));
  }
  return rumble;
}

}  // namespace

/// The force of the cue points to where the draw began, in the plane of the cloth. Its derivative is k along
/// the draw and F/d across it.
glm::dvec3 ForceLoop::cueForce(const glm::dvec3& place_m, const ForceLaw& law, ForceCommand& command) {
  if (!anchor_m_) anchor_m_ = place_m;
  glm::dvec3 draw_m = place_m - *anchor_m_;
  draw_m -= glm::dot(draw_m, law.up) * law.up;
  report_.draw_m = draw_m;
  const double size_m = glm::length(draw_m);
  report_.energy_j = law.cue.energy_j(size_m);
  if (!(size_m > 0.0)) return glm::dvec3(0.0);
  const glm::dvec3 along = draw_m / size_m;
  const double force_n = law.cue.force_n(size_m), k = law.cue.stiffness_n_m(size_m),
               across = force_n / size_m;
  const glm::dmat3 plane = glm::dmat3(1.0) - glm::outerProduct(law.up, law.up);
  command.stiffness_n_m = -across * plane - (k - across) * glm::outerProduct(along, along);
  return -force_n * along;
}

glm::dvec3 ForceLoop::puckForce(const glm::dvec3& place_m, const glm::dvec3& moved_m, const ForceLaw& law) {
  if (!puck_) {
    HeldPuckLaw held = law.puck;
    held.stiffness_n_m = std::min(held.stiffness_n_m, settlingStiffness_n_m(limits_));
    puck_.emplace(held, place_m);
  }
  const glm::dvec3 force_n = puck_->step(place_m, moved_m / limits_.period_s, limits_.period_s);
  report_.proxyBeta = glm::length(puck_->velocity_m_s()) / law.puck.lightSpeed_m_s;
  return force_n;
}

double ForceLoop::storedBy(const ForceLaw& law) const {
  if (law.kind == ForceLaw::Kind::cue && anchor_m_) return report_.energy_j;
  return puck_ ? puck_->stored_j() : 0.0;
}

/// Returns the law's force and its stiffness.
ForceCommand ForceLoop::commandOf(const ForceDeviceState& device, const ForceLaw& law) {
  ForceCommand command;
  command.at_m = device.position_m;
  if (law.kind == ForceLaw::Kind::cue) command.force_n = cueForce(device.position_m, law, command);
  if (law.kind == ForceLaw::Kind::heldPuck) command.force_n = puckForce(device.position_m, moved_m_, law);
  for (std::size_t i = 0; i < std::min(law.blowCount, law.blows.size()); ++i)
    command.force_n += law.blows[i].at(report_.time_s);
  return command;
}

ForceCommand ForceLoop::tick(double now_s, const ForceDeviceState& device, const ForceLaw& law) {
  report_.limit = ForceReport::Limit::none;
  report_.draw_m = glm::dvec3(0.0);
  report_.energy_j = 0.0;
  report_.time_s = now_s;
  const bool isSane = isFinite(device.position_m);
  const bool pressed = law.held || device.pressed;
  report_.active = guard_.look(now_s, law.posted_s, device.time_s, pressed) && isSane;
  if (pressed && !isSane) guard_.fall(ForceFall::notFinite, now_s);
  moved_m_ = place_m_ && isSane ? device.position_m - *place_m_ : glm::dvec3(0.0);
  if (isSane) place_m_ = report_.position_m = device.position_m;
  if (!report_.active || law.kind != ForceLaw::Kind::cue) anchor_m_.reset();
  if (!report_.active || law.kind != ForceLaw::Kind::heldPuck) puck_.reset();
  ForceCommand command;
  if (report_.active) command = commandOf(device, law);
  const glm::dvec3 asked_n = command.force_n;
  if (!isFinite(command.force_n)) {
    guard_.fall(ForceFall::notFinite, now_s);
    command.force_n = glm::dvec3(0.0);
  }
  passivity_.observe(moved_m_, device.held_n, storedBy(law));
  command.force_n = passivity_.limited(command.force_n);
  if (passivity_.acts()) report_.limit = ForceReport::Limit::passivity;
  command.force_n = guard_.allowed(command.force_n, now_s, report_.limit);
  const double size_n = glm::length(asked_n);
  command.stiffness_n_m *= size_n > 0.0 ? std::min(1.0, glm::length(command.force_n) / size_n) : 0.0;
  if (report_.active) command.rumble = rumbleFor(now_s, glm::length(command.force_n), law, limits_);
  if (puck_) {
    shown_.add(device.position_m, command.force_n, limits_.period_s);
    report_.shown_kg = shown_.mass_kg();
  } else {
    shown_ = {};
  }
  report_.force_n = command.force_n;
  report_.rate_hz = guard_.rate_hz();
  report_.port_j = passivity_.energy_j();
  report_.fall = guard_.lastFall();
  report_.falls = guard_.falls();
  return command;
}

void ForceLoop::end(ForceFall why, double now_s) {
  if (report_.active || report_.force_n != glm::dvec3(0.0)) guard_.fall(why, now_s);
  guard_.zero();
  report_.force_n = glm::dvec3(0.0);
  report_.active = false;
  report_.fall = guard_.lastFall();
  report_.falls = guard_.falls();
}

}  // namespace carom
