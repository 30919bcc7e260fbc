#include "app/room_import/sgct_values.h"

#include <algorithm>
#include <unordered_map>

namespace carom {

using Kind = JsonNode::Kind;

void noteUnknown(const JsonNode& object, std::span<const std::string_view> known, Room& room) {
  std::unordered_map<std::string_view, const JsonNode*> last;
  for (const JsonNode& member : object.children) last[member.key] = &member;
  for (const JsonNode& member : object.children) {
    const bool expected = std::find(known.begin(), known.end(), member.key) != known.end();
    const bool streamed = member.key == "spout" || member.key == "ndi" || member.key == "$schema";
    if (!expected && !streamed) addUnknownKey(room, member.keyAt, member.key, known);
    if (last[member.key] != &member) {
      addWarning(room, member.keyAt,
                 fmt::format("key '{}' is given twice; the last counts", printable(member.key)));
    }
  }
}

const JsonNode* member(const JsonNode& object, std::string_view key, Kind kind, std::string_view words,
                       Room& room) {
  const JsonNode* found = object.member(key);
  if (!found) return nullptr;
  const bool fits = found->kind == kind || (kind == Kind::number && found->kind == Kind::whole);
  if (fits) return found;
  addError(room, found->at, fmt::format("{} is {}, expected {}", key, found->words(), words));
  return nullptr;
}

const JsonNode* array(const JsonNode& object, std::string_view key, Room& room) {
  return member(object, key, Kind::array, "an array", room);
}

bool flag(const JsonNode& object, std::string_view key, Room& room) {
  const JsonNode* found = member(object, key, Kind::flag, "true or false", room);
  return found && found->flag;
}

bool isObject(const JsonNode& node, std::string_view what, Room& room) {
  if (node.kind == Kind::object) return true;
  addError(room, node.at, fmt::format("{} is {}, expected an object", what, node.words()));
  return false;
}

std::optional<double> number(const JsonNode& object, std::string_view key, const Range& range, bool whole,
                             Room& room) {
  const JsonNode* found = object.member(key);
  if (!found) return {};
  const bool fits = found->kind == Kind::whole || (!whole && found->kind == Kind::number);
  if (fits && within(range, found->number)) return found->number;
  addError(room, found->at,
           fmt::format("{} is {}, expected {}", key, found->words(), wordsFor(range, whole)));
  return {};
}

void noteIgnored(const JsonNode& node, std::string_view key, std::string_view what, Room& room) {
  if (const JsonNode* found = node.member(key)) {
    addWarning(room, found->at, fmt::format("{} cannot be taken over: {}", key, what));
  }
}

}  // namespace carom
