#pragma once
// Writes JSON with numbers of 17 significant digits, so that reading restores every bit.

#include <nlohmann/json.hpp>
#include <string>

#include "engine/billiard/billiard.h"
#include "engine/spacetime/event.h"

namespace carom {

/// Keys keep the order in which they were added.
using Json = nlohmann::ordered_json;

/// Returns the JSON text with one line for each member of `value` and for each object in an array, ending
/// with a newline. Every number must be finite.
std::string jsonText(const Json& value);

inline Json vectorJson(const Vec2& v) { return Json::array({v.x, v.y}); }
inline Json vectorJson(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

}  // namespace carom
