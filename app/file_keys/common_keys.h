#pragma once
// Keys that several kinds of files have.

#include <cmath>
#include <string_view>

#include "app/file_keys/file_key.h"
#include "engine/base/limits.h"

namespace carom::declare {

/// The speed, v/c, beyond which the drive makes the room no faster.
inline FileKey fastestBeta(std::string_view sentence) {
  const double most = kMostPlatformU / std::hypot(1.0, kMostPlatformU);
  return number("fastest_beta", {.least = 0.0, .most = most, .above = true}, sentence, most);
}

inline constexpr std::string_view kUnitOfRig = "the rig's unit";

/// A place in a room.
inline FileKey corner(std::string_view name, std::string_view sentence) {
  return inUnit(kUnitOfRig, numbers(name, 3, {}, sentence));
}

/// A rigid motion.
inline FileKey pose(std::string_view name, std::string_view sentence) {
  constexpr Range kTurn{.least = -360.0, .most = 360.0};
  return table(
      name, sentence,
      {inUnit(kUnitOfRig, numbers("translation", 3, {}, "after the rotation", {0.0, 0.0, 0.0})),
       numbers("rotation_deg", 3, kTurn, "about the fixed x, then y, then z axis", {0.0, 0.0, 0.0})});
}

}  // namespace carom::declare
