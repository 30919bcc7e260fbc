#pragma once
// Keys that several kinds of files have.

#include <cmath>
#include <cstddef>
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

/// A language is a code or a PO file.
inline constexpr std::string_view kLanguageName = "^([A-Za-z0-9_-]{1,16}|.+\\.po)$";
inline FileKey languageKey(std::string_view sentence) {
  return fitting(kLanguageName, text("language", sentence));
}
inline FileKey languagesKey(std::string_view sentence) {
  constexpr std::size_t kMost = 8;
  return ofSize(1, kMost, fitting(kLanguageName, texts("languages", sentence)));
}

/// Where spacetime stands in the room; `ofRig`: its place is in the rig's unit.
inline FileKey spacetimeKey(bool ofRig) {
  constexpr Range kSize{.least = 0.1, .most = 100.0}, kScale{.least = 0.001, .most = 100.0};
  constexpr Range kTime_s{.least = 0.0, .most = 600.0};
  const FileKey place =
      numbers("place", 3, {}, "of its foot's middle, in the room; left out: to the person's right");
  return table(
      "spacetime", "the game's spacetime as a thing in the room (key I)",
      {ofRig ? inUnit(kUnitOfRig, place) : place, number("height_m", kSize, "of it in the room", 2.2),
       number("scale", kScale, "metres of the room for a metre of the table, and of light", 0.25),
       number("past_s", kTime_s, "board time from its foot to the present; left out: four fifths of it"),
       number("future_s", kTime_s, "from the present to its top; left out: the rest")});
}

}  // namespace carom::declare
