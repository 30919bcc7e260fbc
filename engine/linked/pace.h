#pragma once
// How fast a room of a linked game lives. Hurry is a courtesy that keeps rooms together; it decides nothing
// about who may see what. Theory: app/doc/physics.md, Linked rooms.

#include <algorithm>
#include <optional>

namespace carom {

/// The fastest that a room lives that is behind, and how softly it hurries.
inline constexpr double kMostHurry = 2.0, kHurrySoftly_s = 0.25;
/// The share of the slack by which a room may be behind without hurry.
inline constexpr double kBehindFreely = 0.25;

/// Returns the slack between two heads: how much later than another's promise that it has just been told an
/// eye can be, S = (d − ρ)/c.
inline double slack_s(double apart_m, double reach_m, double c_m_s) {
  return std::max(0.0, apart_m - reach_m) / c_m_s;
}

/// Returns how far a room at `own_s` is behind another whose newest present is of `other_s`, `age_s` old:
/// board seconds beyond the share of the slack that is free.
inline double behind_s(double own_s, double other_s, double age_s, double slack_s) {
  return other_s + age_s - kBehindFreely * slack_s - own_s;
}

/// Returns the pace of a room that is behind: 1, and up to 2 where it is far behind. No room is slowed.
inline double hurry(double behind_s) {
  return behind_s > 0.0 ? std::min(kMostHurry, 1.0 + behind_s / kHurrySoftly_s) : 1.0;
}

/// Returns the pace at which a frame may be lived: `wanted`, else 1; none where eyes would see too much at
/// both. `isAllowed(pace)` tries the frame on copies.
template <typename IsAllowed>
std::optional<double> livablePace(double wanted, IsAllowed&& isAllowed) {
  if (isAllowed(wanted)) return wanted;
  if (wanted != 1.0 && isAllowed(1.0)) return 1.0;
  return std::nullopt;
}

}  // namespace carom
