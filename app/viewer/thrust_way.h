#pragma once
// A way of the platform: thrusts that follow one another, in the room's axes, timed by the room's clock.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/spacetime/event.h"

namespace carom {

struct Thrust {
  double for_s = 0.0;
  Vec3 thrust_m_s2{0.0};
};

class ThrustWay {
 public:
  /// Makes an empty way, with memory for `most` thrusts.
  explicit ThrustWay(std::size_t most) { thrusts_.reserve(most); }

  /// Goes the way from its beginning.
  void take(std::span<const Thrust> way);
  void leave() { take({}); }
  bool isOver() const { return at_ == thrusts_.size(); }

  /// Returns what it adds to the platform's rapidity, times c, in so much time from now on. A planned thrust
  /// above the strongest one is weaker, and lasts longer: observers have gone farther apart since.
  Vec3 gain_m_s(double for_s, double strongest_m_s2) const;
  /// Goes on for so long, likewise.
  void pass(double for_s, double strongest_m_s2) { along(for_s, strongest_m_s2, at_, passed_s_); }

  /// Goes on to the end of the present thrust, or for as long as a frame lasts with it, `left_s(thrust)`.
  /// Returns what it was and how long; nothing at the end of the way.
  template <typename Left>
  std::optional<Thrust> next(const Left& left_s) {
    while (!isOver()) {
      const Thrust& now = thrusts_[at_];
      const double rest_s = now.for_s - passed_s_, most_s = left_s(now.thrust_m_s2);
      if (rest_s > most_s) {
        passed_s_ += most_s;
        return Thrust{most_s, now.thrust_m_s2};
      }
      ++at_;
      passed_s_ = 0.0;
      if (rest_s > 0.0) return Thrust{rest_s, now.thrust_m_s2};
    }
    return std::nullopt;
  }

 private:
  Vec3 along(double for_s, double strongest_m_s2, std::size_t& at, double& passed_s) const;

  std::vector<Thrust> thrusts_;
  std::size_t at_ = 0;     // the present one
  double passed_s_ = 0.0;  // of it
};

}  // namespace carom
