#pragma once
// A room file of any syntax as one tree of named values, so that the readers of all formats look up, check
// and account for values in the same way. Elements and attributes of XML, members of JSON, sections of
// Equalizer and lines of nDisplay's text form are parts.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "app/room_checks/room.h"
#include "app/room_import/json_tree.h"
#include "app/room_import/xml_tree.h"

namespace carom {

struct Part {
  std::string name;
  std::string text;  ///< its own value, without surrounding blanks
  FilePlace at{};
  FilePlace textAt{};
  std::vector<Part> parts{};
  mutable bool isRead = false;  ///< a reader has looked it up

  /// Returns the last part of that name, whatever its capitals, and marks it as read, not those before it;
  /// null if there is none.
  const Part* find(std::string_view wanted) const;
  /// Returns all parts of that name in their order, and marks them as read.
  std::vector<const Part*> all(std::string_view wanted) const;
  /// Returns the text of a part; empty if there is none.
  std::string textOf(std::string_view wanted) const;
  /// Returns the place of a part's text; its own place if there is no such part.
  FilePlace placeOf(std::string_view wanted) const;
  /// Marks it and all its parts as read: the reader has told about them in its own words.
  void markRead() const;
};

/// Returns the parts of a part, which may be null: then there are none.
const std::vector<Part>& partsOf(const Part* part);

/// Returns whether two words are equal but for their capitals (ASCII).
bool alike(std::string_view a, std::string_view b);

Part partOf(const XmlElement& element);
Part partOf(const JsonNode& node);

/// Returns the number that the part's text is, or nothing, with an error noted, if it is none in the range.
std::optional<double> numberOf(const Part& part, const Range& range, bool whole, Room& room);
/// Returns the number of a part of `whole`; nothing if there is no such part or, with an error noted, no such
/// number.
std::optional<double> number(const Part& whole, std::string_view name, const Range& range, bool isWhole,
                             Room& room);
/// Returns the number of a part, or `fallback` if it is absent or, with an error noted, wrong.
double numberOr(const Part& whole, std::string_view name, double fallback, Room& room);
/// Returns whether a switch is on: true, on, yes or 1. Anything but their opposites is an error.
bool flagOr(const Part& whole, std::string_view name, bool fallback, Room& room);
/// Returns the numbers that stand in a text between blanks, commas or semicolons. Returns nothing, with an
/// error noted, unless there are `count` of them.
std::optional<std::vector<double>> numbersIn(const Part& part, std::size_t count, Room& room);
/// Returns three numbers that stand each in a part of its own, in their order: elements of one name, or a
/// JSON array. Returns nothing, with an error noted, if they are others.
std::optional<glm::dvec3> vectorOf(std::span<const Part* const> numbers, FilePlace at, std::string_view what,
                                   Room& room);
/// The same of the parts of a JSON or bracketed array.
std::optional<std::vector<double>> arrayOf(const Part& part, std::size_t count, Room& room);

/// Adds an error for each of the parts whose name, or whose part `key`, another before it has already. Those
/// without one may be alike.
void refuseTwins(const std::vector<const Part*>& parts, std::string_view key, Room& room);
/// The same of the members of all objects of a JSON file.
void refuseTwinMembers(const Part& root, Room& room);

/// Warns of each part below that no reader has looked up, but for those named in `quiet`, which say nothing
/// of a room.
void nameUnread(const Part& whole, std::span<const std::string_view> quiet, Room& room);

}  // namespace carom
