#pragma once
// JSON as this program writes it: numbers with 17 significant digits, so that they read back bit for bit.

#include <nlohmann/json.hpp>
#include <string>

#include "engine/billiard/billiard.h"
#include "engine/spacetime/event.h"

namespace carom {

/// Keys stay in the order in which they were added.
using Json = nlohmann::ordered_json;

/// One line for each member of `value` and for each object in an array; a newline at the end. Every number
/// must be finite.
std::string jsonText(const Json& value);

inline Json vectorJson(const Vec2& v) { return Json::array({v.x, v.y}); }
inline Json vectorJson(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

}  // namespace carom
