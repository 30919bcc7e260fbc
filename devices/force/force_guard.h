#pragma once
// The watch over a force: what makes it fall to 0 N, and how it falls.

#include <cstdint>

#include <glm/vec3.hpp>

#include "devices/force_law/cue_force.h"
#include "devices/force_law/force_law.h"

namespace carom {

/// A force falls when the game has posted nothing for 100 ms, a pose is older than 20 ms, no tick came for
/// 20 ms, the loop is slower than its device needs, or a number is not finite. It falls evenly within 50 ms
/// and stays at 0 N until the button is released and pressed again.
inline constexpr double kGameSilent_s = 0.100, kPoseOld_s = 0.020, kTickLate_s = 0.020, kFalls_s = 0.050;

class ForceGuard {
 public:
  explicit ForceGuard(const ForceLimits& limits) : limits_(limits) {}

  /// Looks at a tick. `pressed`: the dead man's button is down. Returns whether a force may be there.
  bool look(double now_s, double posted_s, double pose_s, bool pressed);
  /// Makes the force fall for another reason.
  void fall(ForceFall why, double now_s);

  /// Returns the force as it may be: at most F_max, changed since the last one by at most the slew, and
  /// falling to zero after a fall.
  glm::dvec3 allowed(const glm::dvec3& wished_n, double now_s, ForceReport::Limit& limit);
  /// The force is 0 N at once, as after an error of the device.
  void zero() { last_n_ = glm::dvec3(0.0); }

  ForceFall lastFall() const { return why_; }
  std::uint64_t falls() const { return falls_; }
  double rate_hz() const { return rate_hz_; }

 private:
  ForceFall faultAt(double now_s, double posted_s, double pose_s) const;
  void measureRate(double now_s);

  ForceLimits limits_;
  ForceFall why_ = ForceFall::none;
  bool fallen_ = false;
  std::uint64_t falls_ = 0;
  double fell_s_ = 0.0, tick_s_ = -1.0, before_s_ = -1.0;
  glm::dvec3 fellFrom_n_{0.0}, last_n_{0.0};
  double windowFrom_s_ = -1.0, rate_hz_ = 0.0;
  int ticks_ = 0;
};

}  // namespace carom
