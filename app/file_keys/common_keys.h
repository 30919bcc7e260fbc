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

}  // namespace carom::declare
