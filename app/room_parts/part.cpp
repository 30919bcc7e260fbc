#include "app/room_parts/part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "app/room_checks/foreign_room.h"

namespace carom {
namespace {

constexpr std::string_view kBetween = " \t\r\n,;";
constexpr std::size_t kShown = 60;

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

std::string shown(std::string_view text) {
  return printable(text.size() > kShown ? std::string(text.substr(0, kShown)) + "…" : std::string(text));
}

/// Returns the part's name for messages; elements of arrays have none.
std::string nameOf(const Part& part) { return part.name.empty() ? "this value" : shown(part.name); }

/// Returns a part of the same name that counts instead of one that no reader has looked up: of several of one
/// name, find() takes the last. Returns null if there is none.
const Part* insteadOf(const Part& part, const Part& whole) {
  const auto later = std::find_if(whole.parts.begin(), whole.parts.end(), [&](const Part& other) {
    return &other > &part && other.isRead && !part.name.empty() && alike(other.name, part.name);
  });
  return later == whole.parts.end() ? nullptr : &*later;
}

}  // namespace

const std::vector<Part>& partsOf(const Part* part) {
  static const std::vector<Part> none;
  return part ? part->parts : none;
}

bool alike(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

const Part* Part::find(std::string_view wanted) const {
  const auto last =
      std::find_if(parts.rbegin(), parts.rend(), [&](const Part& part) { return alike(part.name, wanted); });
  if (last == parts.rend()) return nullptr;
  last->isRead = true;
  return &*last;
}

std::vector<const Part*> Part::all(std::string_view wanted) const {
  std::vector<const Part*> found;
  for (const Part& part : parts) {
    if (!alike(part.name, wanted)) continue;
    part.isRead = true;
    found.push_back(&part);
  }
  return found;
}

std::string Part::textOf(std::string_view wanted) const {
  const Part* part = find(wanted);
  return part ? part->text : std::string();
}

FilePlace Part::placeOf(std::string_view wanted) const {
  const Part* part = find(wanted);
  return part ? part->textAt : at;
}

void Part::markRead() const {
  isRead = true;
  for (const Part& part : parts) part.markRead();
}

Part partOf(const XmlElement& element) {
  Part part{element.name, element.text, element.at, element.textAt};
  for (const XmlAttribute& attribute : element.attributes)
    part.parts.push_back({attribute.name, attribute.value, attribute.nameAt, attribute.valueAt});
  for (const XmlElement& child : element.children) part.parts.push_back(partOf(child));
  return part;
}

Part partOf(const JsonNode& node) {
  using Kind = JsonNode::Kind;
  Part part{node.key, node.text, node.key.empty() ? node.at : node.keyAt, node.at};
  if (node.kind == Kind::flag) part.text = node.flag ? "true" : "false";
  if (node.kind == Kind::whole || node.kind == Kind::number) part.text = fmt::format("{}", node.number);
  for (const JsonNode& child : node.children) part.parts.push_back(partOf(child));
  return part;
}

std::optional<double> numberOf(const Part& part, const Range& range, bool whole, Room& room) {
  part.isRead = true;
  const auto value = wholeNumber(part.text);
  if (value && within(range, *value) && (!whole || *value == static_cast<double>(static_cast<long>(*value))))
    return value;
  addError(room, part.textAt,
           fmt::format("{} is '{}', expected {} and nothing else", nameOf(part), shown(part.text),
                       wordsFor(range, whole)));
  return {};
}

std::optional<double> number(const Part& whole, std::string_view name, const Range& range, bool isWhole,
                             Room& room) {
  const Part* part = whole.find(name);
  return part ? numberOf(*part, range, isWhole, room) : std::nullopt;
}

double numberOr(const Part& whole, std::string_view name, double fallback, Room& room) {
  return number(whole, name, {}, false, room).value_or(fallback);
}

bool flagOr(const Part& whole, std::string_view name, bool fallback, Room& room) {
  const Part* part = whole.find(name);
  if (!part) return fallback;
  for (const char* on : {"true", "on", "yes", "1"}) {
    if (alike(part->text, on)) return true;
  }
  for (const char* off : {"false", "off", "no", "0"}) {
    if (alike(part->text, off)) return false;
  }
  addError(room, part->textAt,
           fmt::format("{} is '{}', expected true or false", nameOf(*part), shown(part->text)));
  return fallback;
}

std::optional<std::vector<double>> numbersIn(const Part& part, std::size_t count, Room& room) {
  part.isRead = true;
  std::vector<double> values;
  const std::string_view text = part.text;
  std::size_t end = 0;
  for (std::size_t begin = text.find_first_not_of(kBetween); begin != std::string_view::npos;
       begin = text.find_first_not_of(kBetween, end)) {
    end = std::min(text.find_first_of(kBetween, begin), text.size());
    const auto value = wholeNumber(text.substr(begin, end - begin));
    if (!value || !within({}, *value)) {
      addError(room, part.textAt,
               fmt::format("'{}' in {} is no number that can be counted with, expected {} numbers",
                           shown(text.substr(begin, end - begin)), nameOf(part), count));
      return {};
    }
    values.push_back(*value);
  }
  if (values.size() == count) return values;
  addError(room, part.textAt,
           fmt::format("{} has {} value{}, expected {} numbers", nameOf(part), values.size(),
                       values.size() == 1 ? "" : "s", count));
  return {};
}

std::optional<glm::dvec3> vectorOf(std::span<const Part* const> numbers, FilePlace at, std::string_view what,
                                   Room& room) {
  if (numbers.size() != 3) {
    addError(room, at,
             fmt::format("{} has {} value{}, expected 3 numbers", what, numbers.size(),
                         numbers.size() == 1 ? "" : "s"));
    return {};
  }
  glm::dvec3 vector(0.0);
  for (int i = 0; i < 3; ++i) {
    const auto value = numberOf(*numbers[static_cast<std::size_t>(i)], {}, false, room);
    if (!value) return {};
    vector[i] = *value;
  }
  return vector;
}

std::optional<std::vector<double>> arrayOf(const Part& part, std::size_t count, Room& room) {
  part.isRead = true;
  if (part.parts.size() != count) {
    addError(room, part.textAt,
             fmt::format("{} has {} value{}, expected an array of {} numbers", nameOf(part),
                         part.parts.size(), part.parts.size() == 1 ? "" : "s", count));
    return {};
  }
  std::vector<double> values;
  for (const Part& element : part.parts) {
    const auto value = numberOf(element, {}, false, room);
    if (!value) return {};
    values.push_back(*value);
  }
  return values;
}

void refuseTwins(const std::vector<const Part*>& parts, std::string_view key, Room& room) {
  std::map<std::string, int> lines;
  for (const Part* part : parts) {
    const std::string name = key.empty() ? part->name : part->textOf(key);
    if (name.empty()) continue;
    const auto [known, isNew] = lines.emplace(name, part->at.line);
    if (isNew) continue;
    addError(room, key.empty() ? part->at : part->placeOf(key),
             fmt::format("the name '{}' is taken in line {}, expected another", shown(name), known->second));
  }
}

void refuseTwinMembers(const Part& root, Room& room) {
  std::vector<const Part*> members;
  for (const Part& part : root.parts) {
    members.push_back(&part);
    refuseTwinMembers(part, room);
  }
  refuseTwins(members, "", room);
}

void nameUnread(const Part& whole, std::span<const std::string_view> quiet, Room& room) {
  for (const Part& part : whole.parts) {
    if (std::any_of(quiet.begin(), quiet.end(),
                    [&](std::string_view word) { return alike(part.name, word); }))
      continue;
    if (part.isRead) {
      nameUnread(part, quiet, room);
    } else if (const Part* other = insteadOf(part, whole)) {
      addWarning(room, part.at,
                 fmt::format("{} is left out: the one of line {} counts", nameOf(part), other->at.line));
    } else if (part.text.empty()) {
      addWarning(room, part.at, fmt::format("'{}' is left out: nothing here does the like", nameOf(part)));
    } else {
      addWarning(
          room, part.at,
          fmt::format("{} '{}' is left out: nothing here does the like", nameOf(part), shown(part.text)));
    }
  }
}

}  // namespace carom
