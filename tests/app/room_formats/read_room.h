#pragma once
// Rooms of other programs from texts of the tests, and their corners.

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <string>

#include "app/room_formats/room_kind.h"
#include "app/temporary_folder.h"
#include "places.h"

namespace carom::test {

inline const std::string kArc = CAROM_TESTS_DIR "/data/rooms/cylinder_a3.mpcdi";

/// Reads a room from a text, whose file has this name.
inline Room roomOf(const std::string& name, const std::string& text, const std::string& room = "") {
  const TemporaryFolder folder;
  return readForeignRoom(folder.file(name, text), room);
}

/// Returns the message with which a text is refused; empty if it is read.
inline std::string refusalOf(const std::string& name, const std::string& text, const std::string& room = "") {
  try {
    const Room read = roomOf(name, text, room);
    for (const Finding& finding : read.findings) {
      if (finding.kind == Finding::Kind::error)
        return fmt::format("{}:{}: {}", finding.at.line, finding.at.column, finding.text);
    }
    return {};
  } catch (const InputError& error) {
    const std::string message = error.what();
    return message.substr(message.find(name) + name.size() + 1);
  }
}

/// Returns the finding whose text has these words; its line is 0 if there is none.
inline Finding findingWith(const Room& room, const std::string& words) {
  for (const Finding& finding : room.findings) {
    if (finding.text.find(words) != std::string::npos) return finding;
  }
  return {Finding::Kind::warning, {0, 0}, {}};
}

inline std::string allFindings(const Room& room) {
  std::string all;
  for (const Finding& finding : room.findings)
    all += fmt::format("{}:{}: {}\n", finding.at.line, finding.at.column, finding.text);
  return all;
}

inline const RoomWall& wallOf(const Room& room, const std::string& name) {
  const auto found = std::find_if(room.walls.begin(), room.walls.end(),
                                  [&](const RoomWall& wall) { return wall.wall.name == name; });
  if (found == room.walls.end()) throw std::runtime_error("no wall " + name + "\n" + allFindings(room));
  return *found;
}

/// Expects corners to a hundredth of a millimetre.
inline void expectCorners(const Room& room, const std::string& name, const glm::dvec3& lowerLeft_m,
                          const glm::dvec3& lowerRight_m, const glm::dvec3& upperLeft_m) {
  constexpr double kNear_m = 1e-5;
  const Wall& wall = wallOf(room, name).wall;
  EXPECT_LT(glm::distance(wall.lowerLeft_m, lowerLeft_m), kNear_m) << name;
  EXPECT_LT(glm::distance(wall.lowerRight_m, lowerRight_m), kNear_m) << name;
  EXPECT_LT(glm::distance(wall.upperLeft_m, upperLeft_m), kNear_m) << name;
}

/// Returns the text with its only `old` replaced by `now`.
inline std::string with(std::string text, const std::string& old, const std::string& now) {
  const std::size_t at = text.find(old);
  if (at == std::string::npos || text.find(old, at + 1) != std::string::npos)
    throw std::runtime_error("not once: " + old);
  return text.replace(at, old.size(), now);
}

}  // namespace carom::test
