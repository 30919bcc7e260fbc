#pragma once
// The limits that several parts of the program must agree on.

#include <algorithm>
#include <cstddef>

namespace carom {

/// The range in which the speed of light can be set. Below it, a step of the foot would be almost all of the
/// distance that light covers in a frame; above it, a room shows nothing of relativity.
inline constexpr double kLeastLightSpeed_m_s = 0.3, kMostLightSpeed_m_s = 30.0;

/// The greatest u = γβ that a stroke gives to a puck at rest (β = 0.949). The points of a faster puck would
/// need more than a second to join its new motion after a bounce.
inline constexpr double kStrongestU = 3.0;

/// Returns the strongest proper acceleration of the platform. Light from a distance c²/a behind never catches
/// up with an observer who accelerates at a. The limit keeps that distance at two metres, or at twice the
/// distance of the farthest of several observers, so that time goes forward in the whole room; where light is
/// fast, the limit is c in one second.
inline double strongestThrust_m_s2(double c_m_s, double farthestObserver_m = 0.0) {
  constexpr double kBehind_m = 2.0, kLeast_s = 1.0;
  return std::min(c_m_s * c_m_s / std::max(kBehind_m, 2.0 * farthestObserver_m), c_m_s / kLeast_s);
}

/// The u = γβ beyond which the drive makes the platform no faster: 0.995 c. There ten of the board's seconds,
/// with everything that happens in them, pass in one of the observer's.
inline constexpr double kMostPlatformU = 10.0;

/// A tracked step faster than this celerity is a glitch of the tracker, not travel: no head moves faster.
inline constexpr double kGlitchCelerity_m_s = 12.0;

/// The same where several observers share a room: there one's step makes the clocks of the others run ahead.
inline constexpr double kGlitchOfSeveral_m_s = 3.0;

/// The most observers whose heads are tracked in one room.
inline constexpr std::size_t kMostViewers = 4;

/// When no sample of the head comes, its pose is predicted for so long, and is then overdue. It goes on until
/// kTrackCoasts_s, comes to rest smoothly in the kTrackFades_s after that, and is lost then.
inline constexpr double kTrackPredicted_s = 0.1, kTrackCoasts_s = 0.5, kTrackFades_s = 0.5;
inline constexpr double kTrackLost_s = kTrackCoasts_s + kTrackFades_s;

/// A hand without samples for so long is lost: a hand is quick, and a button must not stay pressed.
inline constexpr double kHandLost_s = 0.3;

}  // namespace carom
