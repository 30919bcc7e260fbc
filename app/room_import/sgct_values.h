#pragma once
// Reads values of an SGCT room file; wrong values become findings of the room.

#include <fmt/format.h>

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "app/room_checks/foreign_room.h"
#include "app/room_checks/room.h"
#include "app/room_import/json_tree.h"

namespace carom {

/// Warns of members that SGCT does not know and of those given twice.
void noteUnknown(const JsonNode& object, std::span<const std::string_view> known, Room& room);

/// Returns a member, which must be of this kind if it exists. Returns null if it is absent or, with an error
/// noted, wrong.
const JsonNode* member(const JsonNode& object, std::string_view key, JsonNode::Kind kind,
                       std::string_view words, Room& room);
const JsonNode* array(const JsonNode& object, std::string_view key, Room& room);
bool flag(const JsonNode& object, std::string_view key, Room& room);

/// Returns whether it is an object; notes an error if not.
bool isObject(const JsonNode& node, std::string_view what, Room& room);

/// Returns nothing if the key is absent or, with an error noted, wrong.
std::optional<double> number(const JsonNode& object, std::string_view key, const Range& range, bool whole,
                             Room& room);

/// Warns of a setting that cannot be imported.
void noteIgnored(const JsonNode& node, std::string_view key, std::string_view what, Room& room);

/// Reads {x, y} or {x, y, z}. Returns nothing if the key is absent or, with an error noted, wrong.
template <std::size_t N>
std::optional<std::array<double, N>> numbers(const JsonNode& object, std::string_view key, const Range& range,
                                             bool whole, Room& room) {
  static constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
  const JsonNode* found = member(object, key, JsonNode::Kind::object, N == 2 ? "{x, y}" : "{x, y, z}", room);
  if (!found) return {};
  noteUnknown(*found, std::span<const std::string_view>(kNames).first(N), room);
  std::array<double, N> values{};
  bool sound = true;
  for (std::size_t i = 0; i < N; ++i) {
    const auto value = number(*found, kNames[i], range, whole, room);
    if (!value && !found->member(kNames[i])) {
      addError(room, found->at, fmt::format("{} is missing in {}", kNames[i], key));
    }
    sound = sound && value;
    values[i] = value.value_or(0.0);
  }
  if (!sound) return {};
  return values;
}

}  // namespace carom
