#pragma once
// Straight flights in single precision, as a first test whether discs may meet: it needs 16 bytes of the
// other disc, excludes most, and never one that `findMeeting` would find to meet.
//
// With velocities v (over c) and D the way from the first centre to the second at one board time, the
// condition b > R1 + R2 of puck_contact.h, divided by (γ1 γ2)², is
//     (Δv × D)² > (R1 + R2)² (Δv² − (v1 × v2)²),     Δv = v2 − v1
// and, as the approach in the equal-speed frame falls all the time, the discs recede at the later of their
// starts if they do so at the first's, where D is taken:
//     (1 − v2²) v1·D < (1 − v1·v2) v2·D

#include <algorithm>
#include <cmath>

#include "engine/collision/puck_contact.h"

namespace carom {

/// Where a flight, continued forwards or backwards, is at an epoch that it shares with others.
struct CoarseFlight {
  float x = 0.0f, y = 0.0f;    ///< metres
  float vx = 0.0f, vy = 0.0f;  ///< over c
};

/// Returns the flight as it is at board time `epoch`.
inline CoarseFlight coarseFlight(const Disc& disc, double epoch) {
  const double perGamma = 1.0 / disc.u.t, vx = disc.u.x * perGamma, vy = disc.u.y * perGamma;
  const double passed = epoch - disc.start.t;
  return {static_cast<float>(disc.start.x + vx * passed), static_cast<float>(disc.start.y + vy * passed),
          static_cast<float>(vx), static_cast<float>(vy)};
}

/// Tests many flights against one disc.
class DiscCull {
 public:
  /// `largestRadius` bounds the radii of the others; `epoch` is the board time of their flights.
  DiscCull(const Disc& disc, double largestRadius, TurnConvention convention, double epoch)
      : own_(coarseFlight(disc, disc.start.t)),
        sinceEpoch_(static_cast<float>(disc.start.t - epoch)),
        reach2_(static_cast<float>((disc.radius + largestRadius) * (disc.radius + largestRadius)) *
                (1.0f + kRounding)),
        awaitsApproach_(convention == TurnConvention::simultaneousWithContact) {}

  /// Returns false if the flights certainly do not meet. Without a branch, so that loops become vector
  /// instructions.
  bool mayMeet(float x, float y, float vx, float vy) const {
    const float dx = x + vx * sinceEpoch_ - own_.x, dy = y + vy * sinceEpoch_ - own_.y;
    const float dvx = vx - own_.vx, dvy = vy - own_.vy;
    // What rounding can do, with a factor of at least two: to D, to Δv × D, to the difference of squares.
    const float speeds = std::abs(vx) + std::abs(vy) + std::abs(own_.vx) + std::abs(own_.vy);
    const float error = kRounding * (std::abs(x) + std::abs(y) + std::abs(own_.x) + std::abs(own_.y) +
                                     2.0f * std::abs(sinceEpoch_));
    const float passing = std::abs(dvx * dy - dvy * dx) - 2.0f * speeds * error;
    const float across = own_.vx * vy - own_.vy * vx;
    const float differ2 = dvx * dvx + dvy * dvy - across * across + 4.0f * kRounding * speeds * speeds;
    const float approach = (1.0f - vx * vx - vy * vy) * (own_.vx * dx + own_.vy * dy) -
                           (1.0f - vx * own_.vx - vy * own_.vy) * (vx * dx + vy * dy);
    const bool passes = (passing > 0.0f) & (passing * passing > reach2_ * differ2);
    const bool recedes = awaitsApproach_ & (approach < -8.0f * speeds * error);
    return !(passes | recedes);
  }

 private:
  static constexpr float kRounding = 0x1p-21f;
  CoarseFlight own_;  // at its start
  float sinceEpoch_;
  float reach2_;
  bool awaitsApproach_;
};

}  // namespace carom
